#include "game/hud/wind_dial.h"

#include <imgui.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>

#include "engine/core/angles.h"

namespace offing {
namespace {

constexpr ImU32 kRing = IM_COL32(150, 185, 205, 150);
constexpr ImU32 kTick = IM_COL32(190, 215, 230, 210);
constexpr ImU32 kHull = IM_COL32(236, 240, 242, 255);
constexpr ImU32 kSail = IM_COL32(250, 205, 120, 255);
constexpr ImU32 kApparent = IM_COL32(255, 176, 64, 255);
constexpr ImU32 kTrue = IM_COL32(110, 200, 255, 230);
constexpr ImU32 kPort = IM_COL32(220, 70, 70, 160);
constexpr ImU32 kStarboard = IM_COL32(70, 190, 100, 160);

class Dial {
 public:
  Dial(ImVec2 centre, float radius)
      : draw_(ImGui::GetWindowDrawList()), centre_(centre), radius_(radius) {}

  // A place at `share` of the radius and an angle from the bow, clockwise.
  ImVec2 at(double angle, double share) const {
    const double r = share * static_cast<double>(radius_);
    return {centre_.x + static_cast<float>(r * std::sin(angle)),
            centre_.y - static_cast<float>(r * std::cos(angle))};
  }

  void ring() const {
    draw_->AddCircle(centre_, radius_, kRing, 64, 1.5f);
    for (int degree = 0; degree < 360; degree += 10) {
      const double angle = radians(degree);
      const double inner = degree % 90 == 0 ? 0.84 : degree % 30 == 0 ? 0.89 : 0.95;
      draw_->AddLine(at(angle, inner), at(angle, 1.0), kTick, degree % 30 == 0 ? 2.0f : 1.0f);
    }
    // Close-hauled is where the red and green arcs end.
    for (const int side : {-1, 1}) {
      draw_->PathArcTo(centre_, radius_ * 0.97f, static_cast<float>(-kPi / 2),
                       static_cast<float>(-kPi / 2 + side * radians(45.0)), 24);
      draw_->PathStroke(side < 0 ? kPort : kStarboard, 0, 4.0f);
    }
  }

  void boat(const DialReading& reading) const {
    constexpr int kPoints = 24;
    ImVec2 outline[kPoints];
    for (int i = 0; i < kPoints; ++i) {
      // From the bow down one side and up the other: a half-breadth that is fullest aft of the
      // middle.
      const double s =
          i < kPoints / 2 ? i / (kPoints / 2 - 1.0) : (kPoints - 1 - i) / (kPoints / 2 - 1.0);
      const double breadth = 0.155 * std::pow(std::sin(kPi * std::pow(s, 0.62) * 0.78), 0.8) / 0.93;
      const double y = -0.55 + 1.1 * s;
      const float sign = i < kPoints / 2 ? 1.0f : -1.0f;
      outline[i] = {centre_.x + sign * static_cast<float>(breadth) * radius_,
                    centre_.y + static_cast<float>(y) * radius_};
    }
    draw_->AddPolyline(outline, kPoints, kHull, ImDrawFlags_Closed, 2.0f);
    const ImVec2 mast{centre_.x, centre_.y - 0.08f * radius_};
    swing(mast, reading.boom_angle, 0.42, kSail, 3.5f);
    swing({centre_.x, centre_.y - 0.5f * radius_}, reading.jib_angle, 0.42, kSail, 2.5f);
    swing({centre_.x, centre_.y + 0.5f * radius_}, reading.rudder_angle, 0.16, kHull, 3.0f);
  }

  void arrow(double angle, ImU32 colour, double tip, float width) const {
    const double away = 0.30;
    const ImVec2 head = at(angle, tip);
    draw_->AddLine(at(angle, 1.12), at(angle, tip + 0.08), colour, width);
    draw_->AddTriangleFilled(head, at(angle + 0.10 * away / tip * 1.6, tip + 0.17),
                             at(angle - 0.10 * away / tip * 1.6, tip + 0.17), colour);
  }

 private:
  // A spar hinged at `from`, hanging aft, its end swung to starboard by `angle`.
  void swing(ImVec2 from, double angle, double length, ImU32 colour, float width) const {
    const double r = length * static_cast<double>(radius_);
    draw_->AddLine(from,
                   {from.x + static_cast<float>(r * std::sin(angle)),
                    from.y + static_cast<float>(r * std::cos(angle))},
                   colour, width);
  }

  ImDrawList* draw_;
  ImVec2 centre_;
  float radius_;
};

}  // namespace

void draw_wind_dial(const DialReading& reading, float radius) {
  const float margin = radius * 0.16f;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Dial dial({corner.x + radius + margin, corner.y + radius + margin}, radius);
  dial.ring();
  dial.boat(reading);
  dial.arrow(reading.true_angle, kTrue, 0.74, 2.0f);
  dial.arrow(reading.apparent_angle, kApparent, 0.66, 3.5f);
  ImGui::Dummy({2.0f * (radius + margin), 2.0f * (radius + margin)});
  const auto legend = [](ImU32 colour, const char* name, double angle, double knots) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::Text("%s %3.0f\xC2\xB0 %c  %4.1f kn", name, std::abs(degrees(angle)),
                angle < 0 ? 'P' : 'S', knots);
    ImGui::PopStyleColor();
  };
  legend(kApparent, "apparent", reading.apparent_angle, reading.apparent_knots);
  legend(kTrue, "true    ", reading.true_angle, reading.true_knots);
}

}  // namespace offing
