#include "engine/clouds/cloud_noise.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "engine/clouds/noise_cache.h"
#include "engine/clouds/weather_noise.h"
#include "engine/core/random.h"

namespace offing {
namespace {

/// Of one channel, as clouds/noise.comp reads it.
struct Channel {
  glm::vec4 octaves;  ///< cells, octaves, persistence, lacunarity
  glm::vec4 kind;     ///< 0 cellular, 1 gradient, 2 both; 1 where inverted
};
using Channels = std::array<Channel, 4>;

constexpr Channels kShape = {{{{4, 3, 0.5f, 2}, {2, 1, 0, 0}},
                              {{7, 2, 0.5f, 2}, {0, 1, 0, 0}},
                              {{14, 2, 0.5f, 2}, {0, 1, 0, 0}},
                              {{28, 2, 0.5f, 2}, {0, 1, 0, 0}}}};
constexpr Channels kDetail = {{{{3, 1, 0.5f, 2}, {0, 1, 0, 0}},
                               {{6, 1, 0.5f, 2}, {0, 1, 0, 0}},
                               {{12, 1, 0.5f, 2}, {0, 1, 0, 0}},
                               {{4, 1, 0.5f, 2}, {1, 0, 0, 0}}}};

constexpr std::size_t cube(int side, std::size_t bytes) {
  return static_cast<std::size_t>(side) * static_cast<std::size_t>(side) *
         static_cast<std::size_t>(side) * bytes;
}
constexpr std::size_t square(int side, std::size_t bytes) {
  return static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * bytes;
}
constexpr std::size_t kShapeBytes = cube(CloudNoise::kShapeTexels, 4);
constexpr std::size_t kDetailBytes = cube(CloudNoise::kDetailTexels, 4);
constexpr std::size_t kCurlBytes = square(CloudNoise::kCurlTexels, 2);
constexpr std::size_t kWeatherBytes = square(CloudNoise::kWeatherTexels, 4);
constexpr std::size_t kAllBytes = kShapeBytes + kDetailBytes + kCurlBytes + kWeatherBytes;

std::uint64_t parameters_hash() {
  return hash_of(kShape, kDetail, CloudNoise::kShapeTexels, CloudNoise::kDetailTexels,
                 CloudNoise::kCurlTexels, CloudNoise::kWeatherTexels);
}

gl::Texture volume(const char* label, GLenum format, int side, int levels) {
  return {label,
          {.format = format, .width = side, .height = side, .depth = side, .levels = levels}};
}

GLuint groups(int size) { return static_cast<GLuint>((size + 7) / 8); }

void read(const gl::Texture& texture, GLenum format, GLenum type, char* to, std::size_t bytes) {
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(texture.id(), 0, format, type, static_cast<GLsizei>(bytes), to);
}

/// The sum's range that clouds use: what lies outside is saturated. Measured of the volumes above
/// as the 1st and 99th percentile of the default weights.
struct Weights {
  glm::vec4 share;
  glm::vec2 range;
};
Weights normalised(const glm::dvec4& weights, glm::vec2 range) {
  const double sum = std::max(weights.x + weights.y + weights.z + weights.w, 1e-6);
  return {glm::vec4(weights / sum), range};
}

}  // namespace

CloudNoise::CloudNoise(ShaderLibrary& shaders)
    : noise_program_(shaders.program({"clouds/noise.comp"})),
      curl_program_(shaders.program({"clouds/curl.comp"})),
      pack_program_(shaders.program({"clouds/pack.comp"})) {
  if (const std::optional<std::filesystem::path> folder = cache_folder()) {
    cache_file_ = *folder / "clouds.noise";
  }
  // Small until somebody needs them.
  const auto levels = [](int side) { return gl::full_mip_levels(side, side); };
  shape_channels_ = volume("clouds shape channels", GL_RGBA8, kShapeTexels, 1);
  detail_channels_ = volume("clouds detail channels", GL_RGBA8, kDetailTexels, 1);
  shape_ = volume("clouds shape", GL_R8, kShapeTexels, levels(kShapeTexels));
  detail_ = volume("clouds detail", GL_R8, kDetailTexels, levels(kDetailTexels));
  curl_ = {"clouds curl", {.format = GL_RG8_SNORM, .width = kCurlTexels, .height = kCurlTexels}};
  weather_ = {"clouds weather noise",
              {.format = GL_RGBA8, .width = kWeatherTexels, .height = kWeatherTexels}};
}

void CloudNoise::generate() const {
  noise_program_.use();
  const auto fill = [this](const gl::Texture& target, const Channels& channels) {
    for (int c = 0; c < 4; ++c) {
      noise_program_.program().set(c, channels[static_cast<std::size_t>(c)].octaves);
      noise_program_.program().set(4 + c, channels[static_cast<std::size_t>(c)].kind);
    }
    target.bind_image(0, GL_WRITE_ONLY);
    glDispatchCompute(groups(target.width()), groups(target.width()),
                      static_cast<GLuint>(target.width()));
  };
  fill(shape_channels_, kShape);
  fill(detail_channels_, kDetail);
  curl_program_.use();
  curl_.bind_image(0, GL_WRITE_ONLY);
  glDispatchCompute(groups(kCurlTexels), groups(kCurlTexels), 1);
  const std::vector<std::uint8_t> weather = make_weather_noise(kWeatherTexels);
  weather_.upload(GL_RGBA, GL_UNSIGNED_BYTE, weather.data());
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

std::string CloudNoise::contents() const {
  std::string bytes(kAllBytes, '\0');
  char* at = bytes.data();
  read(shape_channels_, GL_RGBA, GL_UNSIGNED_BYTE, at, kShapeBytes);
  read(detail_channels_, GL_RGBA, GL_UNSIGNED_BYTE, at += kShapeBytes, kDetailBytes);
  read(curl_, GL_RG, GL_BYTE, at += kDetailBytes, kCurlBytes);
  read(weather_, GL_RGBA, GL_UNSIGNED_BYTE, at += kCurlBytes, kWeatherBytes);
  return bytes;
}

void CloudNoise::make_or_load() {
  if (!cache_file_.empty()) {
    if (const auto kept = read_noise_cache(cache_file_, parameters_hash(), kAllBytes)) {
      const char* at = kept->data();
      shape_channels_.upload(GL_RGBA, GL_UNSIGNED_BYTE, at);
      detail_channels_.upload(GL_RGBA, GL_UNSIGNED_BYTE, at += kShapeBytes);
      curl_.upload(GL_RG, GL_BYTE, at += kDetailBytes);
      weather_.upload(GL_RGBA, GL_UNSIGNED_BYTE, at += kCurlBytes);
      return;
    }
  }
  generate();
  if (!cache_file_.empty()) write_noise_cache(cache_file_, parameters_hash(), contents());
}

CloudNoise::Ids CloudNoise::add(FrameGraph& graph, const CloudParameters& parameters) {
  const Ids ids{graph.import(shape_), graph.import(detail_), graph.import(curl_),
                graph.import(weather_)};
  const TextureId shape_channels = graph.import(shape_channels_);
  const TextureId detail_channels = graph.import(detail_channels_);
  graph.add(
      "clouds.noise",
      [&](PassBuilder& pass) {
        pass.write(shape_channels)
            .write(detail_channels)
            .write(ids.curl)
            .write(ids.weather)
            .cache(noise_memory_, hash_of(noise_program_.generation(), curl_program_.generation()));
      },
      [this](PassContext&) { make_or_load(); });

  const double* w = parameters.shape_weights;
  const Weights shape = normalised({w[0], w[1], w[2], w[3]}, {0.30f, 0.82f});
  const Weights detail = normalised(glm::dvec4(parameters.detail_weights, 0.0), {0.10f, 0.80f});
  graph.add(
      "clouds.pack",
      [&](PassBuilder& pass) {
        pass.read(shape_channels)
            .read(detail_channels)
            .write(ids.shape)
            .write(ids.detail)
            .cache(pack_memory_, hash_of(shape.share, detail.share, pack_program_.generation()));
      },
      [this, shape, detail](PassContext&) {
        pack_program_.use();
        const auto pack = [this](const gl::Texture& from, const gl::Texture& to,
                                 const Weights& weights) {
          pack_program_.program().set(0, weights.share);
          pack_program_.program().set(1, weights.range);
          from.bind(0);
          to.bind_image(0, GL_WRITE_ONLY);
          glDispatchCompute(groups(to.width()), groups(to.width()),
                            static_cast<GLuint>(to.width()));
          glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
          to.generate_mipmaps();
        };
        pack(shape_channels_, shape_, shape);
        pack(detail_channels_, detail_, detail);
      });
  return ids;
}

}  // namespace offing
