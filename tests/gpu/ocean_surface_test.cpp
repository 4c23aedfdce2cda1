#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/core/random.h"
#include "engine/ocean/ocean.h"
#include "engine/ocean/roughness_table.h"
#include "support/graph_test.h"

namespace offing {
namespace {

class OceanSurface : public test::GraphTest {
 protected:
  /// One frame of foam seen from `eye`.
  void foam(Ocean& ocean, double time, glm::dvec2 eye = {3.0, 1.0e6}) {
    graph_->begin_frame();
    const SeaIds sea = ocean.add_maps(*graph_, time, false);
    OceanView view;
    view.eye = eye;
    view.time = time;
    const TextureId map = ocean.add_foam(*graph_, view, sea, true);
    graph_->add(
        "reader", [&](PassBuilder& pass) { pass.read(map).side_effect(); }, [](PassContext&) {});
    graph_->execute();
  }
  /// Share of a layer that is white.
  static double share(const Ocean& ocean, std::size_t layer) {
    const auto map = ocean.foam().map().read_floats(2);
    const std::size_t count = map.size() / 2 / shared::kFoamLayers;
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = 2 * (layer * count + i);
      sum += static_cast<double>(std::max(map[at], map[at + 1]));
    }
    return sum / static_cast<double>(count);
  }
};

// The share of the map is the share of the picture's water that the evenly distributed pattern
// turns white. A few great waves decide what one patch shows, so three seas are asked for their
// mean.
TEST_F(OceanSurface, FoamCoversTheShareThatWasObserved) {
  Ocean ocean(*shaders_, {.cascades = 3, .size = 128, .foam_size = 64});
  Environment environment;
  for (const double wind : {7.0, 10.0, 14.0, 20.0}) {
    environment.wind.speed = wind;
    SeaState state;
    state.swell.height = 0.0;
    const double observed = 3.84e-6 * std::pow(wind, 3.41);
    double shares[shared::kFoamLayers] = {};
    int count = 0;
    for (const std::uint64_t seed : {5u, 6u, 7u}) {
      ocean.set_sea(state, environment, seed);
      for (int frame = 0; frame < 50; ++frame) {
        foam(ocean, 0.15 * frame, {1e5 * static_cast<double>(seed), 0.0});
        if (frame < 25 || frame % 5 != 0) continue;
        for (std::size_t layer = 1; layer < shared::kFoamLayers; ++layer) {
          shares[layer] += share(ocean, layer);
        }
        ++count;
      }
    }
    for (std::size_t layer = 1; layer < shared::kFoamLayers; ++layer) {
      const double ratio = shares[layer] / count / observed;
      EXPECT_LT(std::abs(std::log(ratio)), std::log(1.5))
          << wind << " m/s, layer " << layer << ": " << ratio;
    }
  }
}

TEST_F(OceanSurface, FoamLastsAndIsTheSameAtOtherFrameRates) {
  Environment environment;
  environment.wind.speed = 14.0;
  double shares[2] = {};
  std::vector<float> maps[2];
  for (int run = 0; run < 2; ++run) {
    Ocean ocean(*shaders_, {.cascades = 2, .size = 64, .foam_size = 64});
    ocean.set_sea({}, environment, 3);
    const double step = run == 0 ? 0.05 : 0.1;
    for (int frame = 0; frame <= std::lround(8.0 / step); ++frame) foam(ocean, step * frame);
    shares[run] = share(ocean, 1);
  }
  EXPECT_NEAR(shares[1] / shares[0], 1.0, 0.1);
  for (std::vector<float>& map : maps) {
    Ocean ocean(*shaders_, {.cascades = 2, .size = 64, .foam_size = 64});
    ocean.set_sea({}, environment, 3);
    for (int frame = 0; frame < 20; ++frame) foam(ocean, 0.1 * frame, {0.3 * frame, 7.0});
    map = ocean.foam().map().read_floats(2);
  }
  EXPECT_EQ(maps[0], maps[1]);  // the same steps, the same foam
}

TEST_F(OceanSurface, FoamRestsWhileTimeStandsStill) {
  Ocean ocean(*shaders_, {.cascades = 2, .size = 64, .foam_size = 64});
  Environment environment;
  ocean.set_sea({}, environment, 3);
  for (int frame = 0; frame < 4; ++frame) foam(ocean, 2.0);
  EXPECT_EQ(row("sea.foam").ran, 1);
  foam(ocean, 2.1);
  EXPECT_EQ(row("sea.foam").ran, 2);
}

// What a texture unit shows of the waves at a size, at random places, plus what the table says is
// missing, is the total, at every size: from a pixel at one's feet to one 5 km away.
TEST_F(OceanSurface, ResolvedAndResidualSlopesMakeTheTotal) {
  const gl::Program reader("reader", {{GL_COMPUTE_SHADER, R"(#version 450 core
layout(local_size_x = 64) in;
layout(binding = 0) uniform sampler2DArray map;
layout(std430, binding = 0) readonly buffer Places { vec4 places[]; };
layout(std430, binding = 1) writeonly buffer Values { vec4 values[]; };
void main() {
  uint i = gl_GlobalInvocationID.x;
  values[i] = textureLod(map, places[i].xyz, places[i].w);
})"}});
  constexpr std::size_t kPlaces = 8192;
  Environment environment;
  for (const double wind : {6.0, 13.0}) {
    environment.wind.speed = wind;
    const gl::Sampler sampler("map", GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT, GL_REPEAT);
    const double sizes[] = {0.003, 0.03, 0.3, 3.0, 15.0};  // m: pixels 1 to 5000 m away
    double resolved[5] = {}, residual[5] = {}, total = 0.0;
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const Sea sea = make_sea({}, environment, seed, 3, 128);
      SeaMaps maps(*shaders_, 3, 128);
      maps.set_waves(sea.cascades, sea.choppiness);
      graph_->begin_frame();
      const SeaIds ids = maps.add(*graph_, 10.0);
      graph_->add(
          "reader", [&](PassBuilder& pass) { pass.read(ids.slopes).side_effect(); },
          [](PassContext&) {});
      graph_->execute();
      total = sea.slope_variance.total();
      const auto table = roughness_table(sea.cascades, sea.slope_variance);
      for (std::size_t s = 0; s < 5; ++s) {
        const double size = std::log2(sizes[s]);
        for (std::size_t c = 0; c < 3; ++c) {
          const CascadeBand& band = sea.cascades[c].band;
          const double level = std::max(size - std::log2(band.length / 128.0), 0.0);
          const double fade = std::clamp((level - 4.0) / 1.5, 0.0, 1.0);
          const double share = 1.0 - fade * fade * (3.0 - 2.0 * fade);
          std::vector<float> places;
          for (std::size_t i = 0; i < kPlaces; ++i) {
            places.push_back(static_cast<float>(random_uniform(seed + 10 * c, i, 0)));
            places.push_back(static_cast<float>(random_uniform(seed + 10 * c, i, 1)));
            places.push_back(static_cast<float>(c));
            places.push_back(static_cast<float>(level));
          }
          const gl::Buffer in = gl::Buffer::of<float>("places", places);
          const gl::Buffer out("values", places.size() * sizeof(float), 0);
          in.bind_storage(0);
          out.bind_storage(1);
          maps.slopes().bind(0);
          sampler.bind(0);
          reader.use();
          glDispatchCompute(kPlaces / 64, 1, 1);
          glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
          glBindSampler(0, 0);
          std::vector<float> values(places.size());
          out.read(values.data(), values.size() * sizeof(float));
          double sum = 0.0;
          for (std::size_t i = 0; i < kPlaces; ++i) {
            sum += std::pow(values[4 * i], 2) + std::pow(values[4 * i + 1], 2);
          }
          resolved[s] += share * share * sum / kPlaces / 3.0;
        }
        const double entry = (size - static_cast<double>(shared::kRoughnessFirst)) *
                             static_cast<double>(shared::kRoughnessSteps);
        const auto first = static_cast<std::size_t>(std::clamp(entry, 0.0, 126.0));
        const double part = std::clamp(entry - static_cast<double>(first), 0.0, 1.0);
        const glm::vec4 missing =
            glm::mix(table[first], table[first + 1], static_cast<float>(part));
        residual[s] += (static_cast<double>(missing.x) + static_cast<double>(missing.y)) / 3.0;
      }
    }
    // Cox and Munk's .003 + .00512 U at 12.5 m.
    EXPECT_NEAR(total / (0.003 + 0.00512 * 1.018 * wind), 1.0, 0.15);
    for (std::size_t s = 0; s < 5; ++s) {
      EXPECT_NEAR((resolved[s] + residual[s]) / total, 1.0, 0.05) << sizes[s] << " m at " << wind;
    }
    EXPECT_GT(resolved[0], 0.2 * total);
    EXPECT_LT(resolved[4], resolved[2]);
  }
}

}  // namespace
}  // namespace offing
