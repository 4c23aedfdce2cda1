#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

namespace offing {

/// The largest model file, and the largest sum of what it refers to.
inline constexpr std::size_t kMaxModelBytes = std::size_t{64} << 20;

/// A glTF file taken apart and checked as far as that needs no knowledge of geometry.
struct GltfFile {
  /// glTF with only the parts that a Model is made of. Every number that is an index, offset or
  /// count is a whole one; buffer views lie inside their buffers; buffers and pictures that aren't
  /// data: URIs are named by keys of `parts`.
  std::string json;
  std::map<std::string, std::string> parts;
};

/// Reads a .gltf or .glb file and the files beside it that it names. It stands between a hostile
/// file and the glTF parser, which trusts offsets, wraps integers and recurses as deep as it is
/// told. Throws InputError "{file}: …".
GltfFile read_gltf(const std::filesystem::path& file);

}  // namespace offing
