#include "engine/ocean/sea_maps.h"

#include <fmt/core.h>

#include "engine/core/error.h"
#include "engine/core/random.h"
#include "shaders/shared/ocean.h"

namespace offing {
namespace {

constexpr int kFields = 4;  // eight real fields in four complex ones

int checked_cascades(int cascades) {
  if (cascades < 1 || cascades > shared::kOceanMaxCascades) {
    throw InputError(
        fmt::format("ocean: {} cascades: must be 1 to {}", cascades, shared::kOceanMaxCascades));
  }
  return cascades;
}

ShaderDefines row_defines(int size, MapStorage storage) {
  ShaderDefines defines = transform_defines(size, kFields);
  if (storage == MapStorage::kHalfSlopes) defines.emplace_back("HALF_SLOPES", "");
  return defines;
}

std::size_t float_bytes(MapStorage storage) {
  return storage == MapStorage::kHalfSlopes ? sizeof(float) / 2 : sizeof(float);
}

std::size_t points(int cascades, int size) {
  return static_cast<std::size_t>(cascades) * static_cast<std::size_t>(size) *
         static_cast<std::size_t>(size);
}

}  // namespace

SeaMaps::SeaMaps(ShaderLibrary& shaders, int cascades, int size, MapStorage storage)
    : cascades_(checked_cascades(cascades)),
      size_(size),
      storage_(storage),
      columns_(shaders.program({"ocean/columns.comp"}, transform_defines(size, kFields))),
      rows_(shaders.program({"ocean/rows.comp"}, row_defines(size, storage))),
      levels_(shaders.program({"ocean/levels.comp"})),
      twiddles_(make_twiddles(size)),
      modes_("sea.modes", points(cascades, size) * 4 * sizeof(float)),
      grids_("sea.grids", static_cast<std::size_t>(cascades) * 4 * sizeof(float)),
      work_("sea.work", work_bytes(cascades, size, kFields), 0),
      displacement_points_("sea.displacement points", points(cascades, size) * 4 * sizeof(float),
                           0),
      slope_points_("sea.slope points", points(cascades, size) * float_bytes(storage) * 4, 0),
      displacement_("sea.displacement", {.format = GL_RGBA32F,
                                         .width = size,
                                         .height = size,
                                         .layers = cascades,
                                         .levels = shared::kOceanMapLevels}),
      slopes_("sea.slopes", {.format = static_cast<GLenum>(
                                 storage == MapStorage::kHalfSlopes ? GL_RGBA16F : GL_RGBA32F),
                             .width = size,
                             .height = size,
                             .layers = cascades,
                             .levels = shared::kOceanMapLevels}) {}

void SeaMaps::set_waves(std::span<const Cascade> cascades, double choppiness) {
  packed_ = pack_modes(cascades, choppiness);
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
        modes_.write(packed_.modes.data(), packed_.modes.size() * sizeof(float));
        grids_.write(packed_.grids.data(), packed_.grids.size() * sizeof(float));
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
        set_time(columns_, time);
        glDispatchCompute(static_cast<GLuint>(groups_for(size_ / 2, size_)),
                          static_cast<GLuint>(cascades_), 1);
      });

  graph.add(
      "sea.maps",
      [&](PassBuilder& pass) {
        pass.read(work).read(grids).write(ids.displacement).write(ids.slopes);
        pass.cache(maps_memory_, hash_of(rows_.generation(), levels_.generation()));
      },
      [this](PassContext&) {
        twiddles_.bind_storage(1);
        work_.bind_storage(2);
        grids_.bind_storage(3);
        displacement_points_.bind_storage(4);
        slope_points_.bind_storage(5);
        rows_.use();
        glDispatchCompute(static_cast<GLuint>(groups_for(size_, size_)),
                          static_cast<GLuint>(cascades_), 1);
        glMemoryBarrier(GL_PIXEL_BUFFER_BARRIER_BIT);
        displacement_.copy_from(displacement_points_.id(), GL_RGBA, GL_FLOAT);
        slopes_.copy_from(slope_points_.id(), GL_RGBA,
                          storage_ == MapStorage::kHalfSlopes ? GL_HALF_FLOAT : GL_FLOAT);
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
