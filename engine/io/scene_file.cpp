#include "engine/io/scene_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <toml++/toml.h>
#include <algorithm>

#include "engine/core/error.h"
#include "engine/core/paths.h"
#include "engine/io/file.h"

namespace offing {
namespace {
namespace fs = std::filesystem;

struct Entry {
  std::string key;
  FieldValue value;
  std::string where;  // "file:line"
  unsigned line;
};

std::string place(const fs::path& file, unsigned line) {
  return fmt::format("{}:{}", file.string(), line);
}

std::string text_of(const toml::date& date) {
  return fmt::format("{:04}-{:02}-{:02}", date.year, date.month, date.day);
}

std::string text_of(const toml::time& time) {
  return fmt::format("{:02}:{:02}:{:02}", time.hour, time.minute, time.second);
}

FieldValue list_value(const toml::array& array, const std::string& where, std::string_view key) {
  std::vector<double> numbers;
  for (const toml::node& node : array) {
    if (!node.is_number()) {
      throw InputError(fmt::format("{}: {}: must be a list of numbers only", where, key));
    }
    numbers.push_back(node.value<double>().value());
  }
  return numbers;
}

FieldValue value_of(const toml::node& node, const std::string& where, std::string_view key) {
  switch (node.type()) {
    case toml::node_type::boolean:
      return node.as_boolean()->get();
    case toml::node_type::integer:
      return static_cast<double>(node.as_integer()->get());
    case toml::node_type::floating_point:
      return node.as_floating_point()->get();
    case toml::node_type::string:
      return node.as_string()->get();
    case toml::node_type::date:
      return text_of(node.as_date()->get());
    case toml::node_type::time:
      return text_of(node.as_time()->get());
    case toml::node_type::array:
      return list_value(*node.as_array(), where, key);
    default:
      throw InputError(fmt::format(
          "{}: {}: a date with a time fits no key; write the date and the time apart", where, key));
  }
}

void collect(const toml::table& table, const std::string& prefix, const fs::path& file,
             std::vector<Entry>& entries) {
  for (const auto& [name, node] : table) {
    const std::string key = prefix + std::string(name.str());
    if (const toml::table* inner = node.as_table()) {
      collect(*inner, key + '.', file, entries);
      continue;
    }
    const unsigned line = node.source().begin.line;
    const std::string where = place(file, line);
    entries.push_back({key, value_of(node, where, key), where, line});
  }
}

toml::table parse(const fs::path& file) {
  try {
    return toml::parse(read_text(file, 1 << 20), file.string());
  } catch (const toml::parse_error& error) {
    std::string why(error.description());
    std::replace(why.begin(), why.end(), '\n', ' ');
    throw InputError(fmt::format("{}: not TOML: {}", place(file, error.source().begin.line), why));
  }
}

std::vector<std::string> file_names(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

fs::path find_data(std::string_view option, std::string_view kind, std::string_view name_or_file,
                   const fs::path& folder) {
  const bool is_path =
      name_or_file.find('/') != std::string_view::npos || name_or_file.ends_with(".toml");
  const fs::path file =
      is_path ? fs::path(name_or_file) : folder / fmt::format("{}.toml", name_or_file);
  std::error_code ignored;
  if (!name_or_file.empty() && fs::exists(file, ignored) && !fs::is_directory(file, ignored)) {
    return file;
  }
  const std::vector<std::string> names = file_names(folder);
  throw InputError(fmt::format(
      "{} {}: no such {}; {}", option, name_or_file, kind,
      names.empty() ? fmt::format("there are none in {}", folder.string())
                    : fmt::format("there are {}, or give a .toml file", fmt::join(names, ", "))));
}

fs::path find_scene(std::string_view name_or_file, const fs::path& folder) {
  return find_data("--scene", "scene", name_or_file,
                   folder.empty() ? data_root() / "assets" / "scenes" : folder);
}

FieldPlaces load_fields(const fs::path& file, const FieldTable& table) {
  std::vector<Entry> entries;
  collect(parse(file), "", file, entries);
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.line < b.line; });
  for (const Entry& entry : entries) table.check(entry.key, entry.value, entry.where);
  FieldPlaces places;
  for (const Entry& entry : entries) {
    table.set(entry.key, entry.value, entry.where);
    places.emplace(entry.key, entry.where);
  }
  return places;
}

void load_scene(const fs::path& file, const FieldTable& table) { load_fields(file, table); }

}  // namespace offing
