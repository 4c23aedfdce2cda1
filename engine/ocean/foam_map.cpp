#include "engine/ocean/foam_map.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/core/random.h"
#include "engine/ocean/foam_law.h"
#include "shaders/shared/bindings.h"

namespace offing {
namespace {

constexpr double kFinestWidth = 51.2;  // m
constexpr double kLongestStep = 2.0;   // s; after longer ones the foam starts anew
constexpr double kLongestGap = 0.15;   // s; crests that break for less than this may be missed
constexpr int kGroup = 8;

double wrapped(double index, int size) { return index - size * std::floor(index / size); }

}  // namespace

FoamMap::FoamMap(ShaderLibrary& shaders, int size)
    : size_(size),
      program_(
          shaders.program({"ocean/foam.comp"}, {{"SIZE", std::to_string(size)},
                                                {"FRESH_SECONDS", std::to_string(kFreshSeconds)},
                                                {"THIN_SECONDS", std::to_string(kThinSeconds)}})),
      map_("sea.foam_map",
           {.format = GL_RG16F, .width = size, .height = size, .layers = shared::kFoamLayers}),
      block_("sea.foam_step", sizeof(shared::FoamData)) {}

double FoamMap::width(int layer) const { return std::ldexp(kFinestWidth, 2 * layer); }

std::uint64_t FoamMap::key(glm::dvec2 eye, double time, std::uint64_t sea_key) const {
  const double cell = width(0) / size_;
  return hash_of(time, std::floor(eye.x / cell), std::floor(eye.y / cell), sea_key,
                 program_.generation());
}

void FoamMap::run(glm::dvec2 eye, double time) {
  bool anew = false;
  for (const Slice& slice : slices_) {
    anew = anew || !slice.valid || time < slice.time || time > slice.time + kLongestStep;
    for (int layer = 0; layer < shared::kFoamLayers; ++layer) {
      const double cell = width(layer) / size_;
      const glm::dvec2 moved = glm::floor(eye / cell) - slice.cell[static_cast<std::size_t>(layer)];
      anew = anew || std::max(std::abs(moved.x), std::abs(moved.y)) > size_ / 16.0;
    }
  }
  program_.use();
  map_.bind_image(0, GL_READ_WRITE);
  block_.bind_uniform(OFFING_BIND_FOAM);
  // After a jump all rows at once: old ones stand for other places.
  const double step =
      time - slices_[static_cast<std::size_t>((next_ + kSlices - 1) % kSlices)].time;
  const int due = static_cast<int>(std::ceil(std::abs(step) * kSlices / kLongestGap));
  const int count = anew ? kSlices : std::clamp(due, 1, kSlices);
  for (int i = 0; i < count; ++i) {
    dispatch(eye, time, next_, anew);
    next_ = (next_ + 1) % kSlices;
  }
}

void FoamMap::dispatch(glm::dvec2 eye, double time, int number, bool anew) {
  Slice& slice = slices_[static_cast<std::size_t>(number)];
  anew = anew && (!slice.valid || time < slice.time || time > slice.time + kLongestStep);
  shared::FoamData data{};
  for (std::size_t l = 0; l < shared::kFoamLayers; ++l) {
    const double cell = width(static_cast<int>(l)) / size_;
    const glm::dvec2 now = glm::floor(eye / cell);
    const glm::dvec2 begin = now * cell - eye;
    const glm::dvec2 moved =
        anew ? glm::dvec2(size_)
             : glm::clamp(now - slice.cell[l], glm::dvec2(-size_), glm::dvec2(size_));
    data.cell[l] = glm::vec4(glm::dvec4(cell, std::log2(cell), begin.x, begin.y));
    data.place[l] =
        glm::vec4(glm::dvec4(wrapped(now.x, size_), wrapped(now.y, size_), moved.x, moved.y));
    slice.cell[l] = now;
  }
  data.step = glm::vec4(glm::dvec4(anew ? 0.0 : time - slice.time, number, kSlices, 0.0));
  slice.time = time;
  slice.valid = true;
  block_.write(data);
  glDispatchCompute(static_cast<GLuint>(size_ / kGroup),
                    static_cast<GLuint>(size_ / kSlices / kGroup), shared::kFoamLayers);
}

}  // namespace offing
