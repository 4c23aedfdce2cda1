#include "engine/clouds/gardner_parameters.h"

namespace offing {

void GardnerParameters::describe(FieldTable& table) {
  table.group("clouds.gardner")
      .integer("terms", terms, {4, 7}, "of the texture's series of sines")
      .number("contrast", contrast, {1.0, 8.0}, "", "T0 of the texture: 1 all, more is fainter")
      .number("high_range", high_range, {0.01, 1.0}, "",
              "D of high clouds: from clear to dense within this much of the texture")
      .number("high_depth", high_depth, {0.0, 8.0}, "", "optical depth of the densest high cloud")
      .number("high_wavelength", high_wavelength, {1.0, 100.0}, "km", "of high clouds' texture")
      .number("high_stretch", high_stretch, {1.0, 12.0}, "", "longer along the wind by this")
      .number("middle_depth", middle_depth, {0.0, 20.0}, "",
              "optical depth of the densest altocumulus")
      .number("middle_wavelength", middle_wavelength, {1.0, 100.0}, "km",
              "of the patches of altocumulus")
      .number("ambient", ambient, {0.0, 1.0}, "", "a: share of even light on ellipsoids")
      .number("texture", texture, {0.0, 1.0}, "", "t: share of the texture in their shading")
      .number("specular", specular, {0.0, 1.0}, "", "s: share of shine in their shading")
      .number("threshold", threshold, {0.0, 1.0}, "", "T1: their texture's threshold in the middle")
      .number("limb_threshold", limb_threshold, {0.0, 2.0}, "", "T2: and at their outline")
      .number("range", range, {0.01, 1.0}, "", "D: from clear to dense within this much")
      .number("wavelength", wavelength, {0.1, 20.0}, "km", "of the ellipsoids' texture");
}

}  // namespace offing
