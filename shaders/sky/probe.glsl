// The light that arrives at the boat from all round, as reflections and as irradiance.
// Needs shared/frame.h and sky/sky.glsl before it.

// Mean radiance (cd/m^2) that a surface of this GGX roughness mirrors from `direction`.
vec3 probe_radiance(vec3 direction, float roughness) { return sky_radiance(direction); }

// Illuminance (lux) of a surface with this normal from sky and clouds, without sun and moon.
vec3 probe_irradiance(vec3 normal) { return sky_irradiance(normal); }
