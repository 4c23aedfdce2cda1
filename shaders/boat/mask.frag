// Blended with MAX over all faces: nearest as 1/distance, farthest as distance.
in vec3 relative_position;
layout(location = 0) out vec2 near_far;

void main() {
  float distance_ = length(relative_position);
  near_far = vec2(1.0 / distance_, distance_);
}
