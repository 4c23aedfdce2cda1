#include "game/world/world.h"

#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

#include "engine/core/angles.h"
#include "engine/core/random.h"
#include "game/world/clouds.h"

namespace offing {

World::World(Scene scene, const WaterSurface& water)
    : scene_(std::move(scene)),
      water_(water),
      wind_(scene_.environment),
      boat_(scene_.boat.parameters),
      camera_(scene_.camera) {}

// The rain of the present clouds, and the wind that it brings down.
void World::update_rain() {
  Environment& environment = scene_.environment;
  const CloudView view = cloud_view(scene_, environment, glm::dvec3(0.0));
  const bool changed = rain_.update(view);
  const double strength = scene_.clouds.effects.squalls;
  const std::uint64_t key = hash_of(environment.wind.speed, environment.wind.from_deg, strength);
  if (changed || key != squall_key_) {
    squall_key_ = key;
    environment.set_squalls(
        rain_.any() ? std::make_shared<SquallField>(rain_.rain(), RainCells::kSize, rain_.period(),
                                                    environment.wind_velocity(), strength)
                    : std::make_shared<SquallField>());
  }
  if (rain_.any()) environment.set_squall_corner(rain_.corner(view));
}

void World::start() {
  update_rain();
  boat_.start(scene_.boat.position, radians(scene_.boat.heading_deg), scene_.boat.speed, water_,
              scene_.environment.elapsed());
  owed_ = 0.0;
  before_ = boat_.state();
  time_before_ = scene_.environment.elapsed();
  start_flotsam();
  draw_between(1.0);
  move_camera(0.0);
}

void World::start_flotsam() {
  flotsam_.clear();
  if (!scene_.flotsam) return;
  // Ahead of her and out of her way, a few lengths apart.
  const glm::dvec2 places[] = {{7.0, 22.0}, {-9.0, 34.0}, {16.0, 60.0}};  // m abeam, ahead
  const double heading = radians(scene_.boat.heading_deg);
  const glm::dvec2 ahead(std::sin(heading), -std::cos(heading)), right(-ahead.y, ahead.x);
  FloatingThing things[] = {barrel(), crate(), raft()};
  for (int kind = 0; kind < static_cast<int>(kFlotsam.size()); ++kind) {
    Afloat thing{.kind = kind, .body = FloatingBody(things[kind])};
    const glm::dvec2 place = scene_.boat.position + places[kind].x * right + places[kind].y * ahead;
    thing.body.start(place, heading + 1.1 * kind, water_, scene_.environment.elapsed());
    thing.position_before = thing.body.position();
    thing.orientation_before = thing.body.orientation();
    flotsam_.push_back(std::move(thing));
  }
}

void World::update(const Helm& helm, double dt) {
  apply(helm, dt);
  if (!scene_.environment.paused) {
    owed_ = std::min(owed_ + dt, kMostSteps * kStep);
    // A step is due when all of it has passed, give or take what adding up loses.
    while (owed_ > kStep * (1.0 - 1e-9)) {
      before_ = boat_.state();
      time_before_ = scene_.environment.elapsed();
      boat_.step(water_, wind_, time_before_, kStep);
      for (Afloat& thing : flotsam_) {
        thing.position_before = thing.body.position();
        thing.orientation_before = thing.body.orientation();
        thing.body.step(water_, time_before_, kStep);
      }
      scene_.environment.advance(kStep);
      update_rain();
      owed_ -= kStep;
    }
    draw_between(std::max(owed_, 0.0) / kStep);
  }
  move_camera(dt);
}

void World::move_camera(double dt) {
  camera_.update({drawn_boat_.position, drawn_boat_.orientation}, dt);
  const glm::dvec2 place(camera_.pose().position.x, camera_.pose().position.z);
  WaterSample water;
  water_.sample({&place, 1}, drawn_time_, {&water, 1});
  camera_.keep_dry(water.height);
  eye_depth_ = std::max(water.height - camera_.pose().position.y, 0.0);
}

void World::apply(const Helm& helm, double dt) {
  constexpr double kSheetRate = 0.35;  // of the sheet's whole length per second
  constexpr double kLeverRate = 0.8;   // of the motor's lever
  if (helm.toggle_auto_trim) boat_.controls().auto_trim = !boat_.controls().auto_trim;
  if (helm.toggle_heading_hold) boat_.hold_heading(!boat_.holding());
  if (helm.tack_or_gybe) boat_.tack_or_gybe();
  if (helm.reef >= 0) boat_.controls().reef = helm.reef;
  if (helm.mainsheet != 0.0) boat_.trim_main(helm.mainsheet * kSheetRate * dt);
  if (helm.jib_sheet != 0.0) boat_.trim_jib(helm.jib_sheet * kSheetRate * dt);
  move_lever(kLeverRate * helm.motor * dt);
  boat_.steer(helm.rudder);
}

void World::move_lever(double delta) {
  if (delta == 0.0) {
    lever_held_ = false;
    return;
  }
  double& lever = boat_.controls().motor;
  const double wanted = std::clamp(lever + delta, -1.0, 1.0);
  // It clicks in neutral: a hand that wants the other way lets go and pushes again.
  if (lever_stopped_ && lever_held_) return;
  lever_stopped_ = lever * wanted < 0.0 || (lever != 0.0 && wanted == 0.0);
  lever_held_ = true;
  lever = lever_stopped_ ? 0.0 : wanted;
}

void World::draw_between(double share) {
  drawn_boat_ = interpolate(before_, boat_.state(), share);
  for (Afloat& thing : flotsam_) {
    thing.drawn_position = glm::mix(thing.position_before, thing.body.position(), share);
    thing.drawn_orientation = glm::slerp(thing.orientation_before, thing.body.orientation(), share);
  }
  drawn_time_ = time_before_ + (scene_.environment.elapsed() - time_before_) * share;
}

}  // namespace offing
