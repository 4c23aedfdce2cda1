#pragma once
#include <glm/vec2.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace offing {

/// The command line, parsed. Which members mean something depends on the verb.
struct Options {
  std::string verb = "play";
  std::string what;  ///< of export and bench

  // Every verb.
  std::string scene = "default";
  std::vector<std::string> sets;  ///< "key=value"
  std::optional<glm::ivec2> size;
  std::string quality = "auto";
  std::optional<int> seed;
  double fps = 60.0;

  // render, export, bench
  std::filesystem::path out;
  int frames = 1;
  int warmup = 0;
  std::filesystem::path report;
  std::filesystem::path json;
  std::filesystem::path plot;

  // export
  std::optional<double> time;
  bool no_discs = false;
  std::filesystem::path points;
  std::string method;          ///< empty: the default of what is exported
  std::optional<int> samples;  ///< of pathtrace: paths a pixel
  std::string tws = "6,12,20", twa = "45,60,90,120,150";
  double seconds = 60.0;
  double dt = 1.0 / 120.0;
};

/// What is left to do after reading the command line.
struct CommandLine {
  Options options;
  std::string text;  ///< --help, --version or --list-keys: to be printed instead of anything else
};

/// Throws InputError, one line, for anything that is not in the contract.
CommandLine parse_command_line(int count, const char* const* arguments);

/// "640x360" → (640, 360); each 16 to 16384. Throws InputError naming the option.
glm::ivec2 parse_size(const std::string& text);

/// "45,60.5,90" → numbers. Throws InputError naming the option.
std::vector<double> parse_numbers(const std::string& option, const std::string& text);

}  // namespace offing
