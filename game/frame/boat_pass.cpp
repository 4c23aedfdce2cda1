#include "game/frame/boat_pass.h"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "engine/core/error.h"
#include "shaders/shared/bindings.h"

namespace offing {
namespace {

struct ClothVertex {
  glm::vec3 position;
  glm::vec2 uv;
  glm::vec4 tangents;  ///< d(y, z)/du, d(y, z)/dv
};

// cd/m^2 of a lamp of one to two candela behind a lens as large as the model's.
constexpr float kLampLuminance = 900.0f;
// All of her: masthead, bulb and boom end, boat frame.
constexpr glm::vec3 kMiddle{0.0f, 4.9f, 0.0f};
constexpr float kRadius = 7.8f;
constexpr std::size_t kMostLineVertices = 2048;
// How far the wheel turns for the rudder's angle.
constexpr float kWheelGear = 6.0f;

const glm::vec3 kUp{0.0f, 1.0f, 0.0f};
// A box about her, boat frame.
constexpr glm::vec3 kLow{-1.3f, -1.5f, -4.1f}, kHigh{1.3f, 12.1f, 4.1f};
// The node that stands for the boat herself.
constexpr int kStill = shared::kBoatNodes - 1;

// A channel of a picture at (u, v) from its upper left corner, between its pixels.
float smooth_pixel(const Image& image, int channel, float u, float v) {
  const float x = std::clamp(u * static_cast<float>(image.width) - 0.5f, 0.0f,
                             static_cast<float>(image.width - 1));
  const float y = std::clamp(v * static_cast<float>(image.height) - 0.5f, 0.0f,
                             static_cast<float>(image.height - 1));
  const int left = static_cast<int>(x), top = static_cast<int>(y);
  const auto pixel = [&](int column, int row) {
    const int at =
        std::min(row, image.height - 1) * image.width + std::min(column, image.width - 1);
    return image.pixels[static_cast<std::size_t>(at * image.channels + channel)];
  };
  const float s = x - static_cast<float>(left), t = y - static_cast<float>(top);
  return glm::mix(glm::mix(pixel(left, top), pixel(left + 1, top), s),
                  glm::mix(pixel(left, top + 1), pixel(left + 1, top + 1), s), t);
}

// Red and green: the pattern seen from port and from starboard; a grey picture is the same from
// both. Blue: where there is cloth; all of it without a picture of that.
gl::Texture cloth_texture(const char* label, const Image& pattern, const Image& alpha) {
  gl::Texture texture(label, {.format = GL_RGBA8,
                              .width = pattern.width,
                              .height = pattern.height,
                              .levels = gl::full_mip_levels(pattern.width, pattern.height)});
  std::vector<float> rows;
  for (int y = pattern.height - 1; y >= 0; --y) {  // bottom row first: v grows toward the head
    for (int x = 0; x < pattern.width; ++x) {
      const auto at = static_cast<std::size_t>((y * pattern.width + x) * pattern.channels);
      const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(pattern.width);
      const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(pattern.height);
      const float cloth = alpha.pixels.empty() ? 1.0f : smooth_pixel(alpha, 0, u, v);
      rows.insert(rows.end(),
                  {pattern.pixels[at], pattern.pixels[at + (pattern.channels >= 3)], cloth, 1.0f});
    }
  }
  texture.upload(GL_RGBA, GL_FLOAT, rows.data());
  texture.generate_mipmaps();
  return texture;
}

gl::Texture colour_texture(const Image& image) {
  gl::Texture texture("boat.base_colour",
                      {.format = GL_SRGB8_ALPHA8,
                       .width = image.width,
                       .height = image.height,
                       .levels = gl::full_mip_levels(image.width, image.height)});
  std::vector<float> rgba;
  for (std::size_t i = 0; i < image.pixels.size(); i += static_cast<std::size_t>(image.channels)) {
    const int last = image.channels >= 3 ? 2 : 0;
    rgba.insert(rgba.end(), {image.pixels[i], image.pixels[i + static_cast<std::size_t>(last) / 2],
                             image.pixels[i + static_cast<std::size_t>(last)], 1.0f});
  }
  texture.upload(GL_RGBA, GL_FLOAT, rgba.data());
  texture.generate_mipmaps();
  return texture;
}

// From the eye to the box about her, m.
float distance_to_box(const BoatView& view) {
  const glm::vec3 eye = glm::inverse(view.orientation) * -view.position;
  return glm::distance(eye, glm::clamp(eye, kLow, kHigh));
}

int need(const Model& model, std::string_view name) {
  const int node = model.find(name);
  if (node < 0) throw InputError(fmt::format("boat model: node '{}' is missing", name));
  return node;
}

}  // namespace

shared::BoatMaterial surface_of(const ModelMaterial& from) {
  // A lobe narrower than this is only noise without supersampling.
  const float alpha = std::max(from.roughness * from.roughness, 0.02f);
  return {
      .base_colour = {from.base_colour.x, from.base_colour.y, from.base_colour.z, from.metallic},
      .emission = {from.emissive.x, from.emissive.y, from.emissive.z, alpha}};
}

void set_rigid_layout(gl::VertexArray& layout, const gl::Buffer& vertices,
                      const gl::Buffer& indices) {
  constexpr int kStride = sizeof(RigidVertex);
  layout.attribute(0, 3, vertices.id(), kStride, offsetof(RigidVertex, position));
  layout.attribute(1, 3, vertices.id(), kStride, offsetof(RigidVertex, normal));
  layout.attribute(2, 2, vertices.id(), kStride, offsetof(RigidVertex, uv));
  layout.attribute(3, 1, vertices.id(), kStride, offsetof(RigidVertex, material));
  layout.index_buffer(indices.id());
}

bool sphere_in_view(const glm::mat4& clip_from_relative, const glm::vec3& centre, float radius) {
  // Gribb & Hartmann 2001: the planes are sums of the projection's rows. Reversed depth without a
  // far plane: only the four sides and the near plane (z <= w) bound it.
  const glm::mat4 rows = glm::transpose(clip_from_relative);
  const std::array<glm::vec4, 5> planes = {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
                                           rows[3] - rows[1], rows[3] - rows[2]};
  return std::ranges::all_of(planes, [&](const glm::vec4& plane) {
    const glm::vec3 normal(plane);
    return glm::dot(normal, centre) + plane.w >= -radius * glm::length(normal);
  });
}

BoatTextures load_boat_textures(const std::filesystem::path& folder) {
  return {.main_alpha = read_image(folder / "main_alpha.png"),
          .main_pattern = read_image(folder / "main_pattern.png"),
          .jib_pattern = read_image(folder / "jib_pattern.png"),
          .flag_alpha = read_image(folder / "flag_alpha.png"),
          .flag_pattern = read_image(folder / "flag_pattern.png")};
}

BoatPass::BoatPass(ShaderLibrary& shaders, const Model& model, const BoatTextures& textures)
    : cloth_program_(shaders.program({"boat/cloth.vert", "boat/cloth.frag"})),
      mask_program_(shaders.program({"boat/mask.vert", "boat/mask.frag"})),
      boat_block_("boat.block", sizeof(shared::BoatData)),
      repeat_("boat.repeat", GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT, GL_REPEAT),
      clamp_("boat.clamp", GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE) {
  if (model.nodes.size() > kStill || model.materials.size() > shared::kBoatMaterials) {
    throw InputError(fmt::format("boat model: {} nodes and {} materials: at most {} and {}",
                                 model.nodes.size(), model.materials.size(), kStill,
                                 shared::kBoatMaterials));
  }
  for (const ModelNode& node : model.nodes) nodes_.push_back({node.parent, node.parent_from_node});
  boom_ = need(model, "boom");
  rudder_ = need(model, "rudder");
  wheel_ = model.find("wheel");
  cloth_[kMainsail].node = need(model, "mainsail");
  cloth_[kJib].node = need(model, "jib");
  cloth_[kFlag].node = need(model, "flag");
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    materials_[i] = surface_of(model.materials[i]);
    const std::string& name = model.materials[i].name;
    if (name == "sail") rope_material_ = static_cast<int>(i);
    if (name == "boot") windward_material_ = static_cast<int>(i);
    if (name == "antifouling") lee_material_ = static_cast<int>(i);
  }
  for (const Image& image : model.images) pictures_.push_back(colour_texture(image));
  build_rigid(shaders, model);
  build_cloth(model, textures);
  for (std::size_t i = 0; i < cloth_blocks_.size(); ++i) {
    cloth_blocks_[i] = gl::Buffer("boat.cloth_block", sizeof(shared::ClothParameters));
  }
}

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
    std::unordered_map<std::uint32_t, std::uint32_t> placed;
    for (std::uint32_t i = 0; i < primitive.index_count; ++i) {
      const std::uint32_t index = model.indices[primitive.first_index + i];
      const auto [found, is_new] =
          placed.try_emplace(index, static_cast<std::uint32_t>(vertices.size()));
      if (is_new) {
        const ModelVertex& from = model.vertices[index];
        vertices.push_back({glm::vec3(placement * glm::vec4(from.position, 1.0f)),
                            glm::mat3(placement) * from.normal, from.uv,
                            static_cast<float>(primitive.material)});
      }
      indices.push_back(found->second);
    }
  };
  // One draw for each program, picture and carrier; the wires last, since they blend with what lies
  // behind them.
  const auto gather_carried = [&](const ShaderProgram& program, int picture, bool wire,
                                  int carrier) {
    const auto first = static_cast<std::uint32_t>(indices.size());
    for (int node = 0; node < static_cast<int>(model.nodes.size()); ++node) {
      if (node == mask || is_cloth(node)) continue;
      if (carriers[static_cast<std::size_t>(node)].node != carrier) continue;
      for (const ModelPrimitive& primitive :
           model.nodes[static_cast<std::size_t>(node)].primitives) {
        const ModelMaterial& material =
            model.materials[static_cast<std::size_t>(primitive.material)];
        const bool is_wire = material.name == "wire";
        if (is_wire == wire && (wire || material.base_colour_image == picture))
          append(node, primitive);
      }
    }
    const auto count = static_cast<std::uint32_t>(indices.size()) - first;
    if (count == 0) return;
    DetailLevels levels;
    levels.fill({first, count});  // a wire's radius is not in its vertices: it stays as it is
    if (!wire) levels = add_detail_levels(vertices, indices, first);
    draws_.push_back({&program, levels, picture, wire, carrier});
  };
  const auto gather = [&](const ShaderProgram& program, int picture, bool wire) {
    for (const int carrier : {kStill, boom_, rudder_, wheel_}) {
      gather_carried(program, picture, wire, carrier);
    }
  };
  const std::vector<std::filesystem::path> stages = {"boat/rigid.vert", "boat/rigid.frag"};
  gather(shaders.program(stages), -1, false);
  for (int picture = 0; picture < static_cast<int>(pictures_.size()); ++picture) {
    gather(shaders.program(stages, {{"PICTURE", "1"}}), picture, false);
  }
  gather(shaders.program(stages, {{"WIRE", "1"}}), -1, true);
  mask_first_ = static_cast<std::uint32_t>(indices.size());
  if (mask >= 0) {
    for (const ModelPrimitive& primitive : model.nodes[static_cast<std::size_t>(mask)].primitives) {
      append(mask, primitive);
    }
  }
  mask_count_ = static_cast<std::uint32_t>(indices.size()) - mask_first_;
  for (std::uint32_t i = mask_first_; i < indices.size(); ++i) {
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
    std::unordered_map<std::uint32_t, std::uint32_t> placed;
    for (const ModelPrimitive& primitive :
         model.nodes[static_cast<std::size_t>(cloth.node)].primitives) {
      for (std::uint32_t i = 0; i < primitive.index_count; ++i) {
        const std::uint32_t index = model.indices[primitive.first_index + i];
        const auto [found, is_new] =
            placed.try_emplace(index, static_cast<std::uint32_t>(vertices.size()));
        if (is_new) {
          const ModelVertex& from = model.vertices[index];
          vertices.push_back({from.position, from.uv, glm::vec4(0.0f)});
        }
        indices.push_back(found->second);
      }
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
      if (vertex.uv.x > 0.999f && vertex.uv.y < 0.001f)
        cloth.rise = vertex.position.y / vertex.position.z;
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

BoatPass::Frame BoatPass::pose(const BoatView& view, const shared::FrameData& frame) const {
  Frame out{};
  out.hoisted = view.hoisted;
  out.detail = detail_level(distance_to_box(view), frame.camera.w);
  shared::BoatData& boat = out.boat;
  boat.relative_from_boat =
      glm::translate(glm::mat4(1.0f), view.position) * glm::mat4_cast(view.orientation);
  const FlagPose flag_now = flag_pose(view.apparent_wind, glm::inverse(view.orientation) * -kUp);
  boat.boat_from_node[kStill] = glm::mat4(1.0f);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const int node = static_cast<int>(i);
    glm::mat4 own(1.0f);
    if (node == boom_) own = yawed(view.main.angle);
    if (node == rudder_) own = yawed(view.rudder);
    if (node == wheel_) {
      own = glm::rotate(own, -kWheelGear * view.rudder, glm::vec3(0.0f, 0.0f, 1.0f));
    }
    if (node == cloth_[kMainsail].node) own = glm::scale(own, glm::vec3(view.reef));
    if (node == cloth_[kJib].node) own = glm::scale(yawed(view.jib.angle), glm::vec3(view.reef));
    if (node == cloth_[kFlag].node) own = yawed(flag_now.yaw);
    const glm::mat4 parent_from_node = nodes_[i].parent_from_node * own;
    boat.boat_from_node[i] = nodes_[i].parent < 0
                                 ? parent_from_node
                                 : boat.boat_from_node[nodes_[i].parent] * parent_from_node;
  }
  for (std::size_t i = 0; i < materials_.size(); ++i) {
    boat.materials[i] = materials_[i];
    const glm::vec3 emission =
        glm::vec3(materials_[i].emission) * view.navigation_lights * kLampLuminance;
    boat.materials[i].emission = glm::vec4(emission, materials_[i].emission.w);
  }
  for (const Sails index : {kMainsail, kJib}) {
    const Cloth& cloth = cloth_[index];
    const glm::mat4& from_node = boat.boat_from_node[cloth.node];
    const glm::vec3 luff = glm::normalize(glm::vec3(from_node[1]));
    const glm::vec3 chord = glm::normalize(glm::vec3(from_node[2]));
    boat.sails[index] = {
        .origin = glm::vec4(glm::vec3(from_node[3]), view.hoisted ? cloth.hoist * view.reef : 0.0f),
        .luff = glm::vec4(luff, cloth.foot * view.reef),
        .chord = glm::vec4(chord, cloth.head * view.reef),
        .normal = glm::vec4(glm::cross(luff, chord), cloth.rise)};
  }
  const double time = frame.time.x;
  out.cloth = {sail_cloth(mainsail, view.main, time, cloth_[kMainsail].node, kMainsail),
               sail_cloth(jib, view.jib, time, cloth_[kJib].node, kJib),
               flag_cloth(flag, flag_now, time, cloth_[kFlag].node)};
  const glm::vec3 down = glm::inverse(view.orientation) * -kUp;
  add_ropes(out, view, down);
  if (view.hoisted) add_telltales(out, view, down, static_cast<float>(time));
  return out;
}

void BoatPass::draw(const Frame& frame) const {
  boat_block_.write(frame.boat);
  boat_block_.bind_uniform(OFFING_BIND_BOAT);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  const auto elements = [](std::uint32_t first, std::uint32_t count) {
    glDrawElements(
        GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
        reinterpret_cast<const void*>(static_cast<std::uintptr_t>(first) * sizeof(std::uint32_t)));
  };

  clamp_.bind(0);
  cloth_layout_.bind();
  cloth_program_.use();
  for (std::size_t i = 0; i < cloth_.size(); ++i) {
    if (i != kFlag && !frame.hoisted) continue;
    cloth_blocks_[i].write(frame.cloth[i]);
    cloth_blocks_[i].bind_uniform(OFFING_BIND_CLOTH);
    cloth_[i].picture.bind(0);
    elements(cloth_[i].first, cloth_[i].count);
  }

  repeat_.bind(0);
  rigid_layout_.bind();
  for (const Draw& item : draws_) {
    item.program->use();
    item.program->program().set(0, item.carrier);
    if (item.picture >= 0) pictures_[static_cast<std::size_t>(item.picture)].bind(0);
    if (item.wire) {
      glDisable(GL_CULL_FACE);
      glEnable(GL_BLEND);
      glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    } else {
      glEnable(GL_CULL_FACE);
    }
    const IndexRange& range = item.levels[static_cast<std::size_t>(frame.detail)];
    elements(range.first, range.count);
  }
  draw_lines(frame.lines);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  glBindSampler(0, 0);
}

void BoatPass::draw_lines(const RigidMesh& lines) const {
  if (lines.indices.empty() || lines.vertices.size() > kMostLineVertices) return;
  line_vertices_.write(lines.vertices.data(), lines.vertices.size() * sizeof(RigidVertex));
  line_indices_.write(lines.indices.data(), lines.indices.size() * sizeof(std::uint32_t));
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  line_layout_.bind();
  line_program_->use();
  line_program_->program().set(0, kStill);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(lines.indices.size()), GL_UNSIGNED_INT,
                 nullptr);
}

glm::mat4 BoatPass::yawed(float angle) { return glm::rotate(glm::mat4(1.0f), angle, kUp); }

bool BoatPass::in_view(const BoatView& view, const shared::FrameData& frame) const {
  const glm::vec3 middle = view.position + view.orientation * kMiddle;
  return sphere_in_view(frame.clip_from_relative, middle, kRadius);
}

void BoatPass::add(FrameGraph& graph, const BoatView& view, const shared::FrameData& frame,
                   const LightAccess& light, TextureId hdr, TextureId depth) const {
  const bool visible = in_view(view, frame);
  graph.add(
      "boat",
      [&](PassBuilder& pass) {
        light.declare(pass);
        pass.modify(hdr).modify(depth).render_to({hdr}, depth).skip_if(!visible);
      },
      [this, posed = pose(view, frame), bind = light.bind](PassContext& context) {
        bind(context);
        draw(posed);
      });
}

bool BoatPass::holds_eye(const BoatView& view) const {
  if (glm::length(view.position) > kRadius) return false;
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

TextureId BoatPass::add_mask(FrameGraph& graph, const BoatView& view,
                             const shared::FrameData& frame) const {
  const TextureId mask = graph.create("boat.mask", {.format = GL_RG16F,
                                                    .width = static_cast<int>(frame.viewport.x),
                                                    .height = static_cast<int>(frame.viewport.y)});
  graph.add(
      "boat.mask",
      [&](PassBuilder& pass) { pass.write(mask, Access::kAttachment).render_to({mask}); },
      [this, boat = pose(view, frame).boat](PassContext&) {
        const float nothing[4] = {};
        glClearBufferfv(GL_COLOR, 0, nothing);
        boat_block_.write(boat);
        boat_block_.bind_uniform(OFFING_BIND_BOAT);
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        glEnable(GL_BLEND);
        glBlendEquation(GL_MAX);
        rigid_layout_.bind();
        mask_program_.use();
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mask_count_), GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(static_cast<std::uintptr_t>(mask_first_) *
                                                     sizeof(std::uint32_t)));
        glBlendEquation(GL_FUNC_ADD);
        glDisable(GL_BLEND);
      });
  return mask;
}

}  // namespace offing
