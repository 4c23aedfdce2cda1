#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <string>

#include "engine/clouds/cloud_effects.h"
#include "engine/core/fields.h"

namespace offing {

/// What contains the clouds.
enum class CloudContainer : int { kShell, kBox };

/// How droplets scatter light.
enum class CloudPhase : int { kDroplets, kLobes };

/// How the clouds look, beyond the weather (Environment::clouds): scene keys clouds.*. The names in
/// brackets are those of the sources' parameters.
struct CloudParameters {
  double scale = 1.0;              ///< of the clouds' size (cloud scale)
  double density_threshold = 0.0;  ///< moves the clouds' edge inward (density threshold), -1 to 1
  double density = 1.0;            ///< multiplies the extinction (density multiplier)
  double extinction = 0.07;        ///< of a dense cumulus, 1/m
  double base = 700.0;             ///< height of the lowest cumulus bases, m
  int container = static_cast<int>(CloudContainer::kShell);
  double box_size = 30.0;  ///< side of the box, km
  double edge_fade = 2.0;  ///< within this of the container's sides clouds thin out, km

  double shape_weights[4] = {0.38, 0.27, 0.20, 0.15};  ///< of the body's noise, by channel
  glm::dvec3 detail_weights{0.6, 0.3, 0.1};            ///< of the edges' noise
  double roughness = 1.0;                              ///< strength of the body's noise
  double erosion = 1.0;                                ///< strength of the edges' noise
  double curl = 1.0;                                   ///< how far the edges are drawn out

  int light_steps = 0;            ///< toward the light, 1 to 6; 0: by quality
  double step_scale = 1.0;        ///< multiplies the steps' length
  double sun_absorption = 1.0;    ///< of light on its way into the cloud (absorption to sun)
  double cloud_absorption = 1.0;  ///< of light on its way out of it (absorption through cloud)
  double darkness_floor = 0.0;    ///< least share of the sunlight anywhere (darkness threshold)
  int phase = static_cast<int>(CloudPhase::kDroplets);
  double droplets_um = 16.0;        ///< their diameter
  double forward_scattering = 0.8;  ///< g of the forward lobe
  double back_scattering = 0.3;     ///< -g of the backward lobe
  double back_share = 0.12;         ///< share of the backward lobe
  double phase_weight = 1.0;  ///< of the phase function against even scattering (phase factor)
  double brightness = 1.0;    ///< of the clouds (base brightness)
  double powder = 0.0;        ///< darkens thin sunlit edges seen down-sun (powder effect)
  double ambient = 1.0;       ///< of the light from sky and sea

  double direction_offset_deg = 0.0;  ///< added to the wind's
  double speed_factor = 1.0;          ///< times the wind's
  double shear = 0.25;                ///< lean of the clouds, m per m of height
  double evolution = 1.0;             ///< how fast clouds come and go
  std::string weather_picture;        ///< file in place of the procedural weather; empty: none

  CloudEffects effects;  ///< on the rest of the scene

  /// The scene keys clouds.*, bound to this object.
  void describe(FieldTable& table);
};

}  // namespace offing
