#include "engine/boat/hull_shape.h"

#include <algorithm>
#include <cmath>

#include "engine/boat/hydrostatics.h"
#include "engine/core/angles.h"

namespace offing {
namespace {

/// One half of a section from keel to deck edge; x >= 0, y rising.
using HalfSection = std::vector<glm::dvec2>;

std::vector<glm::dvec2> mirror(const HalfSection& half) {
  std::vector<glm::dvec2> outline = half;
  for (auto p = half.rbegin(); p != half.rend(); ++p) {
    if (p->x > 1e-9) outline.push_back({-p->x, p->y});
  }
  return outline;
}

struct Station {
  double keel_height, half_beam, deck_half_beam, deck_height;
};

/// The curves of the lines plan at z.
Station station(const HullLines& lines, double z, double depth_scale) {
  const double end = 0.5 * lines.length_waterline, tip = 0.5 * lines.length_overall;
  const double u = z / end;
  Station s{};
  s.deck_height = lines.freeboard + (z < 0.0 ? 0.14 : -0.04) * (z / tip) * (z / tip);
  const double widest = 0.1 * tip;
  const double full = 0.5 * lines.beam;
  if (z < widest) {
    s.deck_half_beam = full * (1.0 - std::pow((widest - z) / (widest + tip), 3.0));
  } else {
    const double aft = (z - widest) / (tip - widest);
    s.deck_half_beam = full * (1.0 - 0.15 * aft * aft);
  }
  if (std::abs(u) < 1.0) {
    const double taper = 1.0 - u * u;
    s.half_beam = 0.5 * lines.beam_waterline * std::pow(taper, 0.96) * (1.0 + 0.15 * u);
    const double area = lines.midship_area * std::pow(taper, 1.85) * (1.0 + 0.08 * u);
    constexpr double kFill = 0.711;  // of the rectangle b x draught
    s.keel_height = -depth_scale * area / (2.0 * kFill * s.half_beam);
  } else {
    const double out = (std::abs(z) - end) / (tip - end);
    s.keel_height = z < 0.0 ? s.deck_height * out * 0.97 : 0.14 * out;
  }
  return s;
}

HalfSection half_section(const Station& s, double z) {
  HalfSection half{{0.0, s.keel_height}};
  if (s.half_beam > 0.0) {
    constexpr double kExponent = 2.46;  // n / (n + 1) = Cm
    for (const double depth : {0.9, 0.75, 0.55, 0.3, 0.0}) {
      half.push_back({s.half_beam * (1.0 - std::pow(depth, kExponent)), depth * s.keel_height});
    }
    for (const double up : {0.3, 0.65, 1.0}) {
      half.push_back(
          {s.half_beam + (s.deck_half_beam - s.half_beam) * std::pow(up, 0.5), up * s.deck_height});
    }
  } else {
    for (const double up : {0.1, 0.3, 0.65, 1.0}) {
      half.push_back({s.deck_half_beam * std::pow(up, 0.6),
                      s.keel_height + up * (s.deck_height - s.keel_height)});
    }
  }
  if (z > -2.2 && z < 0.9) {  // coachroof
    half.push_back({0.62, s.deck_height + 0.03});
    half.push_back({0.52, s.deck_height + 0.22});
    half.push_back({0.0, s.deck_height + 0.27});
  } else {
    half.push_back({0.0, s.deck_height + 0.05});
  }
  return half;
}

HullShape keelboat_at(const HullLines& lines, double depth_scale) {
  constexpr int kSlices = 13;
  HullShape shape;
  shape.length = lines.length_waterline;
  shape.beam = lines.beam_waterline;
  const double thickness = lines.length_overall / kSlices;
  for (int i = 0; i < kSlices; ++i) {
    const double z = (i + 0.5) * thickness - 0.5 * lines.length_overall;
    const Station s = station(lines, z, depth_scale);
    shape.sections.push_back(
        {z, thickness, {s.deck_half_beam, s.deck_height}, mirror(half_section(s, z))});
  }
  return shape;
}

}  // namespace

void HullShape::translate(double y, double z) {
  for (HullSection& section : sections) {
    section.z += z;
    section.sheer.y += y;
    for (glm::dvec2& point : section.outline) point.y += y;
  }
}

HullShape keelboat(const HullLines& lines) {
  // Polygons hold a little less than the curves they follow: scale the depths to the volume.
  double scale = 1.0;
  for (int i = 0; i < 8; ++i) {
    scale *= lines.canoe_volume / immerse_level(keelboat_at(lines, scale), 0.0).volume;
  }
  return keelboat_at(lines, scale);
}

HullShape box(double length, double beam, double height) {
  constexpr int kSlices = 8;
  HullShape shape;
  shape.length = length;
  shape.beam = beam;
  for (int i = 0; i < kSlices; ++i) {
    const double z = ((i + 0.5) / kSlices - 0.5) * length;
    const double x = 0.5 * beam;
    shape.sections.push_back(
        {z, length / kSlices, {x, height}, {{x, 0.0}, {x, height}, {-x, height}, {-x, 0.0}}});
  }
  return shape;
}

HullShape cylinder(double length, double radius) {
  constexpr int kSlices = 4, kSides = 16;
  // Area of the polygon = area of the circle.
  const double corner = radius * std::sqrt(kTau / (kSides * std::sin(kTau / kSides)));
  HullShape shape;
  shape.length = length;
  shape.beam = 2.0 * radius;
  for (int i = 0; i < kSlices; ++i) {
    HullSection section{((i + 0.5) / kSlices - 0.5) * length, length / kSlices, {0.0, radius}, {}};
    for (int k = 0; k < kSides; ++k) {
      const double angle = kTau * k / kSides;
      section.outline.push_back({corner * std::cos(angle), corner * std::sin(angle)});
    }
    shape.sections.push_back(section);
  }
  return shape;
}

}  // namespace offing
