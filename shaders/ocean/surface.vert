// One triangle over the whole picture, and for its pixels what is the same for all of them. (Worked out once;
// and a CPU renderer reads a block's floats for each pixel, one by one, which flat values spare it.)
#include "shared/frame.h"
#include "shared/bindings.h"
#include "shared/ocean.h"
#include "sky/probe.glsl"

layout(location = 0) out vec3 way;           // away from the eye, of any length
layout(location = 1) flat out vec4 light_time;    // toward the brighter of sun and moon; sea time
layout(location = 2) flat out vec4 direct_exposure;   // its illuminance before clouds; exposure
layout(location = 3) flat out vec4 diffuse_height;  // illuminance from the sky, clouds included; height of the eye
layout(location = 4) flat out vec4 haze;     // extinction of the air
#ifdef FLAT_OCEAN
layout(std140, binding = OFFING_BIND_OCEAN) uniform OceanBlock { OceanData block; };
layout(location = 5) flat out OceanData ocean;
#endif

void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
  vec4 far = frame.relative_from_clip * vec4(gl_Position.xy, 1.0, 1.0);
  way = far.xyz * sign(far.w);
  // While the sun is up the moon is lost in it.
  vec3 sun = frame.sun_illuminance.rgb, moon = frame.moon_illuminance.rgb;
  bool by_day = sun.g >= moon.g;
  light_time = vec4(by_day ? frame.sun_direction.xyz : frame.moon_direction.xyz, frame.time.x);
  direct_exposure = vec4(by_day ? sun : moon, frame.time.z);
  diffuse_height = vec4(probe_irradiance(vec3(0.0, 1.0, 0.0)), frame.camera.y);
  haze = frame.haze;
#ifdef FLAT_OCEAN
  ocean = block;
#endif
}
