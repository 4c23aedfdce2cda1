// Compiles a file of pure GLSL formulas (shaders/lib/*.glsl) as C++ in double precision, so that
// one text serves the picture and its proof. Say which file, then include this header:
//
//   #define OFFING_GLSL "shaders/lib/waves.glsl"
//   #include "engine/core/glsl_double.h"          // as often as there are files
//
// Its functions are then offing::glsl::…, local to the translation unit, with every `float` a
// double and vec2 … mat4 glm's double types. Such a file may use free functions, structs,
// overloads, loops and `const float kName = 1.0;`, but no swizzles of more than one component, no
// out or inout, no arrays made by a constructor, no samplers, and no `f` suffix; it does not
// include other files (an entry point, or the C++ file, includes what it needs in order).
#ifndef OFFING_CORE_GLSL_DOUBLE_H
#define OFFING_CORE_GLSL_DOUBLE_H
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

namespace offing::glsl {

using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;
using mat2 = glm::dmat2;
using mat3 = glm::dmat3;
using mat4 = glm::dmat4;
using glm::ivec2;
using glm::ivec3;
using glm::ivec4;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using uint = unsigned int;

using glm::abs, glm::ceil, glm::clamp, glm::floor, glm::fract, glm::isinf, glm::isnan, glm::max,
    glm::min, glm::mix, glm::mod, glm::round, glm::roundEven, glm::sign, glm::smoothstep, glm::step,
    glm::trunc;
using glm::acos, glm::acosh, glm::asin, glm::asinh, glm::atan, glm::atanh, glm::cos, glm::cosh,
    glm::degrees, glm::radians, glm::sin, glm::sinh, glm::tan, glm::tanh;
using glm::all, glm::any, glm::equal, glm::greaterThan, glm::greaterThanEqual, glm::lessThan,
    glm::lessThanEqual, glm::notEqual;
using glm::cross, glm::distance, glm::dot, glm::faceforward, glm::length, glm::normalize,
    glm::reflect, glm::refract;
using glm::determinant, glm::inverse, glm::matrixCompMult, glm::outerProduct, glm::transpose;
using glm::exp, glm::exp2, glm::inversesqrt, glm::log, glm::log2, glm::pow, glm::sqrt;

}  // namespace offing::glsl
#endif

#ifdef OFFING_GLSL
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-variable"
#ifdef __clang__
#pragma clang diagnostic ignored "-Wkeyword-macro"
#endif
namespace offing::glsl {
namespace {
#define float double
#include OFFING_GLSL
#undef float
}  // namespace
}  // namespace offing::glsl
#pragma GCC diagnostic pop
#undef OFFING_GLSL
#endif
