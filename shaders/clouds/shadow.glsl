// What the clouds leave of sun and moon. Needs shared/frame.h before it.

// Share of the brighter light's illuminance that reaches a point, relative to the camera.
float cloud_shadow(vec3 relative) { return 1.0; }
