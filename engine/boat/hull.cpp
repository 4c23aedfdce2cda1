#include "engine/boat/hull.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

#include "engine/core/angles.h"

namespace offing {

HullReading Hull::add_loads(Loads& loads, const RigidBody& body, const RigidBodyState& state,
                            const glm::dvec3& centre, const WaterProbe& water, HullMemory& memory,
                            double dt) const {
  const glm::dmat3 world_from_body = glm::mat3_cast(state.orientation);
  const glm::dmat3 body_from_world = glm::transpose(world_from_body);
  const glm::dvec3 up = body_from_world[1];
  const glm::dvec3 velocity = body_from_world * state.velocity;
  const glm::dvec3& rate = state.angular_velocity;
  const glm::dvec3 acceleration = water.mean_acceleration();

  HullReading reading;
  const int count = static_cast<int>(shape_.sections.size());
  for (int i = 0; i < count; ++i) {
    const HullSection& section = shape_.sections[i];
    const SliceWater& local = water.slice(i);
    // Depth of the point (x, y) of the slice = height of the water above it: linear in x and y.
    const glm::dvec3 right = world_from_body[0], mast = world_from_body[1];
    const auto gradient = [&](const glm::dvec3& axis) {
      return local.slope.x * axis.x + local.slope.y * axis.z - axis.y;
    };
    const WetSection wet =
        wet_section(section, local.height - local.centre.y, {gradient(right), gradient(mast)});
    const double added =
        damping_.impact * kWaterDensity * kPi / 8.0 * wet.breadth * wet.breadth * section.thickness;
    const double gained = memory.known_ ? std::max(added - memory.added_[i], 0.0) : 0.0;
    memory.added_[i] = added;
    if (wet.area <= 0.0) continue;

    const double volume = wet.area * section.thickness;
    const glm::dvec3 push(-kWaterDensity * kGravity * volume * local.slope.x,
                          kWaterDensity * volume *
                              (kGravity + acceleration.y + water.pitch_acceleration() * section.z),
                          -kWaterDensity * kGravity * volume * local.slope.y);
    const glm::dvec3 arm = glm::dvec3(wet.centroid.x, wet.centroid.y, section.z) - centre;
    loads.add(body_from_world * push, arm);
    reading.volume += volume;
    reading.buoyancy += push;

    // Damping, relative to the water: up and down by the waves it makes, by drag and by slamming,
    // sideways by cross-flow.
    const glm::dvec3 relative = velocity + glm::cross(rate, arm) - body_from_world * local.velocity;
    const double sinking = glm::dot(relative, up);
    const double plane = wet.breadth * section.thickness;
    const double slam = sinking < 0.0 ? gained / dt : 0.0;
    reading.slam -= slam * sinking;
    const double vertical = damping_.heave_per_area * plane + slam +
                            0.5 * kWaterDensity * damping_.heave_drag * plane * std::abs(sinking);
    const glm::dvec3 mid = glm::dvec3(wet.waterline_mid, wet.centroid.y, section.z) - centre;
    loads.add_damping(up, mid, vertical, sinking);
    const double side_area = section.thickness * wet.area / std::max(wet.breadth, 0.2);
    loads.add_damping({1.0, 0.0, 0.0}, arm,
                      0.5 * kWaterDensity * damping_.cross_flow * side_area * std::abs(relative.x),
                      relative.x);
  }

  memory.known_ = true;

  const double displaced = body.mass / kWaterDensity;
  const double wetness = std::clamp(reading.volume / displaced, 0.0, 1.0);
  loads.add(wetness * body.added_mass * (body_from_world * acceleration), glm::dvec3(0.0));
  // A surface that lifts the stern turns her about -x.
  loads.add_torque({-wetness * body.added_inertia.x * water.pitch_acceleration(), 0.0, 0.0});
  // Munk's moment: a long body that drifts wants to lie across its way (Newman 1977, 4.13). It is
  // what brings the centre of lateral resistance forward of the keel, and the bow round from irons.
  const glm::dvec3 drift = velocity - body_from_world * water.mean_velocity();
  loads.add_torque(
      {0.0, -wetness * damping_.munk * (body.added_mass.x - body.added_mass.z) * drift.x * drift.z,
       0.0});
  // Rolling to starboard is a negative turn about z (aft).
  loads.add_angular_damping(wetness * glm::dvec3(0.0, damping_.yaw, damping_.roll),
                            rate - glm::dvec3(0.0, 0.0, water.roll_rate()));
  return reading;
}

}  // namespace offing
