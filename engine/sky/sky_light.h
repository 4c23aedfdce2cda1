#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <future>
#include <memory>

#include "engine/environment/ephemeris.h"
#include "engine/sky/starlight.h"
#include "shaders/shared/frame.h"

namespace offing {

/// How the painted sky and the physical one go together.
enum class PaletteMode : int {
  kOff,      ///< physical alone
  kGrade,    ///< the palette's colours at the physical sky's luminance
  kReplace,  ///< painted alone: no tables of the air are computed
};

/// A painted sky: a quadratic Bézier curve from the horizon to the zenith, in the root of the sine
/// of the angle above the horizon. Linear sRGB in cd/m^2; for a grade, of luminance 1.
struct PaintedSky {
  PaletteMode mode = PaletteMode::kOff;
  double strength = 0.0;  ///< of a grade
  glm::dvec3 zenith{0.0}, middle{0.0}, horizon{0.0};
};

/// Where the light comes from and how much there is: what the CPU knows of the sky. Illuminance in
/// lux as linear sRGB, directions in the world's axes, refracted.
struct SkyLight {
  glm::dvec3 sun_direction{0.0, 1.0, 0.0}, moon_direction{0.0, -1.0, 0.0};
  double sun_radius = 0.00465, moon_radius = 0.0045;  ///< radians
  /// Above the air, on a surface facing it: the sun as far as no moon covers it, the moon by phase.
  glm::dvec3 sun_source{0.0}, moon_source{0.0};
  /// cd/m^2 at the horizon all round, from the air outside the moon's shadow; 0 without an eclipse.
  glm::dvec3 umbra_horizon{0.0};
  double sun_uncovered = 1.0;  ///< share of the sun's light that the moon leaves
  double moon_phase = 1.0;     ///< moonlight over that of the full moon
  double moon_lit_fraction = 1.0;
  double moon_luminance = 0.0;  ///< cd/m^2 of the middle of the disc, were it full, outside shadow
  /// Height over width of the discs: refraction flattens them near the horizon.
  double sun_flattening = 1.0, moon_flattening = 1.0;
  /// At the camera, through the air and as far as the disc stands above the horizon.
  glm::dvec3 sun_illuminance{0.0}, moon_illuminance{0.0};
  double sun_share = 1.0, moon_share = 0.0;  ///< of the disc above the horizon
  glm::dvec3 sky_illuminance{0.0};  ///< of a level surface, without the discs, airglow included
  /// Radiance at the zenith above the air, cd/m^2; in an eclipse with what lights the shadow.
  glm::dvec3 airglow{0.0};
  glm::dvec3 extinction{0.0};  ///< of the air at sea level, 1/m
  double haze = 0.0;
  double camera_height = 2.0;  ///< m
  double star_share = 0.0;     ///< 0 by day, 1 by night
  double exposure = 1.0;       ///< picture value of 1 cd/m^2, as an eye at home here would have it
  glm::dmat3 world_from_j2000{1.0};  ///< turns the stars, without refraction
  glm::dmat3 world_from_moon{1.0};   ///< see CelestialState, also the next two
  glm::dvec3 sun_from_moon{0.0, 1.0, 0.0};
  EarthShadow earth_shadow;
  PaintedSky painted;

  /// Total on a level surface, lux.
  double level_illuminance() const;
  /// Writes all that FrameData says of light: directions, illuminance, haze and exposure.
  void fill(shared::FrameData& frame) const;
};

/// Computes SkyLight in double by integration with the formulas of shaders/lib/scattering.glsl.
/// What depends on the air only is kept, and what depends on a light's elevation is tabulated as it
/// is asked for, every degree.
class SkyLightModel {
 public:
  /// `starlight`: what the stars add to the sky's light.
  explicit SkyLightModel(Starlight starlight = {});
  ~SkyLightModel();
  SkyLightModel(SkyLightModel&&) noexcept;
  SkyLightModel& operator=(SkyLightModel&&) noexcept;

  /// `haze` 0 to 1, `camera_height` in metres above the sea (0 to 20 km), `exposure_ev` in stops
  /// brighter than the eye would have it. The reference holds until the next call. Some 10 µs where
  /// the clock runs, 1 to 3 ms each degree of a light's elevation, 10 to 45 ms where haze has
  /// changed.
  const SkyLight& update(const CelestialState& celestial, double haze, double camera_height,
                         double exposure_ev = 0.0);

  /// Where this is set another haze is worked out on another thread while the light of the last one
  /// lasts, some frames: for a window, where a slider must not stick. Elsewhere each update() is
  /// complete, so that the same inputs always give the same light.
  void set_in_background(bool in_background) { in_background_ = in_background; }

 private:
  struct Air;
  void renew_air(double haze, double height_km, const CelestialState& celestial);
  Starlight starlight_;
  std::unique_ptr<Air> air_;
  std::future<std::unique_ptr<Air>> next_air_;
  bool in_background_ = false;
  SkyLight light_;
};

/// The luminance that an eye gets used to which looks at the sea and the sky about it: that of the
/// sky and a little of what sun and moon give.
double adapting_luminance(const SkyLight& light);

/// Share of the limb-darkened sun's light that is left where the moon's centre stands `separation`
/// from the sun's (all radians). In totality a millionth remains: the corona.
double uncovered_sun(double separation, double sun_radius, double moon_radius);

/// Mean over the moon's disc of what the earth's shadow leaves of its light, linear sRGB.
glm::dvec3 sunlight_on_the_moon(const EarthShadow& shadow);

/// What an eye that is used to `level_luminance` (cd/m^2) makes of 1 cd/m^2: full day is bright, a
/// moonlit night dim, a moonless one darker still, with no step in between.
double eye_exposure(double level_luminance);

}  // namespace offing
