#include "game/frame/flotsam_pass.h"

#include <epoxy/gl.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <iterator>

#include "game/frame/boat_pass.h"
#include "game/frame/rigid_vertex.h"
#include "game/frame/weld.h"
#include "shaders/shared/bindings.h"

namespace offing {

FlotsamPass::FlotsamPass(ShaderLibrary& shaders, const Model& model)
    : program_(shaders.program({"boat/rigid.vert", "boat/rigid.frag"})),
      buffer_("flotsam.block", sizeof(shared::BoatData)) {
  RigidMesh mesh;
  for (std::size_t kind = 0; kind < kFlotsam.size(); ++kind) {
    const ModelNode& node = model.nodes[static_cast<std::size_t>(model.find(kFlotsam[kind]))];
    const auto first = static_cast<std::uint32_t>(mesh.indices.size());
    Welded welded;
    for (const ModelPrimitive& primitive : node.primitives) {
      append_welded(model, primitive, welded, mesh.vertices, mesh.indices,
                    [&](const ModelVertex& from) {
                      return RigidVertex{from.position, from.normal, from.uv,
                                         static_cast<float>(primitive.material)};
                    });
    }
    levels_[kind] = add_detail_levels(mesh.vertices, mesh.indices, first);
  }
  const std::size_t materials =
      std::min(model.materials.size(), static_cast<std::size_t>(shared::kBoatMaterials));
  for (std::size_t i = 0; i < materials; ++i) block_.materials[i] = surface_of(model.materials[i]);
  block_.boat_from_node[0] = glm::mat4(1.0f);

  vertices_ = gl::Buffer::of<RigidVertex>("flotsam.vertices", mesh.vertices);
  indices_ = gl::Buffer::of<std::uint32_t>("flotsam.indices", mesh.indices);
  layout_ = gl::VertexArray("flotsam");
  set_rigid_layout(layout_, vertices_, indices_);
}

void FlotsamPass::add(FrameGraph& graph, const std::vector<FlotsamView>& things,
                      const shared::FrameData& frame, const LightAccess& light, TextureId hdr,
                      TextureId depth) const {
  constexpr float kRadius = 2.2f, kSmallest = 0.5f;  // m; pixels
  std::vector<FlotsamView> seen;
  std::ranges::copy_if(things, std::back_inserter(seen), [&](const FlotsamView& thing) {
    const float pixels = kRadius / std::max(glm::length(thing.position), kRadius) / frame.camera.w;
    return pixels > kSmallest && sphere_in_view(frame.clip_from_relative, thing.position, kRadius);
  });
  graph.add(
      "flotsam",
      [&](PassBuilder& pass) {
        light.declare(pass);
        pass.modify(hdr).modify(depth).render_to({hdr}, depth).skip_if(seen.empty());
      },
      [this, seen, light, pixel = frame.camera.w](PassContext& context) {
        light.bind(context);
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_GREATER);
        glDepthMask(GL_TRUE);
        glEnable(GL_CULL_FACE);
        layout_.bind();
        program_.use();
        program_.program().set(0, 0);
        shared::BoatData block = block_;
        for (const FlotsamView& thing : seen) {
          block.relative_from_boat =
              glm::translate(glm::mat4(1.0f), thing.position) * glm::mat4_cast(thing.orientation);
          buffer_.write(block);
          buffer_.bind_uniform(OFFING_BIND_BOAT);
          const float distance = std::max(glm::length(thing.position) - kRadius, 0.0f);
          const IndexRange& range =
              levels_[static_cast<std::size_t>(thing.kind)]
                     [static_cast<std::size_t>(detail_level(distance, pixel))];
          glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(range.count), GL_UNSIGNED_INT,
                         reinterpret_cast<const void*>(static_cast<std::uintptr_t>(range.first) *
                                                       sizeof(std::uint32_t)));
        }
        glDisable(GL_CULL_FACE);
        glDisable(GL_DEPTH_TEST);
      });
}

}  // namespace offing
