#include "game/play/controls.h"

#include <algorithm>
#include <iterator>

namespace offing {
namespace {

// -1, 0 or 1 from two opposite keys.
double axis(bool less, bool more) { return (more ? 1.0 : 0.0) - (less ? 1.0 : 0.0); }

double towards(double value, double target, double step) {
  return value + std::clamp(target - value, -step, step);
}

}  // namespace

const KeyHelp kKeyHelp[] = {
    {"A D or arrows", "rudder to port, to starboard"},
    {"W S or arrows", "mainsheet in, out"},
    {"R F", "jib sheet in, out"},
    {"T", "automatic trim on, off"},
    {"H", "hold this heading"},
    {"G   B", "motor ahead   astern, 8 kW, for calms"},
    {"X", "tack or gybe"},
    {"1 2 3", "full sail, first reef, second reef"},
    {"C   V", "next camera   look astern"},
    {"mouse", "look round; wheel: nearer, farther"},
    {"[ ]", "less wind, more wind"},
    {", .", "less swell, more swell"},
    {"P   O I", "pause time   faster clock, slower and backwards"},
    {"Space", "panels (frees the mouse), back to sailing"},
    {"F1  F5", "this help   reload shaders"},
    {"F10 F12", "hide everything   photo"},
    {"Esc", "menu"},
};
const int kKeyHelpCount = static_cast<int>(std::size(kKeyHelp));

Helm Controls::helm(const Input& input, double dt) {
  constexpr double kFullRudderIn = 0.35, kCentredIn = 0.25;  // s
  Helm helm;
  const GamepadState& pad = input.gamepad();
  const bool port = input.held(Key::kA) || input.held(Key::kLeft);
  const bool starboard = input.held(Key::kD) || input.held(Key::kRight);
  const double wanted = axis(port, starboard);
  const double pace = wanted != 0.0 ? dt / kFullRudderIn : dt / kCentredIn;
  rudder_ = towards(rudder_, wanted, pace);
  const double stick = static_cast<double>(pad.left_stick.x);
  helm.rudder = stick != 0.0 ? stick : rudder_;

  helm.mainsheet = axis(input.held(Key::kW) || input.held(Key::kUp),
                        input.held(Key::kS) || input.held(Key::kDown));
  helm.mainsheet += static_cast<double>(pad.left_trigger - pad.right_trigger);
  helm.jib_sheet = axis(input.held(Key::kR) || input.held(PadButton::kRightBumper),
                        input.held(Key::kF) || input.held(PadButton::kLeftBumper));
  helm.toggle_auto_trim = input.pressed(Key::kT) || input.pressed(PadButton::kY);
  helm.toggle_heading_hold = input.pressed(Key::kH) || input.pressed(PadButton::kA);
  helm.tack_or_gybe = input.pressed(Key::kX) || input.pressed(PadButton::kX);
  helm.motor = axis(input.held(Key::kB), input.held(Key::kG));
  if (input.pressed(Key::kOne)) helm.reef = 0;
  if (input.pressed(Key::kTwo)) helm.reef = 1;
  if (input.pressed(Key::kThree)) helm.reef = 2;
  return helm;
}

Commands Controls::commands(const Input& input, bool looking) {
  constexpr double kRadiansPerPixel = 0.004, kRadiansPerFrameOfStick = 0.04;
  Commands commands;
  commands.toggle_panel = input.pressed(Key::kSpace);
  commands.toggle_menu = input.pressed(Key::kEscape) || input.pressed(PadButton::kStart);
  commands.toggle_help = input.pressed(Key::kF1);
  commands.toggle_hud = input.pressed(Key::kF10);
  commands.next_camera = input.pressed(Key::kC) || input.pressed(PadButton::kRightStick);
  commands.look_astern = input.held(Key::kV);
  commands.toggle_pause = input.pressed(Key::kP);
  commands.faster = input.pressed(Key::kO);
  commands.slower = input.pressed(Key::kI);
  commands.reload_shaders = input.pressed(Key::kF5);
  commands.photo = input.pressed(Key::kF12);
  commands.wind_change = axis(input.held(Key::kLeftBracket), input.held(Key::kRightBracket));
  commands.swell_change = axis(input.held(Key::kComma), input.held(Key::kPeriod));
  const GamepadState& pad = input.gamepad();
  commands.look_yaw = kRadiansPerFrameOfStick * static_cast<double>(pad.right_stick.x);
  commands.look_pitch = -kRadiansPerFrameOfStick * static_cast<double>(pad.right_stick.y);
  if (looking) {
    commands.look_yaw += kRadiansPerPixel * input.mouse_delta().x;
    commands.look_pitch -= kRadiansPerPixel * input.mouse_delta().y;
    commands.zoom = input.scroll().y;
  }
  return commands;
}

}  // namespace offing
