#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "engine/gl/buffer.h"
#include "engine/gl/program.h"
#include "engine/gl/texture.h"
#include "engine/graph/frame_graph.h"
#include "engine/io/model.h"
#include "engine/ocean/ocean.h"
#include "engine/shader/shader_library.h"
#include "game/frame/boat_textures.h"
#include "game/frame/boat_view.h"
#include "game/frame/cloth.h"
#include "game/frame/detail.h"
#include "game/frame/rigid_vertex.h"
#include "shaders/shared/boat.h"
#include "shaders/shared/frame.h"

namespace offing {

/// Nodes that a boat's model must have.
inline constexpr std::array<std::string_view, 8> kBoatNodeNames = {
    "hull", "deck", "mast", "boom", "mainsail", "jib", "rudder", "flag"};

/// Which arc a material that shines is seen over.
enum class Lamp : std::uint8_t { kAllRound, kPort, kStarboard, kStern, kMasthead };

/// Draws the boat: rigid parts with a compact metallic-roughness surface, then sails and flag as
/// cloth. All of her in one pass; it is skipped while she is out of view.
class BoatPass {
 public:
  /// All that changes of her from frame to frame.
  struct Pose {
    shared::BoatData boat;
    std::array<shared::ClothParameters, 3> cloth;
    bool hoisted;
    int detail;       ///< index into DetailLevels
    RigidMesh lines;  ///< ropes and telltales, boat frame
  };

  /// Throws InputError where the model has too many nodes or materials or lacks a required node, or
  /// a shader does not compile.
  BoatPass(ShaderLibrary& shaders, const Model& model, const BoatTextures& textures);

  /// Into `hdr` (radiance × exposure) and `depth` (reversed), both kept where she is not. The frame
  /// block must be bound at binding 0 when the graph runs, and be equal to `frame`. `light`: sky,
  /// probe and cloud shadow.
  void add(FrameGraph& graph, const BoatView& view, const shared::FrameData& frame,
           const LightAccess& light, TextureId hdr, TextureId depth) const;

  Pose pose(const BoatView& view, const shared::FrameData& frame) const;
  /// Draws the depth of her opaque parts (ropes and wires left out), or of her cloth, as the light
  /// of shared::BoatShadowData sees them. First the opaque ones: they bring the boat's block.
  void cast_opaque(const Pose& pose) const;
  void cast_cloth(const Pose& pose) const;

  /// Whether any of the boat may be on screen.
  bool in_view(const BoatView& view, const shared::FrameData& frame) const;

  /// Where no water may be seen, as a picture of the viewport's size: r is 1 / distance (1/m) to
  /// the hull's near side, g the distance (m) to its far side, both 0 where there is none. Water at
  /// distance d from the camera is inside the hull where d × r > 1 and d < g.
  TextureId add_mask(FrameGraph& graph, const BoatView& view, const shared::FrameData& frame) const;

  /// Whether the eye is inside the hull, where it is dry under the waterline as well.
  bool holds_eye(const BoatView& view) const;

  ClothStyle mainsail = mainsail_style();
  ClothStyle jib = jib_style();
  ClothStyle flag = flag_style();

 private:
  /// Wires and lamps are never drawn thinner than a pixel, but fainter.
  enum class Part { kSolid, kWire, kLamp };
  struct Draw {
    const ShaderProgram* program;
    DetailLevels levels;
    int picture;  ///< index into pictures_, or -1
    Part part;
    int carrier;  ///< the node in whose frame its vertices are
  };
  struct Cloth {
    int node = -1;
    std::uint32_t first = 0, count = 0;
    float hoist = 0.0f, foot = 0.0f, head = 0.0f;  ///< outline, m
    glm::vec3 clew{0.0f};
    gl::Texture picture;
  };
  enum Sails { kMainsail, kJib, kFlag };
  /// The node that stands for the boat herself.
  static constexpr int kStill = shared::kBoatNodes - 1;
  static constexpr std::size_t kMostLineVertices = 2048;

  void build_rigid(ShaderLibrary& shaders, const Model& model);
  void build_cloth(const Model& model, const BoatTextures& textures);
  void add_ropes(Pose& out, const BoatView& view, const glm::vec3& down) const;
  void add_telltales(Pose& out, const BoatView& view, const glm::vec3& down, float time) const;
  /// A turn about the upward axis, radians.
  static glm::mat4 yawed(float angle);
  static glm::vec3 cloth_point(const shared::ClothParameters& p, const Cloth& cloth, float u,
                               float v);
  void draw(const Pose& pose) const;
  void draw_cloth(const Pose& pose) const;
  void draw_lines(const RigidMesh& lines) const;

  struct Node {
    int parent;
    glm::mat4 parent_from_node;
  };
  std::vector<Node> nodes_;
  int boom_ = -1, rudder_ = -1, wheel_ = -1;
  int rope_material_ = 0, windward_material_ = 0, lee_material_ = 0;
  std::array<shared::BoatMaterial, shared::kBoatMaterials> materials_;
  std::array<Lamp, shared::kBoatMaterials> lamps_{};  ///< of each material
  std::vector<Draw> draws_;
  IndexRange mask_;
  std::vector<glm::vec3> mask_corners_;  ///< of its triangles, in the boat's frame
  std::array<Cloth, 3> cloth_;
  std::vector<gl::Texture> pictures_;
  const ShaderProgram& cloth_program_;
  const ShaderProgram& mask_program_;
  const ShaderProgram& cast_program_;
  const ShaderProgram& cast_cloth_program_;
  gl::Buffer vertices_, indices_, cloth_vertices_, cloth_indices_;
  const ShaderProgram* line_program_ = nullptr;
  gl::Buffer line_vertices_, line_indices_;
  gl::VertexArray rigid_layout_, cloth_layout_, line_layout_;
  gl::Buffer boat_block_;
  std::array<gl::Buffer, 3> cloth_blocks_;
  gl::Sampler repeat_, clamp_;
};

/// A material as the shaders read it.
shared::BoatMaterial surface_of(const ModelMaterial& from);
/// Attributes of RigidVertex, for boat/rigid.vert.
void set_rigid_layout(gl::VertexArray& layout, const gl::Buffer& vertices,
                      const gl::Buffer& indices);

/// Whether a sphere (relative to the camera, m) may be seen through this projection.
bool sphere_in_view(const glm::mat4& clip_from_relative, const glm::vec3& centre, float radius);

}  // namespace offing
