#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "engine/core/fields.h"

namespace offing {

/// A TOML file by name ("r8": r8.toml in `folder`) or by path (whatever has a "/" or ends with
/// ".toml"). Throws InputError "{option} {name}: no such {kind}; …" that lists the names there are.
std::filesystem::path find_data(std::string_view option, std::string_view kind,
                                std::string_view name_or_file, const std::filesystem::path& folder);

/// A scene by name ("gale": gale.toml in `folder`, assets/scenes under data_root() where that is
/// empty) or by path (whatever has a "/" or ends with ".toml"). Throws InputError that lists the
/// names there are.
std::filesystem::path find_scene(std::string_view name_or_file,
                                 const std::filesystem::path& folder = {});

/// Where each key of a file stands: "file:line".
using FieldPlaces = std::map<std::string, std::string, std::less<>>;

/// Sets the fields named in a TOML file; others keep their values. Tables nest into dotted keys;
/// dates and times arrive as text ("2026-06-21", "18:30:00").
/// Throws InputError "file:line: key = value: …" for bad TOML, an unknown key, a wrong type or a
/// value out of range. Nothing is set where anything is wrong.
FieldPlaces load_fields(const std::filesystem::path& file, const FieldTable& table);
/// The same, of a scene.
void load_scene(const std::filesystem::path& file, const FieldTable& table);

}  // namespace offing
