#pragma once
#include "engine/platform/input.h"
#include "game/world/world.h"

namespace offing {

/// What keys, mouse and pad ask of the program, apart from the helm.
struct Commands {
  bool toggle_panel = false, toggle_menu = false, toggle_help = false, toggle_hud = false;
  bool next_camera = false, look_astern = false;
  bool toggle_pause = false, faster = false, slower = false;
  bool reload_shaders = false, photo = false;
  double wind_change = 0.0;                 ///< -1 less … 1 more, a rate
  double swell_change = 0.0;                ///< likewise
  double look_yaw = 0.0, look_pitch = 0.0;  ///< rad
  double zoom = 0.0;                        ///< notches
};

/// Reads the helm. `dt` in s self-centres the rudder: a tap is a touch of helm, a held key all of
/// it.
class Controls {
 public:
  Helm helm(const Input& input, double dt);
  /// `looking`: the mouse turns the camera (while sailing), or is free (for the panels).
  static Commands commands(const Input& input, bool looking);

 private:
  double rudder_ = 0.0;
};

/// The keys and what they do, a line each, for help and README.
struct KeyHelp {
  const char* keys;
  const char* action;
};
extern const KeyHelp kKeyHelp[];
extern const int kKeyHelpCount;

}  // namespace offing
