#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "engine/core/random.h"
#include "engine/ocean/ocean.h"
#include "shaders/shared/bindings.h"
#include "support/graph_test.h"
#include "support/paths.h"

namespace offing {
namespace {

constexpr std::size_t kPlaces = 16384;  // of each sort

/// Places about the eye and the size of the pixels that show them, m.
struct Pixels {
  double reach = 100.0, size = 0.1;
};

/// Means over random places of what the sea's shaders say of them.
class SeaPicture : public test::GraphTest {
 protected:
  struct Means {
    double cover = 0.0, opacity = 0.0, slope2 = 0.0, missing = 0.0;
  };

  const ShaderProgram& program(const std::string& name, const ShaderDefines& defines) {
    return shaders_->program({test::test_data() / "data/shaders" / name}, defines);
  }

  /// Runs `dispatch` with the sea's surface of `view` bound.
  template <typename Dispatch>
  void read_surface(Ocean& ocean, const OceanView& view, const Dispatch& dispatch) {
    graph_->begin_frame();
    const SeaIds sea = ocean.add_maps(*graph_, view.time, false);
    const TextureId foam = ocean.add_foam(*graph_, view, sea, true);
    const SurfaceAccess access = ocean.surface_access(sea, foam);
    graph_->add(
        "reader",
        [&](PassBuilder& pass) {
          access.declare(pass);
          pass.side_effect();
        },
        [&](PassContext& context) {
          access.bind(context);
          dispatch();
          access.unbind();
        });
    graph_->execute();
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  }

  /// Of places up to `reach` from the eye on both axes, for each sort of pixels; the sea's maps and
  /// foam are those of `time`.
  std::vector<Means> means(Ocean& ocean, const ShaderProgram& reader, double time,
                           std::span<const Pixels> sorts, glm::dvec2 eye) {
    std::vector<float> places;
    for (const Pixels& sort : sorts) {
      for (std::size_t i = 0; i < kPlaces; ++i) {
        for (std::uint64_t axis = 0; axis < 2; ++axis) {
          places.push_back(
              static_cast<float>((2.0 * random_uniform(9, i, axis) - 1.0) * sort.reach));
        }
        places.push_back(static_cast<float>(random_uniform(9, i, 2)));
        places.push_back(static_cast<float>(sort.size));
      }
    }
    const gl::Buffer in = gl::Buffer::of<float>("places", places);
    const gl::Buffer out("seen", places.size() * sizeof(float), 0);
    OceanView view;
    view.eye = eye;
    view.time = time;
    read_surface(ocean, view, [&] {
      in.bind_storage(0);
      out.bind_storage(1);
      reader.use();
      glDispatchCompute(static_cast<GLuint>(sorts.size() * kPlaces / 64), 1, 1);
    });
    std::vector<float> seen(places.size());
    out.read(seen.data(), seen.size() * sizeof(float));
    std::vector<Means> sums(sorts.size());
    for (std::size_t i = 0; i < seen.size() / 4; ++i) {
      Means& sum = sums[i / kPlaces];
      sum.cover += static_cast<double>(seen[4 * i]) / kPlaces;
      sum.opacity += static_cast<double>(seen[4 * i + 1]) / kPlaces;
      sum.slope2 += static_cast<double>(seen[4 * i + 2]) / kPlaces;
      sum.missing += static_cast<double>(seen[4 * i + 3]) / kPlaces;
    }
    return sums;
  }
};

// Not the map but what becomes of it: pattern, crests and what breaks in this moment, near by and
// far.
TEST_F(SeaPicture, WhitecapsCoverTheShareThatWasObserved) {
  const OceanSettings settings{.cascades = 3, .size = 128, .foam_size = 64};
  Ocean ocean(*shaders_, settings);
  const ShaderProgram& reader = program("sea_picture.comp", {{"CASCADES", "3"}});
  Environment environment;
  SeaState state;
  state.swell.height = 0.0;
  for (const double wind : {7.0, 10.0, 14.0, 20.0}) {
    environment.wind.speed = wind;
    const double observed = 3.84e-6 * std::pow(wind, 3.41);
    const std::array<Pixels, 3> sorts{{{80.0, 0.05}, {300.0, 0.7}, {1300.0, 4.0}}};
    double shares[3] = {};
    for (const std::uint64_t seed : {5u, 6u}) {
      ocean.set_sea(state, environment, seed);
      const glm::dvec2 eye(1e5 * static_cast<double>(seed), 0.0);
      for (int frame = 0; frame < 36; ++frame) {
        const bool counts = frame >= 25 && frame % 5 == 0;
        const auto seen =
            means(ocean, reader, 0.15 * frame, std::span(sorts).first(counts ? 3 : 1), eye);
        for (std::size_t s = 0; counts && s < 3; ++s) shares[s] += seen[s].cover / 6.0;
      }
    }
    for (std::size_t s = 0; s < 3; ++s) {
      EXPECT_LT(std::abs(std::log(shares[s] / observed)), std::log(1.5))
          << wind << " m/s, within " << sorts[s].reach << " m: " << shares[s] / observed;
    }
  }
}

// What is really drawn in low, where a pixel reads one of two map levels, and in medium, plus what
// is taken for roughness, is the total, from one's feet to 5 km. Waves are taken as they are before
// they are drawn together.
class SeaPictureOf : public SeaPicture, public ::testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(Quality, SeaPictureOf, ::testing::Values(0, 1));
TEST_P(SeaPictureOf, ResolvedAndResidualSlopesMakeTheTotal) {
  const OceanSettings settings = OceanSettings::of_quality(GetParam());
  Ocean ocean(*shaders_, settings);
  ShaderDefines defines{{"CASCADES", std::to_string(settings.cascades)}};
  if (GetParam() == 0) {
    defines.emplace_back("PICK_LEVELS", "");
    defines.emplace_back("RIPPLES", "");
  }
  const ShaderProgram& reader = program("sea_picture.comp", defines);
  Environment environment;
  SeaState state;
  state.choppiness = 0.0;
  const std::array distances{1.0, 10.0, 100.0, 1000.0, 5000.0};
  std::vector<Pixels> sorts;
  for (const double distance : distances) {
    // The size that mesh.frag gives a pixel of 640 x 360, seen from 3 m up.
    const double pixel = distance * 1.6e-3;
    sorts.push_back({2000.0, std::max(pixel, pixel * distance / 3.0 / 4.0)});
  }
  for (const double wind : {5.0, 15.0}) {
    environment.wind.speed = wind;
    const double cox_munk = 0.003 + 0.00512 * 1.018 * wind;  // at 12.5 m
    std::array<double, 5> all{};
    constexpr int kSeas = 4;  // a draw's slopes scatter
    for (std::uint64_t seed = 0; seed < kSeas; ++seed) {
      ocean.set_sea(state, environment, seed);
      const auto seen = means(ocean, reader, 10.0, sorts, {0.0, 0.0});
      for (std::size_t i = 0; i < 5; ++i) all[i] += (seen[i].slope2 + seen[i].missing) / kSeas;
    }
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_NEAR(all[i] / cox_munk, 1.0, 0.15) << wind << " m/s, " << distances[i] << " m";
      EXPECT_NEAR(all[i] / ocean.slope_variance().total(), 1.0, 0.05)
          << wind << " m/s, " << distances[i] << " m";
    }
  }
}

// Sparkles only share out the glitter's light: their factor has mean 1, and Poisson's variance
// where a pixel holds some mirroring facets (with fewer it is less than that: the tails are short).
TEST_F(SeaPicture, SparklesKeepTheMeanOfTheGlitter) {
  Ocean ocean(*shaders_, {.cascades = 2, .size = 64, .foam_size = 64});
  ocean.set_sea({}, {}, 3);
  const ShaderProgram& reader = program("glints.comp", {});
  constexpr std::size_t kPatches = 65536;
  const gl::Buffer out("factors", kPatches * sizeof(float), 0);
  for (const float size : {0.004f, 0.05f, 0.8f, 12.0f}) {
    for (const float density : {0.05f, 1.0f, 20.0f}) {
      double sum = 0.0, squares = 0.0;
      for (const float time : {0.05f, 1.05f, 2.05f, 3.05f}) {
        read_surface(ocean, {}, [&] {
          out.bind_storage(1);
          reader.use();
          reader.program().set(0, glm::vec4(size, density, time, 0.0f));
          glDispatchCompute(kPatches / 64, 1, 1);
        });
        std::vector<float> factors(kPatches);
        out.read(factors.data(), kPatches * sizeof(float));
        for (const float factor : factors) {
          ASSERT_TRUE(factor >= 0.0f && std::isfinite(factor));
          sum += static_cast<double>(factor);
          squares += static_cast<double>(factor * factor);
        }
      }
      const double mean = sum / (4.0 * kPatches);
      EXPECT_NEAR(mean, 1.0, 0.03) << size << " m, density " << density;
      const double facets = 20.0 * static_cast<double>(density * size * size);
      if (facets > 2.0) {
        const double variance = squares / (4.0 * kPatches) - mean * mean;
        EXPECT_NEAR(variance * facets, 1.0, 0.15) << size << " m, density " << density;
      }
    }
  }
}

}  // namespace
}  // namespace offing
