#include "game/hud/instruments.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/core/angles.h"

namespace offing {
namespace {

void big_number(const char* label, const char* format, double value, const char* unit) {
  ImGui::TextDisabled("%s", label);
  ImGui::SetWindowFontScale(1.7f);
  ImGui::Text(format, value);
  ImGui::SetWindowFontScale(1.0f);
  ImGui::SameLine();
  ImGui::TextDisabled("%s", unit);
}

// A bar from the middle for -1 to 1, or from the left for 0 to 1.
void bar(const char* label, double value, bool centred) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float left = 74.0f, width = 150.0f, height = 9.0f, y = at.y + 4.0f;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled({at.x + left, y}, {at.x + left + width, y + height},
                      IM_COL32(60, 90, 110, 160), 3.0f);
  const float zero = centred ? 0.5f : 0.0f;
  const float end =
      std::clamp(zero + static_cast<float>(value) * (centred ? 0.5f : 1.0f), 0.0f, 1.0f);
  draw->AddRectFilled({at.x + left + width * std::min(zero, end), y},
                      {at.x + left + width * std::max(zero, end) + 1.5f, y + height},
                      IM_COL32(250, 190, 90, 255), 2.0f);
  ImGui::Text("%s", label);
}

}  // namespace

void draw_instruments(const World& world) {
  const Boat& boat = world.boat();
  const Navigation& navigation = boat.navigation();
  const BoatState& state = world.drawn_boat();
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float radius = std::clamp(display.y * 0.105f, 46.0f, 96.0f);

  ImGui::SetNextWindowPos({display.x - 12.0f, 12.0f}, ImGuiCond_Always, {1.0f, 0.0f});
  ImGui::Begin("instruments", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing);
  DialReading reading;
  reading.apparent_angle = navigation.awa;
  reading.apparent_knots = knots(navigation.aws);
  reading.true_angle = navigation.twa;
  reading.true_knots = knots(navigation.tws);
  reading.boom_angle = state.boom_angle;
  reading.jib_angle = state.jib_angle;
  reading.rudder_angle = state.rudder_angle;
  draw_wind_dial(reading, radius);

  ImGui::Columns(2, nullptr, false);
  big_number("speed", "%.1f", knots(navigation.stw), "kn");
  ImGui::NextColumn();
  big_number("heading", "%03.0f",
             std::fmod(degrees(wrap_tau(navigation.heading)) + 0.5, 360.0) - 0.5, "\u00b0");
  ImGui::Columns(1);
  ImGui::Text("heel %2.0f\u00b0   %s", std::abs(degrees(navigation.heel)),
              std::string(name(navigation.point)).c_str());
  bar("rudder", state.rudder_angle / boat.parameters().rudder_most, true);
  bar("mainsheet", state.mainsheet, false);
  bar("jib sheet", state.jib_sheet, false);
  ImGui::TextDisabled("%s%s%s", boat.controls().auto_trim ? "auto trim  " : "",
                      boat.holding() ? "holding heading  " : "",
                      boat.controls().reef > 0 ? "reefed" : "");
  if (boat.controls().motor != 0.0) {
    ImGui::Text("motor %s %.0f %%", boat.controls().motor > 0.0 ? "ahead" : "astern",
                100.0 * std::abs(boat.controls().motor));
  }
  constexpr double kWorthSaying = 0.02;  // m^3
  const double shipped = state.deck_water + state.cockpit_water;
  if (shipped > kWorthSaying) ImGui::Text("water on deck %.0f l", 1000.0 * shipped);
  if (navigation.water_is_late) {
    ImGui::TextColored({1.0f, 0.78f, 0.4f, 1.0f}, "no news of the sea: sailing on the last");
  }
  ImGui::End();

  if (navigation.trouble != Trouble::kNone) {
    ImGui::SetNextWindowPos({display.x * 0.5f, display.y - 18.0f}, ImGuiCond_Always, {0.5f, 1.0f});
    ImGui::Begin("trouble", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushTextWrapPos(display.x - 40.0f);
    ImGui::TextColored({1.0f, 0.78f, 0.4f, 1.0f}, "%s",
                       std::string(name(navigation.trouble)).c_str());
    ImGui::SameLine();
    ImGui::Text("%s", std::string(advice(navigation.trouble)).c_str());
    ImGui::PopTextWrapPos();
    ImGui::End();
  }
}

}  // namespace offing
