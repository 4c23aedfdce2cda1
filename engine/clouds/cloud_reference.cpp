#include "engine/clouds/cloud_reference.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "shaders/shared/bindings.h"

namespace offing {
namespace {

constexpr int kTile = 64;  // pixels on a side: some tenths of a second of work
// llvmpipe ends shaders that go through more than 65535 rounds of loops without a word: so many
// steps, of 194 rounds each, and one path at once stay below.
constexpr int kSteps = 4096, kStepsAtOnce = 256;

ShaderDefines defines() {
  // march.glsl wants its quality; the references only take its light.
  return {{"STEPS", "1"},    {"SKIPS", "1"},       {"LIGHT_STEPS", "1"},  {"FINEST", "10.0"},
          {"GROWTH", "0.0"}, {"REACH", "90000.0"}, {"CLOUDS_BRANCH", "1"}};
}

gl::Texture empty(const char* label, GLenum format, glm::ivec2 size) {
  gl::Texture texture(label, {.format = format, .width = size.x, .height = size.y});
  glClearTexImage(texture.id(), 0, format == GL_RGBA32F ? GL_RGBA : GL_RG, GL_FLOAT, nullptr);
  return texture;
}

template <class Work>
void for_tiles(glm::ivec2 size, Work work) {
  for (int y = 0; y < size.y; y += kTile) {
    for (int x = 0; x < size.x; x += kTile) {
      work(glm::ivec2(x, y));
      const int width = std::min(kTile, size.x - x), height = std::min(kTile, size.y - y);
      glDispatchCompute(static_cast<GLuint>((width + 7) / 8), static_cast<GLuint>((height + 7) / 8),
                        1);
      glFinish();
    }
  }
}

}  // namespace

CloudReference::CloudReference(ShaderLibrary& shaders)
    : march_program_(shaders.program({"clouds/reference.comp"}, defines())),
      path_program_(shaders.program({"clouds/pathtrace.comp"}, defines())) {}

CloudSightings CloudReference::march(FrameGraph& graph, const CloudField& field,
                                     const CloudIds& ids, const Sky& sky, const SkyIds& sky_ids,
                                     const CloudShadow& shadow, const CloudShadowIds& shadow_ids,
                                     glm::ivec2 size) const {
  const gl::Texture light = empty("cloud reference", GL_RGBA32F, size);
  const gl::Texture distance = empty("cloud reference distance", GL_RG32F, size);
  graph.add(
      "clouds.reference",
      [&](PassBuilder& pass) {
        ids.read_by(pass);
        sky_ids.read_by(pass);
        shadow_ids.read_by(pass);
        pass.side_effect();
      },
      [&, this](PassContext& context) {
        field.bind(context, ids);
        sky.bind(context, sky_ids);
        shadow.bind(context, shadow_ids);
        light.bind_image(0, GL_READ_WRITE);
        distance.bind_image(1, GL_READ_WRITE);
        march_program_.use();
        for (int step = 0; step < kSteps; step += kStepsAtOnce) {
          march_program_.program().set(1, glm::ivec2(step, kStepsAtOnce));
          for_tiles(size, [&](glm::ivec2 corner) { march_program_.program().set(0, corner); });
          glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
        }
      });
  graph.execute();
  CloudSightings seen{size, {}, {}};
  const std::vector<float> values = light.read_floats(4), metres = distance.read_floats(2);
  for (std::size_t i = 0; i < metres.size() / 2; ++i) {
    seen.light.emplace_back(values[4 * i], values[4 * i + 1], values[4 * i + 2], values[4 * i + 3]);
    seen.distance.push_back(metres[2 * i]);
  }
  return seen;
}

CloudSightings CloudReference::path_trace(FrameGraph& graph, const CloudField& field,
                                          const CloudIds& ids, const Sky& sky,
                                          const SkyIds& sky_ids, const CloudShadow& shadow,
                                          const CloudShadowIds& shadow_ids, glm::ivec2 size,
                                          int samples, int first) const {
  const gl::Texture sum = empty("cloud paths", GL_RGBA32F, size);
  const gl::Texture distance = empty("cloud path lengths", GL_RG32F, size);
  graph.add(
      "clouds.path_trace",
      [&](PassBuilder& pass) {
        ids.read_by(pass);
        sky_ids.read_by(pass);
        shadow_ids.read_by(pass);
        pass.side_effect();
      },
      [&, this](PassContext& context) {
        field.bind(context, ids);
        sky.bind(context, sky_ids);
        shadow.bind(context, shadow_ids);
        sum.bind_image(0, GL_READ_WRITE);
        distance.bind_image(1, GL_READ_WRITE);
        path_program_.use();
        for (int sample = first; sample < first + samples; ++sample) {
          path_program_.program().set(1, glm::ivec2(sample, 1));
          for_tiles(size, [&](glm::ivec2 corner) { path_program_.program().set(0, corner); });
          glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
        }
      });
  graph.execute();
  CloudSightings seen{size, {}, {}};
  const std::vector<float> values = sum.read_floats(4), metres = distance.read_floats(2);
  const float share = 1.0f / static_cast<float>(std::max(samples, 1));
  for (std::size_t i = 0; i < metres.size() / 2; ++i) {
    seen.light.push_back(
        glm::vec4(values[4 * i], values[4 * i + 1], values[4 * i + 2], values[4 * i + 3]) * share);
    seen.distance.push_back(metres[2 * i] / std::max(metres[2 * i + 1], 1.0f));
  }
  return seen;
}

}  // namespace offing
