#include "engine/sky/palette.h"

#include <fmt/core.h>

#include <toml++/toml.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/core/angles.h"
#include "engine/core/error.h"
#include "engine/core/paths.h"
#include "engine/io/file.h"

namespace offing {
namespace {
namespace fs = std::filesystem;

constexpr double kBrightestSky = 1e5, kBrightestSun = 2e5;  // cd/m^2, lux

double luminance(const glm::dvec3& c) { return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722)); }

/// One key frame of a file, read field by field.
class FrameReader {
 public:
  FrameReader(const toml::table& table, const fs::path& file, std::size_t number)
      : table_(table), file_(file), number_(number) {}

  PaletteFrame read() const {
    for (const auto& [key, node] : table_) {
      if (std::find(kFields.begin(), kFields.end(), key.str()) == kFields.end()) {
        throw refuse(node, key.str(),
                     "is no field of a frame; there are hour, zenith, middle, horizon, luminance, "
                     "sun, sun_lux, moon, moon_lux");
      }
    }
    PaletteFrame frame;
    frame.hour = number("hour", 24.0);
    if (frame.hour == 24.0) throw refuse(field("hour"), "hour", "must be less than 24");
    frame.zenith = colour("zenith");
    frame.middle = colour("middle");
    frame.horizon = colour("horizon");
    frame.luminance = luminances();
    frame.sun = colour("sun");
    frame.moon = colour("moon");
    frame.sun_lux = number("sun_lux", kBrightestSun);
    frame.moon_lux = number("moon_lux", kBrightestSun);
    return frame;
  }

  InputError refuse(const toml::node& node, std::string_view key, std::string_view why) const {
    return InputError(fmt::format("{}:{}: frame {}: {}: {}", file_.string(),
                                  node.source().begin.line, number_, key, why));
  }

 private:
  static constexpr std::array<std::string_view, 9> kFields = {
      "hour", "zenith", "middle", "horizon", "luminance", "sun", "sun_lux", "moon", "moon_lux"};

  const toml::node& field(std::string_view key) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) throw refuse(table_, key, "is missing");
    return *node;
  }

  double in_range(const toml::node& node, std::string_view key, double least, double most) const {
    const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
    // Written so that a NaN is refused too.
    if (!value || !(*value >= least && *value <= most)) {
      throw refuse(node, key, fmt::format("must be a number from {} to {}", least, most));
    }
    return *value;
  }

  double number(std::string_view key, double most) const {
    return in_range(field(key), key, 0.0, most);
  }

  glm::dvec3 luminances() const {
    const toml::node& node = field("luminance");
    const toml::array* array = node.as_array();
    if (array == nullptr || array->size() != 3) {
      throw refuse(node, "luminance",
                   "must be three numbers: zenith, middle and horizon, in cd/m^2");
    }
    glm::dvec3 value;
    for (int i = 0; i < 3; ++i) {
      value[i] =
          in_range(*array->get(static_cast<std::size_t>(i)), "luminance", 1e-7, kBrightestSky);
    }
    return value;
  }

  /// "#rrggbb" as linear sRGB of luminance 1.
  glm::dvec3 colour(std::string_view key) const {
    const toml::node& node = field(key);
    const std::string text = node.value<std::string>().value_or("");
    const bool shape = text.size() == 7 && text[0] == '#' &&
                       text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    if (!node.is_string() || !shape) {
      throw refuse(node, key, "must be a colour as \"#7db4ea\" (sRGB: red, green, blue)");
    }
    glm::dvec3 linear;
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(1 + 2 * i);
      const double coded = std::stoi(text.substr(at, 2), nullptr, 16) / 255.0;
      linear[i] = coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
    }
    if (luminance(linear) <= 0.0) {
      throw refuse(node, key, "must not be black: how bright it is the luminance says");
    }
    return linear / luminance(linear);
  }

  const toml::table& table_;
  const fs::path& file_;
  std::size_t number_;
};

toml::table parse(const fs::path& file) {
  try {
    return toml::parse(read_text(file, 1 << 20), file.string());
  } catch (const toml::parse_error& error) {
    std::string why(error.description());
    std::replace(why.begin(), why.end(), '\n', ' ');
    throw InputError(
        fmt::format("{}:{}: not TOML: {}", file.string(), error.source().begin.line, why));
  }
}

/// Between two luminances by decades; from or to darkness, which has none, in proportion.
double between(double a, double b, double t) {
  return a > 0.0 && b > 0.0 ? std::exp(glm::mix(std::log(a), std::log(b), t)) : glm::mix(a, b, t);
}

/// `value` with the colour of `tint` (of luminance 1).
glm::dvec3 graded(const glm::dvec3& value, const glm::dvec3& tint, double strength) {
  return glm::mix(value, luminance(value) * tint, strength);
}

/// Illuminance over pi of a level surface under a PaintedSky: the integral of its Bézier curve.
glm::dvec3 level_mean(const glm::dvec3& zenith, const glm::dvec3& middle,
                      const glm::dvec3& horizon) {
  return (horizon + 4.0 * middle + 10.0 * zenith) / 15.0;
}

}  // namespace

PaletteFrame Palette::at(double hour) const {
  const double h = hour - 24.0 * std::floor(hour / 24.0);
  const auto after = std::upper_bound(frames.begin(), frames.end(), h,
                                      [](double x, const PaletteFrame& f) { return x < f.hour; });
  const PaletteFrame& a = after == frames.begin() ? frames.back() : *(after - 1);
  const PaletteFrame& b = after == frames.end() ? frames.front() : *after;
  const auto forward = [](double from, double to) {
    return to < from ? to + 24.0 - from : to - from;
  };
  const double t = forward(a.hour, h) / forward(a.hour, b.hour);
  PaletteFrame now;
  now.hour = h;
  now.zenith = glm::mix(a.zenith, b.zenith, t);
  now.middle = glm::mix(a.middle, b.middle, t);
  now.horizon = glm::mix(a.horizon, b.horizon, t);
  now.sun = glm::mix(a.sun, b.sun, t);
  now.moon = glm::mix(a.moon, b.moon, t);
  for (int i = 0; i < 3; ++i) now.luminance[i] = between(a.luminance[i], b.luminance[i], t);
  now.sun_lux = between(a.sun_lux, b.sun_lux, t);
  now.moon_lux = between(a.moon_lux, b.moon_lux, t);
  return now;
}

fs::path find_palette(const std::string& name_or_file) {
  const bool is_path =
      name_or_file.find('/') != std::string::npos || name_or_file.ends_with(".toml");
  return is_path ? fs::path(name_or_file)
                 : data_root() / "assets/palettes" / fmt::format("{}.toml", name_or_file);
}

Palette load_palette(const fs::path& file) {
  const toml::table table = parse(file);
  for (const auto& [key, node] : table) {
    if (key.str() != "frame" || !node.is_array_of_tables()) {
      throw InputError(fmt::format("{}:{}: {}: a palette is a list of [[frame]]", file.string(),
                                   node.source().begin.line, key.str()));
    }
  }
  const toml::array* list = table["frame"].as_array();
  const std::size_t count = list == nullptr ? 0 : list->size();
  if (count < 2) {
    throw InputError(fmt::format("{}:1: has {} [[frame]]: a day needs at least two", file.string(),
                                 count == 0 ? "no" : "one"));
  }
  Palette palette;
  for (std::size_t i = 0; i < count; ++i) {
    const FrameReader reader(*list->get(i)->as_table(), file, i + 1);
    palette.frames.push_back(reader.read());
    if (i > 0 && !(palette.frames[i].hour > palette.frames[i - 1].hour)) {
      throw reader.refuse(*list->get(i)->as_table()->get("hour"), "hour",
                          fmt::format("{:g} must be later than {:g} of the frame before",
                                      palette.frames[i].hour, palette.frames[i - 1].hour));
    }
  }
  return palette;
}

double solar_hour(double utc_seconds, double longitude_deg) {
  const double hours = utc_seconds / 3600.0 + longitude_deg / 15.0;
  return hours - 24.0 * std::floor(hours / 24.0);
}

void apply_palette(SkyLight& light, const PaletteFrame& now, PaletteMode mode, double strength) {
  if (mode == PaletteMode::kOff) return;
  const double before = eye_exposure(adapting_luminance(light));
  light.painted = {mode, strength, now.zenith, now.middle, now.horizon};
  if (mode == PaletteMode::kGrade) {
    // Not the sources: the sky that they make is graded itself.
    light.sun_illuminance = graded(light.sun_illuminance, now.sun, strength);
    light.moon_illuminance = graded(light.moon_illuminance, now.moon, strength);
    const glm::dvec3 mean = level_mean(now.zenith, now.middle, now.horizon);
    light.sky_illuminance = graded(light.sky_illuminance, mean, strength);
  } else {
    PaintedSky& sky = light.painted;
    sky.zenith *= now.luminance.x;
    sky.middle *= now.luminance.y;
    sky.horizon *= now.luminance.z;
    const double moon_before = luminance(light.moon_source);
    light.sun_source = now.sun_lux * light.sun_uncovered * now.sun;
    light.moon_source =
        now.moon_lux * light.moon_phase * now.moon * sunlight_on_the_moon(light.earth_shadow);
    if (moon_before > 0.0) light.moon_luminance *= luminance(light.moon_source) / moon_before;
    light.sun_illuminance = light.sun_source * light.sun_share;
    light.moon_illuminance = light.moon_source * light.moon_share;
    light.sky_illuminance = kPi * level_mean(sky.zenith, sky.middle, sky.horizon);
    light.airglow = glm::dvec3(0.0);
  }
  light.exposure *= eye_exposure(adapting_luminance(light)) / before;
}

void SkyLook::describe(FieldTable& table) {
  const auto check = [](std::string_view name) {
    try {
      load_palette(find_palette(std::string(name)));
      return std::string();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  table.group("sky")
      .choice("palette_mode", mode, {"off", "grade", "replace"},
              "painted sky: off, as a grade over the physical one, or instead of it")
      .text("palette", palette, "palette of the painted sky: a name in assets/palettes or a file",
            check)
      .number("palette_strength", strength, {0.0, 1.0}, "", "strength of the grade")
      .flag(
          "probe", probe,
          "reflection probe; off: sea and boat mirror the plain sky, without clouds or roughness");
}

}  // namespace offing
