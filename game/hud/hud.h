#pragma once
#include <string>
#include <vector>

#include "engine/graph/frame_graph.h"
#include "game/hud/wind_dial.h"
#include "game/world/world.h"

namespace offing {

/// What is open on the screen.
struct HudState {
  bool hidden = false;  ///< F10
  bool panel = false;   ///< Space: sliders and times
  bool menu = false;    ///< Esc
  bool help = false;    ///< F1
  bool quit = false;    ///< asked for in the menu
};

/// What the renderer has to tell.
struct HudInfo {
  std::string renderer, quality;
  double frames_per_second = 0.0;
  double frame_ms = 0.0;
  const std::vector<PassReport>* passes = nullptr;  ///< of the last second
  std::string shader_error;                         ///< empty when all is well
  double hs = 0.0, tp = 0.0;                        ///< of the sea, m and s
};

/// Draws instruments, panels, menu and help for this frame, between ImGuiLayer::begin_frame() and
/// end_frame(). Sliders change the world's scene.
void draw_hud(HudState& state, World& world, const HudInfo& info);

}  // namespace offing
