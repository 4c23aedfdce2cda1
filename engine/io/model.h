#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/io/image.h"

namespace offing {

struct ModelVertex {
  glm::vec3 position;  ///< metres, in the frame of its node
  glm::vec3 normal;
  glm::vec2 uv;
};

/// Metallic-roughness material of glTF 2.0.
struct ModelMaterial {
  std::string name;
  glm::vec4 base_colour{1.0f};
  float metallic = 0.0f, roughness = 1.0f;
  glm::vec3 emissive{0.0f};
  int base_colour_image = -1;  ///< into Model::images
  bool double_sided = false;
};

/// One draw call.
struct ModelPrimitive {
  int material = 0;
  std::uint32_t first_index = 0, index_count = 0;
};

struct ModelNode {
  std::string name;
  int parent = -1;  ///< always smaller than the node's own index
  glm::mat4 parent_from_node{1.0f};
  std::vector<ModelPrimitive> primitives;
};

/// A glTF scene as plain data: one vertex and one index buffer (triangles) for all of it.
struct Model {
  std::vector<ModelVertex> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<ModelMaterial> materials;  ///< at least one
  std::vector<ModelNode> nodes;          ///< parents before children
  std::vector<Image> images;

  /// Index of the node with this name, or -1.
  int find(std::string_view name) const;
};

/// Reads .gltf or .glb (glTF 2.0, at most 64 MiB, no required extensions): the nodes of its scene,
/// triangles only. A mesh without normals is flat-shaded. Every count, index, offset and path in
/// the file is checked before use. In a build without OpenImageIO pictures are left out, with a
/// word about it. Throws InputError ("{file}: node 'boom' is missing: …") for anything that is not
/// a sound model of at most `max_triangles` as stored and as drawn, lacks any of `required_nodes`,
/// or refers to a file outside its folder.
Model load_model(const std::filesystem::path& file,
                 std::span<const std::string_view> required_nodes = {},
                 std::size_t max_triangles = 2'000'000);

}  // namespace offing
