#pragma once
#include "engine/core/fields.h"

namespace offing {

/// What Gardner's clouds look like: scene keys clouds.gardner.*.
struct GardnerParameters {
  int terms = 7;                   ///< of the texture's series, 4 to 7
  double contrast = 1.0;           ///< T0: 1 all, more is fainter
  double high_range = 0.45;        ///< D of (9)
  double high_depth = 1.6;         ///< optical depth of the densest high cloud
  double high_wavelength = 9.0;    ///< km, across the wind
  double high_stretch = 5.0;       ///< longer along the wind by this
  double middle_depth = 3.0;       ///< optical depth of the densest altocumulus
  double middle_wavelength = 8.0;  ///< km, of its patches
  double ambient = 0.4;            ///< a of (8)
  double texture = 0.35;           ///< t of (8)
  double specular = 0.1;           ///< s of (8)
  double threshold = 0.02;         ///< T1 of (11), in the middle
  double limb_threshold = 0.36;    ///< T2 of (11), at the outline
  double range = 0.12;             ///< D of (11)
  double wavelength = 0.9;         ///< km, of the ellipsoids' texture

  void describe(FieldTable& table);
};

}  // namespace offing
