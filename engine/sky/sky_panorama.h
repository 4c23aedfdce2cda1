#pragma once
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/graph/frame_graph.h"
#include "engine/shader/shader_library.h"
#include "engine/sky/probe.h"
#include "engine/sky/sky.h"
#include "engine/sky/stars.h"

namespace offing {

/// Radiance all round (cd/m^2, linear sRGB primaries): row 0 the zenith, column 0 north, eastward.
struct Panorama {
  int width = 0, height = 0;
  std::vector<glm::dvec3> pixels;

  glm::dvec3& at(int x, int y) {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  /// Toward the middle of a pixel.
  glm::dvec3 direction(double x, double y) const;
  /// Of a pixel of this row, sr: exact.
  double solid_angle(int y) const;
  /// Of a level surface that looks up, lux as linear sRGB: the sum over the upper half.
  glm::dvec3 level_illuminance() const;
};

/// Adds the passes that make a map of the clouds; nothing where there are none.
using AddClouds = std::function<std::optional<ProbeClouds>(FrameGraph&, const SkyIds&)>;

/// The sky without discs and stars, with what clouds `add_clouds` gives, and below the horizon a
/// mean sea. Computes and waits: for exports and tests. FrameData of `light` is bound on the way.
Panorama sky_panorama(ShaderLibrary& shaders, FrameGraph& graph, Sky& sky, const SkyLight& light,
                      double wind_speed, int width, int height, const AddClouds& add_clouds = {});

/// Adds sun and moon: each pixel gets what of the disc lies in it, so that their light on a surface
/// is SkyLight's however coarse the picture is. The moon's disc is even.
void add_discs(Panorama& panorama, const SkyLight& light);

/// Adds the stars above the horizon, dimmed by the air, each in its pixel.
void add_stars(Panorama& panorama, const SkyLight& light, std::span<const Star> stars);

}  // namespace offing
