// For comparison only (bench ocean): one stage of a radix-2 transform along one axis, as most ocean
// demos do it: log2(N) dispatches for each direction, pictures read and written in turn, twiddle
// factors and indices from a table.
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0, rg32f) uniform readonly image2DArray from;
layout(binding = 1, rg32f) uniform writeonly image2DArray to;
layout(std430, binding = 0) readonly buffer Butterflies { vec4 butterflies[]; };  // twiddle, indices
layout(location = 0) uniform ivec2 stage_along_y;

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  int size = imageSize(to).x;
  bool along_y = stage_along_y.y != 0;
  vec4 butterfly = butterflies[stage_along_y.x * size + (along_y ? at.y : at.x)];
  int top = int(butterfly.z), bottom = int(butterfly.w);
  vec2 a = imageLoad(from, along_y ? ivec3(at.x, top, at.z) : ivec3(top, at.yz)).xy;
  vec2 b = imageLoad(from, along_y ? ivec3(at.x, bottom, at.z) : ivec3(bottom, at.yz)).xy;
  vec2 w = butterfly.xy;
  imageStore(to, at, vec4(a + vec2(w.x * b.x - w.y * b.y, w.x * b.y + w.y * b.x), 0.0, 0.0));
}
