// A drop cloud of the spray (spray.h). Places relative to the camera of its last step, y above the mean
// sea level, m.
struct Drop {
  vec4 place;     // w: age (s)
  vec4 velocity;  // w: how old it gets (s), 0: none
};
