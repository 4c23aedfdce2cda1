#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "engine/core/error.h"
#include "engine/shader/shader_library.h"

#include <fstream>

namespace offing {
namespace {
namespace fs = std::filesystem;

class Preprocessor {
 public:
  Preprocessor(const fs::path& root, ShaderText& out) : root_(root), out_(out) {}

  void emit(const std::string& line, int file, int number) {
    out_.text += line + '\n';
    out_.lines.push_back({file, number});
  }

  void include(const fs::path& file, const std::string& from) {
    const auto same = [&](const fs::path& known) { return known == file; };
    if (std::any_of(open_.begin(), open_.end(), same)) {
      throw InputError(
          fmt::format("{}: {} includes itself; break the circle", from, file.string()));
    }
    if (std::any_of(out_.files.begin(), out_.files.end(), same)) return;
    std::ifstream stream(root_ / file);
    if (!stream || fs::is_directory(root_ / file)) {
      throw InputError(fmt::format("{}: {} is not there; paths start at {}", from, file.string(),
                                   root_.string()));
    }
    out_.files.push_back(file);
    open_.push_back(file);
    const int index = static_cast<int>(out_.files.size()) - 1;
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
      const std::string path = included_path(line);
      if (path.empty()) {
        emit(line, index, number);
      } else {
        include(path, fmt::format("{}:{}", file.string(), number));
      }
    }
    open_.pop_back();
  }

 private:
  // The path of an `#include "path"` line, or nothing.
  static std::string included_path(const std::string& line) {
    std::size_t at = line.find_first_not_of(" \t");
    if (at == std::string::npos || line.compare(at, 8, "#include") != 0) return {};
    const std::size_t open = line.find('"', at + 8);
    const std::size_t close = open == std::string::npos ? open : line.find('"', open + 1);
    return close == std::string::npos ? std::string() : line.substr(open + 1, close - open - 1);
  }

  const fs::path& root_;
  ShaderText& out_;
  std::vector<fs::path> open_;
};

}  // namespace

ShaderText preprocess_shader(const fs::path& root, const fs::path& file,
                             const ShaderDefines& defines) {
  ShaderText result;
  Preprocessor preprocessor(root, result);
  preprocessor.emit("#version 450 core", -1, 0);
  for (const auto& [name, value] : defines) {
    preprocessor.emit(fmt::format("#define {} {}", name, value), -1, 0);
  }
  preprocessor.include(file, "shader");
  return result;
}

std::string ShaderText::map_log(const std::string& log) const {
  // Drivers write "0:12(34): error" (Mesa), "0(12) : error" (NVIDIA) or "ERROR: 0:12:" (others).
  std::string out;
  std::istringstream stream(log);
  for (std::string line; std::getline(stream, line);) {
    for (std::size_t at = line.find('0'); at != std::string::npos; at = line.find('0', at + 1)) {
      const bool word_start = at == 0 || std::isspace(static_cast<unsigned char>(line[at - 1]));
      if (!word_start || at + 2 >= line.size() || (line[at + 1] != ':' && line[at + 1] != '('))
        continue;
      std::size_t end = at + 2;
      while (end < line.size() && std::isdigit(static_cast<unsigned char>(line[end]))) ++end;
      if (end == at + 2) continue;
      const std::size_t number = std::stoul(line.substr(at + 2, end - at - 2));
      if (number < 1 || number > lines.size()) continue;
      const Line& source = lines[number - 1];
      if (line[at + 1] == '(' && end < line.size() && line[end] == ')') ++end;
      const std::string where =
          source.file < 0
              ? std::string("defines")
              : fmt::format("{}:{}", files[static_cast<std::size_t>(source.file)].string(),
                            source.line);
      line.replace(at, end - at, where);
      break;
    }
    if (!line.empty()) out += line + '\n';
  }
  return out;
}

}  // namespace offing
