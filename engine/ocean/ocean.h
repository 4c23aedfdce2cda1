#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/environment/environment.h"
#include "engine/environment/squall_field.h"
#include "engine/gl/program.h"
#include "engine/graph/frame_graph.h"
#include "engine/ocean/foam_law.h"
#include "engine/ocean/foam_map.h"
#include "engine/ocean/foam_pattern.h"
#include "engine/ocean/gpu_moments.h"
#include "engine/ocean/sea.h"
#include "engine/ocean/sea_maps.h"
#include "engine/ocean/sea_mesh.h"
#include "engine/ocean/sea_state.h"
#include "engine/ocean/sea_water.h"
#include "engine/ocean/spectrum.h"
#include "engine/ocean/spray.h"
#include "engine/ocean/underwater.h"
#include "engine/shader/shader_library.h"

namespace offing {

struct OceanSettings {
  int cascades = 3;     ///< 1 to 5
  int size = 128;       ///< points per side of a cascade: 64, 128, 256 or 512
  int foam_size = 128;  ///< cells per side of the foam map's squares
  int mesh_cells = 8;   ///< per side of a mesh square; even; the mesh grows with its square
  /// Cascades that water queries know, from the longest on: two hold the waves down to some 3 m
  /// that move a boat, the same at every quality.
  int query_cascades = 2;
  int quality = 0;  ///< 0 low to 3 ultra, of what has no size of its own here

  /// 0 low, 1 medium, 2 high, 3 ultra.
  static OceanSettings of_quality(int quality);
};

/// From where the sea is looked at.
struct OceanView {
  glm::mat4 clip_from_relative{1.0f};          ///< as in shared::FrameData
  glm::dvec2 eye{0.0};                         ///< x, z of the camera in the world, m
  double eye_height = 2.0;                     ///< above the mean sea level, m
  double time = 0.0;                           ///< the sea's clock, s; foam grows older by it
  bool hull_in_view = false;                   ///< something stands in the water where one looks
  bool clouds = true;                          ///< there are some, whose shadow may fall on it
  double gusts = 0.0;                          ///< strength, 0 to 1
  glm::dvec2 gust_origin{0.0};                 ///< where the gust field's origin lies now, m
  std::shared_ptr<const SquallField> squalls;  ///< none if null
  glm::dvec2 squall_corner{0.0};               ///< where their grid begins, m
  double chlorophyll = 0.4;                    ///< of the water, mg/m^3
  Lens lens = Lens::kDry;
};

/// The sea: its waves, its picture, and where its surface is.
class Ocean {
 public:
  Ocean(ShaderLibrary& shaders, const OceanSettings& settings);

  /// Another sea at once: for a start. Computes waves (some ms) where any of this has changed, else
  /// does nothing.
  void set_sea(const SeaState& state, const Environment& environment, std::uint64_t seed);
  /// Another sea by and by: from a quarter second after `time` on (the sea's clock) it fades over
  /// in a second, in the picture and for what floats alike. To be called every frame: does nothing
  /// where nothing has changed, and waits for a fade that is under way.
  void turn_to(const SeaState& state, const Environment& environment, std::uint64_t seed,
               double time);

  /// Adds sea.spectrum, sea.fft, sea.maps for the sea's clock `time` (s) and, where floating things
  /// are told by the GPU and `readback`, sea.moment and sea.readback.
  SeaIds add_maps(FrameGraph& graph, double time, bool readback = true);
  /// Makes the water known around `time`. Waits: for starts only.
  void prime(FrameGraph& graph, double time);

  /// Adds sea.foam, sea.mesh, which finds what water each pixel shows, sea.hull where a hull
  /// stands in it, and sea.draw: its light into `hdr`
  /// (radiance × exposure) and `depth` (reversed). The frame's FrameData must be bound when the
  /// graph runs. They do not run where not `visible`. Nothing is drawn inside a hull: `dry`, a
  /// picture of the same size, holds 1 / distance to its near side and the distance to its far
  /// side. `solid`: the depth of what was drawn before, read where the lens is not dry. What it
  /// returns is for add_underwater().
  UnderwaterIds add_draw(FrameGraph& graph, const OceanView& view, const SeaIds& sea,
                         const LightAccess& sky, TextureId dry, TextureId solid, TextureId hdr,
                         TextureId depth, bool visible);
  /// Adds the spray of breaking crests over all that is drawn but the view from the water.
  void add_spray(FrameGraph& graph, const OceanView& view, const SeaIds& sea,
                 const LightAccess& sky, TextureId hdr, TextureId depth, bool visible);
  /// Adds the view from the water, last before tone mapping (underwater.h). Skipped while dry.
  void add_underwater(FrameGraph& graph, const UnderwaterView& view, const SeaIds& sea,
                      const LightAccess& sky, const UnderwaterIds& ids, TextureId hdr) const;

  /// Whether the near side of this view (its corners relative to the eye, m) lies in the water at
  /// `time`; `eye` in the world. Queries know the long waves only, so that next to the surface the
  /// answer is kCrossing.
  Lens lens(glm::dvec3 eye, std::span<const glm::vec3> corners, double time) const;

  /// Adds sea.foam alone, which add_draw() contains: the foam map for the view's place and time.
  TextureId add_foam(FrameGraph& graph, const OceanView& view, const SeaIds& sea, bool visible);

  /// The surface's maps, foam and parameters for a pass of one's own, for the view of add_foam().
  SurfaceAccess surface_access(const SeaIds& sea, TextureId foam) const;

  /// Takes in what has come back of the sea; never waits.
  void collect();
  /// Heights of the water for physics; safe from any thread.
  const WaterSurface& water() const { return water_; }

  const SeaStatistics& statistics() const { return statistics_; }
  /// Expected height variance of the waves that the cascades carry, m^2.
  double carried_variance() const;
  std::span<const Cascade> cascades() const { return cascades_; }
  double choppiness() const { return choppiness_; }
  const SlopeVariance& slope_variance() const { return slope_variance_; }
  const SeaMaps& maps() const { return maps_; }
  const Underwater& underwater() const { return underwater_; }
  const FoamMap& foam() const { return foam_map_; }
  const Spray& spray() const { return spray_; }
  const OceanSettings& settings() const { return settings_; }

 private:
  void make_grid();
  /// What a picture of the sea shows or not: each has its program, since a CPU renderer works on
  /// what an `if` leaves out.
  struct Shows {
    bool hull, squalls, streaks, clouds;
  };
  /// The picture's program, made when first asked for.
  const ShaderProgram& surface_program(const Shows& shows);
  void show(Sea sea);
  void choose_queries(int method);
  void fade(double time);
  std::shared_ptr<const QueryWaves> query_waves(std::span<const Cascade> cascades) const;
  /// Foam lies in rows from force 7 on, all over the sea at force 10: 0 to 1.
  double streaks() const;
  void update_block(const OceanView& view);
  void bind_surface(const PassContext& context, const SeaIds& sea) const;
  void show_squalls(const std::shared_ptr<const SquallField>& squalls);
  static void unbind_samplers();
  // The passes that add_draw() puts together.
  void add_mesh(FrameGraph& graph, const OceanView& view, const SeaIds& sea,
                std::vector<SeaMesh::Square> squares, TextureId dry, TextureId seen,
                TextureId depth);
  static void add_hull(FrameGraph& graph, TextureId hdr, TextureId hull, bool shows);
  TextureId add_horizon(FrameGraph& graph, const LightAccess& sky, bool visible) const;

  OceanSettings settings_;
  ShaderLibrary& shaders_;
  SeaMaps maps_;
  GpuMoments* gpu_moments_ = nullptr;  ///< of water_, where it asks the GPU
  SeaWater water_;
  SeaMesh mesh_;
  const ShaderProgram& mesh_program_;
  const ShaderProgram& mesh_about_hull_;            ///< leaves its inside dry
  const ShaderProgram& two_sided_mesh_program_;     ///< tells from which side water is seen
  std::array<const ShaderProgram*, 16> surface_{};  ///< see surface_program()
  const ShaderProgram& horizon_;                    ///< the sky's strip
  gl::Buffer vertices_, indices_, squares_, block_;
  gl::VertexArray array_, no_vertices_;
  gl::Sampler map_sampler_, level_sampler_, foam_sampler_;
  gl::Sampler line_sampler_, wrap_sampler_;
  FoamPatterns foam_;
  std::array<float, shared::kFoamLayers + 1> foam_crest_{};  ///< see OceanData
  gl::Texture gusts_, squalls_, roughness_;
  std::shared_ptr<const SquallField> squalls_shown_;
  FoamMap foam_map_;
  FoamLaw foam_law_;
  std::uint64_t shown_ = 0;  ///< counts show()
  Spray spray_;
  Underwater underwater_;
  int index_count_ = 0;

  std::uint64_t sea_key_ = 0;
  Sea from_, to_;       ///< what a fade goes from and to; empty outside
  double begin_ = 0.0;  ///< of the fade, the sea's clock
  bool fading_ = false;
  int queries_ = kDirectQueries;
  // What is shown now.
  std::vector<Cascade> cascades_;
  SeaStatistics statistics_;
  SlopeVariance slope_variance_;
  double choppiness_ = 1.0;
  double white_share_ = 0.0;
  double ripples_ = 0.0;  ///< see ripple_share()
  double wind_speed_ = 0.0;
  glm::dvec2 wind_to_{0.0, 1.0};
};

}  // namespace offing
