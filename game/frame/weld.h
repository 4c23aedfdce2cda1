#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "engine/io/model.h"

namespace offing {

/// Where each of a model's vertices lies in a list of one's own.
using Welded = std::unordered_map<std::uint32_t, std::uint32_t>;

/// Appends the triangles of `primitive` to `indices`, and to `vertices` what `make` makes of each
/// ModelVertex that is not yet `welded`: vertices that triangles share stay shared.
template <typename Vertex, typename Make>
void append_welded(const Model& model, const ModelPrimitive& primitive, Welded& welded,
                   std::vector<Vertex>& vertices, std::vector<std::uint32_t>& indices,
                   const Make& make) {
  for (std::uint32_t i = 0; i < primitive.index_count; ++i) {
    const std::uint32_t index = model.indices[primitive.first_index + i];
    const auto [found, is_new] =
        welded.try_emplace(index, static_cast<std::uint32_t>(vertices.size()));
    if (is_new) vertices.push_back(make(model.vertices[index]));
    indices.push_back(found->second);
  }
}

}  // namespace offing
