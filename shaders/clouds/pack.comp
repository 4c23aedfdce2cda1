// The four channels of a noise volume by their weights, as one: what a march reads.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler3D volume;
layout(r8, binding = 0) uniform writeonly image3D target;
layout(location = 0) uniform vec4 weights;  // their absolute values sum to 1
layout(location = 1) uniform vec2 range;    // of the sum: what becomes 0 and 1

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (any(greaterThanEqual(texel, imageSize(target)))) return;
  float value = dot(texelFetch(volume, texel, 0), weights);
  value = clamp((value - range.x) / (range.y - range.x), 0.0, 1.0);
  imageStore(target, texel, vec4(value));
}
