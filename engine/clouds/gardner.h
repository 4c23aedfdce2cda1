#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

#include "engine/clouds/gardner_parameters.h"
#include "engine/environment/environment.h"
#include "engine/gl/buffer.h"
#include "engine/gl/program.h"
#include "engine/gl/texture.h"
#include "engine/graph/frame_graph.h"
#include "engine/shader/shader_library.h"
#include "engine/sky/sky.h"
#include "engine/sky/sky_light.h"

namespace offing {

/// What Gardner's clouds are drawn from.
struct GardnerView {
  Clouds weather;                  ///< cover, middle and high
  glm::dvec2 low_carried{0.0};     ///< how far the wind has carried the cumuli (x, z; m)
  glm::dvec2 middle_carried{0.0};  ///< and the altocumulus
  glm::dvec2 high_carried{0.0};    ///< and the cirrus
  glm::dvec2 wind_to{0.0, 1.0};    ///< unit (x, z)
  glm::dvec3 eye{0.0};             ///< the camera in the world, m
  glm::ivec2 size{1};              ///< of the picture, pixels
  double base = 700.0;             ///< of cumuli, m
  bool ellipsoids = false;         ///< whether cumuli are drawn this way
  bool sky_visible = true;
  std::uint64_t seed = 1;
  GardnerParameters parameters;
};

/// An ellipsoid of a cumulus, relative to the camera.
struct GardnerEllipsoid {
  glm::vec3 centre;  ///< m
  float unused = 0.0f;
  glm::vec3 radii;  ///< m
  float base;       ///< m over the sea
};

/// The cumuli round the camera, farthest first: heaps of ellipsoids on a grid that the wind
/// carries. `cover` 0 to 1 is the share of the grid's cells that hold one.
std::vector<GardnerEllipsoid> gardner_cumuli(const GardnerView& view);

/// What the texture function on a plane takes on, in order: an evenly spaced sample of one period.
/// Some 5 ms.
std::vector<double> gardner_values(int terms, double contrast);

/// Clouds as G. Gardner drew them in 1985: high and middle ones as textures on sky planes, and, as
/// the cheapest tier, cumuli as translucent ellipsoids.
class GardnerClouds {
 public:
  explicit GardnerClouds(ShaderLibrary& shaders);

  /// Adds clouds.high, clouds.high_composite and clouds.ellipsoids, which draw onto the sky in
  /// `hdr` (where `depth` is 0). Skipped where the weather has none of either, or no sky is in
  /// view.
  void add(FrameGraph& graph, const GardnerView& view, const SkyLight& light, const Sky& sky,
           const SkyIds& sky_ids, TextureId hdr, TextureId depth);

 private:
  void add_high(FrameGraph& graph, const GardnerView& view, const Sky& sky, const SkyIds& sky_ids,
                BufferId block, TextureId hdr, TextureId depth, bool visible);

  const ShaderProgram& tile_program_;
  const ShaderProgram& high_program_;
  const ShaderProgram& composite_program_;
  const ShaderProgram& ellipsoid_program_;
  gl::Buffer block_, ellipsoids_;
  gl::VertexArray ellipsoid_array_, no_vertices_;
  gl::Sampler linear_, repeating_;
  gl::Texture tile_, high_;
  PassMemory block_memory_, tile_memory_;
  std::vector<double> values_;  ///< gardner_values() of these:
  int values_terms_ = 0;
  double values_contrast_ = 0.0;
};

}  // namespace offing
