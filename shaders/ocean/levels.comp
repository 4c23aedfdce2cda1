// Coarser levels 1 to 5 of a map, each point the mean of four, in one dispatch: a group reduces a
// tile of 32 × 32 points. (A chain of draws for each level and layer costs more than the transform.)
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2DArray map;
layout(binding = 0) uniform writeonly image2DArray levels[5];

shared vec4 tile[16][16];

void main() {
  ivec2 local = ivec2(gl_LocalInvocationID.xy), group = ivec2(gl_WorkGroupID.xy);
  int layer = int(gl_WorkGroupID.z);
  ivec2 source = 2 * (16 * group + local);
  vec4 mean = 0.25 * (texelFetch(map, ivec3(source, layer), 0) +
                      texelFetch(map, ivec3(source + ivec2(1, 0), layer), 0) +
                      texelFetch(map, ivec3(source + ivec2(0, 1), layer), 0) +
                      texelFetch(map, ivec3(source + ivec2(1, 1), layer), 0));
  imageStore(levels[0], ivec3(16 * group + local, layer), mean);
  tile[local.y][local.x] = mean;
  int width = 8;
  for (int level = 1; level < 5; ++level) {
    barrier();
    bool inside = local.x < width && local.y < width;
    if (inside) {
      ivec2 at = 2 * local;
      mean = 0.25 * (tile[at.y][at.x] + tile[at.y][at.x + 1] + tile[at.y + 1][at.x] +
                     tile[at.y + 1][at.x + 1]);
    }
    barrier();
    if (inside) {
      ivec3 texel = ivec3(width * group + local, layer);
      if (level == 1) imageStore(levels[1], texel, mean);
      if (level == 2) imageStore(levels[2], texel, mean);
      if (level == 3) imageStore(levels[3], texel, mean);
      if (level == 4) imageStore(levels[4], texel, mean);
      tile[local.y][local.x] = mean;
    }
    width /= 2;
  }
}
