#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/gl/buffer.h"
#include "engine/gl/program.h"
#include "engine/gl/texture.h"
#include "engine/graph/frame_graph.h"
#include "engine/shader/shader_library.h"
#include "engine/sky/probe_plan.h"
#include "engine/sky/sky.h"
#include "engine/sky/sky_light.h"

namespace offing {

/// What shaders/sky/probe.glsl reads, in this frame's graph.
struct ProbeIds {
  TextureId map;
  BufferId block;  ///< shared::ProbeData
  /// Declares that a pass uses probe.glsl. Where it runs, Probe::bind() must be called.
  void read_by(PassBuilder& pass) const;
};

/// Clouds as the probe takes them in: a hemi-octahedral map of the upper half of the sky as seen
/// from the boat (place of a direction: cloud_map_units() in shaders/lib/cloud_map.glsl). rgb:
/// radiance in cd/m^2, not multiplied by the exposure; a: share of the sky behind that shows.
struct ProbeClouds {
  TextureId map;
  std::uint64_t version = 0;  ///< another number whenever the map shows something else
};

struct ProbeSettings {
  int size = 192;   ///< texels per side of each half of level 0; a multiple of 32
  int slices = 64;  ///< frames over which a refresh is spread at most; a multiple of 4, 8 or more

  /// 0 low to 3 ultra.
  static ProbeSettings of_quality(int quality);
};

/// The reflection probe: sky, clouds and a mean sea as a surface at the camera mirrors them, for
/// thirteen roughnesses, and as it is lit by them (spherical harmonics).
///
/// While anything that it shows moves, a slice of the next generation is made in each frame; when
/// that is whole, what is shown moves over to it at an even pace during as many frames again. The
/// faster sun and moon move, the fewer frames: what is shown is of `2 frames()` frames ago.
/// Where nothing moves nothing is done. The first frame, and one after a leap in time or place,
/// makes it whole at once.
class Probe {
 public:
  Probe(ShaderLibrary& shaders, const ProbeSettings& settings);

  /// Adds sky.probe. The frame's FrameData must be bound when the graph runs, and say the same of
  /// the light as `light`. `wind_speed` in m/s roughens the mean sea. With
  /// `on` false the map holds the plain sky at every roughness and sky_irradiance() of sky.glsl,
  /// without clouds and sea: what is seen without a probe.
  ProbeIds add(FrameGraph& graph, const SkyLight& light, double wind_speed, const Sky& sky,
               const SkyIds& sky_ids, const std::optional<ProbeClouds>& clouds = {},
               bool on = true);

  /// Binds the map and the block for probe.glsl, within a pass that has declared ids.read_by().
  void bind(const PassContext& context, const ProbeIds& ids) const;

  const ProbeSettings& settings() const { return settings_; }
  /// Share of a whole refresh's work in each slice, estimated; the sum is 1.
  std::vector<double> slice_shares() const;
  /// Over how many frames the generation that was begun last is spread: settings().slices, or as
  /// many as let sun and moon go no further than 5 degrees meanwhile; 8 at least.
  int frames() const { return frames_; }
  const gl::Texture& map() const { return shown_; }

 private:
  enum class Kind : std::uint8_t { kCapture, kMips, kLevel, kSharpen, kIrradiance };
  /// One dispatch: some tiles of the plan, or all there is of mips and irradiance.
  struct Work {
    Kind kind;
    int first_tile, tiles;
    double cost;
    int slice;
  };
  /// What the probe depends on, coarse enough that a change of one step cannot be seen.
  struct State {
    glm::dvec3 sun, moon;
    double height, haze;
    bool clouds, on;
  };
  struct Generation {
    gl::Texture map;
    gl::Buffer irradiance;
  };
  struct Frame;

  void plan_work();
  void run(const Frame& frame, const PassContext& context);
  void run_slices(const Frame& frame, int first, int last, const Generation& into);
  void dispatch(const Work& work) const;
  void make_mips() const;
  void blend(int left);

  ProbeSettings settings_;
  const ShaderProgram& capture_;
  const ShaderProgram& mip_;
  const ShaderProgram& level_;
  const ShaderProgram& sharpen_;
  const ShaderProgram& irradiance_;
  const ShaderProgram& blend_;
  std::vector<Work> work_;
  gl::Texture shown_;
  gl::Texture sums_;  ///< the levels before they are sharpened
  ProbePlan plan_;
  gl::Texture places_, lists_, seen_;  ///< of the plan's nodes
  gl::Buffer block_, tiles_;
  Generation generations_[2];
  gl::Sampler linear_, nearest_;

  // Where the refresh stands; moved on only where the pass runs.
  int building_ = 0;       ///< which generation; the other one is whole
  int frames_ = 0;         ///< over which it is spread
  int frame_ = 0;          ///< of those, the next; frames_: none is being made
  int frames_shown_ = 0;   ///< over which the whole generation is brought in
  int blend_left_ = 0;     ///< frames until what is shown equals the whole generation
  bool on_ = true;         ///< of what is being made; off: the sky's tables as they are
  bool complete_ = false;  ///< there is a whole generation
  std::uint64_t key_ = 0;  ///< of the generation that was begun last
  State last_{};           ///< when the pass last ran
};

}  // namespace offing
