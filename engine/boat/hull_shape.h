#pragma once
#include <glm/vec2.hpp>

#include <vector>

namespace offing {

/// A slice of a hull across its length: one closed outline that stands for `thickness` metres.
struct HullSection {
  double z = 0.0;                   ///< m, middle of the slice, boat frame (bow at -z)
  double thickness = 0.0;           ///< m
  glm::dvec2 sheer{0.0};            ///< (x, y) of the deck's edge, starboard
  std::vector<glm::dvec2> outline;  ///< (x, y), counter-clockwise seen from astern
};

/// A closed hull as slices, in the boat frame: x to starboard, y up, z aft, y = 0 at the design
/// waterline, origin amidships.
struct HullShape {
  std::vector<HullSection> sections;
  double length = 0.0;  ///< m, of the waterline
  double beam = 0.0;    ///< m, of the waterline

  void translate(double y, double z);
};

/// Main dimensions of a round-bilged keelboat, metres.
struct HullLines {
  double length_overall = 8.0;
  double length_waterline = 6.7;
  double beam = 2.5;
  double beam_waterline = 2.05;
  double freeboard = 0.85;
  double midship_area = 0.4956;  ///< m^2, Cm BWL T: the slices below water are scaled to `volume`
  double canoe_volume = 1.840;   ///< m^3 under the design waterline, without keel
};

/// Sail-boat lines from coefficients: waterline breadth (1-u^2)^r with Cw = 0.68, sectional areas
/// (1-u^2)^s with Cp = 0.55, sections b (1 - (depth/draught)^n) with Cm = 0.711, topsides that
/// flare to the deck, overhangs at both ends and a coachroof. 13 slices.
HullShape keelboat(const HullLines& lines);

/// A box of length (z), beam (x) and height (y), its bottom at y = 0.
HullShape box(double length, double beam, double height);

/// A cylinder lying along z, its axis at y = 0.
HullShape cylinder(double length, double radius);

}  // namespace offing
