#include "engine/boat/water_probe.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/core/angles.h"

namespace offing {
namespace {

bool finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

void WaterProbe::reset() {
  started_ = false;
  vertical_acceleration_ = pitch_acceleration_ = slope_energy_ = velocity_energy_ = 0.0;
  mean_velocity_ = mean_acceleration_ = glm::dvec3(0.0);
  good_.fill(WaterSample{});
}

WaterSample WaterProbe::checked(const WaterSample& sample, int index) {
  constexpr double kMostHeight = 40.0, kMostSpeed = 30.0, kLeastUp = 0.17;
  if (!std::isfinite(sample.height) || !finite(sample.normal) || !finite(sample.velocity)) {
    ++limits_;
    return good_[index];
  }
  WaterSample result = sample;
  const double speed = glm::length(result.velocity);
  if (speed > kMostSpeed) {
    // scaled in two steps: the square of an absurd number may overflow
    result.velocity /= std::max(
        {std::abs(result.velocity.x), std::abs(result.velocity.y), std::abs(result.velocity.z)});
    result.velocity *= kMostSpeed / glm::length(result.velocity);
  }
  const bool cut =
      speed > kMostSpeed || std::abs(result.height) > kMostHeight || !(result.normal.y >= kLeastUp);
  result.height = std::clamp(result.height, -kMostHeight, kMostHeight);
  if (!(result.normal.y >= kLeastUp)) result.normal = {0.0, 1.0, 0.0};
  if (cut) ++limits_;
  good_[index] = result;
  return result;
}

void WaterProbe::sample(const HullShape& shape, const glm::dvec3& origin,
                        const glm::dquat& orientation, const WaterSurface& water, double time,
                        double dt) {
  const int count = static_cast<int>(shape.sections.size());
  const glm::dvec3 aft = orientation * glm::dvec3(0.0, 0.0, 1.0);
  // To starboard along the water, whatever the heel. A bow that points at the zenith has no
  // starboard side on the water: any direction serves.
  glm::dvec2 right(aft.z, -aft.x);
  const double level = glm::length(right);
  right = level > 1e-6 ? right / level : glm::dvec2(1.0, 0.0);
  const double reach = 0.35 * shape.beam;

  for (int i = 0; i < count; ++i) slices_[i].centre = origin + aft * shape.sections[i].z;
  // Slices closer together than half a metre share their samples: the sea has no shorter waves that
  // move a body.
  constexpr double kApart = 0.5;
  const double first = shape.sections.front().z, last = shape.sections.back().z;
  const int stations = std::clamp(static_cast<int>(std::ceil((last - first) / kApart)) + 1,
                                  std::min(2, count), count);
  const double apart = stations > 1 ? (last - first) / (stations - 1) : 1.0;
  for (int i = 0; i < stations; ++i) {
    const glm::dvec3 centre = origin + aft * (first + i * apart);
    const glm::dvec2 place(centre.x, centre.z);
    points_[2 * i] = place + reach * right;
    points_[2 * i + 1] = place - reach * right;
  }
  water.sample(std::span(points_.data(), 2 * stations), time,
               std::span(samples_.data(), 2 * stations));

  struct Station {
    double height = 0.0, roll = 0.0;
    glm::dvec2 slope{0.0};
    glm::dvec3 velocity{0.0};
  };
  std::array<Station, kMostSlices> sampled;
  for (int i = 0; i < stations; ++i) {
    const WaterSample starboard = checked(samples_[2 * i], 2 * i);
    const WaterSample port = checked(samples_[2 * i + 1], 2 * i + 1);
    Station& station = sampled[i];
    station.height = 0.5 * (starboard.height + port.height);
    station.velocity = 0.5 * (starboard.velocity + port.velocity);
    const glm::dvec2 from_normals =
        -0.5 * (glm::dvec2(starboard.normal.x, starboard.normal.z) / starboard.normal.y +
                glm::dvec2(port.normal.x, port.normal.z) / port.normal.y);
    // Across the boat the heights say it best, for waves as short as the beam.
    double across = (starboard.height - port.height) / (2.0 * reach);
    across = std::clamp(across, -3.0, 3.0);
    station.slope = from_normals + right * (across - glm::dot(from_normals, right));
    station.roll = (starboard.velocity.y - port.velocity.y) / (2.0 * reach);
  }

  glm::dvec3 velocity(0.0);
  glm::dvec2 slope_sum(0.0);
  double height = 0.0, roll = 0.0, lift = 0.0, arms = 0.0;
  for (int i = 0; i < count; ++i) {
    const double z = shape.sections[i].z;
    const int k = std::clamp(static_cast<int>((z - first) / apart), 0, std::max(stations - 2, 0));
    const Station& a = sampled[k];
    const Station& b = sampled[std::min(k + 1, stations - 1)];
    const double t = stations > 1 ? (z - first) / apart - k : 0.0;
    SliceWater& slice = slices_[i];
    slice.height = a.height + (b.height - a.height) * t;
    slice.velocity = a.velocity + (b.velocity - a.velocity) * t;
    slice.slope = a.slope + (b.slope - a.slope) * t;
    velocity += slice.velocity;
    slope_sum += slice.slope;
    height += slice.height;
    lift += z * slice.velocity.y;
    arms += z * z;
    roll += a.roll + (b.roll - a.roll) * t;
  }
  velocity /= count;
  mean_slope_ = slope_sum / static_cast<double>(count);
  mean_height_ = height / count;
  roll_rate_ = roll / count;

  const double pitch_rate = arms > 0.0 ? lift / arms : 0.0;
  if (started_) {
    constexpr double kSmoothing = 0.1, kMostPitch = 4.0;
    // The difference is half a step late already: the smoothing makes it the same lag in all steps.
    const double share = dt / (dt + std::max(kSmoothing - 0.5 * dt, 0.0));
    const double up =
        std::clamp((velocity.y - mean_velocity_.y) / dt, -0.6 * kGravity, 0.6 * kGravity);
    const double pitch = std::clamp((pitch_rate - pitch_rate_) / dt, -kMostPitch, kMostPitch);
    vertical_acceleration_ += (up - vertical_acceleration_) * share;
    pitch_acceleration_ += (pitch - pitch_acceleration_) * share;
  }
  pitch_rate_ = pitch_rate;
  started_ = true;
  mean_velocity_ = velocity;
  constexpr double kMemory = 10.0;
  const double weight = dt / (dt + kMemory);
  slope_energy_ += (glm::dot(mean_slope_, mean_slope_) - slope_energy_) * weight;
  velocity_energy_ += (glm::dot(velocity, velocity) - velocity_energy_) * weight;
  mean_acceleration_ = {-kGravity * mean_slope_.x, vertical_acceleration_,
                        -kGravity * mean_slope_.y};
}

double WaterProbe::left_at(double depth) const {
  if (velocity_energy_ < 1e-9 || depth <= 0.0) return 1.0;
  constexpr double kShortest = 3.0;  // 1/m: no wave shorter than 2 m moves a boat
  const double k = std::min(kGravity * slope_energy_ / velocity_energy_, kShortest);
  return std::exp(-k * depth);
}

const SliceWater& WaterProbe::at(const HullShape& shape, double z) const {
  const int count = static_cast<int>(shape.sections.size());
  const double step = shape.sections.front().thickness;
  const int i = static_cast<int>(std::floor((z - shape.sections.front().z) / step + 0.5));
  return slices_[std::clamp(i, 0, count - 1)];
}

}  // namespace offing
