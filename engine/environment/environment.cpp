#include "engine/environment/environment.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/core/angles.h"
#include "engine/environment/calendar.h"
#include "engine/environment/gust_field.h"

namespace offing {
namespace {

constexpr double kRoughnessLength = 0.005;  // metres: a moderately rough sea
constexpr double kReferenceHeight = 10.0;   // metres
constexpr double kLowestHeight = 0.05;      // metres
constexpr double kPaces[] = {-1440.0, -60.0, -1.0, 1.0, 60.0, 1440.0};  // of the clock
constexpr const char* kDefaultDate = "2026-08-12";
constexpr const char* kDefaultTime = "15:30:00";

double wrapped(double value, double period) { return value - period * std::floor(value / period); }

}  // namespace

Environment::Environment() {
  set_utc_seconds(*parse_date(kDefaultDate) + *parse_time(kDefaultTime));
}

void Environment::describe(FieldTable& table) {
  const auto check_date = [](std::string_view text) {
    std::string problem;
    parse_date(text, &problem);
    return problem;
  };
  const auto check_time = [](std::string_view text) {
    std::string problem;
    parse_time(text, &problem);
    return problem;
  };
  table.group("environment")
      .text("date", date_text_, "date (UTC), YYYY-MM-DD, 1600 to 2200", check_date)
      .text("time", time_text_, "time of day (UTC), HH:MM or HH:MM:SS", check_time)
      .number("latitude", latitude_deg, {-90.0, 90.0}, "deg", "latitude, north positive")
      .number("longitude", longitude_deg, {-180.0, 180.0}, "deg", "longitude, east positive")
      .number("wind.speed", wind.speed, {0.0, 60.0}, "m/s", "mean wind at 10 m")
      .number("wind.from", wind.from_deg, {0.0, 360.0}, "deg", "where the wind comes from, true")
      .number("gusts", wind.gusts, {0.0, 1.0}, "", "gustiness: 0 steady, 1 squally")
      .number("haze", haze, {0.0, 1.0}, "", "haze: 0 clear, 1 fog")
      .number("clouds.cover", clouds.cover, {0.0, 1.0}, "", "share of the sky that clouds cover")
      .number("clouds.type", clouds.type, {0.0, 1.0}, "", "0 stratus, 0.5 stratocumulus, 1 cumulus")
      .number("clouds.precipitation", clouds.precipitation, {0.0, 1.0}, "", "rain from the clouds")
      .number("clouds.high", clouds.high, {0.0, 1.0}, "", "cirrus")
      .number("clouds.middle", clouds.middle, {0.0, 1.0}, "",
              "altocumulus: share of the sky with its patches")
      .number("clock_rate", clock_rate, {-86400.0, 86400.0}, "s/s",
              "seconds of day and night per second of sailing; negative runs backwards")
      .flag("paused", paused, "clock and sea stand still");
}

void Environment::apply_fields() {
  const std::optional<double> date = parse_date(date_text_);
  const std::optional<double> time = parse_time(time_text_);
  // Texts that still say what the clock says leave its fraction of a second alone.
  const bool same = date && time && *date + *time == std::floor(utc_seconds_);
  set_utc_seconds(date && time && !same ? *date + *time : utc_seconds_);
}

void Environment::quicken() {
  const auto* next = std::upper_bound(std::begin(kPaces), std::end(kPaces), clock_rate);
  clock_rate = next == std::end(kPaces) ? *(next - 1) : *next;
}

void Environment::slow_down() {
  const auto* next = std::lower_bound(std::begin(kPaces), std::end(kPaces), clock_rate);
  clock_rate = next == std::begin(kPaces) ? *next : *(next - 1);
}

void Environment::advance(double dt) {
  if (paused) return;
  elapsed_ += dt;
  air_drift_ += dt * wind_velocity();
  const glm::dvec2 moved = gust_origin_ + dt * wind_velocity();
  gust_origin_ = {wrapped(moved.x, GustField::kPeriod), wrapped(moved.y, GustField::kPeriod)};
  set_utc_seconds(utc_seconds_ + clock_rate * dt);
}

void Environment::set_utc_seconds(double seconds) {
  const double old = utc_seconds_;
  utc_seconds_ = std::clamp(seconds, first_utc_seconds(), last_utc_seconds());
  if (std::floor(old) == std::floor(utc_seconds_) && !date_text_.empty() &&
      time_text_.size() == 8) {
    return;
  }
  date_text_ = date_text(utc_seconds_);
  time_text_ = time_text(utc_seconds_);
}

void Environment::set_elapsed(double seconds) {
  elapsed_ = seconds;
  air_drift_ = seconds * wind_velocity();
  const glm::dvec2 moved = seconds * wind_velocity();
  gust_origin_ = {wrapped(moved.x, GustField::kPeriod), wrapped(moved.y, GustField::kPeriod)};
}

glm::dvec2 Environment::wind_to() const {
  const double from = radians(wind.from_deg);
  return {-std::sin(from), std::cos(from)};
}

double Environment::gust_factor(glm::dvec2 position) const {
  if (wind.gusts == 0.0) return 1.0;
  const double deviation = gust_field().at(position - gust_origin_);
  return std::max(0.0, 1.0 + GustField::kIntensity * wind.gusts * deviation);
}

glm::dvec2 Environment::wind_at(glm::dvec2 position, double height) const {
  static const double kLogReference = std::log(kReferenceHeight / kRoughnessLength);
  const double profile =
      std::log(std::max(height, kLowestHeight) / kRoughnessLength) / kLogReference;
  return profile *
         (gust_factor(position) * wind_velocity() + squalls_->added(position - squall_corner_));
}

const CelestialState& Environment::celestial() const {
  const double key[3] = {utc_seconds_, latitude_deg, longitude_deg};
  if (!std::equal(key, key + 3, celestial_key_)) {
    celestial_ = ephemeris_.at(utc_seconds_, latitude_deg, longitude_deg);
    std::copy(key, key + 3, celestial_key_);
  }
  return celestial_;
}

}  // namespace offing
