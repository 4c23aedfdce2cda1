#include "engine/ocean/underwater.h"

#include <algorithm>
#include <cmath>

#include "shaders/shared/bindings.h"
#include "shaders/shared/underwater.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/water.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/underwater.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

constexpr double kCausticWidth = 20.0;  // m of the sea whose light is gathered
constexpr GLuint kCausticUnit = 7;
constexpr int kCausticLevels = 5;

struct Fineness {
  int texels, steps;  // of the caustics' map, along a view's ray through them
};
constexpr Fineness kFineness[] = {{128, 6}, {192, 10}, {256, 16}, {384, 24}};

const Fineness& fineness(int quality) { return kFineness[std::clamp(quality, 0, 3)]; }

std::size_t map_bytes(int texels) {
  return static_cast<std::size_t>(texels) * static_cast<std::size_t>(texels) *
         shared::kCausticLayers * sizeof(std::uint32_t);
}

glm::vec4 pack(const glm::dvec3& v, double w) { return glm::vec4(glm::dvec4(v, w)); }

ShaderDefines view_defines(int quality, bool crossing) {
  ShaderDefines defines{{"STEPS", std::to_string(fineness(quality).steps)}};
  if (crossing) defines.emplace_back("CROSSING", "1");
  if (quality <= 0) defines.emplace_back("RIPPLES", "");  // as from above
  return defines;
}

ShaderDefines relight_defines(bool crossing) {
  return crossing ? ShaderDefines{{"CROSSING", "1"}} : ShaderDefines{};
}

void draw_all(const gl::VertexArray& no_vertices) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  no_vertices.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace

double chlorophyll_of(double clarity) {
  double low = std::log(0.01), high = std::log(30.0);
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    const bool clearer = glsl::secchi_depth(glsl::water_optics(std::exp(middle))) > clarity;
    (clearer ? low : high) = middle;
  }
  return std::exp(0.5 * (low + high));
}

double underwater_exposure_ev(double clarity, double depth) {
  if (depth <= 0.0) return 0.0;
  const glsl::WaterOptics water = glsl::water_optics(chlorophyll_of(clarity));
  const double lost = glsl::diffuse_attenuation(water, glsl::kDiffuseWay).y * depth / std::log(2.0);
  // From the surface on the view is of water, a stop or two darker than sea and sky.
  return std::min(0.8 * lost + 1.0 * -std::expm1(-depth), 7.0);
}

Underwater::Underwater(ShaderLibrary& shaders, int quality)
    : texels_(fineness(quality).texels),
      row_(2 * texels_),
      split_(shaders.program({"post/full_screen.vert", "ocean/underwater_split.frag"})),
      gather_(shaders.program({"ocean/caustics.comp"})),
      smooth_(shaders.program({"ocean/caustics_smooth.comp"})),
      relight_{&shaders.program({"post/full_screen.vert", "ocean/underwater_relight.frag"},
                                relight_defines(false)),
               &shaders.program({"post/full_screen.vert", "ocean/underwater_relight.frag"},
                                relight_defines(true))},
      view_{&shaders.program({"post/full_screen.vert", "ocean/underwater.frag"},
                             view_defines(quality, false)),
            &shaders.program({"post/full_screen.vert", "ocean/underwater.frag"},
                             view_defines(quality, true))},
      block_("underwater", sizeof(shared::UnderwaterData)),
      gathered_("underwater.gathered", map_bytes(texels_)),
      caustics_("underwater.caustics", {.format = GL_R16F,
                                        .width = texels_,
                                        .height = texels_,
                                        .layers = shared::kCausticLayers,
                                        .levels = kCausticLevels}),
      linear_("underwater.caustics", GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE,
              GL_CLAMP_TO_EDGE),
      no_vertices_("underwater") {
  const float even = 1.0f;
  for (int level = 0; level < kCausticLevels; ++level) {
    glClearTexImage(caustics_.id(), level, GL_RED, GL_FLOAT, &even);
  }
}

TextureId Underwater::add_split(FrameGraph& graph, const SurfaceAccess& surface, TextureId seen,
                                UnderwaterIds* ids) const {
  gl::TextureDesc line = graph.desc(seen);
  line.format = GL_R16F;
  const TextureId above = graph.create("sea.above", graph.desc(seen));
  const TextureId below = graph.create("sea.below", graph.desc(seen));
  const TextureId beyond = graph.create("sea.beyond", line);
  const bool crossing = ids->lens == Lens::kCrossing;
  graph.add(
      "sea.split",
      [&](PassBuilder& pass) {
        surface.declare(pass);
        pass.read(seen).read(ids->solid);
        pass.write(above, Access::kAttachment)
            .write(below, Access::kAttachment)
            .write(beyond, Access::kAttachment)
            .render_to({above, below, beyond})
            .skip_if(!crossing);
      },
      [this, surface, seen, solid = ids->solid](const PassContext& context) {
        surface.bind(context);
        context.texture(seen).bind(3);
        context.texture(solid).bind(4);
        split_.use();
        draw_all(no_vertices_);
        surface.unbind();
      });
  if (!crossing) return seen;
  ids->below = below;
  ids->beyond = beyond;
  return above;
}

void Underwater::update_block(const UnderwaterView& view) const {
  // Light counts by how much of it comes down through a level sea.
  const auto level = [](const glm::dvec3& direction, const glm::dvec3& illuminance) {
    const glsl::BentLight bent = glsl::bent_light(direction);
    return illuminance.y * bent.passing * bent.toward.y;
  };
  const bool by_day = level(view.sun_direction, view.sun_illuminance) >=
                      level(view.moon_direction, view.moon_illuminance);
  const glm::dvec3 above = by_day ? view.sun_direction : view.moon_direction;
  const glm::dvec3 bright = by_day ? view.sun_illuminance : view.moon_illuminance;
  const glsl::BentLight bent = glsl::bent_light(above);

  const glsl::WaterOptics water = glsl::water_optics(chlorophyll_of(view.clarity));
  const double direct = bright.y * bent.passing * bent.toward.y;
  const double diffuse = view.sky_illuminance.y + 1e-9;
  const double way =
      (direct / bent.toward.y + diffuse * glsl::kDiffuseWay) / std::max(direct + diffuse, 1e-9);
  const double depth = std::max(-view.eye.y, 0.0);

  shared::UnderwaterData data{};
  const glm::dvec3 fading = glsl::diffuse_attenuation(water, way);
  const glm::dvec3 glow = glsl::irradiance_reflectance(water) / glsl::kWaterPi;
  data.beam = pack(glsl::picture_attenuation(water), depth);
  data.diffuse = pack(fading, 0.0);
  data.glow = pack(glow, 0.0);
  data.once = pack(glow * (water.absorption + water.backscatter + fading), 0.0);
  data.light = pack(bent.toward, bent.passing);
  // Low rays cross the waves' shadows more than their slopes: what they draw loses contrast.
  const double drawn = std::clamp((above.y - 0.03) / 0.12, 0.0, 1.0);
  data.bright = pack(bright, direct > 0.0 ? drawn : 0.0);
  data.above = pack(above, view.boat_visible ? 1.0 : 0.0);
  // Most of it before the eye. The photons lie still in the world: waves pass them, not the eye.
  const double between = kCausticWidth / row_;
  const glm::dvec2 eye(view.eye.x, view.eye.z);
  const glm::dvec2 middle = 0.3 * kCausticWidth * glm::dvec2(view.forward.x, view.forward.z);
  const glm::dvec2 first = glm::floor((eye + middle) / between) * between - eye;
  data.caustics = glm::vec4(glm::dvec4(first, kCausticWidth, texels_));
  data.photons = glm::vec4(glm::dvec4(first - (0.5 * row_ - 0.5) * between, between, row_));
  block_.write(data);
}

void Underwater::add(FrameGraph& graph, const UnderwaterView& view, const SurfaceAccess& surface,
                     const LightAccess& sky, const UnderwaterIds& ids, TextureId hdr) const {
  const bool dry = ids.lens == Lens::kDry;
  const bool crossing = ids.lens == Lens::kCrossing;
  const BufferId block = graph.import(block_), gathered = graph.import(gathered_);
  const TextureId caustics = graph.import(caustics_);
  const bool lit = std::max(view.sun_illuminance.y, view.moon_illuminance.y) > 0.0;

  graph.add(
      "sea.caustics",
      [&](PassBuilder& pass) {
        surface.declare(pass);
        pass.write(block, Access::kTransfer).write(gathered).write(caustics).skip_if(dry);
      },
      [this, view, surface, lit](const PassContext& context) {
        update_block(view);
        if (!lit) return;
        const std::uint32_t none = 0;
        glClearNamedBufferData(gathered_.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        surface.bind(context);
        block_.bind_uniform(OFFING_BIND_UNDERWATER);
        gathered_.bind_storage(0);
        gather_.use();
        const auto groups = static_cast<GLuint>(row_ / 8);
        glDispatchCompute(groups, groups, 1);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        caustics_.bind_image(0, GL_WRITE_ONLY);
        smooth_.use();
        glDispatchCompute(groups / 2, groups / 2, shared::kCausticLayers);
        glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
        caustics_.generate_mipmaps();
        surface.unbind();
      });

  gl::TextureDesc shape = graph.desc(hdr);
  shape.format = GL_RGBA16F;
  const TextureId relit = graph.create("sea.relit", shape);
  const auto reads = [&](PassBuilder& pass) {
    sky.declare(pass);
    pass.read(ids.below).read(caustics).read(block, Access::kUniform);
  };
  graph.add(
      "sea.relight",
      [&](PassBuilder& pass) {
        reads(pass);
        pass.read(ids.solid).read(hdr).write(relit, Access::kAttachment).render_to({relit});
        pass.skip_if(dry);
      },
      [this, ids, caustics, hdr, crossing, bind_sky = sky.bind](const PassContext& context) {
        bind_sky(context);
        block_.bind_uniform(OFFING_BIND_UNDERWATER);
        context.texture(ids.below).bind(3);
        context.texture(ids.solid).bind(4);
        context.texture(hdr).bind(5);
        context.texture(caustics).bind(kCausticUnit);
        linear_.bind(kCausticUnit);
        relight_[crossing ? 1 : 0]->use();
        draw_all(no_vertices_);
        glBindSampler(kCausticUnit, 0);
      });

  graph.add(
      "sea.underwater",
      [&](PassBuilder& pass) {
        reads(pass);
        surface.declare(pass);
        pass.read(relit).modify(hdr).render_to({hdr}).skip_if(dry);
        if (crossing) pass.read(ids.beyond);
      },
      [this, ids, caustics, relit, crossing, surface,
       bind_sky = sky.bind](const PassContext& context) {
        surface.bind(context);
        bind_sky(context);
        block_.bind_uniform(OFFING_BIND_UNDERWATER);
        context.texture(ids.below).bind(3);
        context.texture(relit).bind(4);
        if (crossing) context.texture(ids.beyond).bind(5);
        context.texture(caustics).bind(kCausticUnit);
        linear_.bind(kCausticUnit);
        view_[crossing ? 1 : 0]->use();
        draw_all(no_vertices_);
        glBindSampler(kCausticUnit, 0);
        surface.unbind();
      });
}

}  // namespace offing
