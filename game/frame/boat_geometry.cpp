// The model's parts as vertices and draws, made once.
#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "game/frame/boat_pass.h"
#include "game/frame/weld.h"

namespace offing {
namespace {

struct ClothVertex {
  glm::vec3 position;
  glm::vec2 uv;
  glm::vec4 tangents;  ///< d(y, z)/du, d(y, z)/dv
};

/// A lamp's vertices as boat/rigid.vert wants them: all at its middle, the way from there as
/// normal, its smallest radius in u, so that it can be drawn larger than it is.
void place_from_middle(std::span<RigidVertex> lamp) {
  if (lamp.empty()) return;
  glm::vec3 low = lamp.front().position, high = low;
  for (const RigidVertex& vertex : lamp) {
    low = glm::min(low, vertex.position);
    high = glm::max(high, vertex.position);
  }
  const glm::vec3 middle = 0.5f * (low + high), reach = 0.5f * (high - low);
  const float radius = std::max(std::min({reach.x, reach.y, reach.z}), 1e-3f);
  for (RigidVertex& vertex : lamp) {
    vertex.normal = vertex.position - middle;
    vertex.position = middle;
    vertex.uv = {radius, 0.0f};
  }
}

}  // namespace

void BoatPass::build_rigid(ShaderLibrary& shaders, const Model& model) {
  std::vector<RigidVertex> vertices;
  std::vector<std::uint32_t> indices;
  const int mask = model.find("mask");
  const auto is_cloth = [&](int node) {
    return std::ranges::any_of(cloth_, [&](const Cloth& cloth) { return cloth.node == node; });
  };
  // What does not move in the boat is stored in her frame, the rest in that of the part that
  // carries it: a draw then needs one matrix, and there are few draws.
  struct Carrier {
    int node;
    glm::mat4 from_node;
  };
  std::vector<Carrier> carriers;
  for (int node = 0; node < static_cast<int>(model.nodes.size()); ++node) {
    const ModelNode& from = model.nodes[static_cast<std::size_t>(node)];
    if (node == boom_ || node == rudder_ || node == wheel_) {
      carriers.push_back({node, glm::mat4(1.0f)});
    } else if (from.parent < 0) {
      carriers.push_back({kStill, from.parent_from_node});
    } else {
      const Carrier& parent = carriers[static_cast<std::size_t>(from.parent)];
      carriers.push_back({parent.node, parent.from_node * from.parent_from_node});
    }
  }
  const auto append = [&](int node, const ModelPrimitive& primitive) {
    const glm::mat4& placement = carriers[static_cast<std::size_t>(node)].from_node;
    Welded welded;
    append_welded(model, primitive, welded, vertices, indices, [&](const ModelVertex& from) {
      return RigidVertex{glm::vec3(placement * glm::vec4(from.position, 1.0f)),
                         glm::mat3(placement) * from.normal, from.uv,
                         static_cast<float>(primitive.material)};
    });
  };
  const auto part_of = [&](int material) {
    const auto i = static_cast<std::size_t>(material);
    if (model.materials[i].name == "wire") return Part::kWire;
    return lamps_[i] == Lamp::kAllRound ? Part::kSolid : Part::kLamp;
  };
  // One draw for each program, picture and carrier; wires and lamps last, since they blend with
  // what lies behind them.
  const auto gather_carried = [&](const ShaderProgram& program, int picture, Part part,
                                  int carrier) {
    const auto first = static_cast<std::uint32_t>(indices.size());
    for (int node = 0; node < static_cast<int>(model.nodes.size()); ++node) {
      if (node == mask || is_cloth(node)) continue;
      if (carriers[static_cast<std::size_t>(node)].node != carrier) continue;
      for (const ModelPrimitive& primitive :
           model.nodes[static_cast<std::size_t>(node)].primitives) {
        const ModelMaterial& material =
            model.materials[static_cast<std::size_t>(primitive.material)];
        if (part_of(primitive.material) != part) continue;
        if (part == Part::kSolid && material.base_colour_image != picture) continue;
        const std::size_t first_vertex = vertices.size();
        append(node, primitive);
        if (part == Part::kLamp) place_from_middle(std::span(vertices).subspan(first_vertex));
      }
    }
    const auto count = static_cast<std::uint32_t>(indices.size()) - first;
    if (count == 0) return;
    DetailLevels levels;
    levels.fill({first, count});  // a wire's radius is not in its vertices: it stays as it is
    if (part == Part::kSolid) levels = add_detail_levels(vertices, indices, first);
    draws_.push_back({&program, levels, picture, part, carrier});
  };
  const auto gather = [&](const ShaderProgram& program, int picture, Part part) {
    for (const int carrier : {kStill, boom_, rudder_, wheel_}) {
      gather_carried(program, picture, part, carrier);
    }
  };
  const std::vector<std::filesystem::path> stages = {"boat/rigid.vert", "boat/rigid.frag"};
  gather(shaders.program(stages), -1, Part::kSolid);
  for (int picture = 0; picture < static_cast<int>(pictures_.size()); ++picture) {
    gather(shaders.program(stages, {{"PICTURE", "1"}}), picture, Part::kSolid);
  }
  gather(shaders.program(stages, {{"WIRE", "1"}}), -1, Part::kWire);
  gather(shaders.program(stages, {{"LAMP", "1"}}), -1, Part::kLamp);
  mask_.first = static_cast<std::uint32_t>(indices.size());
  if (mask >= 0) {
    for (const ModelPrimitive& primitive : model.nodes[static_cast<std::size_t>(mask)].primitives) {
      append(mask, primitive);
    }
  }
  mask_.count = static_cast<std::uint32_t>(indices.size()) - mask_.first;
  for (std::uint32_t i = mask_.first; i < indices.size(); ++i) {
    mask_corners_.push_back(vertices[indices[i]].position);
  }

  vertices_ = gl::Buffer::of<RigidVertex>("boat.vertices", vertices);
  indices_ = gl::Buffer::of<std::uint32_t>("boat.indices", indices);
  rigid_layout_ = gl::VertexArray("boat.rigid");
  set_rigid_layout(rigid_layout_, vertices_, indices_);
  line_vertices_ = gl::Buffer("boat.line_vertices", kMostLineVertices * sizeof(RigidVertex));
  line_indices_ = gl::Buffer("boat.line_indices", 6 * kMostLineVertices * sizeof(std::uint32_t));
  line_layout_ = gl::VertexArray("boat.lines");
  set_rigid_layout(line_layout_, line_vertices_, line_indices_);
  line_program_ = &shaders.program(stages, {{"WIRE", "1"}});
}

void BoatPass::build_cloth(const Model& model, const BoatTextures& textures) {
  std::vector<ClothVertex> vertices;
  std::vector<std::uint32_t> indices;
  for (Cloth& cloth : cloth_) {
    cloth.first = static_cast<std::uint32_t>(indices.size());
    const auto base = vertices.size();
    Welded welded;
    for (const ModelPrimitive& primitive :
         model.nodes[static_cast<std::size_t>(cloth.node)].primitives) {
      append_welded(model, primitive, welded, vertices, indices, [](const ModelVertex& from) {
        return ClothVertex{from.position, from.uv, glm::vec4(0.0f)};
      });
    }
    cloth.count = static_cast<std::uint32_t>(indices.size()) - cloth.first;
    // The cloth's derivatives along u and v: the mean over the triangles about a vertex, each of
    // which solves its two edges for them.
    std::vector<float> shares(vertices.size() - base, 0.0f);
    for (std::uint32_t i = cloth.first; i + 2 < indices.size(); i += 3) {
      const ClothVertex& a = vertices[indices[i]];
      const glm::vec2 s = vertices[indices[i + 1]].uv - a.uv,
                      t = vertices[indices[i + 2]].uv - a.uv;
      const glm::vec3 p = vertices[indices[i + 1]].position - a.position,
                      q = vertices[indices[i + 2]].position - a.position;
      const float area = s.x * t.y - s.y * t.x;
      if (std::abs(area) < 1e-12f) continue;
      const glm::vec3 du = (p * t.y - q * s.y) / area, dv = (q * s.x - p * t.x) / area;
      for (std::uint32_t k = 0; k < 3; ++k) {
        vertices[indices[i + k]].tangents += glm::vec4(du.y, du.z, dv.y, dv.z);
        shares[indices[i + k] - base] += 1.0f;
      }
    }
    for (std::size_t i = base; i < vertices.size(); ++i) {
      ClothVertex& vertex = vertices[i];
      vertex.tangents /= std::max(shares[i - base], 1.0f);
      cloth.hoist = std::max(cloth.hoist, vertex.position.y);
      cloth.foot = std::max(cloth.foot, vertex.position.z);
      if (vertex.uv.y > 0.999f) cloth.head = std::max(cloth.head, vertex.position.z);
      if (vertex.uv.x > 0.999f && vertex.uv.y < 0.001f) cloth.clew = vertex.position;
    }
  }
  cloth_[kMainsail].picture =
      cloth_texture("boat.mainsail", textures.main_pattern, textures.main_alpha);
  cloth_[kJib].picture = cloth_texture("boat.jib", textures.jib_pattern, {});
  cloth_[kFlag].picture = cloth_texture("boat.flag", textures.flag_pattern, textures.flag_alpha);

  cloth_vertices_ = gl::Buffer::of<ClothVertex>("boat.cloth_vertices", vertices);
  cloth_indices_ = gl::Buffer::of<std::uint32_t>("boat.cloth_indices", indices);
  cloth_layout_ = gl::VertexArray("boat.cloth");
  constexpr int kStride = sizeof(ClothVertex);
  cloth_layout_.attribute(0, 3, cloth_vertices_.id(), kStride, offsetof(ClothVertex, position));
  cloth_layout_.attribute(1, 2, cloth_vertices_.id(), kStride, offsetof(ClothVertex, uv));
  cloth_layout_.attribute(2, 4, cloth_vertices_.id(), kStride, offsetof(ClothVertex, tangents));
  cloth_layout_.index_buffer(cloth_indices_.id());
}

bool BoatPass::holds_eye(const BoatView& view) const {
  if (glm::length(view.position) > kBoatRadius) return false;
  const glm::vec3 eye = glm::inverse(view.orientation) * -view.position;
  // Inside where a line straight up leaves the closed hull an odd number of times.
  bool inside = false;
  for (std::size_t i = 0; i + 2 < mask_corners_.size(); i += 3) {
    const glm::vec3 a = mask_corners_[i] - eye, b = mask_corners_[i + 1] - eye,
                    c = mask_corners_[i + 2] - eye;
    const auto turn = [](const glm::vec3& p, const glm::vec3& q) { return p.x * q.z - p.z * q.x; };
    const float ab = turn(a, b), bc = turn(b, c), ca = turn(c, a);
    const bool over = (ab > 0.0f) == (bc > 0.0f) && (bc > 0.0f) == (ca > 0.0f);
    const float area = ab + bc + ca;
    if (over && area != 0.0f && (a.y * bc + b.y * ca + c.y * ab) / area > 0.0f) inside = !inside;
  }
  return inside;
}

}  // namespace offing
