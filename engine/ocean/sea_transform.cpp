#include "engine/ocean/sea_transform.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/core/angles.h"
#include "engine/core/error.h"

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

// Dxz rides with h in one transform: scaled to its size, so that neither drowns in the other's
// rounding. A power of two costs no digits.
double shear_scale(const Cascade& cascade) {
  double height = 0.0, shear = 0.0;
  for (int z = 0; z < cascade.size; ++z) {
    for (int x = 0; x < cascade.size; ++x) {
      const double energy = std::norm(cascade.h0[static_cast<std::size_t>(z * cascade.size + x)]);
      if (energy == 0.0) continue;
      const glm::dvec2 k = cascade.wave_vector(x, z);
      height += energy;
      shear += energy * k.x * k.x * k.y * k.y / (k.x * k.x + k.y * k.y);
    }
  }
  if (!(shear > 0.0)) return 1.0;
  return std::exp2(std::round(0.5 * std::log2(height / shear)));
}

}  // namespace

SeaModes pack_modes(std::span<const Cascade> cascades, double choppiness) {
  SeaModes packed;
  for (const Cascade& cascade : cascades)
    packed.modes.reserve(4 * cascades.size() * cascade.h0.size());
  for (const Cascade& cascade : cascades) {
    const int size = cascade.size;
    for (int x = 0; x < size; ++x) {  // the transform starts with columns: [x][z]
      for (int z = 0; z < size; ++z) {
        const auto cell = static_cast<std::size_t>(z * size + x);
        const double turns = cascade.frequency[cell] / kTau;
        const auto high = static_cast<float>(turns);
        packed.modes.insert(packed.modes.end(),
                            {static_cast<float>(cascade.h0[cell].real()),
                             static_cast<float>(cascade.h0[cell].imag()), high,
                             static_cast<float>(turns - static_cast<double>(high))});
      }
    }
    const double dk = kTau / cascade.band.length;
    packed.grids.insert(packed.grids.end(),
                        {static_cast<float>(dk * std::cos(cascade.band.angle)),
                         static_cast<float>(dk * std::sin(cascade.band.angle)),
                         static_cast<float>(choppiness), static_cast<float>(shear_scale(cascade))});
  }
  return packed;
}

ShaderDefines transform_defines(int size, int fields) {
  const auto [a, b] = radices(size);
  return {{"RADIX_A", std::to_string(a)},
          {"RADIX_B", std::to_string(b)},
          {"FIELDS", std::to_string(fields)}};
}

gl::Buffer make_twiddles(int size) {
  std::vector<float> values;
  for (int j = 0; j < size; ++j) {
    values.push_back(static_cast<float>(std::cos(kTau * j / size)));
    values.push_back(static_cast<float>(std::sin(kTau * j / size)));
  }
  return gl::Buffer::of<float>("sea.twiddles", values);
}

std::size_t work_bytes(int cascades, int size, int fields) {
  return static_cast<std::size_t>(cascades) * static_cast<std::size_t>(size) *
         static_cast<std::size_t>(size) / 2 * static_cast<std::size_t>((fields + 1) / 2) * 4 *
         sizeof(float);
}

int groups_for(int lines, int size) {
  // As fft.glsl: 32 threads where shared memory holds that many lines.
  const auto [a, b] = radices(size);
  return size > 256 ? lines : lines * std::min(a, b) / 32;
}

void set_time(const ShaderProgram& columns, double time) {
  const auto bits = std::bit_cast<std::uint64_t>(time);
  columns.program().set(0, glm::ivec2(static_cast<std::int32_t>(bits & 0xffffffffu),
                                      static_cast<std::int32_t>(bits >> 32)));
}

}  // namespace offing
