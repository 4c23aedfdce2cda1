#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/paths.h"

namespace {
namespace fs = std::filesystem;

// Lowest first: a folder may include itself and those before it.
const std::vector<std::string> kLayers = {"core",  "platform", "gl",          "shader",
                                          "io",    "graph",    "environment", "post",
                                          "ocean", "sky",      "clouds",      "boat"};

// Path from the project's root → the headers it includes, as written.
using Includes = std::map<std::string, std::vector<std::string>>;

std::vector<std::string> includes_in(const std::string& text) {
  static const std::regex line(R"(^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"])",
                               std::regex::multiline);
  std::vector<std::string> found;
  for (std::sregex_iterator i(text.begin(), text.end(), line), end; i != end; ++i) {
    found.push_back((*i)[1]);
  }
  return found;
}

Includes read_tree(const fs::path& root) {
  Includes result;
  for (const char* top : {"engine", "game", "shaders"}) {
    if (!fs::exists(root / top)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const std::string type = entry.path().extension().string();
      if (type != ".h" && type != ".cpp") continue;
      std::ifstream in(entry.path());
      const std::string text(std::istreambuf_iterator<char>(in), {});
      result[entry.path().lexically_relative(root).generic_string()] = includes_in(text);
    }
  }
  return result;
}

bool under(const std::string& path, const std::string& folder) {
  return path.rfind(folder + "/", 0) == 0;
}

// Place in kLayers, or -1.
int layer_of(const std::string& path) {
  if (!under(path, "engine")) return -1;
  const std::string folder = path.substr(7, path.find('/', 7) - 7);
  const auto layer = std::find(kLayers.begin(), kLayers.end(), folder);
  return layer == kLayers.end() ? -1 : static_cast<int>(layer - kLayers.begin());
}

bool is_opengl(const std::string& header) {
  static const std::regex name(R"((epoxy|GL|GLES\d?|GLFW|EGL|glad)/.*)");
  return std::regex_match(header, name);
}

// One line for each include that breaks the order; empty where all is well.
std::vector<std::string> problems_of(const Includes& files) {
  std::vector<std::string> problems;
  for (const auto& [file, headers] : files) {
    if (under(file, "engine") && layer_of(file) < 0) problems.push_back(file + " is in no layer");
    for (const std::string& header : headers) {
      if (header.rfind("OpenImageIO/", 0) == 0 && !under(file, "engine/io")) {
        problems.push_back(file + " includes " + header);
      }
      if (!under(file, "engine")) continue;
      const bool upwards = under(header, "engine") && layer_of(header) > layer_of(file);
      if (upwards || under(header, "game")) problems.push_back(file + " includes " + header);
    }
  }

  // The simulation must run without any GPU: no OpenGL header, not even through another's.
  for (const auto& [file, ignored] : files) {
    if (!under(file, "engine/boat") && !under(file, "game/world")) continue;
    std::set<std::string> seen{file};
    std::vector<std::string> queue{file};
    while (!queue.empty()) {
      const std::string next = queue.back();
      queue.pop_back();
      const auto found = files.find(next);
      if (found == files.end()) continue;
      for (const std::string& header : found->second) {
        if (is_opengl(header)) problems.push_back(file + " reaches " + header + " by " + next);
        if (seen.insert(header).second) queue.push_back(header);
      }
    }
  }
  return problems;
}

TEST(Layers, EveryIncludePointsDown) {
  const Includes files = read_tree(offing::test::test_data() / "..");
  ASSERT_GT(files.size(), 20u) << "the source tree was not found";
  ASSERT_TRUE(files.count("engine/core/error.h"));
  for (const std::string& problem : problems_of(files)) ADD_FAILURE() << problem;
}

TEST(Layers, IncludesAreFoundAsWritten) {
  EXPECT_EQ(includes_in("#pragma once\n#include <a/b.h>\n  # include \"engine/io/c.h\"\n"
                        "// #include <no.h>\nint x;  #include <no.h>\n#include<d.h>"),
            (std::vector<std::string>{"a/b.h", "engine/io/c.h", "d.h"}));
}

TEST(Layers, SoundIncludesPass) {
  EXPECT_TRUE(problems_of({{"engine/boat/boat.cpp", {"engine/boat/boat.h", "engine/core/log.h"}},
                           {"engine/gl/texture.h", {"epoxy/gl.h"}},
                           {"engine/io/image.cpp", {"OpenImageIO/imageio.h"}},
                           {"game/frame/frame.cpp", {"engine/gl/texture.h", "game/world/world.h"}}})
                  .empty());
}

TEST(Layers, EachBadIncludeIsFound) {
  const std::vector<Includes> bad = {
      {{"engine/core/log.cpp", {"engine/io/file.h"}}},
      {{"engine/sky/sky.cpp", {"engine/clouds/clouds.h"}}},
      {{"engine/platform/window.h", {"engine/gl/texture.h"}}},
      {{"engine/ocean/ocean.h", {"game/world/world.h"}}},
      {{"engine/ocean/ocean.cpp", {"OpenImageIO/imageio.h"}}},
      {{"game/render/render.cpp", {"OpenImageIO/imageio.h"}}},
      {{"engine/weather/rain.h", {}}},
      {{"engine/boat/hull.cpp", {"GL/gl.h"}}},
      {{"game/world/world.h", {"GLFW/glfw3.h"}}},
      {{"game/world/world.cpp", {"engine/ocean/ocean.h"}},
       {"engine/ocean/ocean.h", {"engine/gl/texture.h"}},
       {"engine/gl/texture.h", {"epoxy/gl.h"}}},
  };
  for (const Includes& files : bad) {
    EXPECT_EQ(problems_of(files).size(), 1u) << files.begin()->first;
  }
}

}  // namespace
