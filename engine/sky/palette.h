#pragma once
#include <glm/vec3.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/sky/sky_light.h"

namespace offing {

/// The look of the sky at one hour. Colours are linear sRGB of luminance 1.
struct PaletteFrame {
  double hour = 0.0;  ///< local mean solar time, 0 to 24
  glm::dvec3 zenith{1.0}, middle{1.0}, horizon{1.0};
  glm::dvec3 luminance{0.0};  ///< of zenith, middle and horizon, cd/m^2
  glm::dvec3 sun{1.0}, moon{1.0};
  double sun_lux = 0.0, moon_lux = 0.0;  ///< on a surface facing it; the moon when full
};

/// A day in key frames, two at least, in the order of their hours.
struct Palette {
  std::vector<PaletteFrame> frames;

  /// At an hour (any number, periodic in 24): between the frames before and after it, colours
  /// linear, luminances linear in the logarithm (in the number itself where one of them is 0).
  PaletteFrame at(double hour) const;
};

/// The file of a name in assets/palettes, or a path to a .toml file.
std::filesystem::path find_palette(const std::string& name_or_file);

/// Throws InputError, one line with file and line, for what is no TOML, fewer than two frames,
/// hours not ascending or not 0 to below 24, fields that are missing or unknown, and values out of
/// range.
Palette load_palette(const std::filesystem::path& file);

/// Local mean solar time in hours: 12 when the mean sun stands in the meridian.
double solar_hour(double utc_seconds, double longitude_deg);

/// Paints `light` with the palette's look of this hour. `strength` (0 to 1) is that of a grade.
/// What the palette says of sun and moon is theirs while they stand high; eclipses and phases dim
/// it, and the horizon cuts it off.
void apply_palette(SkyLight& light, const PaletteFrame& now, PaletteMode mode, double strength);

/// The scene keys sky.*: the painted sky, and whether the probe is used.
struct SkyLook {
  int mode = 0;  ///< PaletteMode
  std::string palette = "day";
  double strength = 0.7;
  bool probe = true;
  void describe(FieldTable& table);
};

}  // namespace offing
