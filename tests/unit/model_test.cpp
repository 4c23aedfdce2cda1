#include "engine/io/model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/random.h"
#include "engine/io/file.h"
#include "support/scratch_folder.h"
#include "unit/png_bytes.h"

namespace offing {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

template <class T>
std::string bytes_of(std::initializer_list<T> values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), values.begin(), bytes.size());
  return bytes;
}

std::string as_glb(const std::string& text, const std::string& binary) {
  const auto word = [](std::size_t value) {
    return bytes_of<std::uint32_t>({static_cast<std::uint32_t>(value)});
  };
  std::string padded = text + std::string((4 - text.size() % 4) % 4, ' ');
  std::string data = binary + std::string((4 - binary.size() % 4) % 4, '\0');
  return "glTF" + word(2) + word(12 + 8 + padded.size() + 8 + data.size()) + word(padded.size()) +
         "JSON" + padded + word(data.size()) + std::string("BIN\0", 4) + data;
}

// A square hull of two triangles, 2 m wide, with a boom 3 m above it that is the same square.
struct Boat {
  Boat() {
    const std::size_t positions = add(bytes_of<float>({-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1}));
    const std::size_t normals = add(bytes_of<float>({0, 2, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0}));
    const std::size_t uvs = add(bytes_of<float>({0, 0, 1, 0, 1, 1, 0, 1}));
    const std::size_t indices = add(bytes_of<std::uint16_t>({0, 2, 1, 0, 3, 2}));
    const std::size_t picture = add(PngBytes::make(2, 1, 3, std::string("\xff\0\0\0\xff\0", 6)));
    root["asset"] = {{"version", "2.0"}};
    root["scene"] = 0;
    root["scenes"] = {{{"nodes", {1}}}};
    root["nodes"] = {{{"name", "boom"}, {"translation", {0.0, 3.0, 0.0}}, {"mesh", 0}},
                     {{"name", "hull"}, {"children", {0}}, {"mesh", 0}, {"extras", {{"a", 1}}}}};
    root["meshes"] = {{{"primitives",
                        {{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"TEXCOORD_0", 2}}},
                          {"indices", 3},
                          {"material", 0}}}}}};
    root["accessors"] = {accessor(positions, 5126, 4, "VEC3"), accessor(normals, 5126, 4, "VEC3"),
                         accessor(uvs, 5126, 4, "VEC2"), accessor(indices, 5123, 6, "SCALAR")};
    root["materials"] = {{{"name", "gelcoat"},
                          {"doubleSided", true},
                          {"emissiveFactor", {0.0, 0.25, 1.0}},
                          {"pbrMetallicRoughness",
                           {{"baseColorFactor", {1.0, 0.5, 0.25, 1.0}},
                            {"metallicFactor", 0.125},
                            {"roughnessFactor", 0.5},
                            {"baseColorTexture", {{"index", 0}}}}}}};
    root["textures"] = {{{"source", 0}}};
    root["images"] = {{{"bufferView", picture}, {"mimeType", "image/png"}}};
  }

  std::size_t add(const std::string& data) {
    root["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", data.size()}});
    binary += data + std::string((4 - data.size() % 4) % 4, '\0');
    return root["bufferViews"].size() - 1;
  }
  static json accessor(std::size_t view, int type, int count, const char* shape) {
    return {{"bufferView", view}, {"componentType", type}, {"count", count}, {"type", shape}};
  }
  json& primitive() { return root["meshes"][0]["primitives"][0]; }
  std::string glb() {
    root["buffers"] = {{{"byteLength", binary.size()}}};
    return as_glb(root.dump(), binary);
  }

  json root;
  std::string binary;
};

struct Models : testing::Test {
  Models() { fs::create_directories(folder / "inside"); }

  fs::path file(const char* name = "inside/boat.glb") const { return folder / name; }
  Model load(const std::string& bytes, const char* name = "inside/boat.glb") {
    write_text(file(name), bytes);
    return load_model(file(name));
  }
  // What a refused file's message says after its name; empty for one that loads.
  std::string refusal(const std::string& bytes, const char* name = "inside/boat.glb") {
    try {
      load(bytes, name);
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find(file(name).string()), 0u) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_LT(message.size(), file(name).string().size() + 300) << message;
      return message.substr(file(name).string().size());
    }
    return "";
  }
  std::string refusal_after(const std::function<void(Boat&)>& change) {
    Boat boat;
    change(boat);
    return refusal(boat.glb());
  }

  const test::ScratchFolder scratch;
  const fs::path folder = scratch.path();
};

TEST_F(Models, AGlbIsReadWhole) {
  const Model model = load(Boat().glb());
  ASSERT_EQ(model.vertices.size(), 4u);
  EXPECT_EQ(model.indices, (std::vector<std::uint32_t>{0, 2, 1, 0, 3, 2}));
  EXPECT_EQ(model.vertices[2].position, glm::vec3(1, 0, 1));
  EXPECT_EQ(model.vertices[0].normal, glm::vec3(0, 1, 0)) << "normalised";
  EXPECT_EQ(model.vertices[3].normal, glm::vec3(0, 1, 0)) << "in place of a zero";
  EXPECT_EQ(model.vertices[1].uv, glm::vec2(1, 0));

  ASSERT_EQ(model.nodes.size(), 2u);
  EXPECT_EQ(model.find("hull"), 0) << "parents come first";
  EXPECT_EQ(model.find("boom"), 1);
  EXPECT_EQ(model.find("mast"), -1);
  EXPECT_EQ(model.nodes[0].parent, -1);
  EXPECT_EQ(model.nodes[1].parent, 0);
  EXPECT_EQ(model.nodes[1].parent_from_node * glm::vec4(1, 2, 3, 1), glm::vec4(1, 5, 3, 1));
  ASSERT_EQ(model.nodes[1].primitives.size(), 1u);
  EXPECT_EQ(model.nodes[1].primitives[0].index_count, 6u);

  ASSERT_EQ(model.materials.size(), 1u);
  const ModelMaterial& material = model.materials[0];
  EXPECT_EQ(material.name, "gelcoat");
  EXPECT_EQ(material.base_colour, glm::vec4(1, 0.5, 0.25, 1));
  EXPECT_EQ(material.metallic, 0.125f);
  EXPECT_EQ(material.roughness, 0.5f);
  EXPECT_EQ(material.emissive, glm::vec3(0, 0.25, 1));
  EXPECT_TRUE(material.double_sided);
  if (!reads_pictures()) {
    EXPECT_EQ(material.base_colour_image, -1);
    return;
  }
  ASSERT_EQ(material.base_colour_image, 0);
  ASSERT_EQ(model.images.size(), 1u);
  EXPECT_EQ(model.images[0].pixels, (std::vector<float>{1, 0, 0, 0, 1, 0}));
}

TEST_F(Models, AGltfFindsItsFilesBesideIt) {
  Boat boat;
  fs::create_directories(folder / "inside" / "sub dir");
  write_text(file("inside/sub dir/boat.bin"), boat.binary);
  write_text(file("inside/red.png"), PngBytes::make(1, 1, 3, std::string("\xff\0\0", 3)));
  boat.root["buffers"] = {{{"byteLength", boat.binary.size()}, {"uri", "sub%20dir/boat.bin"}}};
  boat.root["images"] = {{{"uri", "red.png"}}};
  const Model model = load(boat.root.dump(), "inside/boat.gltf");
  EXPECT_EQ(model.vertices.size(), 4u);
  if (reads_pictures()) {
    EXPECT_EQ(model.images.at(0).pixels, (std::vector<float>{1, 0, 0}));
  }
}

TEST_F(Models, ABufferMayBeADataUri) {
  // One triangle: 36 bytes, all positions 0 but for x of the second and y of the third, 1.0f.
  json root = {{"asset", {{"version", "2.0"}}}};
  const std::string base64 = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
  root["buffers"] = {
      {{"byteLength", 36}, {"uri", "data:application/octet-stream;base64," + base64}}};
  root["bufferViews"] = {{{"buffer", 0}, {"byteLength", 36}}};
  root["accessors"] = {Boat::accessor(0, 5126, 3, "VEC3")};
  root["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}};
  root["nodes"] = {{{"mesh", 0}}};
  const Model model = load(root.dump(), "inside/boat.gltf");
  ASSERT_EQ(model.vertices.size(), 3u);
  EXPECT_EQ(model.vertices[1].position, glm::vec3(1, 0, 0));
  EXPECT_EQ(model.vertices[2].normal, glm::vec3(0, 0, 1)) << "right-handed, counter-clockwise";
  EXPECT_EQ(model.materials.size(), 1u) << "the default one";
  EXPECT_EQ(model.nodes[0].primitives[0].material, 0);
}

TEST_F(Models, MissingNormalsAreFlat) {
  Boat boat;
  boat.primitive()["attributes"].erase("NORMAL");
  const Model model = load(boat.glb());
  EXPECT_EQ(model.vertices.size(), 6u) << "each triangle has its own corners";
  for (const ModelVertex& vertex : model.vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 1, 0));
}

TEST_F(Models, TransformsAreReadInBothForms) {
  Boat boat;
  const double half = std::sqrt(0.5);
  // A quarter turn about y takes x to -z; scale acts first, translation last.
  boat.root["nodes"][0]["rotation"] = {0.0, half, 0.0, half};
  boat.root["nodes"][0]["scale"] = {2.0, 1.0, 1.0};
  boat.root["nodes"][1]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};
  const Model model = load(boat.glb());
  const glm::vec4 boom = model.nodes[1].parent_from_node * glm::vec4(1, 0, 0, 1);
  EXPECT_NEAR(boom.x, 0.0f, 1e-6f);
  EXPECT_NEAR(boom.y, 3.0f, 1e-6f);
  EXPECT_NEAR(boom.z, -2.0f, 1e-6f);
  EXPECT_EQ(model.nodes[0].parent_from_node * glm::vec4(0, 0, 0, 1), glm::vec4(5, 6, 7, 1));
}

TEST_F(Models, MissingNodesAreAllNamedAtOnce) {
  write_text(file(), Boat().glb());
  const std::string_view wanted[] = {"hull", "mast", "boom", "jib"};
  load_model(file(), std::span(wanted, 1));
  const auto said = [&](std::span<const std::string_view> names) {
    try {
      load_model(file(), names);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(said(wanted),
            file().string() +
                ": nodes 'mast', 'jib' are missing: name them in the model and export "
                "it again");
  EXPECT_EQ(said(std::span(wanted, 2)),
            file().string() + ": node 'mast' is missing: name it in the model and export it again");
}

TEST_F(Models, TrianglesAreLimitedAsStoredAndAsDrawn) {
  write_text(file(), Boat().glb());
  load_model(file(), {}, 4);
  EXPECT_THROW(load_model(file(), {}, 3), InputError) << "two nodes draw two triangles each";
  EXPECT_THROW(load_model(file(), {}, 1), InputError);
}

TEST_F(Models, WhatIsNoModelIsRefused) {
  EXPECT_NE(refusal(""), "");
  EXPECT_NE(refusal("hello"), "");
  EXPECT_NE(refusal("glTF"), "");
  EXPECT_NE(refusal("[]"), "");
  EXPECT_NE(refusal("{}"), "");
  EXPECT_NE(refusal(R"({"asset":{"version":"2.0"}})"), "");
  EXPECT_NE(refusal(std::string(1000000, '[')), "");
  EXPECT_NE(refusal("{\"asset\":" + std::string(1000000, '[')), "");
  EXPECT_NE(refusal("{\"nodes\":[" + std::string(1200000, '0') + "]}"), "");
  EXPECT_THROW(load_model(folder / "none.glb"), InputError);
  EXPECT_THROW(load_model(folder), InputError);
  EXPECT_NE(refusal_after([](Boat& b) { b.root["asset"]["version"] = "1.0"; }), "");
  EXPECT_NE(refusal_after([](Boat& b) { b.root["extensionsRequired"] = {"KHR_draco"}; }), "");
}

TEST_F(Models, FilesOutsideTheFolderAreRefused) {
  Boat boat;
  write_text(file("secret.bin"), boat.binary);
  fs::create_symlink("../secret.bin", file("inside/link.bin"));
  for (const std::string& uri :
       {std::string("../secret.bin"), std::string("%2e%2e/secret.bin"),
        std::string("sub/../../secret.bin"), file("secret.bin").string(),
        "file://" + file("secret.bin").string(), std::string("..\\secret.bin"),
        std::string("link.bin"), std::string("http://example.com/a.bin"), std::string("%2"),
        std::string("a%00b"), std::string(""), std::string("."), std::string("none.bin")}) {
    boat.root["buffers"] = {{{"byteLength", boat.binary.size()}, {"uri", uri}}};
    const std::string said = refusal(boat.root.dump(), "inside/boat.gltf");
    EXPECT_NE(said, "") << uri;
    EXPECT_EQ(said.find("bytes of"), std::string::npos) << uri << " was read: " << said;
  }
  EXPECT_NE(refusal_after([](Boat& b) { b.root["images"] = {{{"uri", "../a.png"}}}; }), "");
}

TEST_F(Models, EveryUnsoundPartIsRefused) {
  using Change = std::function<void(Boat&)>;
  const auto accessor = [](int i, const char* key, const json& value) -> Change {
    return [=](Boat& b) { b.root["accessors"][i][key] = value; };
  };
  const auto view = [](int i, const char* key, const json& value) -> Change {
    return [=](Boat& b) { b.root["bufferViews"][i][key] = value; };
  };
  const auto node = [](int i, const char* key, const json& value) -> Change {
    return [=](Boat& b) { b.root["nodes"][i][key] = value; };
  };
  const auto primitive = [](const char* key, const json& value) -> Change {
    return [=](Boat& b) { b.primitive()[key] = value; };
  };
  const auto position = [](float value) -> Change {
    return [=](Boat& b) { std::memcpy(b.binary.data() + 4, &value, 4); };
  };
  const auto pbr = [](const char* key, const json& value) -> Change {
    return [=](Boat& b) { b.root["materials"][0]["pbrMetallicRoughness"][key] = value; };
  };
  const std::vector<std::pair<const char*, Change>> changes = {
      {"accessor past its view", accessor(0, "count", 5)},
      {"accessor offset past its view", accessor(0, "byteOffset", 4)},
      {"huge count", accessor(0, "count", 2147483647)},
      {"huger count", accessor(0, "count", 18446744073709551615ull)},
      {"negative count", accessor(0, "count", -1)},
      {"no count", accessor(0, "count", 0)},
      {"fractional count", accessor(0, "count", 4.5)},
      {"attributes of different lengths", accessor(1, "count", 3)},
      {"position of the wrong type", accessor(0, "type", "VEC2")},
      {"position of the wrong component", accessor(0, "componentType", 5125)},
      {"unknown component", accessor(0, "componentType", 1)},
      {"float indices", accessor(3, "componentType", 5126)},
      {"indices that wrap to bytes past the end", accessor(3, "componentType", 5125)},
      {"unaligned", accessor(0, "byteOffset", 2)},
      {"sparse", accessor(0, "sparse", {{"count", 1}})},
      {"no view", [](Boat& b) { b.root["accessors"][0].erase("bufferView"); }},
      {"another view", accessor(0, "bufferView", 99)},
      {"a view that wraps", accessor(0, "bufferView", 4294967296)},
      {"view past its buffer", view(0, "byteLength", 100000)},
      {"view offset past its buffer", view(0, "byteOffset", 2147483647)},
      {"view of no buffer", view(0, "buffer", 7)},
      {"picture's view past its buffer", view(4, "byteOffset", 100000)},
      {"stride below an element", view(0, "byteStride", 8)},
      {"odd stride", view(0, "byteStride", 13)},
      {"stride past the view", view(0, "byteStride", 16)},
      {"not triangles", primitive("mode", 1)},
      {"no such material", primitive("material", 1)},
      {"no such indices", primitive("indices", 4)},
      {"no positions", [](Boat& b) { b.primitive()["attributes"].erase("POSITION"); }},
      {"index out of range", [](Boat& b) { b.binary[128] = 4; }},
      {"half a triangle", accessor(3, "count", 5)},
      {"NaN position", position(std::numeric_limits<float>::quiet_NaN())},
      {"infinite position", position(-std::numeric_limits<float>::infinity())},
      {"absurd position", position(1e30f)},
      {"its own child", node(0, "children", {0})},
      {"a ring", node(0, "children", {1})},
      {"no such child", node(0, "children", {2})},
      {"a child twice", node(1, "children", {0, 0})},
      {"no such mesh", node(0, "mesh", 1)},
      {"short translation", node(0, "translation", {1.0, 2.0})},
      {"long rotation", node(0, "rotation", {0.0, 0.0, 0.0, 2.0})},
      {"huge translation", node(0, "translation", {1e300, 0.0, 0.0})},
      {"short matrix", node(1, "matrix", {1.0, 0.0})},
      {"projection", node(1, "matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1})},
      {"no such scene", [](Boat& b) { b.root["scene"] = 1; }},
      {"no such root", [](Boat& b) { b.root["scenes"][0]["nodes"] = {5}; }},
      {"a child as root",
       [](Boat& b) {
         b.root["scenes"][0]["nodes"] = {1, 0};
       }},
      {"a root twice",
       [](Boat& b) {
         b.root["scenes"][0]["nodes"] = {1, 1};
       }},
      {"an empty scene", [](Boat& b) { b.root["scenes"][0]["nodes"] = json::array(); }},
      {"nothing to draw",
       [](Boat& b) {
         b.root["nodes"] = {{{"name", "a"}}, {{"name", "b"}}};
       }},
      {"bright base colour", pbr("baseColorFactor", {2.0, 0.0, 0.0, 1.0})},
      {"short base colour", pbr("baseColorFactor", {1.0})},
      {"metal of 7", pbr("metallicFactor", 7.0)},
      {"no such texture", pbr("baseColorTexture", {{"index", 1}})},
      {"second coordinates", pbr("baseColorTexture", {{"index", 0}, {"texCoord", 1}})},
      {"no such image", [](Boat& b) { b.root["textures"][0]["source"] = 1; }},
      {"an image twice", [](Boat& b) { b.root["images"][0]["uri"] = "a.png"; }},
      {"an image nowhere", [](Boat& b) { b.root["images"][0].erase("bufferView"); }},
      {"nodes that are none", [](Boat& b) { b.root["nodes"] = {1, 2}; }},
      {"a table that is none", [](Boat& b) { b.root["accessors"] = "x"; }},
  };
  for (const auto& [name, change] : changes) EXPECT_NE(refusal_after(change), "") << name;
}

TEST_F(Models, DeepTreesAreRefused) {
  const auto chain = [](int depth) {
    return [depth](Boat& b) {
      b.root["nodes"] = json::array();
      for (int i = 0; i < depth; ++i) b.root["nodes"].push_back({{"children", {i + 1}}});
      b.root["nodes"].push_back({{"mesh", 0}});
      b.root["scenes"][0]["nodes"] = {0};
    };
  };
  EXPECT_EQ(refusal_after(chain(60)), "");
  EXPECT_NE(refusal_after(chain(70)), "");
}

TEST_F(Models, APictureThatIsNoneIsRefused) {
  if (!reads_pictures()) GTEST_SKIP() << "this build has no OpenImageIO";
  const std::string said = refusal_after([](Boat& b) {
    const std::size_t at = b.root["bufferViews"][4]["byteOffset"];
    b.binary.replace(at, 8, "no PNG!!");
  });
  EXPECT_EQ(said.find(": image 0: cannot be read: "), 0u) << said;
}

// Any change of a sound file either still loads or is refused by an InputError: load() lets every
// other exception through, and the sanitizers' build catches the rest.
TEST_F(Models, CutAndDamagedFilesNeverCrash) {
  const std::string good = Boat().glb();
  for (std::size_t size = 0; size < good.size(); size += 7) {
    EXPECT_NE(refusal(good.substr(0, size)), "") << size;
  }
  int refused = 0;
  for (std::uint64_t round = 0; round < 600; ++round) {
    std::string bytes = good;
    for (std::uint64_t i = 0; i <= round % 3; ++i) {
      const std::uint64_t bits = random_bits(1, round, i);
      bytes[bits % bytes.size()] = static_cast<char>(bits >> 40);
    }
    refused += refusal(bytes) != "";
  }
  EXPECT_GT(refused, 100);
}

TEST_F(Models, AnyValueInAnyPlaceNeverCrashes) {
  Boat boat;
  boat.root.erase("images");  // decoded pictures have their own test
  boat.root.erase("textures");
  boat.root["materials"][0]["pbrMetallicRoughness"].erase("baseColorTexture");
  ASSERT_EQ(refusal(boat.glb()), "");
  const json flat = boat.root.flatten();
  const std::vector<json> values = {
      -1,  0,     1,   2147483647, 4294967295u,   9223372036854775808ull,
      0.5, 1e300, "x", nullptr,    json::array(), json::object(),
      true};
  int refused = 0, tried = 0;
  for (const auto& [path, old] : flat.items()) {
    for (const json& value : values) {
      json root = boat.root;
      root[json::json_pointer(path)] = value;
      refused += refusal(as_glb(root.dump(), boat.binary)) != "";
      ++tried;
    }
  }
  EXPECT_GT(refused, tried / 2) << "of " << tried;
}

}  // namespace
}  // namespace offing
