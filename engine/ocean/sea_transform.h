#pragma once
#include <span>
#include <vector>

#include "engine/gl/buffer.h"
#include "engine/ocean/spectrum.h"
#include "engine/shader/shader_library.h"

namespace offing {

/// What the transforms of shaders/ocean/columns.comp and its rows need, whoever runs them.

/// The random waves of cascades of one size, laid out for columns.comp.
struct SeaModes {
  std::vector<float> modes;  ///< h0, frequency in turns as two floats; [cascade][x][z]
  std::vector<float> grids;  ///< dk cos, dk sin, choppiness, scale of Dxz; by cascade
};
SeaModes pack_modes(std::span<const Cascade> cascades, double choppiness);

/// Radices for grids of `size`² (64 to 512; InputError for others) and the number of complex
/// fields.
ShaderDefines transform_defines(int size, int fields);
/// Roots of unity from double precision.
gl::Buffer make_twiddles(int size);
/// Bytes of what columns hand to rows: half of the rows carry waves.
std::size_t work_bytes(int cascades, int size, int fields);
/// Groups of columns.comp (of size / 2 columns) or of rows (of size) for one cascade.
int groups_for(int lines, int size);
/// Tells columns.comp the sea's clock, s.
void set_time(const ShaderProgram& columns, double time);

}  // namespace offing
