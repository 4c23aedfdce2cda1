#include "game/hud/hud.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/core/angles.h"
#include "game/hud/field_panel.h"
#include "game/hud/instruments.h"
#include "game/play/controls.h"

namespace offing {
namespace {

// A slider over the day of the scene's date, in UTC hours.
void draw_clock(Environment& environment) {
  constexpr double kDay = 86400.0;
  const double midnight = std::floor(environment.utc_seconds() / kDay) * kDay;
  double hours = (environment.utc_seconds() - midnight) / 3600.0;
  const double first = 0.0, last = 23.999;
  const int minutes = static_cast<int>(hours * 60.0);
  char format[32];
  std::snprintf(format, sizeof(format), "%02d:%02d UTC", minutes / 60, minutes % 60);
  if (ImGui::SliderScalar("time of day", ImGuiDataType_Double, &hours, &first, &last, format)) {
    environment.set_utc_seconds(midnight + hours * 3600.0);
  }
  ImGui::TextUnformatted(environment.date().c_str());
  ImGui::SameLine();
  if (ImGui::SmallButton("day -")) environment.set_utc_seconds(environment.utc_seconds() - kDay);
  ImGui::SameLine();
  if (ImGui::SmallButton("day +")) environment.set_utc_seconds(environment.utc_seconds() + kDay);

  if (ImGui::Button("slower, back")) environment.slow_down();
  ImGui::SameLine();
  if (ImGui::Button(environment.paused ? "run" : "pause")) environment.paused = !environment.paused;
  ImGui::SameLine();
  if (ImGui::Button("faster")) environment.quicken();
  ImGui::SameLine();
  if (ImGui::Button("x 1")) environment.clock_rate = 1.0;
  ImGui::TextDisabled("the clock %s, x %.0f", environment.paused ? "stands" : "runs",
                      environment.clock_rate);
}

void draw_times(const HudInfo& info) {
  if (info.passes == nullptr ||
      !ImGui::BeginTable("passes", 6, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg)) {
    return;
  }
  for (const char* column : {"pass", "ms", "ran", "cached", "culled", "skipped"})
    ImGui::TableSetupColumn(column);
  ImGui::TableHeadersRow();
  for (const PassReport& pass : *info.passes) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(pass.name.c_str());
    ImGui::TableNextColumn();
    if (!pass.milliseconds.empty()) ImGui::Text("%6.2f", pass.milliseconds.back());
    for (const int count : {pass.ran, pass.cached, pass.culled, pass.skipped}) {
      ImGui::TableNextColumn();
      if (count > 0) ImGui::Text("%d", count);
    }
  }
  ImGui::EndTable();
}

void draw_panel(World& world, const HudInfo& info) {
  const float height = ImGui::GetIO().DisplaySize.y;
  ImGui::SetNextWindowPos({12.0f, 12.0f}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize({390.0f, std::max(120.0f, height - 24.0f)}, ImGuiCond_FirstUseEver);
  ImGui::Begin("Weather, time and measures");
  ImGui::PushItemWidth(-165.0f);  // what is left of it is the labels'
  const FieldTable table = world.scene().fields();
  draw_clock(world.environment());
  if (ImGui::CollapsingHeader("wind and weather", ImGuiTreeNodeFlags_DefaultOpen)) {
    draw_fields(table, "environment.wind.");
    draw_fields(table, "environment.gusts");
    draw_fields(table, "environment.clouds.");
    draw_fields(table, "environment.haze");
    draw_fields(table, "environment.clock_rate");
  }
  if (ImGui::CollapsingHeader("place")) {
    draw_fields(table, "environment.latitude");
    draw_fields(table, "environment.longitude");
  }
  if (ImGui::CollapsingHeader("clouds: form, light, effects")) {
    draw_fields(table, "clouds.", "clouds.gardner.");
  }
  if (ImGui::CollapsingHeader("clouds: Gardner's")) draw_fields(table, "clouds.gardner.");
  if (ImGui::CollapsingHeader("painted sky")) draw_fields(table, "sky.palette");
  if (ImGui::CollapsingHeader("exposure")) draw_fields(table, "exposure.");
  if (ImGui::CollapsingHeader("sea", ImGuiTreeNodeFlags_DefaultOpen)) {
    for (const char* prefix : {"sea.spectrum", "sea.spreading", "sea.fetch", "sea.depth",
                               "sea.choppiness", "sea.swell."}) {
      draw_fields(table, prefix);
    }
    ImGui::TextDisabled("Hs %.2f m, Tp %.1f s", info.hs, info.tp);
  }
  if (ImGui::CollapsingHeader("frame", ImGuiTreeNodeFlags_DefaultOpen)) {
    ImGui::Text("%.1f ms, %.0f frames/s, quality %s", info.frame_ms, info.frames_per_second,
                info.quality.c_str());
    ImGui::TextDisabled("%s", info.renderer.c_str());
    draw_times(info);
  }
  ImGui::PopItemWidth();
  ImGui::End();
}

constexpr ImGuiWindowFlags kMiddle = ImGuiWindowFlags_NoCollapse |
                                     ImGuiWindowFlags_AlwaysAutoResize |
                                     ImGuiWindowFlags_NoSavedSettings;

void centre_next_window() {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x * 0.5f, display.y * 0.5f}, ImGuiCond_Always, {0.5f, 0.5f});
}

void draw_menu(HudState& state, World& world) {
  centre_next_window();
  ImGui::Begin("Offing", nullptr, kMiddle);
  const ImVec2 size{220.0f, 0.0f};
  if (ImGui::Button("Sail on (Esc)", size)) state.menu = false;
  if (ImGui::Button("Start again", size)) {
    world.start();
    state.menu = false;
  }
  if (ImGui::Button("Keys (F1)", size)) state.help = true;
  if (ImGui::Button("Quit", size)) state.quit = true;
  ImGui::End();
}

void draw_help(HudState& state) {
  centre_next_window();
  ImGui::Begin("Keys", &state.help, kMiddle);
  for (int i = 0; i < kKeyHelpCount; ++i) {
    ImGui::TextColored({1.0f, 0.8f, 0.45f, 1.0f}, "%s", kKeyHelp[i].keys);
    ImGui::SameLine(140.0f);
    ImGui::TextUnformatted(kKeyHelp[i].action);
  }
  ImGui::End();
}

void draw_shader_error(const std::string& error) {
  ImGui::SetNextWindowPos({12.0f, ImGui::GetIO().DisplaySize.y - 12.0f}, ImGuiCond_Always,
                          {0.0f, 1.0f});
  ImGui::Begin("shader error", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::TextColored({1.0f, 0.45f, 0.4f, 1.0f}, "The last good shaders are still in use:");
  ImGui::TextUnformatted(error.c_str());
  ImGui::End();
}

}  // namespace

void draw_hud(HudState& state, World& world, const HudInfo& info) {
  if (!state.hidden) {
    draw_instruments(world);
    if (state.panel) draw_panel(world, info);
    if (state.help) draw_help(state);
  }
  if (state.menu) draw_menu(state, world);
  if (!info.shader_error.empty()) draw_shader_error(info.shader_error);
}

}  // namespace offing
