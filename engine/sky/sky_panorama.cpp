#include "engine/sky/sky_panorama.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/core/angles.h"
#include "shaders/shared/bindings.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/scattering.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

using glm::dvec3;

constexpr int kTransmittanceSteps = 64;

/// Light (lux, on a surface that faces it) from one direction, into its pixel.
void add_ray(Panorama& panorama, const dvec3& direction, const dvec3& lux) {
  const double turn = std::atan2(direction.x, -direction.z) / kTau;
  const double down = std::acos(std::clamp(direction.y, -1.0, 1.0)) / kPi;
  const int x = std::clamp(static_cast<int>((turn - std::floor(turn)) * panorama.width), 0,
                           panorama.width - 1);
  const int y = std::clamp(static_cast<int>(down * panorama.height), 0, panorama.height - 1);
  panorama.at(x, y) += lux / panorama.solid_angle(y);
}

/// A disc as many small equal parts of its area; those below the horizon are left out.
void add_disc(Panorama& panorama, const dvec3& toward, double radius, const dvec3& lux,
              double horizon, bool limb_darkened) {
  constexpr int kRings = 24, kSectors = 48;
  const dvec3 right = glm::normalize(
      glm::cross(std::abs(toward.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0), toward));
  const dvec3 above = glm::cross(toward, right);
  std::vector<std::pair<dvec3, dvec3>> rays;
  dvec3 total(0.0);
  for (int i = 0; i < kRings; ++i) {
    const double share = std::sqrt((i + 0.5) / kRings);
    for (int j = 0; j < kSectors; ++j) {
      const double a = kTau * (j + 0.5 * (i % 2)) / kSectors;
      const dvec3 d = glm::normalize(toward + std::tan(radius * share) *
                                                  (std::cos(a) * right + std::sin(a) * above));
      if (d.y < horizon) continue;
      const dvec3 weight = limb_darkened ? glsl::limb_darkening(share) : dvec3(1.0);
      rays.emplace_back(d, weight);
      total += weight;
    }
  }
  for (const auto& [d, weight] : rays) add_ray(panorama, d, lux * weight / total);
}

}  // namespace

dvec3 Panorama::direction(double x, double y) const {
  const double a = kTau * (x + 0.5) / width, z = kPi * (y + 0.5) / height;
  return {std::sin(a) * std::sin(z), std::cos(z), -std::cos(a) * std::sin(z)};
}

double Panorama::solid_angle(int y) const {
  return kTau / width * (std::cos(kPi * y / height) - std::cos(kPi * (y + 1) / height));
}

dvec3 Panorama::level_illuminance() const {
  dvec3 sum(0.0);
  for (int y = 0; 2 * y < height; ++y) {
    dvec3 row(0.0);
    for (int x = 0; x < width; ++x) {
      row += pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x)];
    }
    // The integral of the cosine over the row, exactly; of an odd height the middle row counts
    // half.
    const double top = kPi * y / height, bottom = std::min(kPi * (y + 1) / height, kPi / 2.0);
    sum +=
        row * (kPi / width * (std::sin(bottom) * std::sin(bottom) - std::sin(top) * std::sin(top)));
  }
  return sum;
}

Panorama sky_panorama(ShaderLibrary& shaders, FrameGraph& graph, Sky& sky, const SkyLight& light,
                      double wind_speed, int width, int height, const AddClouds& add_clouds) {
  const ShaderProgram& program = shaders.program({"sky/export.comp"});
  shared::FrameData frame{};
  light.fill(frame);
  frame.camera = {0.0f, static_cast<float>(light.camera_height), 0.0f, 1e-3f};
  frame.wind = {0.0f, 0.0f, 0.0f, static_cast<float>(wind_speed)};
  const gl::Buffer block("panorama frame", sizeof(frame));
  block.write(frame);
  Panorama panorama{width, height, {}};
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const gl::Buffer picture("panorama", count * sizeof(glm::vec4));
  const gl::Sampler linear("panorama clouds", GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE,
                           GL_CLAMP_TO_EDGE);
  block.bind_uniform(OFFING_BIND_FRAME);
  graph.begin_frame();
  const SkyIds ids = sky.add_tables(graph, light);
  const std::optional<ProbeClouds> clouds =
      add_clouds ? add_clouds(graph, ids) : std::optional<ProbeClouds>();
  graph.add(
      "sky.panorama",
      [&](PassBuilder& pass) {
        ids.read_by(pass);
        if (clouds) pass.read(clouds->map);
        pass.side_effect();
      },
      [&](const PassContext& context) {
        sky.bind(context, ids);
        if (clouds) {
          context.texture(clouds->map).bind(OFFING_UNIT_CLOUD_MAP);
          linear.bind(OFFING_UNIT_CLOUD_MAP);
        }
        picture.bind_storage(0);
        program.use();
        program.program().set(0, glm::ivec2(width, height));
        program.program().set(4, clouds ? 1 : 0);
        glDispatchCompute(static_cast<GLuint>((width + 15) / 16),
                          static_cast<GLuint>((height + 3) / 4), 1);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        std::vector<glm::vec4> values(count);
        picture.read(values.data(), values.size() * sizeof(glm::vec4));
        panorama.pixels.reserve(count);
        for (const glm::vec4& value : values) panorama.pixels.emplace_back(glm::vec3(value));
      });
  graph.execute();
  return panorama;
}

void add_discs(Panorama& panorama, const SkyLight& light) {
  const double horizon = -glsl::horizon_dip_sine(light.camera_height * 1e-3);
  if (light.sun_share > 0.0) {
    add_disc(panorama, light.sun_direction, light.sun_radius, light.sun_illuminance, horizon, true);
  }
  if (light.moon_share > 0.0) {
    add_disc(panorama, light.moon_direction, light.moon_radius, light.moon_illuminance, horizon,
             false);
  }
}

void add_stars(Panorama& panorama, const SkyLight& light, std::span<const Star> stars) {
  const glsl::Aerosol aerosol = glsl::aerosol_of_haze(light.haze);
  const double height = light.camera_height * 1e-3;
  const double horizon = -glsl::horizon_dip_sine(height);
  for (const Star& star : stars) {
    const dvec3 d = light.world_from_j2000 * star.direction;
    if (d.y < horizon) continue;
    const dvec3 air = glsl::srgb_from_bands(
        glsl::transmittance_to_top(aerosol, height, d.y, kTransmittanceSteps));
    const double lux = kStarLux * std::pow(10.0, -0.4 * star.magnitude) * light.star_share;
    add_ray(panorama, d, lux * air * star_colour(star.colour_index));
  }
}

}  // namespace offing
