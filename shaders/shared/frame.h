// What every pass of a frame may read. One struct for C++ and GLSL (std140: vec4 and mat4 only).
//
// Positions in shaders are relative to the camera ("relative"), so that nothing loses digits far
// from the origin: world = relative + camera, and only the CPU, in double, knows the world's x and z.
// Axes: x east, y up, z south; y = 0 is the mean sea level. Depth is reversed: 1 near, 0 infinitely far.
// Light: radiance in cd/m^2, illuminance in lux, as linear sRGB; what is written to the HDR picture
// is radiance × exposure.
#ifdef __cplusplus
#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
namespace offing::shared {
using glm::mat4;
using glm::vec4;
#endif

struct FrameData {
  mat4 clip_from_relative;
  mat4 relative_from_clip;
  vec4 viewport;           // width, height, 1/width, 1/height in pixels
  vec4 camera;             // x: 0, y: height above mean sea level (m), z: 0, w: pixel angle (rad)
  vec4 sun_direction;      // xyz: toward the sun; w: cosine of its angular radius
  vec4 sun_illuminance;    // rgb: lux at the camera on a surface facing it, after the atmosphere; w: share of the disc above the horizon
  vec4 moon_direction;     // as for the sun
  vec4 moon_illuminance;
  vec4 sky_illuminance;    // rgb: lux on a horizontal surface from the sky without the discs; w: unused
  vec4 wind;               // x, z: velocity at 10 m (m/s); y: gusts 0 to 1; w: speed at 10 m
  vec4 time;               // x: sea time modulo 4096 s, y: step of this frame (s), z: exposure, w: frame number
  vec4 haze;               // rgb: extinction of the air, mean of the way from the camera down to the sea (1/m); w: unused
  vec4 flash_direction;    // xyz: toward lightning inside a cloud; w: 1 - cosine of half the angle that it glows over; 0: none
  vec4 flash_illuminance;  // rgb: lux at the camera on a surface facing it
};

#ifdef __cplusplus
static_assert(sizeof(FrameData) == 320);
}  // namespace offing::shared
#else
layout(std140, binding = 0) uniform FrameBlock { FrameData frame; };
#endif
