#include "engine/sky/sky.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <span>

#include "engine/core/random.h"
#include "engine/sky/milky_way.h"
#include "engine/sky/stars.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/sky.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/scattering.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

constexpr int kTransmittanceWidth = 256, kTransmittanceHeight = 64, kMultiscatterSize = 32;

/// Steps in which a light's elevation is told apart: twilight changes by 0.1 % in one.
constexpr double kElevationStep = 0.002 * 3.14159265358979 / 180.0;
/// A light lower than this (19 degrees under the horizon) reaches no air that could scatter it
/// here.
constexpr double kLowestSine = -0.3256;

constexpr int kDomeVertices = 96 * 3;  // as in dome.vert

constexpr int kBandVertices = 72 * 20 * 6;  // as in milky_way.vert

constexpr float kGlareReach = 16.0f;  // as in moon.frag
constexpr float kCoronaReach = 8.0f;  // as in sun.frag
constexpr double kEarthshine = 0.25;  // cd/m^2 on the moon at new moon

gl::Texture cleared(const std::string& label, int width, int height) {
  gl::Texture texture(label, {.format = GL_RGBA32F, .width = width, .height = height});
  glClearTexImage(texture.id(), 0, GL_RGBA, GL_FLOAT, nullptr);
  return texture;
}

double luminance(const glm::dvec3& c) { return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722)); }

GLuint groups(int size) { return static_cast<GLuint>((size + 7) / 8); }

void dispatch_over(const gl::Texture& table) {
  table.bind_image(0, GL_WRITE_ONLY);
  glDispatchCompute(groups(table.width()), groups(table.height()), 1);
}

glm::vec4 pack(const glm::dvec3& v, double w) {
  return glm::vec4(glm::vec3(v), static_cast<float>(w));
}

/// The moon adds nothing that the eye could see while the sun is up.
bool lit_by_moon(const SkyLight& light) {
  return light.moon_direction.y > kLowestSine && light.sun_direction.y < 0.05;
}

/// One star as stars.vert reads it.
struct StarVertex {
  glm::vec4 direction_lux, tint_seed;
};

std::vector<StarVertex> star_vertices(const std::vector<Star>& stars) {
  std::vector<StarVertex> vertices;
  for (std::uint64_t i = 0; i < stars.size(); ++i) {
    const Star& star = stars[i];
    vertices.push_back({pack(star.direction, kStarLux * std::pow(10.0, -0.4 * star.magnitude)),
                        pack(star_colour(star.colour_index), random_uniform(7, 0, i))});
  }
  return vertices;
}

/// Toward a direction in the plane; any where it is the zenith.
glm::dvec2 heading(const glm::dvec3& direction) {
  const double length = std::hypot(direction.x, direction.z);
  return length > 1e-9 ? glm::dvec2(direction.x, direction.z) / length : glm::dvec2(1.0, 0.0);
}

}  // namespace

SkySettings SkySettings::of_quality(int quality) {
  constexpr SkySettings kQualities[] = {
      {80, 56, 20}, {128, 96, 30}, {192, 108, 36}, {256, 144, 48}};
  return kQualities[std::clamp(quality, 0, 3)];
}

void SkyIds::read_by(PassBuilder& pass) const {
  pass.read(sun).read(moon).read(transmittance).read(block, Access::kUniform);
}

Sky::Sky(ShaderLibrary& shaders, const SkySettings& settings)
    : transmittance_program_(shaders.program({"sky/transmittance.comp"})),
      multiscatter_program_(shaders.program({"sky/multiscatter.comp"})),
      view_program_(
          shaders.program({"sky/view.comp"}, {{"STEPS", std::to_string(settings.steps)}})),
      sun_program_(shaders.program({"sky/disc.vert", "sky/sun.frag"})),
      moon_program_(shaders.program({"sky/disc.vert", "sky/moon.frag"})),
      stars_program_(shaders.program({"sky/stars.vert", "sky/stars.frag"})),
      milky_way_program_(shaders.program({"sky/milky_way.vert", "sky/milky_way.frag"})),
      linear_("sky tables", GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE),
      around_("milky way", GL_LINEAR, GL_LINEAR, GL_REPEAT, GL_CLAMP_TO_EDGE),
      block_("sky block", sizeof(shared::SkyData)),
      star_array_("stars"),
      no_vertices_("sky without vertices") {
  for (int moon = 0; moon < 2; ++moon) {
    for (int mode = 0; mode < 3; ++mode) {
      const ShaderDefines what = {
          {"SKY_MOON", moon == 1 ? "1" : "0"},
          {"SKY_AIR", mode == static_cast<int>(PaletteMode::kReplace) ? "0" : "1"},
          {"SKY_PAINTED", mode == static_cast<int>(PaletteMode::kOff) ? "0" : "1"}};
      domes_[moon][mode] = {&shaders.program({"sky/dome.vert", "sky/background.frag"}, what),
                            &shaders.program({"sky/dome.vert", "sky/distant_sea.frag"}, what)};
    }
  }
  transmittance_ = cleared("sky transmittance", kTransmittanceWidth, kTransmittanceHeight);
  multiscatter_ = cleared("sky multiscatter", kMultiscatterSize, kMultiscatterSize);
  sun_view_ = cleared("sky view of the sun", settings.width, settings.height);
  moon_view_ = cleared("sky view of the moon", settings.width, settings.height);
  const std::vector<StarVertex> stars = star_vertices(load_stars(star_file()));
  star_count_ = static_cast<int>(stars.size());
  star_vertices_ = gl::Buffer::of<StarVertex>("stars", stars);
  star_array_.attribute(0, 4, star_vertices_.id(), sizeof(StarVertex), 0);
  star_array_.attribute(1, 4, star_vertices_.id(), sizeof(StarVertex), sizeof(glm::vec4));
  const MilkyWay milky_way = load_milky_way(milky_way_file());
  milky_way_ = gl::Texture("milky way",
                           {.format = GL_R8, .width = milky_way.width, .height = milky_way.height});
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  milky_way_.upload(GL_RED, GL_UNSIGNED_BYTE, milky_way.values.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void Sky::add_view(FrameGraph& graph, const char* name, const gl::Texture& table,
                   PassMemory& memory, double light_elevation, double height_km, glm::vec3 aerosol,
                   bool needed, TextureId transmittance, TextureId multiscatter) {
  const auto step = static_cast<std::int64_t>(std::llround(light_elevation / kElevationStep));
  const float sine = static_cast<float>(std::sin(static_cast<double>(step) * kElevationStep));
  const float height = static_cast<float>(height_km);
  graph.add(
      name,
      [&](PassBuilder& pass) {
        pass.read(transmittance)
            .read(multiscatter)
            .write(graph.import(table))
            .cache(memory, hash_of(step, height, view_program_.generation()))
            .skip_if(!needed);
      },
      [this, &table, aerosol, height, sine](PassContext&) {
        view_program_.use();
        view_program_.program().set(0, aerosol);
        view_program_.program().set(1, glm::vec2(height, sine));
        transmittance_.bind(OFFING_UNIT_TRANSMITTANCE);
        multiscatter_.bind(OFFING_UNIT_MULTISCATTER);
        linear_.bind(OFFING_UNIT_TRANSMITTANCE);
        linear_.bind(OFFING_UNIT_MULTISCATTER);
        dispatch_over(table);
      });
}

SkyIds Sky::add_tables(FrameGraph& graph, const SkyLight& light) {
  const glsl::Aerosol a = glsl::aerosol_of_haze(light.haze);
  const glm::vec3 aerosol(glm::dvec3(a.scattering, a.extinction, a.scale_height));
  SkyIds ids{graph.import(sun_view_), graph.import(moon_view_), graph.import(transmittance_),
             graph.import(block_)};
  const TextureId multiscatter = graph.import(multiscatter_);
  const bool air = light.painted.mode != PaletteMode::kReplace;

  graph.add(
      "sky.transmittance",
      [&](PassBuilder& pass) {
        pass.write(ids.transmittance)
            .cache(transmittance_memory_, hash_of(aerosol, transmittance_program_.generation()))
            .skip_if(!air);
      },
      [this, aerosol](PassContext&) {
        transmittance_program_.use();
        transmittance_program_.program().set(0, aerosol);
        dispatch_over(transmittance_);
      });
  graph.add(
      "sky.multiscatter",
      [&](PassBuilder& pass) {
        pass.read(ids.transmittance)
            .write(multiscatter)
            .cache(multiscatter_memory_, hash_of(multiscatter_program_.generation()))
            .skip_if(!air);
      },
      [this, aerosol](PassContext&) {
        multiscatter_program_.use();
        multiscatter_program_.program().set(0, aerosol);
        transmittance_.bind(OFFING_UNIT_TRANSMITTANCE);
        linear_.bind(OFFING_UNIT_TRANSMITTANCE);
        dispatch_over(multiscatter_);
      });

  // In steps, even near the sea: the boat's heave must not make the tables anew.
  const double coarse = light.camera_height < 100.0 ? 2.0 : 50.0;
  const double height_km = std::max(1.0, std::round(light.camera_height / coarse)) * coarse * 1e-3;
  const bool sun_lights = light.sun_direction.y > kLowestSine;
  const bool moon_lights = lit_by_moon(light);
  // The sun's view also holds what the air lets through of the night's glow: it is kept all night.
  add_view(graph, "sky.sun_view", sun_view_, sun_memory_,
           std::asin(std::max(light.sun_direction.y, kLowestSine)), height_km, aerosol, air,
           ids.transmittance, multiscatter);
  add_view(graph, "sky.moon_view", moon_view_, moon_memory_, std::asin(light.moon_direction.y),
           height_km, aerosol, air && moon_lights, ids.transmittance, multiscatter);

  shared::SkyData data{};
  const double dip = glsl::horizon_dip_sine(light.camera_height * 1e-3);
  data.sun_source = pack(sun_lights ? light.sun_source : glm::dvec3(0.0), light.sun_uncovered);
  data.moon_source = pack(moon_lights ? light.moon_source : glm::dvec3(0.0), light.moon_luminance);
  const glm::dvec2 to_sun = heading(light.sun_direction), to_moon = heading(light.moon_direction);
  data.azimuths = glm::vec4(glm::dvec4(to_sun.x, to_sun.y, to_moon.x, to_moon.y));
  data.night = pack(light.airglow, kEarthshine * (1.0 - light.moon_lit_fraction));
  data.umbra = pack(light.umbra_horizon, 0.0);
  data.observer = glm::vec4(
      glm::dvec4(light.camera_height * 1e-3, dip, std::sqrt(1.0 - dip * dip), light.star_share));
  const PaintedSky& painted = light.painted;
  data.lights = glm::vec4(glm::dvec4(moon_lights ? 1.0 : 0.0, painted.strength, air ? 1.0 : 0.0,
                                     painted.mode == PaletteMode::kOff ? 0.0 : 1.0));
  data.palette_zenith = pack(painted.zenith, 0.0);
  data.palette_middle = pack(painted.middle, 0.0);
  data.palette_horizon = pack(painted.horizon, 0.0);
  data.aerosol = glm::vec4(aerosol, 0.0f);
  data.table_texels =
      glm::vec4(static_cast<float>(sun_view_.width()), static_cast<float>(sun_view_.height()),
                static_cast<float>(kTransmittanceWidth), static_cast<float>(kTransmittanceHeight));
  data.world_from_j2000 = glm::mat4(glm::mat3(light.world_from_j2000));
  graph.add(
      "sky.block",
      [&](PassBuilder& pass) {
        pass.write(ids.block, Access::kTransfer)
            .cache(block_memory_, hash_bytes(&data, sizeof(data)));
      },
      [this, data](PassContext&) { block_.write(data); });
  return ids;
}

void Sky::bind(const PassContext& context, const SkyIds& ids) const {
  context.texture(ids.sun).bind(OFFING_UNIT_SKY_SUN);
  context.texture(ids.moon).bind(OFFING_UNIT_SKY_MOON);
  context.texture(ids.transmittance).bind(OFFING_UNIT_TRANSMITTANCE);
  for (GLuint unit : {OFFING_UNIT_SKY_SUN, OFFING_UNIT_SKY_MOON, OFFING_UNIT_TRANSMITTANCE}) {
    linear_.bind(unit);
  }
  context.buffer(ids.block).bind_uniform(OFFING_BIND_SKY);
}

const Sky::Dome& Sky::dome(const SkyLight& light) const {
  return domes_[lit_by_moon(light) ? 1 : 0][static_cast<int>(light.painted.mode)];
}

void Sky::add_background(FrameGraph& graph, const SkyLight& light, const SkyIds& ids, TextureId hdr,
                         TextureId depth, bool visible) {
  const auto declare = [&](PassBuilder& pass) {
    ids.read_by(pass);
    pass.read(depth, Access::kAttachment).modify(hdr).render_to({hdr}, depth);
  };
  const auto far_pixels_only = [] {
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GEQUAL);
    glDepthMask(GL_FALSE);
  };
  const auto body = [](const glm::dvec3& direction, double radius) {
    return glm::vec4(glm::vec3(direction), static_cast<float>(std::sin(radius)));
  };
  const glm::vec4 sun = body(light.sun_direction, light.sun_radius);
  const glm::vec4 moon = body(light.moon_direction, light.moon_radius);
  // Seen only where the moon leaves next to nothing of the sun: about 4 radii of it then.
  const bool corona = light.sun_uncovered < 1e-3;
  const bool sun_up = light.sun_share > 0.0, moon_up = light.moon_share > 0.0;
  graph.add(
      "sky.background",
      [&](PassBuilder& pass) {
        declare(pass);
        pass.skip_if(!visible);
      },
      [this, &light, ids, far_pixels_only, sun, moon, corona, sun_up,
       moon_up](PassContext& context) {
        far_pixels_only();
        bind(context, ids);
        no_vertices_.bind();
        glDisable(GL_BLEND);
        const Dome& halves = dome(light);
        halves.sky->use();
        halves.sky->program().set(0, 1.0f);
        glDrawArrays(GL_TRIANGLES, 0, kDomeVertices);

        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        if (sun_up) {
          sun_program_.use();
          sun_program_.program().set(0, sun);
          sun_program_.program().set(1, moon);
          sun_program_.program().set(2, glm::vec2(light.sun_flattening, corona ? 1.0 : 0.0));
          sun_program_.program().set(3, corona ? kCoronaReach : 1.0f);
          glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        }
        if (moon_up) {
          moon_program_.use();
          moon_program_.program().set(0, moon);
          moon_program_.program().set(1, pack(light.sun_from_moon, light.moon_flattening));
          moon_program_.program().set(2, pack(light.earth_shadow.axis, 0.0));
          moon_program_.program().set(3, light.star_share > 0.0 ? kGlareReach : 1.0f);
          moon_program_.program().set(
              6, glm::vec2(glm::dvec2(luminance(sunlight_on_the_moon(light.earth_shadow)),
                                      luminance(light.moon_illuminance))));
          moon_program_.program().set(
              4, glm::vec2(glm::dvec2(light.earth_shadow.umbra, light.earth_shadow.penumbra)));
          moon_program_.program().set(5,
                                      glm::mat4(glm::mat3(glm::transpose(light.world_from_moon))));
          glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        }
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        halves.sea->use();
        halves.sea->program().set(0, -1.0f);
        glDrawArrays(GL_TRIANGLES, 0, kDomeVertices);
        glDisable(GL_BLEND);
        glDepthMask(GL_TRUE);
      });
  graph.add(
      "sky.stars",
      [&](PassBuilder& pass) {
        declare(pass);
        pass.skip_if(!visible || light.star_share <= 0.0);
      },
      [this, &light, ids, far_pixels_only](PassContext& context) {
        far_pixels_only();
        bind(context, ids);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        milky_way_program_.use();
        const glm::dmat3 world_from_galactic =
            light.world_from_j2000 * glm::transpose(galactic_from_j2000());
        milky_way_program_.program().set(0, glm::mat4(glm::mat3(world_from_galactic)));
        milky_way_program_.program().set(
            1, pack(255.0 * MilkyWay::kUnit * milky_way_colour(), MilkyWay::kReach));
        milky_way_.bind(0);
        around_.bind(0);
        no_vertices_.bind();
        glDrawArrays(GL_TRIANGLES, 0, kBandVertices);

        stars_program_.use();
        star_array_.bind();
        glEnable(GL_PROGRAM_POINT_SIZE);
        glDrawArrays(GL_POINTS, 0, star_count_);
        glDisable(GL_BLEND);
        glDepthMask(GL_TRUE);
      });
}

bool sky_in_view(const glm::mat4& relative_from_clip, double camera_height) {
  // The directions below the horizon fill a cone narrower than a half space, so a picture whose
  // four corners lie in it lies in it whole.
  const double dip = glsl::horizon_dip_sine(std::max(camera_height, 0.0) * 1e-3);
  for (const glm::vec2 corner : {glm::vec2(-1, -1), {1, -1}, {-1, 1}, {1, 1}}) {
    const glm::vec4 p = relative_from_clip * glm::vec4(corner, 1.0f, 1.0f);
    const glm::vec3 d = glm::normalize(glm::vec3(p) / p.w);
    if (d.y > -dip) return true;
  }
  return false;
}

}  // namespace offing
