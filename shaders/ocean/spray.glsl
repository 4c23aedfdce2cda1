// A drop cloud of the spray (spray.h). Places relative to the camera of its last step, y above the mean
// sea level, m.
struct Drop {
  vec4 place;     // w: age (s)
  vec4 velocity;  // w: how old it gets (s), 0: none
};

// What half a cloud covers of the foam's pattern, along its way and across.
const vec2 kSprayTuft = vec2(0.1, 0.3);
