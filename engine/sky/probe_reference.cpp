#include "engine/sky/probe_reference.h"

#include <algorithm>
#include <cmath>

#include "engine/core/angles.h"
#include "shaders/shared/bindings.h"

namespace offing {

ProbeReference::ProbeReference(ShaderLibrary& shaders)
    : program_(shaders.program({"sky/probe_reference.comp"})),
      linear_("probe reference", GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE) {}

std::vector<ProbeAnswer> ProbeReference::ask(const PassContext& context, const Sky& sky,
                                             const SkyIds& sky_ids, const Probe& probe,
                                             const ProbeIds& probe_ids,
                                             std::span<const ProbeQuery> queries, int samples,
                                             const std::optional<ProbeClouds>& clouds) const {
  constexpr int kGroup = 32;
  // Mesa's software renderer ends all loops of an invocation after 65535 rounds, those within the
  // sky's functions included.
  constexpr int kBatch = 1024;
  static_assert(sizeof(ProbeQuery) == sizeof(glm::vec4));
  const gl::Buffer asked = gl::Buffer::of<ProbeQuery>("probe queries", queries);
  const gl::Buffer answered("probe answers", queries.size() * 2 * sizeof(glm::vec4));
  sky.bind(context, sky_ids);
  probe.bind(context, probe_ids);
  asked.bind_storage(0);
  answered.bind_storage(1);
  program_.use();
  program_.program().set(0, samples);
  program_.program().set(1, static_cast<int>(queries.size()));
  program_.program().set(4, clouds ? 1 : 0);
  if (clouds) {
    context.texture(clouds->map).bind(OFFING_UNIT_CLOUD_MAP);
    linear_.bind(OFFING_UNIT_CLOUD_MAP);
  }
  std::vector<glm::dvec4> sums(queries.size(), glm::dvec4(0.0));
  std::vector<glm::vec4> values(2 * queries.size());
  for (int first = 0; first < samples; first += kBatch) {
    program_.program().set(2, glm::ivec2(first, std::min(first + kBatch, samples)));
    glDispatchCompute(static_cast<GLuint>((queries.size() + kGroup - 1) / kGroup), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    answered.read(values.data(), values.size() * sizeof(glm::vec4));
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += glm::dvec4(values[2 * i]);
  }
  std::vector<ProbeAnswer> answers(queries.size());
  for (std::size_t i = 0; i < answers.size(); ++i) {
    answers[i] = {glm::vec3(glm::dvec3(sums[i]) / sums[i].w), glm::vec3(values[2 * i + 1])};
  }
  return answers;
}

double relative_rms(std::span<const ProbeAnswer> answers) {
  glm::dvec3 squares(0.0), sum(0.0);
  for (const ProbeAnswer& answer : answers) {
    const glm::dvec3 error = glm::dvec3(answer.probe) - glm::dvec3(answer.reference);
    squares += error * error;
    sum += glm::dvec3(answer.reference);
  }
  const auto count = static_cast<double>(answers.size());
  double worst = 0.0;
  for (int c = 0; c < 3; ++c)
    worst = std::max(worst, std::sqrt(squares[c] / count) / (sum[c] / count));
  return worst;
}

std::vector<ProbeQuery> queries_all_round(int count, float roughness) {
  // Swinbank & Purser's spiral: an equal share of the sphere for each.
  const double golden = kPi * (3.0 - std::sqrt(5.0));
  std::vector<ProbeQuery> queries;
  for (int i = 0; i < count; ++i) {
    const double y = 1.0 - 2.0 * (i + 0.5) / count, r = std::sqrt(1.0 - y * y);
    const glm::dvec3 d(r * std::cos(golden * i), y, r * std::sin(golden * i));
    queries.push_back({glm::vec3(d), roughness});
  }
  return queries;
}

}  // namespace offing
