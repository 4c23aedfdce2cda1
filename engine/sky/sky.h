#pragma once
#include <glm/mat4x4.hpp>

#include "engine/gl/buffer.h"
#include "engine/gl/program.h"
#include "engine/gl/texture.h"
#include "engine/graph/frame_graph.h"
#include "engine/shader/shader_library.h"
#include "engine/sky/sky_light.h"

namespace offing {

/// What sky.glsl reads, in this frame's graph.
struct SkyIds {
  TextureId sun, moon;  ///< sky views, each for 1 lux above the air
  TextureId transmittance;
  BufferId block;  ///< shared::SkyData
  /// Declares that a pass uses sky.glsl. Where it runs, Sky::bind() must be called.
  void read_by(PassBuilder& pass) const;
};

/// The sky view's table, of which half the azimuths stand for all, and the steps of its rays.
struct SkySettings {
  int width = 128, height = 96, steps = 30;
  /// 0 low to 3 ultra.
  static SkySettings of_quality(int quality);
};

/// The atmosphere in tables (Hillaire 2020) and what is drawn behind everything else.
class Sky {
 public:
  Sky(ShaderLibrary& shaders, const SkySettings& settings);
  Sky(ShaderLibrary& shaders, int quality) : Sky(shaders, SkySettings::of_quality(quality)) {}

  /// Brings the tables up to date: those of the air where haze has changed, the sky views where a
  /// light's elevation has (by 0.002 degrees) or the camera's height.
  SkyIds add_tables(FrameGraph& graph, const SkyLight& light);

  /// Fills the pixels of `hdr` that nothing has been drawn to (depth 0) with sky, discs, stars and
  /// distant sea, times exposure. FrameData must be bound. `visible`: see sky_in_view().
  void add_background(FrameGraph& graph, const SkyLight& light, const SkyIds& ids, TextureId hdr,
                      TextureId depth, bool visible);

  /// Binds the tables and the block for sky.glsl, within a pass that has declared ids.read_by().
  void bind(const PassContext& context, const SkyIds& ids) const;

 private:
  void add_view(FrameGraph& graph, const char* name, const gl::Texture& table, PassMemory& memory,
                double light_elevation, double height_km, glm::vec3 aerosol, bool needed,
                TextureId transmittance, TextureId multiscatter);

  const ShaderProgram& transmittance_program_;
  const ShaderProgram& multiscatter_program_;
  const ShaderProgram& view_program_;
  /// The two halves of the background for a sky of which it is known what there is of it.
  struct Dome {
    const ShaderProgram* sky;
    const ShaderProgram* sea;
  };
  const Dome& dome(const SkyLight& light) const;

  const ShaderProgram& sun_program_;
  const ShaderProgram& moon_program_;
  const ShaderProgram& stars_program_;
  const ShaderProgram& milky_way_program_;
  Dome domes_[2][3];  ///< [moon][PaletteMode]
  gl::Texture transmittance_, multiscatter_, sun_view_, moon_view_, milky_way_;
  gl::Sampler linear_, around_;
  gl::Buffer block_;
  gl::Buffer star_vertices_;
  gl::VertexArray star_array_, no_vertices_;
  int star_count_ = 0;
  PassMemory transmittance_memory_, multiscatter_memory_, sun_memory_, moon_memory_, block_memory_;
};

/// Whether any pixel of this camera can see above the sea's horizon.
bool sky_in_view(const glm::mat4& relative_from_clip, double camera_height);

}  // namespace offing
