#pragma once
#include <filesystem>
#include <string_view>

#include "engine/core/fields.h"

namespace offing {

/// A scene by name ("gale": gale.toml in `folder`, assets/scenes under data_root() where that is
/// empty) or by path (whatever has a "/" or ends with ".toml"). Throws InputError that lists the
/// names there are.
std::filesystem::path find_scene(std::string_view name_or_file,
                                 const std::filesystem::path& folder = {});

/// Sets the fields named in a TOML file; others keep their values. Tables nest into dotted keys;
/// dates and times arrive as text ("2026-06-21", "18:30:00").
/// Throws InputError "file:line: key = value: …" for bad TOML, an unknown key, a wrong type or a
/// value out of range. Nothing is set where anything is wrong.
void load_scene(const std::filesystem::path& file, const FieldTable& table);

}  // namespace offing
