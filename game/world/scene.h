#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <string>
#include <vector>

#include "engine/boat/parameters.h"
#include "engine/clouds/cloud_parameters.h"
#include "engine/clouds/gardner_parameters.h"
#include "engine/core/fields.h"
#include "engine/environment/environment.h"
#include "engine/ocean/sea_state.h"
#include "engine/post/exposure_settings.h"
#include "engine/sky/palette.h"

namespace offing {

/// Where the boat starts.
struct BoatStart {
  double heading_deg = 90.0;  ///< degrees true
  double speed = 3.0;         ///< m/s through the water
  glm::dvec2 position{0.0};   ///< x east, z south, m
  std::string file = "r8";    ///< a name in assets/boats/, or a TOML file
  std::string model;          ///< a glTF file; empty: R8's own
  R8Parameters parameters;    ///< what the file says
};

enum class CameraMode : int { kChase, kHelm, kMast, kFree, kOrbit };

/// Where one looks from.
struct CameraStart {
  int mode = static_cast<int>(CameraMode::kChase);
  glm::dvec3 position{20.0, 6.0, 20.0};  ///< free: m, world
  glm::dvec3 target{0.0, 2.0, 0.0};      ///< free: m, world
  double field_of_view_deg = 55.0;       ///< vertical
};

/// How low clouds are drawn.
enum class CloudMethod : int { kVolumetric, kEllipsoids };

/// Everything that a scene file can say. Its field table is the list of the scene keys.
struct Scene {
  Environment environment;
  SeaState sea;
  CloudParameters clouds;
  BoatStart boat;
  CameraStart camera;
  ExposureSettings exposure;
  bool flotsam = true;  ///< barrel, crate and raft float about the start
  GardnerParameters gardner;
  int cloud_method = static_cast<int>(CloudMethod::kVolumetric);
  SkyLook sky;
  int seed = 1;
  double sea_time = 0.0;  ///< the sea's clock at the start, s

  /// Bound to this object.
  FieldTable fields();
};

/// The scene of a name or file, then the settings "key=value", then the seed where one is given.
/// Throws InputError naming what is wrong; nothing half-set is ever returned.
Scene make_scene(const std::string& name_or_file, const std::vector<std::string>& settings);

}  // namespace offing
