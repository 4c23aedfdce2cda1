#include "game/frame/boat_pass.h"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "shaders/shared/bindings.h"

namespace offing {
namespace {

// cd/m^2 of a lamp of one to two candela behind a lens as large as the model's.
constexpr float kLampLuminance = 900.0f;
// How far the wheel turns for the rudder's angle.
constexpr float kWheelGear = 6.0f;

const glm::vec3 kUp{0.0f, 1.0f, 0.0f};
// A box about her, boat frame.
constexpr glm::vec3 kLow{-1.3f, -1.5f, -4.1f}, kHigh{1.3f, 12.1f, 4.1f};

// From the eye to the box about her, m.
float distance_to_box(const BoatView& view) {
  const glm::vec3 eye = glm::inverse(view.orientation) * -view.position;
  return glm::distance(eye, glm::clamp(eye, kLow, kHigh));
}

// Share of a lamp's light that goes toward the eye: each is screened to its arc (International
// Regulations for Preventing Collisions at Sea, rule 21), and cut off over five degrees (annex I).
// A sailing boat shows no masthead light, one under power does.
float lamp_share(Lamp lamp, const BoatView& view) {
  if (lamp == Lamp::kAllRound) return 1.0f;
  if (lamp == Lamp::kMasthead && !view.under_power) return 0.0f;
  const glm::vec3 eye = glm::inverse(view.orientation) * -view.position;
  const float bearing = glm::degrees(std::atan2(eye.x, -eye.z));  // from the bow, + to starboard
  const auto arc = [&](float from, float to) {
    constexpr float kCut = 2.5f;  // either side of where the arc ends
    return glm::smoothstep(from - kCut, from + kCut, bearing) *
           (1.0f - glm::smoothstep(to - kCut, to + kCut, bearing));
  };
  constexpr float kAbaftBeam = 112.5f;
  if (lamp == Lamp::kPort) return arc(-kAbaftBeam, 0.0f);
  if (lamp == Lamp::kStarboard) return arc(0.0f, kAbaftBeam);
  const float ahead = arc(-kAbaftBeam, kAbaftBeam);
  return lamp == Lamp::kMasthead ? ahead : 1.0f - ahead;
}

void draw_range(const IndexRange& range) {
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(range.count), GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(static_cast<std::uintptr_t>(range.first) *
                                               sizeof(std::uint32_t)));
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

BoatPass::BoatPass(ShaderLibrary& shaders, const Model& model, const BoatTextures& textures)
    : cloth_program_(shaders.program({"boat/cloth.vert", "boat/cloth.frag"})),
      mask_program_(shaders.program({"boat/mask.vert", "boat/mask.frag"})),
      cast_program_(shaders.program({"boat/shadow.vert", "boat/shadow.frag"})),
      cast_cloth_program_(shaders.program({"boat/cloth.vert", "boat/shadow.frag"},
                                          {{"SHADOW", "1"}, {"CLOTH", "1"}})),
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
    if (name == "light_port") lamps_[i] = Lamp::kPort;
    if (name == "light_starboard") lamps_[i] = Lamp::kStarboard;
    if (name == "light_stern") lamps_[i] = Lamp::kStern;
    if (name == "light_masthead") lamps_[i] = Lamp::kMasthead;
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

BoatPass::Pose BoatPass::pose(const BoatView& view, const shared::FrameData& frame) const {
  Pose out{};
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
    const glm::vec3 emission = glm::vec3(materials_[i].emission) * kLampLuminance *
                               view.navigation_lights * lamp_share(lamps_[i], view);
    boat.materials[i].emission = glm::vec4(emission, materials_[i].emission.w);
  }
  const double time = frame.time.x;
  out.cloth = {sail_cloth(mainsail, view.main, time, cloth_[kMainsail].node),
               sail_cloth(jib, view.jib, time, cloth_[kJib].node),
               flag_cloth(flag, flag_now, time, cloth_[kFlag].node)};
  const glm::vec3 down = glm::inverse(view.orientation) * -kUp;
  add_ropes(out, view, down);
  if (view.hoisted) add_telltales(out, view, down, static_cast<float>(time));
  return out;
}

void BoatPass::draw_cloth(const Pose& pose) const {
  clamp_.bind(0);
  cloth_layout_.bind();
  for (std::size_t i = 0; i < cloth_.size(); ++i) {
    if (i != kFlag && !pose.hoisted) continue;
    cloth_blocks_[i].write(pose.cloth[i]);
    cloth_blocks_[i].bind_uniform(OFFING_BIND_CLOTH);
    cloth_[i].picture.bind(0);
    draw_range({cloth_[i].first, cloth_[i].count});
  }
  glBindSampler(0, 0);
}

void BoatPass::draw(const Pose& pose) const {
  boat_block_.write(pose.boat);
  boat_block_.bind_uniform(OFFING_BIND_BOAT);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  cloth_program_.use();
  draw_cloth(pose);

  repeat_.bind(0);
  rigid_layout_.bind();
  for (const Draw& item : draws_) {
    item.program->use();
    item.program->program().set(0, item.carrier);
    if (item.picture >= 0) pictures_[static_cast<std::size_t>(item.picture)].bind(0);
    if (item.part == Part::kWire) {
      glDisable(GL_CULL_FACE);
    } else {
      glEnable(GL_CULL_FACE);
    }
    if (item.part != Part::kSolid) {
      glEnable(GL_BLEND);
      glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    }
    draw_range(item.levels[static_cast<std::size_t>(pose.detail)]);
  }
  draw_lines(pose.lines);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  glBindSampler(0, 0);
}

void BoatPass::cast_opaque(const Pose& pose) const {
  boat_block_.write(pose.boat);
  boat_block_.bind_uniform(OFFING_BIND_BOAT);
  rigid_layout_.bind();
  cast_program_.use();
  // A shadow's edge is softer than what throws it by more than the coarsest level is off.
  for (const Draw& item : draws_) {
    if (item.part != Part::kSolid) continue;
    cast_program_.program().set(0, item.carrier);
    draw_range(item.levels.back());
  }
}

void BoatPass::cast_cloth(const Pose& pose) const {
  cast_cloth_program_.use();
  draw_cloth(pose);
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
  const glm::vec3 middle = view.position + view.orientation * kBoatMiddle;
  return sphere_in_view(frame.clip_from_relative, middle, kBoatRadius);
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
        draw_range(mask_);
        glBlendEquation(GL_FUNC_ADD);
        glDisable(GL_BLEND);
      });
  return mask;
}

}  // namespace offing
