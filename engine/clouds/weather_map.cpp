#include "engine/clouds/weather_map.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/clouds/weather_noise.h"
#include "engine/core/error.h"
#include "engine/core/random.h"
#include "engine/io/image.h"

#define OFFING_GLSL "shaders/lib/clouds.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

constexpr int kLargestPicture = 4096;

GLuint groups(int size) { return static_cast<GLuint>((size + 7) / 8); }

gl::Texture plane(const char* label, int side) {
  return {label, {.format = GL_RGBA8, .width = side, .height = side}};
}

Image read_weather_picture(const std::string& file) {
  constexpr const char* kKey = "clouds.weather_picture";
  try {
    Image image = read_image(file);
    if (image.width <= kLargestPicture && image.height <= kLargestPicture) return image;
    throw InputError(fmt::format("{}: is {}x{} pixels; keep to {} on a side", file, image.width,
                                 image.height, kLargestPicture));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{} = {}", kKey, error.what()));
  }
}

}  // namespace

double tallest_cloud(const Clouds& weather) {
  // Types scatter about the global one.
  return std::max(glsl::cloud_kind(std::min(weather.type + 0.15, 1.0)).thickness,
                  tallest_storm(weather));
}

double tallest_storm(const Clouds& weather) {
  return glsl::storm_thickness(weather.type, weather.precipitation);
}

WeatherMap::WeatherMap(ShaderLibrary& shaders)
    : weather_program_(shaders.program({"clouds/weather.comp"})),
      most_program_(shaders.program({"clouds/most.comp"})),
      weather_(plane("clouds weather", kTexels)),
      most_("clouds most", {.format = GL_R8, .width = kCells, .height = kCells}),
      picture_(plane("clouds weather picture", 1)),
      repeating_("clouds weather", GL_LINEAR, GL_LINEAR, GL_REPEAT, GL_REPEAT) {}

void WeatherMap::load_picture(const std::string& file) {
  if (file == picture_file_) return;
  glm::vec4 channels(0.0f);
  gl::Texture picture = plane("clouds weather picture", 1);
  if (!file.empty()) {
    const Image image = read_weather_picture(file);
    std::vector<std::uint8_t> texels(static_cast<std::size_t>(image.width) *
                                     static_cast<std::size_t>(image.height) * 4);
    const auto stored = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i * 4 < texels.size(); ++i) {
      for (std::size_t c = 0; c < std::min<std::size_t>(stored, 4); ++c) {
        const float value = image.pixels[i * stored + c];
        texels[4 * i + c] = static_cast<std::uint8_t>(
            std::lround(255.0 * std::clamp(std::isfinite(value) ? value : 0.0f, 0.0f, 1.0f)));
      }
    }
    for (int c = 0; c < std::min(image.channels, 4); ++c) channels[c] = 1.0f;
    picture = gl::Texture("clouds weather picture",
                          {.format = GL_RGBA8, .width = image.width, .height = image.height});
    picture.upload(GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  }
  picture_ = std::move(picture);
  picture_channels_ = channels;
  picture_file_ = file;
  memory_.reset();
}

WeatherMap::Ids WeatherMap::add(FrameGraph& graph, TextureId patterns, const Clouds& weather,
                                double elapsed, const CloudParameters& parameters,
                                std::uint64_t seed) {
  load_picture(parameters.weather_picture);
  const Ids ids{graph.import(weather_), graph.import(most_)};
  // In steps of the clock: the map costs a millisecond, and clouds change slowly.
  const double time = parameters.evolution * kStep * std::floor(elapsed / kStep);
  const WeatherOffsets at = weather_offsets(seed, time);
  const std::array<glm::vec4, 2> offsets = {glm::vec4(glm::dvec4(at.cells, at.finer)),
                                            glm::vec4(glm::dvec4(at.fronts, at.patches))};
  const bool drawn = !picture_file_.empty();
  const glm::vec4 state(
      glm::dvec4(weather.cover, weather.type, weather.precipitation, drawn ? 1.0 : 0.0));
  const glm::vec4 form(glm::dvec4(glsl::weather_threshold(weather.cover),
                                  parameters.density_threshold, parameters.roughness,
                                  tallest_cloud(weather)));
  const glm::vec2 storms(glm::dvec2(tallest_storm(weather), weather.precipitation));
  graph.add(
      "clouds.weather",
      [&](PassBuilder& pass) {
        pass.read(patterns)
            .write(ids.weather)
            .write(ids.most)
            .cache(memory_, hash_of(offsets, state, form, storms, weather_program_.generation(),
                                    most_program_.generation()));
      },
      [this, patterns, offsets, state, form, storms](const PassContext& context) {
        weather_program_.use();
        for (int i = 0; i < 2; ++i) {
          weather_program_.program().set(i, offsets[static_cast<std::size_t>(i)]);
        }
        weather_program_.program().set(2, state);
        weather_program_.program().set(3, picture_channels_);
        context.texture(patterns).bind(0);
        picture_.bind(1);
        repeating_.bind(0);
        repeating_.bind(1);
        weather_.bind_image(0, GL_WRITE_ONLY);
        glDispatchCompute(groups(kTexels), groups(kTexels), 1);
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
        most_program_.use();
        most_program_.program().set(0, form);
        most_program_.program().set(1, storms);
        weather_.bind(0);
        most_.bind_image(0, GL_WRITE_ONLY);
        glDispatchCompute(groups(kCells), groups(kCells), 1);
        glBindSampler(0, 0);
        glBindSampler(1, 0);
      });
  return ids;
}

}  // namespace offing
