#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>

#include "engine/gl/buffer.h"
#include "engine/gl/program.h"
#include "engine/gl/texture.h"
#include "engine/graph/frame_graph.h"
#include "engine/shader/shader_library.h"

namespace offing {

/// Whether the lens is in the water.
enum class Lens : std::uint8_t { kDry, kCrossing, kSubmerged };

/// How a pass reaches the light of sky, probe and clouds and the boat's shadow, which lie above the
/// sea in the order of includes: what their shaders read is declared at set-up and bound when
/// drawing.
struct LightAccess {
  std::function<void(PassBuilder&)> declare;
  std::function<void(const PassContext&)> bind;
};

/// How a pass reaches what ocean/surface.glsl reads.
struct SurfaceAccess {
  std::function<void(PassBuilder&)> declare;
  std::function<void(const PassContext&)> bind;
  std::function<void()> unbind;
};

/// What of a frame the view from the water is made of; textures without an id are not needed.
struct UnderwaterIds {
  Lens lens = Lens::kDry;
  TextureId solid;   ///< depth of what was drawn before the sea
  TextureId below;   ///< the surface that wet pixels show
  TextureId beyond;  ///< crossing: height of the lens above the water
};

/// From where, and in what light, one looks about in the water.
struct UnderwaterView {
  glm::dvec3 eye{0.0};      ///< the camera in the world, m
  glm::dvec3 forward{0.0};  ///< unit
  glm::dvec3 sun_direction{0.0, 1.0, 0.0}, sun_illuminance{0.0};
  glm::dvec3 moon_direction{0.0, 1.0, 0.0}, moon_illuminance{0.0};
  glm::dvec3 sky_illuminance{0.0};  ///< lux, on a level plane
  double clarity = 24.0;            ///< Secchi depth, m
  bool boat_visible = true;         ///< her picture may be mirrored or seen through the surface
};

/// Light of the sea for a Secchi depth (m, held within 1.4 to 60): the chlorophyll (mg/m^3) of
/// water in which a white disc vanishes there.
double chlorophyll_of(double clarity);

/// How much longer (stops) an eye at this depth (m) adapts: by most of what daylight has lost in
/// green light.
double underwater_exposure_ev(double clarity, double depth);

/// The view from the water: fog, the surface from below, caustics, shafts of light. All of its
/// passes are skipped while the lens is dry.
class Underwater {
 public:
  /// `quality` 0 (low) to 3 (ultra): the fineness of caustics and shafts.
  Underwater(ShaderLibrary& shaders, int quality);

  /// Adds sea.split, which gives each pixel of a crossing lens to the air or the water. Returns
  /// what the air sees of the surface, and sets the rest in `ids`; other lenses see `seen` as it
  /// is.
  TextureId add_split(FrameGraph& graph, const SurfaceAccess& surface, TextureId seen,
                      UnderwaterIds* ids) const;
  /// Adds sea.caustics, sea.relight and sea.underwater, which change the wet pixels of `hdr`.
  void add(FrameGraph& graph, const UnderwaterView& view, const SurfaceAccess& surface,
           const LightAccess& sky, const UnderwaterIds& ids, TextureId hdr) const;

  /// Light gathered by the waves at kCausticLayers depths, over that under a level sea: for tests.
  const gl::Texture& caustics() const { return caustics_; }

 private:
  void update_block(const UnderwaterView& view) const;

  int texels_, row_;
  const ShaderProgram& split_;
  const ShaderProgram& gather_;
  const ShaderProgram& smooth_;
  const ShaderProgram* relight_[2];  ///< submerged, crossing
  const ShaderProgram* view_[2];
  gl::Buffer block_, gathered_;
  gl::Texture caustics_;
  gl::Sampler linear_;
  gl::VertexArray no_vertices_;
};

}  // namespace offing
