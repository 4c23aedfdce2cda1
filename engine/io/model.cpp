#include "engine/io/model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/io/gltf_file.h"

namespace offing {
namespace {
namespace fs = std::filesystem;

constexpr double kMaxCoordinate = 1e6;  // metres; nothing that floats is larger
constexpr int kMaxNodeDepth = 64;
constexpr std::size_t kMaxImagesValues = std::size_t{1} << 28;  // 1 GiB, all images together

// tinygltf calls these instead of opening files and decoding pictures itself.
tinygltf::FsCallbacks serve(const GltfFile& file) {
  tinygltf::FsCallbacks callbacks{};
  callbacks.FileExists = [](const std::string& name, void* data) {
    return static_cast<const GltfFile*>(data)->parts.contains(name);
  };
  callbacks.ExpandFilePath = [](const std::string& name, void*) { return name; };
  callbacks.ReadWholeFile = [](std::vector<unsigned char>* out, std::string*,
                               const std::string& name, void* data) {
    const std::string& bytes = static_cast<const GltfFile*>(data)->parts.at(name);
    out->assign(bytes.begin(), bytes.end());
    return true;
  };
  callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&,
                                void*) { return false; };
  callbacks.user_data = const_cast<GltfFile*>(&file);
  return callbacks;
}

bool keep_encoded(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                  const unsigned char* bytes, int size, void*) {
  image->image.assign(bytes, bytes + size);
  return true;
}

// Elements of an accessor, whose every byte has been checked to be there.
struct Elements {
  const unsigned char* first;
  std::size_t stride, count;
  int component_type;

  template <class T>
  T get(std::size_t element, int component) const {
    T value;
    std::memcpy(&value, first + element * stride + component * sizeof(T), sizeof(T));
    return value;
  }
};

class Builder {
 public:
  Builder(const fs::path& file, std::size_t max_triangles)
      : file_(file.string()), max_triangles_(max_triangles) {}

  Model build(const fs::path& file) {
    parse(read_gltf(file));
    for (const tinygltf::Material& material : in_.materials) add_material(material);
    for (std::size_t i = 0; i < in_.meshes.size(); ++i) add_mesh(i);
    if (uses_default_material_) out_.materials.push_back({});
    if (out_.materials.empty()) out_.materials.push_back({});
    add_nodes();
    if (drawn_triangles_ == 0) fail("draws no triangles", "export at least one mesh");
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(std::string_view why,
                         std::string_view advice = "export it again as glTF 2.0") const {
    throw InputError(fmt::format("{}: {}; {}", file_, why, advice));
  }

  void parse(const GltfFile& file) {
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(keep_encoded, nullptr);
    loader.SetFsCallbacks(serve(file));
    std::string errors, warnings;
    bool done = false;
    try {
      done = loader.LoadASCIIFromString(&in_, &errors, &warnings, file.json.data(),
                                        static_cast<unsigned>(file.json.size()), "");
    } catch (const std::exception& error) {
      errors = error.what();
    }
    if (done && errors.empty()) return;
    std::string line = errors.substr(0, errors.find('\n')).substr(0, 160);
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
    fail("not sound glTF: " + (line.empty() ? "its parts do not fit" : line));
  }

  // ---- accessors

  template <class List>
  const auto& entry(const List& list, int index, std::string_view what) const {
    if (index < 0 || static_cast<std::size_t>(index) >= list.size()) {
      fail(fmt::format("refers to {} {}, and there are {}", what, index, list.size()));
    }
    return list[static_cast<std::size_t>(index)];
  }

  Elements elements(int index, int type, std::string_view what) const {
    const tinygltf::Accessor& accessor = entry(in_.accessors, index, "accessor");
    const std::string name = fmt::format("accessor {} ({})", index, what);
    const tinygltf::BufferView& view = entry(in_.bufferViews, accessor.bufferView, "bufferView");
    const std::vector<unsigned char>& buffer = entry(in_.buffers, view.buffer, "buffer").data;
    if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset) {
      fail(name + " lies outside its buffer");
    }
    if (accessor.type != type) fail(name + " has the wrong type");
    const int component = tinygltf::GetComponentSizeInBytes(accessor.componentType);
    const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type));
    if (component <= 0 || components <= 0) fail(name + " has an unknown type");
    const auto size = static_cast<std::size_t>(component) * components;
    const std::size_t stride = view.byteStride == 0 ? size : view.byteStride;
    const bool aligned =
        stride % component == 0 && (view.byteOffset + accessor.byteOffset) % component == 0;
    if (stride < size || !aligned) fail(name + " is not aligned");
    if (accessor.count == 0) fail(name + " is empty");
    // Counts are below 2^31 and strides below 2^8 (read_gltf, tinygltf): no overflow.
    if (accessor.byteOffset + stride * (accessor.count - 1) + size > view.byteLength) {
      fail(name + " lies outside its bufferView");
    }
    return {buffer.data() + view.byteOffset + accessor.byteOffset, stride, accessor.count,
            accessor.componentType};
  }

  float finite(float value, std::string_view what) const {
    if (!(std::abs(value) <= kMaxCoordinate)) {
      fail(fmt::format("has a {} of {}, allowed is -{} to {}", what, value, kMaxCoordinate,
                       kMaxCoordinate));
    }
    return value;
  }

  Elements floats(int index, int type, std::string_view what) const {
    const Elements found = elements(index, type, what);
    if (found.component_type != TINYGLTF_COMPONENT_TYPE_FLOAT) {
      fail(fmt::format("accessor {} ({}) does not hold floats", index, what));
    }
    return found;
  }

  glm::vec3 vec3(const Elements& list, std::size_t i, std::string_view what) const {
    return {finite(list.get<float>(i, 0), what), finite(list.get<float>(i, 1), what),
            finite(list.get<float>(i, 2), what)};
  }

  float uv(const Elements& list, std::size_t i, int component) const {
    switch (list.component_type) {
      case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return finite(list.get<float>(i, component), "texture coordinate");
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return static_cast<float>(list.get<std::uint8_t>(i, component)) / 255.0f;
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return static_cast<float>(list.get<std::uint16_t>(i, component)) / 65535.0f;
      default:
        fail("has texture coordinates of an unknown type");
    }
  }

  std::uint32_t index_at(const Elements& list, std::size_t i) const {
    switch (list.component_type) {
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return list.get<std::uint8_t>(i, 0);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return list.get<std::uint16_t>(i, 0);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return list.get<std::uint32_t>(i, 0);
      default:
        fail("has indices of an unknown type");
    }
  }

  // ---- meshes

  void count_triangles(std::size_t& total, std::size_t more) const {
    total += more;
    if (total > max_triangles_) {
      fail(fmt::format("has more than {} triangles", max_triangles_), "simplify it");
    }
  }

  void add_mesh(std::size_t index) {
    std::vector<ModelPrimitive> primitives;
    for (const tinygltf::Primitive& primitive : in_.meshes[index].primitives) {
      primitives.push_back(add_primitive(primitive, fmt::format("mesh {}", index)));
    }
    meshes_.push_back(std::move(primitives));
  }

  ModelPrimitive add_primitive(const tinygltf::Primitive& primitive, const std::string& name) {
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES) {
      fail(name + " is not made of triangles", "export triangles");
    }
    const std::vector<ModelVertex> vertices = read_vertices(primitive, name);
    const std::vector<std::uint32_t> indices = read_indices(primitive, name, vertices.size());
    count_triangles(stored_triangles_, indices.size() / 3);

    ModelPrimitive result;
    result.material = primitive.material;
    if (primitive.material < 0) {
      uses_default_material_ = true;
      result.material = static_cast<int>(in_.materials.size());
    } else {
      entry(in_.materials, primitive.material, "material");
    }
    result.first_index = static_cast<std::uint32_t>(out_.indices.size());
    result.index_count = static_cast<std::uint32_t>(indices.size());
    if (primitive.attributes.contains("NORMAL")) {
      append(vertices, indices);
    } else {
      append_flat(vertices, indices);
    }
    return result;
  }

  std::vector<ModelVertex> read_vertices(const tinygltf::Primitive& primitive,
                                         const std::string& name) {
    const auto attribute = [&](const char* key) {
      const auto found = primitive.attributes.find(key);
      return found == primitive.attributes.end() ? -1 : found->second;
    };
    if (attribute("POSITION") < 0) fail(name + " has no positions");
    const Elements positions = floats(attribute("POSITION"), TINYGLTF_TYPE_VEC3, "positions");
    // Many primitives may name the same vertices, used or not: bounds memory and time.
    read_vertices_ += positions.count;
    if (read_vertices_ > 3 * max_triangles_) {
      fail(fmt::format("has more than {} vertices", 3 * max_triangles_), "simplify it");
    }
    std::vector<ModelVertex> vertices(positions.count, {{}, {0.0f, 1.0f, 0.0f}, {}});
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      vertices[i].position = vec3(positions, i, "position");
    }
    const auto matching = [&](const Elements& list) {
      if (list.count != vertices.size()) fail(name + " has attributes of different lengths");
      return list;
    };
    if (const int accessor = attribute("NORMAL"); accessor >= 0) {
      const Elements normals = matching(floats(accessor, TINYGLTF_TYPE_VEC3, "normals"));
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        const glm::vec3 normal = vec3(normals, i, "normal");
        // Exporters write zeros where a vertex has no area round it: those keep the default.
        if (glm::length(normal) > 1e-12f) vertices[i].normal = glm::normalize(normal);
      }
    }
    if (const int accessor = attribute("TEXCOORD_0"); accessor >= 0) {
      const Elements uvs = matching(elements(accessor, TINYGLTF_TYPE_VEC2, "texture coordinates"));
      for (std::size_t i = 0; i < vertices.size(); ++i)
        vertices[i].uv = {uv(uvs, i, 0), uv(uvs, i, 1)};
    }
    return vertices;
  }

  std::vector<std::uint32_t> read_indices(const tinygltf::Primitive& primitive,
                                          const std::string& name, std::size_t vertices) const {
    std::vector<std::uint32_t> indices;
    if (primitive.indices < 0) {
      for (std::uint32_t i = 0; i < vertices; ++i) indices.push_back(i);
    } else {
      const Elements list = elements(primitive.indices, TINYGLTF_TYPE_SCALAR, "indices");
      if (list.count / 3 > max_triangles_) {
        fail(fmt::format("has more than {} triangles", max_triangles_), "simplify it");
      }
      indices.resize(list.count);
      for (std::size_t i = 0; i < indices.size(); ++i) {
        indices[i] = index_at(list, i);
        if (indices[i] >= vertices) {
          fail(fmt::format("{} has index {} for {} vertices", name, indices[i], vertices));
        }
      }
    }
    if (indices.size() % 3 != 0) fail(name + " ends in the middle of a triangle");
    return indices;
  }

  void append(const std::vector<ModelVertex>& vertices, const std::vector<std::uint32_t>& indices) {
    const auto base = static_cast<std::uint32_t>(out_.vertices.size());
    out_.vertices.insert(out_.vertices.end(), vertices.begin(), vertices.end());
    for (const std::uint32_t index : indices) out_.indices.push_back(base + index);
  }

  // A mesh without normals is flat-shaded (glTF 2.0, 3.7.2.1): each triangle has its own vertices.
  void append_flat(const std::vector<ModelVertex>& vertices,
                   const std::vector<std::uint32_t>& indices) {
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      ModelVertex corner[3] = {vertices[indices[i]], vertices[indices[i + 1]],
                               vertices[indices[i + 2]]};
      const glm::dvec3 a(corner[0].position), b(corner[1].position), c(corner[2].position);
      const glm::dvec3 area = glm::cross(b - a, c - a);
      const double size = glm::length(area);
      for (ModelVertex& vertex : corner) {
        if (size > 0.0) vertex.normal = glm::vec3(area / size);
        out_.indices.push_back(static_cast<std::uint32_t>(out_.vertices.size()));
        out_.vertices.push_back(vertex);
      }
    }
  }

  // ---- materials

  float unit(double value, std::string_view what) const {
    if (!(value >= 0.0 && value <= 1.0)) {
      fail(fmt::format("has a {} of {}, allowed is 0 to 1", what, value));
    }
    return static_cast<float>(value);
  }

  void add_material(const tinygltf::Material& material) {
    const tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
    ModelMaterial result;
    result.name = material.name;
    if (pbr.baseColorFactor.size() != 4) fail("has a base colour without 4 numbers");
    if (material.emissiveFactor.size() != 3) fail("has an emissive colour without 3 numbers");
    for (int i = 0; i < 4; ++i) result.base_colour[i] = unit(pbr.baseColorFactor[i], "base colour");
    for (int i = 0; i < 3; ++i)
      result.emissive[i] = unit(material.emissiveFactor[i], "emissive colour");
    result.metallic = unit(pbr.metallicFactor, "metallic factor");
    result.roughness = unit(pbr.roughnessFactor, "roughness factor");
    result.double_sided = material.doubleSided;
    if (pbr.baseColorTexture.index >= 0) {
      if (pbr.baseColorTexture.texCoord != 0) {
        fail("has a texture on a second set of texture coordinates", "export one set only");
      }
      const tinygltf::Texture& texture = entry(in_.textures, pbr.baseColorTexture.index, "texture");
      result.base_colour_image = image(texture.source);
    }
    out_.materials.push_back(std::move(result));
  }

  // The place in Model::images of the file's image; -1 in a build that can't read pictures.
  int image(int source) {
    const tinygltf::Image& encoded = entry(in_.images, source, "image");
    const auto known = images_.find(source);
    if (known != images_.end()) return known->second;
    if (!reads_pictures()) {
      log_warning("{}: image {} left out: this build has no OpenImageIO", file_, source);
      return images_[source] = -1;
    }
    if (encoded.image.empty()) fail(fmt::format("image {} is empty", source));
    out_.images.push_back(decode_image(encoded.image, fmt::format("{}: image {}", file_, source)));
    image_values_ += out_.images.back().pixels.size();
    if (image_values_ > kMaxImagesValues)
      fail("has more than 1 GiB of pictures", "make them smaller");
    return images_[source] = static_cast<int>(out_.images.size()) - 1;
  }

  // ---- nodes

  // Parents of all nodes, -1 for roots.
  std::vector<int> parents() const {
    std::vector<int> result(in_.nodes.size(), -1);
    for (std::size_t i = 0; i < in_.nodes.size(); ++i) {
      for (const int child : in_.nodes[i].children) {
        entry(in_.nodes, child, "node");
        if (result[child] >= 0) fail(fmt::format("node {} has two parents", child));
        result[child] = static_cast<int>(i);
      }
    }
    for (std::size_t i = 0; i < result.size(); ++i) {
      int depth = 0;
      for (int up = static_cast<int>(i); up >= 0; up = result[up]) {
        if (++depth > kMaxNodeDepth) {
          fail(fmt::format("node {} is its own ancestor or more than {} deep", i, kMaxNodeDepth));
        }
      }
    }
    return result;
  }

  // The roots of the scene shown, or of the file where it has no scene.
  std::vector<int> roots() const {
    const std::vector<int> parent = parents();
    std::vector<int> result;
    if (in_.scenes.empty()) {
      for (std::size_t i = 0; i < parent.size(); ++i) {
        if (parent[i] < 0) result.push_back(static_cast<int>(i));
      }
      return result;
    }
    std::vector<bool> seen(parent.size(), false);
    for (const int node : entry(in_.scenes, std::max(in_.defaultScene, 0), "scene").nodes) {
      entry(in_.nodes, node, "node");
      if (parent[node] >= 0 || seen[node]) fail(fmt::format("node {} is in the scene twice", node));
      seen[node] = true;
      result.push_back(node);
    }
    return result;
  }

  // Breadth first, so that parents stand before children.
  void add_nodes() {
    struct Next {
      int node, parent;
    };
    std::vector<Next> queue;
    for (const int root : roots()) queue.push_back({root, -1});
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const Next next = queue[i];
      const tinygltf::Node& node = in_.nodes[next.node];
      ModelNode result;
      result.name = node.name;
      result.parent = next.parent;
      result.parent_from_node = transform(node);
      if (node.mesh >= 0) result.primitives = entry(meshes_, node.mesh, "mesh");
      for (const ModelPrimitive& primitive : result.primitives) {
        count_triangles(drawn_triangles_, primitive.index_count / 3);
      }
      out_.nodes.push_back(std::move(result));
      for (const int child : node.children) queue.push_back({child, static_cast<int>(i)});
    }
  }

  void check_transform(const std::vector<double>& values, std::size_t size) const {
    if (!values.empty() && values.size() != size) {
      fail(fmt::format("has a node's transform of {} numbers instead of {}", values.size(), size));
    }
    for (const double value : values) finite(static_cast<float>(value), "transform");
  }

  glm::mat4 transform(const tinygltf::Node& node) const {
    check_transform(node.matrix, 16);
    check_transform(node.translation, 3);
    check_transform(node.rotation, 4);
    check_transform(node.scale, 3);
    if (!node.matrix.empty()) {
      if (node.matrix[3] != 0 || node.matrix[7] != 0 || node.matrix[11] != 0 ||
          node.matrix[15] != 1) {
        fail("has a node's matrix that is not affine");
      }
      return glm::mat4(glm::make_mat4(node.matrix.data()));
    }
    glm::dmat4 result(1.0);
    if (!node.rotation.empty()) {
      const auto& r = node.rotation;
      const glm::dquat rotation(r[3], r[0], r[1], r[2]);
      if (std::abs(glm::length(rotation) - 1.0) > 1e-2)
        fail("has a node's rotation that is not of length 1");
      result = glm::mat4_cast(glm::normalize(rotation));
    }
    for (int i = 0; i < 3; ++i) {
      if (!node.scale.empty()) result[i] *= node.scale[i];
      if (!node.translation.empty()) result[3][i] = node.translation[i];
    }
    return glm::mat4(result);
  }

  std::string file_;
  std::size_t max_triangles_;
  tinygltf::Model in_;
  Model out_;
  std::vector<std::vector<ModelPrimitive>> meshes_;
  std::map<int, int> images_;
  bool uses_default_material_ = false;
  std::size_t stored_triangles_ = 0, drawn_triangles_ = 0, image_values_ = 0, read_vertices_ = 0;
};

void check_names(const fs::path& file, const Model& model,
                 std::span<const std::string_view> required) {
  std::vector<std::string> missing;
  for (const std::string_view name : required) {
    if (model.find(name) < 0) missing.push_back(fmt::format("'{}'", name));
  }
  if (missing.empty()) return;
  throw InputError(fmt::format("{}: node{} {} {} missing: name {} in the model and export it again",
                               file.string(), missing.size() == 1 ? "" : "s",
                               fmt::join(missing, ", "), missing.size() == 1 ? "is" : "are",
                               missing.size() == 1 ? "it" : "them"));
}

}  // namespace

int Model::find(std::string_view name) const {
  const auto node =
      std::find_if(nodes.begin(), nodes.end(), [&](const ModelNode& n) { return n.name == name; });
  return node == nodes.end() ? -1 : static_cast<int>(node - nodes.begin());
}

Model load_model(const fs::path& file, std::span<const std::string_view> required_nodes,
                 std::size_t max_triangles) {
  Model model = Builder(file, max_triangles).build(file);
  check_names(file, model, required_nodes);
  return model;
}

}  // namespace offing
