// The pixels whose stairs are smoothed, and what becomes of them. Of the C++ side engine/post/antialias.cpp.
const float kContrast = 0.04;  // of brightness as displayed: less is no stair

layout(std430, binding = 0) buffer Outlines {
  uint groups, one_y, one_z;  // of glDispatchComputeIndirect, 64 pixels each
  uint count;                 // found; those beyond the list's length stay as they are
  uvec2 pixels[];             // x + 65536 y; their new colour, RGBA8
} outlines;

float brightness(vec3 colour) { return dot(colour, vec3(0.299, 0.587, 0.114)); }
