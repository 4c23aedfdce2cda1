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

/// What a program leaves in its two images: four and two values a pixel.
struct Sums {
  std::vector<float> light, distance;
};

/// Runs a program over the picture once for each of `pieces`, which it gets as uniform 1.
Sums summed(FrameGraph& graph, const CloudSources& sources, const char* name,
            const ShaderProgram& program, glm::ivec2 size, const std::vector<glm::ivec2>& pieces) {
  const gl::Texture light = empty("cloud reference", GL_RGBA32F, size);
  const gl::Texture distance = empty("cloud reference distance", GL_RG32F, size);
  graph.add(
      name,
      [&](PassBuilder& pass) {
        sources.field_ids.read_by(pass);
        sources.sky_ids.read_by(pass);
        sources.shadow_ids.read_by(pass);
        pass.side_effect();
      },
      [&](PassContext& context) {
        sources.field.bind(context, sources.field_ids);
        sources.sky.bind(context, sources.sky_ids);
        sources.shadow.bind(context, sources.shadow_ids);
        light.bind_image(0, GL_READ_WRITE);
        distance.bind_image(1, GL_READ_WRITE);
        program.use();
        for (const glm::ivec2& piece : pieces) {
          program.program().set(1, piece);
          for_tiles(size, [&](glm::ivec2 corner) { program.program().set(0, corner); });
          glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
        }
      });
  graph.execute();
  return {light.read_floats(4), distance.read_floats(2)};
}

}  // namespace

CloudReference::CloudReference(ShaderLibrary& shaders)
    : march_program_(shaders.program({"clouds/reference.comp"}, defines())),
      path_program_(shaders.program({"clouds/pathtrace.comp"}, defines())) {}

CloudSightings CloudReference::march(FrameGraph& graph, const CloudSources& sources,
                                     glm::ivec2 size, bool smoothed) const {
  std::vector<glm::ivec2> pieces;
  for (int step = 0; step < kSteps; step += kStepsAtOnce) pieces.emplace_back(step, kStepsAtOnce);
  march_program_.program().set(2, smoothed ? 1.0f : 0.0f);
  const auto [light, metres] =
      summed(graph, sources, "clouds.reference", march_program_, size, pieces);
  CloudSightings seen{size, {}, {}};
  for (std::size_t i = 0; i < metres.size() / 2; ++i) {
    seen.light.emplace_back(light[4 * i], light[4 * i + 1], light[4 * i + 2], light[4 * i + 3]);
    seen.distance.push_back(metres[2 * i]);
  }
  return seen;
}

CloudSightings CloudReference::path_trace(FrameGraph& graph, const CloudSources& sources,
                                          glm::ivec2 size, int samples, int first) const {
  std::vector<glm::ivec2> pieces;
  for (int sample = first; sample < first + samples; ++sample) pieces.emplace_back(sample, 1);
  const auto [light, metres] =
      summed(graph, sources, "clouds.path_trace", path_program_, size, pieces);
  CloudSightings seen{size, {}, {}};
  const float share = 1.0f / static_cast<float>(std::max(samples, 1));
  for (std::size_t i = 0; i < metres.size() / 2; ++i) {
    seen.light.push_back(
        glm::vec4(light[4 * i], light[4 * i + 1], light[4 * i + 2], light[4 * i + 3]) * share);
    seen.distance.push_back(metres[2 * i] / std::max(metres[2 * i + 1], 1.0f));
  }
  return seen;
}

}  // namespace offing
