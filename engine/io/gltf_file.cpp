#include "engine/io/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "engine/core/error.h"
#include "engine/io/file.h"

namespace offing {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kMaxDepth = 32;                // of JSON; glTF itself needs 8
constexpr std::size_t kMaxValues = 500'000;  // in the JSON
constexpr std::size_t kMaxParts = 4096;      // nodes, meshes, accessors, … of each kind

// What a Model is made of; the rest (animations, skins, cameras, extras) is left out.
constexpr std::array<std::string_view, 10> kTables = {
    "nodes",     "meshes",   "accessors", "bufferViews", "buffers",
    "materials", "textures", "images",    "scenes",      "samplers"};

// Members that are indices, offsets or counts wherever they stand.
constexpr std::array<std::string_view, 16> kWholeNumbers = {
    "buffer",  "bufferView", "byteLength", "byteOffset", "byteStride", "componentType",
    "count",   "index",      "indices",    "material",   "mesh",       "mode",
    "sampler", "scene",      "source",     "texCoord"};

template <class List>
bool contains(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

bool is_whole(const json& value) {
  return value.is_number_unsigned() &&
         value.get<std::uint64_t>() <= std::numeric_limits<std::int32_t>::max();
}

class Reader {
 public:
  explicit Reader(const fs::path& file) : file_(file) {}

  GltfFile read() {
    const std::string bytes = read_text(file_, kMaxModelBytes);
    parse(bytes.starts_with("glTF") ? open_binary(bytes) : std::string_view(bytes));
    check_version();
    keep_known_parts();
    check_values(root_);
    for (std::size_t i = 0; i < size("buffers"); ++i) take_buffer(i);
    for (std::size_t i = 0; i < size("bufferViews"); ++i) check_view(i);
    for (std::size_t i = 0; i < size("images"); ++i) take_image(i);
    result_.json = root_.dump();
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(std::string_view why,
                         std::string_view advice = "export it again as glTF 2.0") const {
    throw InputError(fmt::format("{}: {}; {}", file_.string(), why, advice));
  }

  std::size_t size(const char* table) const {
    return root_.contains(table) ? root_[table].size() : 0;
  }

  // A whole number in check_values()'s range.
  static std::uint64_t number(const json& object, const char* key, std::uint64_t fallback) {
    return object.contains(key) ? object[key].get<std::uint64_t>() : fallback;
  }

  // The JSON chunk of a .glb; its BIN chunk goes to binary_. Layout: glTF 2.0 specification, 4.4.
  std::string_view open_binary(std::string_view bytes) {
    const auto word = [&](std::size_t at) {
      std::uint32_t value = 0;
      if (at + 4 > bytes.size()) fail("is cut short");
      std::memcpy(&value, bytes.data() + at, 4);
      return value;
    };
    if (word(4) != 2) fail(fmt::format("is binary glTF {} and not 2", word(4)));
    if (word(8) != bytes.size()) {
      fail(fmt::format("has {} bytes where its header says {}", bytes.size(), word(8)));
    }
    std::string_view text;
    for (std::size_t at = 12; at < bytes.size();) {
      const std::uint32_t length = word(at), type = word(at + 4);
      at += 8;
      if (length > bytes.size() - at) fail("has a chunk that is cut short");
      const std::string_view chunk = bytes.substr(at, length);
      at += length;
      if (type == 0x4e4f534a && text.empty()) text = chunk;        // "JSON"
      if (type == 0x004e4942 && binary_.empty()) binary_ = chunk;  // "BIN"
    }
    return text;
  }

  void parse(std::string_view text) {
    std::size_t values = 0;
    const auto bounded = [&](int depth, json::parse_event_t, json&) {
      if (depth > kMaxDepth) fail("nests too deep");
      if (++values > kMaxValues) fail("has too many values");
      return true;
    };
    try {
      root_ = json::parse(text, bounded);
    } catch (const json::exception& error) {
      // "[json.exception.parse_error.101] parse error at line 1, column 1: …"
      std::string why = error.what();
      std::replace_if(
          why.begin(), why.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
      fail("not glTF: " + why.substr(why.find(']') + 1, 160));
    }
    if (!root_.is_object()) fail("not glTF: its JSON is no object");
  }

  void check_version() const {
    const auto asset = root_.find("asset");
    const bool known = asset != root_.end() && asset->is_object() && asset->contains("version") &&
                       (*asset)["version"].is_string() &&
                       (*asset)["version"].get<std::string>().starts_with("2.");
    if (!known) fail("is not glTF 2.0");
    const auto required = root_.find("extensionsRequired");
    if (required != root_.end() && !(required->is_array() && required->empty())) {
      fail("needs glTF extensions, and none are read", "export it without them");
    }
  }

  void keep_known_parts() {
    json kept = {{"asset", {{"version", "2.0"}}}};
    if (root_.contains("scene")) kept["scene"] = root_["scene"];
    for (const std::string_view name : kTables) {
      const auto table = root_.find(name);
      if (table == root_.end()) continue;
      if (!table->is_array()) fail(fmt::format("{} is no array", name));
      if (table->size() > kMaxParts) fail(fmt::format("has more than {} {}", kMaxParts, name));
      for (const json& entry : *table) {
        if (!entry.is_object()) fail(fmt::format("{} holds something else than objects", name));
      }
      kept[std::string(name)] = std::move(*table);
    }
    root_ = std::move(kept);
  }

  // Drops what is not read and refuses numbers that the parser would wrap or replace in silence.
  // Depth is bounded by parse().
  void check_values(json& value) const {
    if (value.is_array()) {
      for (json& entry : value) check_values(entry);
      return;
    }
    if (!value.is_object()) return;
    value.erase("extras");
    value.erase("extensions");
    value.erase("targets");
    if (value.contains("sparse")) fail("has sparse accessors", "export it without them");
    for (auto& [key, member] : value.items()) {
      if (contains(kWholeNumbers, key) && !is_whole(member)) {
        fail(fmt::format("{} is no whole number", key));
      }
      if (key == "children" || (key == "nodes" && &value != &root_)) check_indices(key, member);
      if (key == "attributes") check_indices(key, member);
      check_values(member);
    }
  }

  void check_indices(const std::string& key, const json& list) const {
    const bool fine =
        (list.is_array() || list.is_object()) && std::all_of(list.begin(), list.end(), is_whole);
    if (!fine) fail(fmt::format("{} holds something else than indices", key));
  }

  void take_buffer(std::size_t index) {
    json& buffer = root_["buffers"][index];
    const std::string name = fmt::format("buffer {}", index);
    const std::uint64_t length = number(buffer, "byteLength", 0);
    if (length == 0 || length > kMaxModelBytes) fail(name + " has no sound byteLength");
    std::string bytes;
    if (!buffer.contains("uri")) {
      if (index != 0 || binary_.empty()) fail(name + " has no uri");
      bytes = binary_;
    } else {
      if (is_data(buffer["uri"])) return;
      bytes = beside(name, buffer["uri"]);
    }
    if (bytes.size() < length)
      fail(fmt::format("{} has {} bytes of {}", name, bytes.size(), length));
    bytes.resize(length);
    buffer["uri"] = add_part(std::move(bytes));
  }

  void check_view(std::size_t index) const {
    const json& view = root_["bufferViews"][index];
    const std::uint64_t buffer = number(view, "buffer", size("buffers"));
    const std::uint64_t length = number(view, "byteLength", 0);
    const bool inside =
        buffer < size("buffers") && length > 0 &&
        number(view, "byteOffset", 0) + length <= number(root_["buffers"][buffer], "byteLength", 0);
    if (!inside) fail(fmt::format("bufferView {} lies outside its buffer", index));
  }

  void take_image(std::size_t index) {
    json& image = root_["images"][index];
    const std::string name = fmt::format("image {}", index);
    if (image.contains("bufferView") == image.contains("uri")) {
      fail(name + " needs either a uri or a bufferView");
    }
    if (image.contains("bufferView")) {
      if (number(image, "bufferView", 0) >= size("bufferViews"))
        fail(name + " has no such bufferView");
      return;
    }
    if (is_data(image["uri"])) return;
    std::string bytes = beside(name, image["uri"]);
    if (bytes.empty()) fail(name + " is empty");
    image["uri"] = add_part(std::move(bytes));
  }

  static bool is_data(const json& uri) {
    return uri.is_string() && uri.get_ref<const std::string&>().starts_with("data:");
  }

  std::string add_part(std::string bytes) {
    const std::string key = fmt::format("part-{}", result_.parts.size());
    result_.parts.emplace(key, std::move(bytes));
    return key;
  }

  // The bytes of a file named by a relative URI, which must lie in the model's folder, links
  // followed.
  std::string beside(const std::string& name, const json& uri) {
    if (!uri.is_string()) fail(name + ": its uri is no text");
    const fs::path relative = decoded(name, uri.get<std::string>());
    const auto outside = [&] {
      fail(fmt::format("{} refers to a file outside the model's folder", name),
           "put all files of a model in one folder");
    };
    const std::string text = relative.string();
    if (text.empty() || relative.is_absolute() || text.find_first_of(":\\") != text.npos) outside();
    if (std::find(relative.begin(), relative.end(), "..") != relative.end()) outside();
    std::error_code error;
    const fs::path folder = fs::canonical(fs::absolute(file_).parent_path(), error);
    const fs::path target = fs::canonical(folder / relative, error);
    if (error || !fs::is_regular_file(target, error)) {
      fail(fmt::format("{} refers to a file that is not there", name), "put it beside the model");
    }
    if (std::mismatch(folder.begin(), folder.end(), target.begin(), target.end()).first !=
        folder.end()) {
      outside();
    }
    std::string bytes = read_text(target, kMaxModelBytes - taken_);
    taken_ += bytes.size();
    return bytes;
  }

  std::string decoded(const std::string& name, std::string_view uri) const {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
      unsigned value = static_cast<unsigned char>(uri[i]);
      if (uri[i] == '%') {
        const std::string_view digits = uri.substr(i + 1, 2);
        const auto end = digits.data() + digits.size();
        if (digits.size() != 2 || std::from_chars(digits.data(), end, value, 16).ptr != end) {
          fail(name + ": its uri is malformed");
        }
        i += 2;
      }
      if (value < 0x20) fail(name + ": its uri is malformed");
      text += static_cast<char>(value);
    }
    return text;
  }

  fs::path file_;
  json root_;
  std::string binary_;  // the BIN chunk
  std::size_t taken_ = 0;
  GltfFile result_;
};

}  // namespace

GltfFile read_gltf(const fs::path& file) { return Reader(file).read(); }

}  // namespace offing
