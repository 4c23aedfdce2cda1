#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

#include <string>
#include "engine/clouds/gardner.h"

#include "engine/clouds/cloud_field.h"
#include "engine/ocean/underwater.h"
#include "engine/post/exposure_settings.h"
#include "engine/sky/palette.h"
#include "engine/sky/sky_light.h"
#include "game/frame/boat_view.h"
#include "game/world/world.h"
#include "shaders/shared/frame.h"

namespace offing {

/// A thing afloat, to be drawn.
struct FlotsamView {
  int kind = 0;              ///< index into kFlotsam (world.h)
  glm::vec3 position{0.0f};  ///< m, less the camera's place
  glm::quat orientation{1.0f, 0.0f, 0.0f, 0.0f};
};

/// One frame as data: all that crosses from the simulation to the picture. Never changed once made.
struct FrameView {
  glm::ivec2 size{1};                          ///< pixels
  shared::FrameData frame;                     ///< as the shaders read it
  glm::dvec3 camera{0.0};                      ///< world, m
  double sea_time = 0.0;                       ///< s
  glm::dvec2 gust_origin{0.0};                 ///< of the gust field now, m
  std::shared_ptr<const SquallField> squalls;  ///< the wind that rain brings down
  glm::dvec2 squall_corner{0.0};               ///< of its grid now, m
  double chlorophyll = 0.4;                    ///< of the water, mg/m^3
  SkyLight light;
  CloudView clouds;
  BoatView boat;
  std::vector<FlotsamView> flotsam;
  GardnerView gardner;
  ExposureSettings exposure;
  UnderwaterView underwater;
  bool sea_visible = true, sky_visible = true;
  bool probe = true;
};

/// Makes FrameViews. Holds only what is worth keeping of the sky's light from frame to frame.
class Extractor {
 public:
  /// Reads the stars. Throws InputError where their files are not there or damaged.
  Extractor();
  /// See SkyLightModel::set_in_background(): for a window.
  void set_in_background(bool in_background) { light_.set_in_background(in_background); }
  /// `dt` is the time since the last frame (s), `number` its number.
  FrameView extract(const World& world, glm::ivec2 size, double dt, int number);

 private:
  SkyLight paint(const Scene& scene, SkyLight light);
  SkyLightModel light_;
  std::string palette_name_;
  Palette palette_;
};

}  // namespace offing
