#pragma once
#include <glm/vec3.hpp>

#include <span>
#include <vector>

#include "engine/graph/frame_graph.h"
#include "engine/shader/shader_library.h"
#include "engine/sky/probe.h"

namespace offing {

/// What to ask of the probe: the radiance that a surface of this roughness (0 to 1) mirrors from a
/// direction (unit), or where it is below 0 the irradiance of a surface with this normal.
struct ProbeQuery {
  glm::vec3 direction{0.0f, 1.0f, 0.0f};
  float roughness = 0.0f;
};

/// cd/m^2, or lux.
struct ProbeAnswer {
  glm::vec3 reference;  ///< by brute force from the sky itself
  glm::vec3 probe;      ///< as probe.glsl has it
};

/// The oracle of the probe: each answer by `samples` looks at what the probe is made from, without
/// any of its maps. Slow, and waits for the GPU.
class ProbeReference {
 public:
  explicit ProbeReference(ShaderLibrary& shaders);

  /// Call within a pass that has declared both ids' read_by(), with FrameData bound. No clouds.
  std::vector<ProbeAnswer> ask(const PassContext& context, const Sky& sky, const SkyIds& sky_ids,
                               const Probe& probe, const ProbeIds& probe_ids,
                               std::span<const ProbeQuery> queries, int samples,
                               const std::optional<ProbeClouds>& clouds = {}) const;

 private:
  const ShaderProgram& program_;
  gl::Sampler linear_;
};

/// Root mean square over the answers of (probe - reference), over the mean of the reference; of the
/// three channels the worst.
double relative_rms(std::span<const ProbeAnswer> answers);

/// `count` directions spread evenly over the sphere, all of one roughness.
std::vector<ProbeQuery> queries_all_round(int count, float roughness);

}  // namespace offing
