#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "engine/clouds/cloud_field.h"
#include "engine/clouds/cloud_shadow.h"
#include "engine/sky/sky.h"

namespace offing {

/// What a picture of clouds costs.
struct CloudQuality {
  glm::ivec2 cell{4, 4};      ///< one pixel of such a cell is marched in a frame
  glm::ivec2 cut_cell{1, 1};  ///< and until each was once after a cut, or by lightning: one of such
  int steps = 40;             ///< most of a ray, in and near cloud
  int light_steps = 3;
  int light_steps_inside = 0;  ///< for an eye among the clouds; 0: as outside
  float finest = 45.0f;        ///< shortest step, m
  float growth = 0.011f;       ///< step over distance
  float reach = 70000.0f;      ///< m
  bool curl = true;            ///< edges drawn out by the wind
  // Switched off only to measure what they buy.
  float least = 0.008f;    ///< transmittance at which a ray ends; 0: never before its end
  bool skipping = true;    ///< longer steps where the field says that there is no cloud
  bool shadow_map = true;  ///< light from beyond the light steps
  /// 0 low, 1 medium, 2 high, 3 ultra.
  static CloudQuality of(int quality);
};

/// What the picture of this frame is seen through.
struct CloudCamera {
  glm::ivec2 size{1};
  glm::mat4 clip_from_relative{1.0f};
  glm::dvec3 eye{0.0};
  double exposure = 1.0;
};

/// The clouds of the picture: marched for a share of the pixels in each frame, the rest out of the
/// frames before.
class CloudMarch {
 public:
  CloudMarch(ShaderLibrary& shaders, const CloudQuality& quality);

  /// Adds clouds.march and clouds.resolve; returns radiance × exposure and transmittance (RGBA16F)
  /// at the size of the picture. After a cut, and in the first frame, all of it is made anew.
  /// Nothing runs where not `visible`.
  TextureId add(FrameGraph& graph, const CloudField& field, const CloudIds& ids, const Sky& sky,
                const SkyIds& sky_ids, const CloudShadow& shadow, const CloudShadowIds& shadow_ids,
                const CloudView& view, const CloudCamera& camera, bool visible);
  /// Adds clouds.composite: the clouds over the sky, and from among them or above over the sea too.
  void add_composite(FrameGraph& graph, const CloudField& field, const CloudIds& ids,
                     const Sky& sky, const SkyIds& sky_ids, TextureId seen, TextureId hdr,
                     TextureId depth, bool visible, bool from_below);

  const CloudQuality& quality() const { return quality_; }
  /// Where the light of each pixel comes from (m), of the last frame after a cut: one texel for
  /// each CloudQuality::cut_cell.
  const gl::Texture& distances() const { return anew_.distance; }

 private:
  /// What was marched of each cell.
  struct Marched {
    glm::ivec2 cell;
    const ShaderProgram& resolve;
    gl::Texture seen, distance;
  };

  void resize(glm::ivec2 size);
  /// Rows that are not marched, beneath the horizon, hold no cloud, whatever they held before.
  void empty_rows(int which, int rows);

  CloudQuality quality_;
  Marched in_turn_, anew_;
  const ShaderProgram& march_program_;
  const ShaderProgram& far_program_;
  const ShaderProgram& all_program_;
  gl::Sampler linear_;
  gl::VertexArray no_vertices_;
  gl::Texture pictures_[2];
  int empty_rows_[2] = {0, 0};
  int newest_ = 0;
  int turn_ = 0;          ///< which pixel of each cell comes next
  int anew_turn_ = 0;     ///< the same after a cut, of cut_cell; its number of pixels: done
  int still_frames_ = 0;  ///< since anything has changed
  bool known_ = false;
  bool flashing_before_ = false;
  std::uint64_t shown_ = 0, settings_ = 0;
  CloudCamera before_;
  int first_row_before_ = 0;
  glm::dvec2 carried_before_{0.0};
  PassMemory march_memory_, resolve_memory_;
};

}  // namespace offing
