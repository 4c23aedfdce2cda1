// Coarser levels 1 to 5 of a map, each point the mean of four, in one dispatch: a group reduces a
// tile of 32 × 32 points, a thread 4 × 4 of them. (A chain of draws for each level and layer costs more
// than the transform.)
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray map;
layout(binding = 0) uniform writeonly image2DArray levels[5];

shared vec4 second[8][8], third[4][4], fourth[2][2];

vec4 first_level(ivec2 at, int layer) {
  ivec2 source = 2 * at;
  vec4 mean = 0.25 * (texelFetch(map, ivec3(source, layer), 0) +
                      texelFetch(map, ivec3(source + ivec2(1, 0), layer), 0) +
                      texelFetch(map, ivec3(source + ivec2(0, 1), layer), 0) +
                      texelFetch(map, ivec3(source + ivec2(1, 1), layer), 0));
  imageStore(levels[0], ivec3(at, layer), mean);
  return mean;
}

#define MEAN(tile) \
  (0.25 * (tile[at.y][at.x] + tile[at.y][at.x + 1] + tile[at.y + 1][at.x] + tile[at.y + 1][at.x + 1]))

void main() {
  ivec2 local = ivec2(gl_LocalInvocationID.xy), group = ivec2(gl_WorkGroupID.xy);
  int layer = int(gl_WorkGroupID.z);
  ivec2 at = 2 * (8 * group + local);
  vec4 mean = 0.25 * (first_level(at, layer) + first_level(at + ivec2(1, 0), layer) +
                      first_level(at + ivec2(0, 1), layer) + first_level(at + ivec2(1, 1), layer));
  imageStore(levels[1], ivec3(8 * group + local, layer), mean);
  second[local.y][local.x] = mean;
  at = 2 * local;
  barrier();
  if (local.x < 4 && local.y < 4) {
    mean = MEAN(second);
    imageStore(levels[2], ivec3(4 * group + local, layer), mean);
    third[local.y][local.x] = mean;
  }
  barrier();
  if (local.x < 2 && local.y < 2) {
    mean = MEAN(third);
    imageStore(levels[3], ivec3(2 * group + local, layer), mean);
    fourth[local.y][local.x] = mean;
  }
  barrier();
  if (local.x == 0 && local.y == 0) imageStore(levels[4], ivec3(group, layer), MEAN(fourth));
}
