// Hull, deck, spars and wires: everything that does not bend.
#include "shared/frame.h"
#include "shared/boat.h"
#include "boat/light.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in float material;

layout(location = 0) uniform int node;

out Surface {
  vec3 relative;
  vec3 normal;
  vec3 uv_coverage;
  vec4 ambient;  // lux; w: what the clouds leave of the sun
  vec3 air;      // cd/m^2
  flat vec4 base;      // as BoatMaterial
  flat vec4 emission;
} surface;

void main() {
  mat4 boat_from_node = boat.boat_from_node[node];
  vec4 in_boat = boat_from_node * vec4(position, 1.0);
  vec3 turned = mat3(boat_from_node) * normal;
  float coverage = 1.0;
#ifdef LAMP
  // Its middle, and the way from there (m) in place of a normal; the smallest radius in u. As with a wire: never
  // less than a disc that has some pixel's middle in it, however small it should be.
  float distance = length((boat.relative_from_boat * in_boat).xyz);
  float grown = max(0.75 * distance * frame.camera.w / uv.x, 1.0);
  in_boat.xyz += turned * grown;
  turned = normalize(turned);
  coverage = 1.0 / (grown * grown);
#endif
#ifdef WIRE
  // A wire thinner than a pixel flickers. Draw it a pixel wide and as much fainter as that is too wide
  // (E. Persson, "Phone-wire AA", 2012). Its radius comes in u.
  float distance = length((boat.relative_from_boat * in_boat).xyz);
  float radius = max(uv.x, 0.6 * distance * frame.camera.w);
  in_boat.xyz += turned * (radius - uv.x);
  coverage = uv.x / radius;
#endif
  vec4 relative = boat.relative_from_boat * in_boat;
  surface.relative = relative.xyz;
  surface.normal = mat3(boat.relative_from_boat) * turned;
  surface.uv_coverage = vec3(uv, coverage);
  surface.ambient = vec4(ambient_illuminance(surface.normal), cloud_shadow(relative.xyz));
  surface.air = light_of_air(relative.xyz);
  surface.base = boat.materials[int(material)].base_colour;
  surface.emission = boat.materials[int(material)].emission;
  gl_Position = frame.clip_from_relative * relative;
}
