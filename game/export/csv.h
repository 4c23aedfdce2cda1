#pragma once
#include <glm/vec2.hpp>

#include <filesystem>
#include <vector>

namespace offing {

/// Points "x,z" (m), one per line; a heading, blank lines and spaces are allowed. Throws InputError
/// "file:line: …" for anything else, and where there is no point at all.
std::vector<glm::dvec2> read_points(const std::filesystem::path& file);

}  // namespace offing
