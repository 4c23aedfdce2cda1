#pragma once
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace offing {

/// The displaced surface around a parameter point q: x = q + D(q), with D's derivatives.
struct SurfacePoint {
  glm::dvec3 displacement{0.0};            ///< Dx, h, Dz
  glm::dvec2 slope{0.0};                   ///< dh/dq
  double dxx = 0.0, dzz = 0.0, dxz = 0.0;  ///< dDx/dqx, dDz/dqz, dDx/dqz = dDz/dqx
};

/// Unit normal of the displaced surface: the slope in space is J^-T dh/dq, cross term included.
inline glm::dvec3 surface_normal(const SurfacePoint& p) {
  const double jacobian = std::max((1.0 + p.dxx) * (1.0 + p.dzz) - p.dxz * p.dxz, 0.05);
  const double sx = ((1.0 + p.dzz) * p.slope.x - p.dxz * p.slope.y) / jacobian;
  const double sz = ((1.0 + p.dxx) * p.slope.y - p.dxz * p.slope.x) / jacobian;
  return glm::normalize(glm::dvec3(-sx, 1.0, -sz));
}

/// Where a search for the water at a place has ended.
struct Meeting {
  glm::dvec2 parameter{0.0};
  SurfacePoint point;    ///< the surface there
  glm::dvec2 rest{0.0};  ///< what Newton's next step would still add to the parameter
};

/// The water at `place`: solves q + D(q) = place for q. Newton's method with the Jacobian's
/// determinant held at 0.2 or more, so that steep crests slow it down instead of throwing it away;
/// stops when the place is met within `tolerance` (m) or after `limit` steps, and gives the best
/// of what it saw.
template <class Surface>
Meeting meet_surface(glm::dvec2 place, double tolerance, int limit, const Surface& surface) {
  glm::dvec2 q = place;
  Meeting best;
  double best_miss = 1e300;
  for (int i = 0; i < limit; ++i) {
    const SurfacePoint p = surface(q);
    const glm::dvec2 miss = q + glm::dvec2(p.displacement.x, p.displacement.z) - place;
    const double distance = glm::length(miss);
    const double jacobian = std::max((1.0 + p.dxx) * (1.0 + p.dzz) - p.dxz * p.dxz, 0.2);
    glm::dvec2 step{((1.0 + p.dzz) * miss.x - p.dxz * miss.y) / jacobian,
                    ((1.0 + p.dxx) * miss.y - p.dxz * miss.x) / jacobian};
    // Never further than the miss by more than twice: where D is nearly folded Newton overshoots.
    const double length = glm::length(step);
    if (length > 2.0 * distance) step *= 2.0 * distance / length;
    if (distance < best_miss) {
      best_miss = distance;
      best = {q, p, -step};
    }
    if (distance < tolerance) break;
    q -= step;
  }
  return best;
}

}  // namespace offing
