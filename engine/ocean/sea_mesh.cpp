#include "engine/ocean/sea_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace offing {
namespace {

/// The five planes of a view with an infinite far side, inward.
class View {
 public:
  explicit View(const glm::mat4& clip_from_relative) {
    const glm::dmat4 rows = glm::transpose(glm::dmat4(clip_from_relative));
    planes_ = {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1], rows[3]};
  }
  bool sees(glm::dvec3 low, glm::dvec3 high) const {
    return std::all_of(planes_.begin(), planes_.end(), [&](const glm::dvec4& plane) {
      const glm::dvec3 corner{plane.x > 0.0 ? high.x : low.x, plane.y > 0.0 ? high.y : low.y,
                              plane.z > 0.0 ? high.z : low.z};
      return glm::dot(glm::dvec3(plane), corner) + plane.w > 0.0;
    });
  }

 private:
  std::array<glm::dvec4, 5> planes_;
};

struct Selection {
  const SeaMesh& mesh;
  const View& view;
  glm::dvec2 eye;
  double height, amplitude;
  std::vector<SeaMesh::Square> squares;

  // (i, j) counts squares of this level from the world's origin.
  void visit(int level, double i, double j) {
    const double spacing = std::ldexp(mesh.finest_spacing, level);
    const double side = spacing * mesh.cells;
    const double x = side * i - eye.x, z = side * j - eye.y;
    const double near_x = std::max({x, -x - side, 0.0}), near_z = std::max({z, -z - side, 0.0});
    const double far_x = std::max(std::abs(x), std::abs(x + side));
    const double far_z = std::max(std::abs(z), std::abs(z + side));
    const double ground = std::hypot(near_x, near_z);
    const double drop = (far_x * far_x + far_z * far_z) / (2.0 * kEarthRadius);
    // Choppy waves move water sideways by about as much as up and down.
    const glm::dvec3 low{x - amplitude, -height - amplitude - drop, z - amplitude};
    const glm::dvec3 high{x + side + amplitude, -height + amplitude, z + side + amplitude};
    if (!view.sees(low, high)) return;
    if (level > 0 && std::hypot(ground, height) < SeaMesh::kReach * 0.5 * side) {
      for (const double dj : {0.0, 1.0}) {
        for (const double di : {0.0, 1.0}) visit(level - 1, 2.0 * i + di, 2.0 * j + dj);
      }
      return;
    }
    squares.emplace_back(x, z, spacing, SeaMesh::kReach * side);
  }
};

}  // namespace

double SeaMesh::horizon(double height) {
  return std::sqrt(std::max(height, 0.0) * (2.0 * kEarthRadius + std::max(height, 0.0)));
}

std::vector<SeaMesh::Square> SeaMesh::select(glm::dvec2 eye, double height, double amplitude,
                                             const glm::mat4& clip_from_relative,
                                             double farthest) const {
  // Crests beyond the horizon of the mean level still stand above it.
  const double reach = std::min(1.05 * (horizon(height) + horizon(amplitude)) + 2000.0, farthest);
  const double finest_side = finest_spacing * cells;
  const int top = std::max(0, static_cast<int>(std::ceil(std::log2(reach / (2.0 * finest_side)))));
  const double side = std::ldexp(finest_side, top);
  const View view(clip_from_relative);
  Selection selection{*this, view, eye, height, amplitude, {}};
  for (double j = std::floor((eye.y - reach) / side); j * side < eye.y + reach; j += 1.0) {
    for (double i = std::floor((eye.x - reach) / side); i * side < eye.x + reach; i += 1.0) {
      selection.visit(top, i, j);
    }
  }
  // Near first: what lies behind a crest is then rejected by depth.
  std::sort(selection.squares.begin(), selection.squares.end(),
            [](const SeaMesh::Square& a, const SeaMesh::Square& b) { return a.z < b.z; });
  return selection.squares;
}

}  // namespace offing
