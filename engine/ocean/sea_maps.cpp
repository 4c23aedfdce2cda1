#include "engine/ocean/sea_maps.h"

#include <fmt/core.h>

#include <bit>
#include <cmath>

#include "engine/core/angles.h"
#include "engine/core/error.h"
#include "engine/core/random.h"
#include "shaders/shared/ocean.h"

namespace offing {
namespace {

struct Radices {
  int a, b;
};
Radices radices(int size) {
  switch (size) {
    case 64:
      return {8, 8};
    case 128:
      return {16, 8};
    case 256:
      return {16, 16};
    case 512:
      return {32, 16};
    default:
      throw InputError(
          fmt::format("ocean: cascades of {0} x {0} points: must be 64, 128, 256 or 512", size));
  }
}

ShaderDefines fft_defines(int size) {
  const auto [a, b] = radices(size);
  return {{"RADIX_A", std::to_string(a)}, {"RADIX_B", std::to_string(b)}};
}

int checked_cascades(int cascades) {
  if (cascades < 1 || cascades > shared::kOceanMaxCascades) {
    throw InputError(
        fmt::format("ocean: {} cascades: must be 1 to {}", cascades, shared::kOceanMaxCascades));
  }
  return cascades;
}

gl::Buffer make_twiddles(int size) {
  std::vector<float> values;
  for (int j = 0; j < size; ++j) {
    values.push_back(static_cast<float>(std::cos(kTau * j / size)));
    values.push_back(static_cast<float>(std::sin(kTau * j / size)));
  }
  return gl::Buffer::of<float>("sea.twiddles", values);
}

std::size_t points(int cascades, int size) {
  return static_cast<std::size_t>(cascades) * static_cast<std::size_t>(size) *
         static_cast<std::size_t>(size);
}

}  // namespace

SeaMaps::SeaMaps(ShaderLibrary& shaders, int cascades, int size)
    : cascades_(checked_cascades(cascades)),
      size_(size),
      columns_(shaders.program({"ocean/columns.comp"}, fft_defines(size))),
      rows_(shaders.program({"ocean/rows.comp"}, fft_defines(size))),
      levels_(shaders.program({"ocean/levels.comp"})),
      modes_host_(points(cascades, size) * 4, 0.0f),
      grids_host_(static_cast<std::size_t>(cascades) * 4, 0.0f),
      twiddles_(make_twiddles(size)),
      modes_("sea.modes", modes_host_.size() * sizeof(float)),
      grids_("sea.grids", grids_host_.size() * sizeof(float)),
      // Four complex fields, of which half the rows carry waves.
      work_("sea.work", points(cascades, size) / 2 * 4 * 2 * sizeof(float), 0),
      displacement_("sea.displacement", {.format = GL_RGBA32F,
                                         .width = size,
                                         .height = size,
                                         .layers = cascades,
                                         .levels = shared::kOceanMapLevels}),
      slopes_("sea.slopes", {.format = GL_RGBA16F,
                             .width = size,
                             .height = size,
                             .layers = cascades,
                             .levels = shared::kOceanMapLevels}) {}

void SeaMaps::set_waves(std::span<const Cascade> cascades, double choppiness) {
  float* mode = modes_host_.data();
  float* grid = grids_host_.data();
  for (const Cascade& cascade : cascades) {
    for (int x = 0; x < size_; ++x) {  // the transform starts with columns: [x][z]
      for (int z = 0; z < size_; ++z) {
        const auto cell = static_cast<std::size_t>(z * size_ + x);
        const double turns = cascade.frequency[cell] / kTau;
        const auto high = static_cast<float>(turns);
        *mode++ = static_cast<float>(cascade.h0[cell].real());
        *mode++ = static_cast<float>(cascade.h0[cell].imag());
        *mode++ = high;
        *mode++ = static_cast<float>(turns - static_cast<double>(high));
      }
    }
    const double dk = kTau / cascade.band.length;
    *grid++ = static_cast<float>(dk * std::cos(cascade.band.angle));
    *grid++ = static_cast<float>(dk * std::sin(cascade.band.angle));
    *grid++ = static_cast<float>(choppiness);
    *grid++ = 0.0f;
  }
  ++waves_generation_;
}

SeaIds SeaMaps::add(FrameGraph& graph, double time) {
  const BufferId modes = graph.import(modes_), grids = graph.import(grids_);
  const BufferId work = graph.import(work_);
  const SeaIds ids{graph.import(displacement_), graph.import(slopes_)};

  graph.add(
      "sea.spectrum",
      [&](PassBuilder& pass) {
        pass.write(modes, Access::kTransfer).write(grids, Access::kTransfer);
        pass.cache(spectrum_memory_, waves_generation_);
      },
      [this](PassContext&) {
        modes_.write(modes_host_.data(), modes_host_.size() * sizeof(float));
        grids_.write(grids_host_.data(), grids_host_.size() * sizeof(float));
      });

  graph.add(
      "sea.fft",
      [&](PassBuilder& pass) {
        pass.read(modes).read(grids).write(work);
        pass.cache(fft_memory_, hash_of(time, waves_generation_, columns_.generation()));
      },
      [this, time](PassContext&) {
        modes_.bind_storage(0);
        twiddles_.bind_storage(1);
        work_.bind_storage(2);
        grids_.bind_storage(3);
        columns_.use();
        const auto bits = std::bit_cast<std::uint64_t>(time);
        columns_.program().set(0, glm::ivec2(static_cast<std::int32_t>(bits & 0xffffffffu),
                                             static_cast<std::int32_t>(bits >> 32)));
        glDispatchCompute(static_cast<GLuint>(size_ / 2), static_cast<GLuint>(cascades_), 1);
      });

  graph.add(
      "sea.maps",
      [&](PassBuilder& pass) {
        pass.read(work).write(ids.displacement).write(ids.slopes);
        pass.cache(maps_memory_, hash_of(rows_.generation(), levels_.generation()));
      },
      [this](PassContext&) {
        twiddles_.bind_storage(1);
        work_.bind_storage(2);
        displacement_.bind_image(0, GL_WRITE_ONLY);
        slopes_.bind_image(1, GL_WRITE_ONLY);
        rows_.use();
        glDispatchCompute(static_cast<GLuint>(size_), static_cast<GLuint>(cascades_), 1);
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
        levels_.use();
        for (const gl::Texture* map : {&displacement_, &slopes_}) {
          map->bind(0);
          for (int level = 1; level < shared::kOceanMapLevels; ++level) {
            map->bind_image(static_cast<GLuint>(level - 1), GL_WRITE_ONLY, level);
          }
          const auto groups = static_cast<GLuint>(size_ / 32);
          glDispatchCompute(groups, groups, static_cast<GLuint>(cascades_));
        }
      });
  return ids;
}

}  // namespace offing
