// What hangs and streams about the boat: sheets, halyards and telltales.
#include <algorithm>
#include <cmath>

#include "game/frame/boat_pass.h"
#include "game/frame/ropes.h"

namespace offing {
void BoatPass::add_ropes(Pose& out, const BoatView& view, const glm::vec3& down) const {
  constexpr float kSheetRadius = 0.007f, kHalyardRadius = 0.005f;
  const auto rope = [&](glm::vec3 a, glm::vec3 b, float length, float radius) {
    add_line(out.lines, hanging_rope(a, b, length, down), radius, rope_material_);
  };
  // The mainsheet: from the boom's block to the traveller. Its length is what lets the boom as far
  // out as its sheet allows, so it hangs slack while the boom swings inside.
  const glm::vec3 block(0.0f, -0.21f, 2.83f), traveller(0.0f, 0.60f, 2.68f);
  const auto block_at = [&](float angle) {
    const Node& node = nodes_[static_cast<std::size_t>(boom_)];
    return glm::vec3(node.parent_from_node * yawed(angle) * glm::vec4(block, 1.0f));
  };
  const float paid_out = glm::distance(block_at(view.main.sheet), traveller);
  for (const float part : {-0.03f, 0.03f}) {  // two parts of the tackle
    const glm::vec3 beside(part, 0.0f, 0.0f);
    rope(block_at(view.main.angle) + beside, traveller + beside,
         std::max(paid_out, glm::distance(block_at(view.main.angle), traveller)), kSheetRadius);
  }
  // Halyards down the mast's forward side.
  for (const float side : {-0.075f, 0.075f}) {
    rope({side, 10.6f, -0.66f}, {side, 1.55f, -0.68f}, 9.06f, kHalyardRadius);
  }
  if (!view.hoisted) return;
  // Jib sheets: through the cars to the winches. The one to leeward pulls, the other lies slack.
  const Cloth& cloth = cloth_[kJib];
  const auto clew_at = [&](float angle) {
    const Node& node = nodes_[static_cast<std::size_t>(cloth.node)];
    return glm::vec3(node.parent_from_node * yawed(angle) *
                     glm::vec4(view.reef * cloth.clew, 1.0f));
  };
  const glm::vec3 clew = clew_at(view.jib.angle);
  for (const float side : {-1.0f, 1.0f}) {
    const glm::vec3 car(0.575f * side, 1.21f, 0.39f), winch(0.90f * side, 1.02f, 1.75f);
    const bool pulls = side * view.jib.angle >= 0.0f;
    const float direct = glm::distance(clew, car);
    const float length = pulls
                             ? std::max(glm::distance(clew_at(side * view.jib.sheet), car), direct)
                             : 1.12f * direct + 0.1f;
    rope(clew, car, length, kSheetRadius);
    rope(car, winch, glm::distance(car, winch), kSheetRadius);
  }
}

void BoatPass::add_telltales(Pose& out, const BoatView& view, const glm::vec3& down,
                             float time) const {
  constexpr float kLength = 0.24f, kThickness = 0.006f, kOff = 0.02f;
  constexpr int kPieces = 4;
  const auto streamer = [&](Sails index, float u, float v, float side, float flow, int material) {
    const Cloth& cloth = cloth_[index];
    const glm::mat4& from_node = out.boat.boat_from_node[cloth.node];
    const glm::vec3 from = cloth_point(out.cloth[index], cloth, u, v);
    const glm::vec3 down_here = glm::inverse(glm::mat3(from_node)) * down;
    const float seed = 3.7f * static_cast<float>(index) + 11.0f * v + side;
    std::vector<glm::vec3> points;
    glm::vec3 at = from + glm::vec3(side * kOff, 0.0f, 0.0f);
    // Streams aft where the flow lies on the cloth, lifts and shakes where it does not, hangs in
    // calm.
    const float wind = std::clamp(glm::length(view.apparent_wind) / 3.0f, 0.0f, 1.0f);
    const float shake = (1.0f - flow) * wind;
    for (int i = 0; i <= kPieces; ++i) {
      points.emplace_back(from_node * glm::vec4(at, 1.0f));
      const float phase = 9.0f * time + seed - 0.9f * static_cast<float>(i);
      const glm::vec3 aft(side * 0.5f * shake * std::abs(std::sin(0.7f * phase)),
                          shake * 1.2f * std::sin(phase), 1.0f - 0.8f * shake);
      const glm::vec3 way = glm::mix(down_here, aft, wind);
      at += kLength / kPieces / std::max(glm::length(way), 1e-3f) * way;
    }
    add_line(out.lines, points, kThickness, material);
  };
  for (const float v : {0.22f, 0.45f, 0.68f}) {
    for (const float side : {-1.0f, 1.0f}) {
      const bool lee = side * view.jib.fill >= 0.0f;
      const float flow = lee ? 1.0f - view.jib.stall : 1.0f - view.jib.luff;
      streamer(kJib, 0.22f, v, side, flow, lee ? lee_material_ : windward_material_);
    }
  }
  for (const float v : {0.35f, 0.6f, 0.82f}) {
    const float flow = 1.0f - std::max(view.main.stall, view.main.luff);
    streamer(kMainsail, 1.0f, v, 0.0f, flow, lee_material_);
  }
}

// As shaders/boat/cloth.vert places it, without its waves.
glm::vec3 BoatPass::cloth_point(const shared::ClothParameters& p, const Cloth& cloth, float u,
                                float v) {
  const float chord = glm::mix(cloth.foot, cloth.head, v);
  const float place = p.belly.z, rise = 1.1f * place / (1.0f - place);
  const float camber = std::pow(u, rise) * std::pow(1.0f - u, 1.1f) /
                       (std::pow(place, rise) * std::pow(1.0f - place, 1.1f));
  const float from_foot = glm::smoothstep(0.0f, 0.35f, v);
  const float full = glm::mix(p.stream.w, 1.0f, from_foot);
  const float x = p.belly.x * chord * camber * full * (1.0f - 0.7f * p.gradient_weight.w) +
                  std::sin(p.belly.y * v) * chord * u;
  return {x, v * cloth.hoist, u * chord};
}

}  // namespace offing
