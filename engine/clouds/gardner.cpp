#include "engine/clouds/gardner.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/clouds/lay_over.h"
#include "engine/core/angles.h"
#include "engine/core/random.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/gardner.h"

#define OFFING_GLSL "shaders/lib/gardner.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

constexpr double kHighHeight = 8200.0, kMiddleHeight = 4100.0;  // m
constexpr double kCell = 1900.0;                                // m between cumuli
constexpr int kCellsAcross = 7;                                 // on either side of the camera
constexpr int kHeap = 7;                                        // ellipsoids of a cumulus at most
constexpr int kMostEllipsoids = (2 * kCellsAcross + 1) * (2 * kCellsAcross + 1) * kHeap;
constexpr int kDomeVertices = 96 * 3;  // as in sky/dome.vert
constexpr int kTileTexels = 512;       // of one period
// Pixels of high clouds are so many of the screen's wide and high: the plane is seen at a slant.
constexpr glm::ivec2 kHighCell{4, 2};

glm::vec4 pack(const glm::dvec3& v, double w) { return {glm::vec3(v), static_cast<float>(w)}; }
glm::vec4 pack(double x, double y, double z, double w) { return glm::vec4(glm::dvec4(x, y, z, w)); }

/// Into one period of the texture, which is two wavelengths.
double in_period(double wavelengths) { return wavelengths - 2.0 * std::floor(0.5 * wavelengths); }

/// Whether a layer of this share of the sky at that height is drawn: from below only.
bool shows(const GardnerView& view, double share, double height) {
  return view.sky_visible && share > 0.0 && view.eye.y < height - 100.0;
}

/// Place of the camera on a layer that the wind has carried so far, along and across it, in
/// wavelengths (m) of its texture.
glm::dvec2 place_in(const GardnerView& view, glm::dvec2 carried, glm::dvec2 wavelengths) {
  const glm::dvec2 place = glm::dvec2(view.eye.x, view.eye.z) - carried, to = view.wind_to;
  return {in_period(glm::dot(place, to) / wavelengths.x),
          in_period(glm::dot(place, glm::dvec2(-to.y, to.x)) / wavelengths.y)};
}

/// Thresholds: what the texture exceeds over the share of the sky that a layer covers.
shared::GardnerData gardner_data(const GardnerView& view, const SkyLight& light,
                                 double high_threshold, double middle_threshold) {
  const GardnerParameters& p = view.parameters;
  shared::GardnerData data{};
  const auto luminance = [](const glm::dvec3& c) {
    return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722));
  };
  // High clouds see the sun for some minutes after it has set here.
  const bool sun = light.sun_direction.y > -0.09 ||
                   luminance(light.sun_illuminance) >= luminance(light.moon_illuminance);
  data.light_direction = pack(sun ? light.sun_direction : light.moon_direction, 0.0);
  data.light_source = pack(sun ? light.sun_source : light.moon_source, 0.0);

  const glm::dvec2 to = view.wind_to;
  const double wavelength = 1000.0 * p.high_wavelength;
  const glm::dvec2 high =
      place_in(view, view.high_carried, glm::dvec2(p.high_stretch, 1.0) * wavelength);
  data.high = pack(high.x, high.y, 1.0 / wavelength, kHighHeight);
  data.high_wind = pack(to.x, to.y, p.high_stretch, p.contrast);
  const double ice = p.high_depth * (0.35 + 0.65 * view.weather.high);
  data.high_form = pack(high_threshold, p.high_range,
                        shows(view, view.weather.high, kHighHeight) ? ice : 0.0, p.terms);
  const double patches = 1000.0 * p.middle_wavelength;
  const glm::dvec2 middle = place_in(view, view.middle_carried, glm::dvec2(patches));
  data.middle = pack(middle.x, middle.y, 1.0 / patches, kMiddleHeight);
  data.middle_form =
      pack(middle_threshold, shows(view, view.weather.middle, kMiddleHeight) ? p.middle_depth : 0.0,
           0.0, 0.0);

  data.shading = pack(p.ambient, p.texture, p.specular, p.contrast);
  data.translucency = pack(p.threshold, p.limb_threshold, p.range, p.terms);
  const double low = 1000.0 * p.wavelength;
  data.pattern = pack(
      glm::dvec3(in_period((view.eye.x - view.low_carried.x) / low), in_period(view.eye.y / low),
                 in_period((view.eye.z - view.low_carried.y) / low)),
      1.0 / low);
  return data;
}

}  // namespace

std::vector<double> gardner_values(int terms, double contrast) {
  constexpr int kSide = 96;
  std::vector<double> values;
  values.reserve(kSide * kSide);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      values.push_back(glsl::gardner_texture(
          {2.0 * (x + 0.37) / kSide, 2.0 * (y + 0.61) / kSide, 0.0}, terms, contrast, 0.0));
    }
  }
  std::sort(values.begin(), values.end());
  return values;
}

std::vector<GardnerEllipsoid> gardner_cumuli(const GardnerView& view) {
  std::vector<GardnerEllipsoid> all;
  const glm::dvec2 eye = glm::dvec2(view.eye.x, view.eye.z) - view.low_carried;
  const auto cell_x = static_cast<std::int64_t>(std::floor(eye.x / kCell));
  const auto cell_z = static_cast<std::int64_t>(std::floor(eye.y / kCell));
  for (std::int64_t z = cell_z - kCellsAcross; z <= cell_z + kCellsAcross; ++z) {
    for (std::int64_t x = cell_x - kCellsAcross; x <= cell_x + kCellsAcross; ++x) {
      const auto stream = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ull ^
                          static_cast<std::uint64_t>(z) * 0xc2b2ae3d27d4eb4full;
      std::uint64_t count = 0;
      const auto random = [&] { return random_uniform(view.seed + 77, stream, count++); };
      if (random() >= view.weather.cover) continue;
      const double size = (0.35 + 0.65 * random()) * (0.6 + 0.6 * view.weather.cover);
      const glm::dvec2 middle((static_cast<double>(x) + random()) * kCell,
                              (static_cast<double>(z) + random()) * kCell);
      const int heap = 4 + static_cast<int>(random() * (kHeap - 3));
      for (int i = 0; i < heap; ++i) {
        const double turn = kTau * random(), out = i == 0 ? 0.0 : 620.0 * size * random();
        const double share = i == 0 ? 1.0 : 0.45 + 0.4 * random();
        const glm::dvec3 radii = glm::dvec3(720.0, 430.0, 720.0) * (size * share);
        const glm::dvec2 at = middle + out * glm::dvec2(std::cos(turn), std::sin(turn)) - eye;
        const double height = view.base + (0.35 + (i == 0 ? 0.0 : 0.9 * random())) * radii.y;
        const double drop = glm::dot(at, at) / (2.0 * 6.36e6);  // the earth is round
        all.push_back({glm::vec3(glm::dvec3(at.x, height - drop - view.eye.y, at.y)), 0.0f,
                       glm::vec3(radii), static_cast<float>(view.base)});
      }
    }
  }
  std::sort(all.begin(), all.end(), [](const GardnerEllipsoid& a, const GardnerEllipsoid& b) {
    return glm::dot(a.centre, a.centre) > glm::dot(b.centre, b.centre);
  });
  return all;
}

GardnerClouds::GardnerClouds(ShaderLibrary& shaders)
    : tile_program_(shaders.program({"clouds/gardner_tile.comp"})),
      high_program_(shaders.program({"sky/dome.vert", "clouds/high.frag"})),
      composite_program_(shaders.program({"sky/dome.vert", "clouds/composite.frag"})),
      ellipsoid_program_(shaders.program({"clouds/ellipsoid.vert", "clouds/ellipsoid.frag"})),
      block_("gardner block", sizeof(shared::GardnerData)),
      ellipsoids_("gardner ellipsoids", kMostEllipsoids * sizeof(GardnerEllipsoid)),
      ellipsoid_array_("gardner ellipsoids"),
      no_vertices_("gardner without vertices"),
      linear_("gardner high", GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE),
      repeating_("gardner tile", GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT, GL_REPEAT),
      tile_("gardner tile", {.format = GL_R16,
                             .width = kTileTexels,
                             .height = kTileTexels,
                             .levels = gl::full_mip_levels(kTileTexels, kTileTexels)}) {
  ellipsoid_array_.attribute(0, 4, ellipsoids_.id(), sizeof(GardnerEllipsoid), 0);
  ellipsoid_array_.attribute(1, 4, ellipsoids_.id(), sizeof(GardnerEllipsoid), sizeof(glm::vec4));
  glVertexArrayBindingDivisor(ellipsoid_array_.id(), 0, 1);
  glVertexArrayBindingDivisor(ellipsoid_array_.id(), 1, 1);
}

void GardnerClouds::add_high(FrameGraph& graph, const GardnerView& view, const Sky& sky,
                             const SkyIds& sky_ids, BufferId block, TextureId hdr, TextureId depth,
                             bool visible) {
  const glm::ivec2 size = (view.size + kHighCell - 1) / kHighCell;
  if (!high_ || glm::ivec2(high_.width(), high_.height()) != size) {
    high_ = {"gardner high", {.format = GL_RGBA16F, .width = size.x, .height = size.y}};
  }
  const TextureId tile = graph.import(tile_), picture = graph.import(high_);
  const GardnerParameters& p = view.parameters;
  graph.add(
      "clouds.high_tile",
      [&](PassBuilder& pass) {
        pass.write(tile);
        pass.cache(tile_memory_, hash_of(p.terms, p.contrast, tile_program_.generation()));
      },
      [this, terms = p.terms, contrast = static_cast<float>(p.contrast)](PassContext&) {
        tile_program_.use();
        tile_program_.program().set(0, terms);
        tile_program_.program().set(1, contrast);
        tile_.bind_image(0, GL_WRITE_ONLY);
        glDispatchCompute(kTileTexels / 8, kTileTexels / 8, 1);
        glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
        tile_.generate_mipmaps();
      });
  graph.add(
      "clouds.high",
      [&](PassBuilder& pass) {
        sky_ids.read_by(pass);
        pass.read(tile).read(block, Access::kUniform);
        pass.write(picture, Access::kAttachment).render_to({picture}).skip_if(!visible);
      },
      [this, &sky, sky_ids](const PassContext& context) {
        const float nothing[4] = {0.0f, 0.0f, 0.0f, 1.0f};
        glClearBufferfv(GL_COLOR, 0, nothing);
        sky.bind(context, sky_ids);
        block_.bind_uniform(OFFING_BIND_GARDNER);
        tile_.bind(0);
        repeating_.bind(0);
        glDisable(GL_DEPTH_TEST);
        no_vertices_.bind();
        high_program_.use();
        // A little beyond the horizon, for the filter between pixels.
        high_program_.program().set(0, static_cast<float>(kHighCell.y));
        high_program_.program().set(1, glm::vec2(kHighCell));
        glDrawArrays(GL_TRIANGLES, 0, kDomeVertices);
        glBindSampler(0, 0);
      });
  graph.add(
      "clouds.high_composite",
      [&](PassBuilder& pass) {
        sky_ids.read_by(pass);
        pass.read(picture).read(depth, Access::kAttachment).modify(hdr).render_to({hdr}, depth);
        pass.skip_if(!visible);
      },
      [this, &sky, sky_ids](const PassContext& context) {
        sky.bind(context, sky_ids);
        const LayOver over;
        high_.bind(0);
        linear_.bind(0);
        no_vertices_.bind();
        composite_program_.use();
        composite_program_.program().set(0, 1.0f);
        composite_program_.program().set(
            1, 1.0f / glm::vec2(glm::ivec2(high_.width(), high_.height()) * kHighCell));
        glDrawArrays(GL_TRIANGLES, 0, kDomeVertices);
      });
}

void GardnerClouds::add(FrameGraph& graph, const GardnerView& view, const SkyLight& light,
                        const Sky& sky, const SkyIds& sky_ids, TextureId hdr, TextureId depth) {
  const bool high = shows(view, view.weather.high, kHighHeight) ||
                    shows(view, view.weather.middle, kMiddleHeight);
  const bool heaps = view.sky_visible && view.ellipsoids && view.weather.cover > 0.0;
  const BufferId block = graph.import(block_);
  if (high || heaps) {
    const GardnerParameters& p = view.parameters;
    if (values_terms_ != p.terms || values_contrast_ != p.contrast) {
      values_ = gardner_values(p.terms, p.contrast);
      values_terms_ = p.terms;
      values_contrast_ = p.contrast;
    }
    const auto exceeded = [&](double share) {
      const double rank =
          (1.0 - std::clamp(share, 0.0, 1.0)) * static_cast<double>(values_.size() - 1);
      return values_[static_cast<std::size_t>(rank)];
    };
    const shared::GardnerData data =
        gardner_data(view, light, exceeded(view.weather.high), exceeded(view.weather.middle));
    graph.add(
        "clouds.gardner_block",
        [&](PassBuilder& pass) {
          pass.write(block, Access::kTransfer)
              .cache(block_memory_, hash_bytes(&data, sizeof(data)));
        },
        [this, data](PassContext&) { block_.write(data); });
  }
  add_high(graph, view, sky, sky_ids, block, hdr, depth, high);
  std::vector<GardnerEllipsoid> cumuli;
  if (heaps) cumuli = gardner_cumuli(view);
  graph.add(
      "clouds.ellipsoids",
      [&](PassBuilder& pass) {
        sky_ids.read_by(pass);
        pass.read(block, Access::kUniform).read(depth, Access::kAttachment).modify(hdr);
        pass.render_to({hdr}, depth).skip_if(cumuli.empty());
      },
      [this, &sky, sky_ids, cumuli](const PassContext& context) {
        ellipsoids_.write(cumuli.data(), cumuli.size() * sizeof(GardnerEllipsoid));
        sky.bind(context, sky_ids);
        block_.bind_uniform(OFFING_BIND_GARDNER);
        const LayOver over;
        ellipsoid_array_.bind();
        ellipsoid_program_.use();
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(cumuli.size()));
      });
}

}  // namespace offing
