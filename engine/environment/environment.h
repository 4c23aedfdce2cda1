#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <memory>
#include <string>

#include "engine/core/fields.h"
#include "engine/environment/ephemeris.h"
#include "engine/environment/squall_field.h"

namespace offing {

/// The mean wind at 10 m. Directions at the edges are where it comes FROM, degrees true.
struct Wind {
  double speed = 8.0;      ///< m/s at 10 m
  double from_deg = 45.0;  ///< degrees true
  double gusts = 0.3;      ///< 0 (steady) to 1 (squally)
};

/// What the sky holds.
struct Clouds {
  double cover = 0.35;         ///< 0 to 1
  double type = 1.0;           ///< 0 stratus, 0.5 stratocumulus, 1 cumulus
  double precipitation = 0.0;  ///< 0 to 1
  double high = 0.2;           ///< cirrus, 0 to 1
  double middle = 0.0;         ///< altocumulus, share of the sky with its patches, 0 to 1
};

/// The only wind, clock, place and weather. Waves, sails, sky and clouds read it; nobody keeps a
/// copy. Time: `clock` is UTC as seconds since 1970-01-01; `elapsed` is what waves, gusts and cloth
/// run by.
class Environment {
 public:
  Environment();

  Wind wind;
  Clouds clouds;
  double latitude_deg = 43.3623;   ///< north positive
  double longitude_deg = -8.4115;  ///< east positive
  double haze = 0.1;               ///< 0 (clear) to 1 (fog)
  bool paused = false;
  double clock_rate = 1.0;  ///< seconds of day and night per second of sailing

  /// The scene keys environment.*, bound to this object. Date and time are text there.
  /// The table must not outlive the object, nor the object move.
  void describe(FieldTable& table);
  /// Takes over date and time as set through the table: call after setting fields.
  void apply_fields();

  /// The next quicker or slower pace of the clock: a day in a minute, an hour in a minute, as it
  /// runs, and the same backwards.
  void quicken();
  void slow_down();

  /// Moves clock and sea time on by dt seconds (nothing while paused). dt may be negative.
  void advance(double dt);

  double utc_seconds() const { return utc_seconds_; }
  /// Kept within the years 1600 to 2200: the clock stops at either end.
  void set_utc_seconds(double seconds);
  /// UTC as text: "2026-08-12" and "15:30:00".
  const std::string& date() const { return date_text_; }
  const std::string& time() const { return time_text_; }
  double elapsed() const { return elapsed_; }
  /// Also moves the gusts to where the present wind would have carried them since time 0.
  void set_elapsed(double seconds);

  /// Unit vector (x east, z south) the mean wind blows toward, and the velocity in m/s at 10 m.
  glm::dvec2 wind_to() const;
  glm::dvec2 wind_velocity() const { return wind.speed * wind_to(); }
  /// Wind velocity (x, z; m/s) with gusts at a place, `height` metres above the water, now:
  /// logarithmic profile over z0 = 0.005 m, times the mean wind with one frozen periodic gust field
  /// that it carries, and what squalls add. Speed is at least 0; `height` below 0.05 m counts as
  /// 0.05 m.
  glm::dvec2 wind_at(glm::dvec2 position, double height) const;
  /// The gust factor alone (1 = mean wind), for the look of the water.
  double gust_factor(glm::dvec2 position) const;
  /// Where the gust field's origin lies now (x, z; metres, within one period), for its texture.
  glm::dvec2 gust_origin() const { return gust_origin_; }
  /// The wind that rain brings down, from now on, with its grid's corner in the world (x, z; m).
  void set_squalls(std::shared_ptr<const SquallField> squalls) { squalls_ = std::move(squalls); }
  void set_squall_corner(glm::dvec2 corner) { squall_corner_ = corner; }
  /// Never null.
  const std::shared_ptr<const SquallField>& squalls() const { return squalls_; }
  glm::dvec2 squall_corner() const { return squall_corner_; }
  /// How far the mean wind at 10 m has carried the air since time 0 (x, z; m): where clouds are.
  glm::dvec2 air_drift() const { return air_drift_; }

  /// Sun and moon for the clock and the place.
  const CelestialState& celestial() const;

 private:
  std::string date_text_, time_text_;
  double utc_seconds_ = 0.0;
  double elapsed_ = 0.0;
  glm::dvec2 gust_origin_{0.0};
  glm::dvec2 air_drift_{0.0};
  std::shared_ptr<const SquallField> squalls_ = std::make_shared<SquallField>();
  glm::dvec2 squall_corner_{0.0};
  mutable Ephemeris ephemeris_;
  mutable CelestialState celestial_;
  mutable double celestial_key_[3] = {1e300, 0.0, 0.0};
};

}  // namespace offing
