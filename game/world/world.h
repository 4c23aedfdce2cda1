#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "engine/boat/boat.h"
#include "engine/boat/environment_wind.h"
#include "engine/boat/floating_body.h"
#include "engine/clouds/rain_cells.h"
#include "engine/ocean/water_surface.h"
#include "game/world/camera.h"
#include "game/world/scene.h"

namespace offing {

/// What the player wants during one frame. Rates are held keys; the booleans are presses.
struct Helm {
  double rudder = 0.0;     ///< -1 to port … 1 to starboard
  double mainsheet = 0.0;  ///< -1 haul in … 1 ease, per frame a rate
  double jib_sheet = 0.0;  ///< likewise
  double motor = 0.0;      ///< -1 astern … 1 ahead, a rate: the lever stays where it is left
  bool toggle_auto_trim = false;
  bool toggle_heading_hold = false;
  bool tack_or_gybe = false;
  int reef = -1;  ///< 0 to 3, or -1 for no change
};

/// What floats about the boat at the start, by its model's node.
inline constexpr std::array<std::string_view, 3> kFlotsam = {"barrel", "crate", "raft"};

/// One of them.
struct Afloat {
  int kind = 0;  ///< index into kFlotsam
  FloatingBody body;
  glm::dvec3 position_before{0.0}, drawn_position{0.0};
  glm::dquat orientation_before{1.0, 0.0, 0.0, 0.0}, drawn_orientation{1.0, 0.0, 0.0, 0.0};
};

/// The simulation: environment, sea state, boat and camera. Knows no OpenGL. The same scene, seed
/// and steps give the same states.
class World {
 public:
  static constexpr double kStep = 1.0 / 120.0;  ///< s
  static constexpr int kMostSteps = 8;          ///< per update; time beyond them is dropped

  /// `water` is where the boat floats; it must outlive the world. start() must follow.
  World(Scene scene, const WaterSurface& water);
  World(const World&) = delete;  // the boat's wind refers to the environment in here
  World& operator=(const World&) = delete;

  /// Puts the boat on the water as the scene says. The water must be known by then.
  void start();
  /// Moves everything on by dt seconds of real time, in fixed steps.
  void update(const Helm& helm, double dt);

  Scene& scene() { return scene_; }
  const Scene& scene() const { return scene_; }
  const RainCells& rain() const { return rain_; }
  Environment& environment() { return scene_.environment; }
  const Environment& environment() const { return scene_.environment; }
  Boat& boat() { return boat_; }
  const Boat& boat() const { return boat_; }
  Camera& camera() { return camera_; }
  const Camera& camera() const { return camera_; }

  const std::vector<Afloat>& flotsam() const { return flotsam_; }
  /// The boat between its last two steps, as it is to be drawn now.
  const BoatState& drawn_boat() const { return drawn_boat_; }
  /// How far the camera lies under the waves, m; 0 above them.
  double eye_depth() const { return eye_depth_; }
  /// The sea's clock of what is drawn now, s.
  double drawn_time() const { return drawn_time_; }

 private:
  void apply(const Helm& helm, double dt);
  void move_lever(double delta);
  void start_flotsam();
  void draw_between(double share);
  void move_camera(double dt);

  Scene scene_;
  const WaterSurface& water_;
  void update_rain();

  RainCells rain_;
  std::uint64_t squall_key_ = 0;
  EnvironmentWind wind_;
  Boat boat_;
  Camera camera_;
  std::vector<Afloat> flotsam_;
  BoatState before_, drawn_boat_;
  double time_before_ = 0.0, drawn_time_ = 0.0;
  bool lever_held_ = false, lever_stopped_ = false;  ///< of the motor
  double eye_depth_ = 0.0;
  double owed_ = 0.0;  ///< time passed and not yet simulated, s
};

}  // namespace offing
