#include "game/options.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <charconv>
#include <cmath>
#include <map>

#include "engine/core/error.h"
#include "engine/core/paths.h"
#include "game/world/scene.h"

namespace offing {
namespace {

const std::map<std::string, std::string> kVerbs = {
    {"play", "sail in a window (what no verb means)"},
    {"render", "draw pictures without a window"},
    {"export", "data for other tools: ocean, heights, sky, clouds, ephemeris, polar or boat"},
    {"bench",
     "measure run time, and error where there is one: frame, ocean, query, stress, sky, probe, "
     "clouds or boat"},
};

std::string list_keys() {
  Scene scene;
  FieldTable table = scene.fields();
  std::string text;
  for (const Field& field : table.fields()) {
    text += fmt::format("{:<32} {:<24} {} ({})\n", field.key, FieldTable::to_text(field),
                        field.help, FieldTable::allowed(field));
  }
  return text;
}

std::string overview() {
  std::string text =
      "offing: sail a boat over an FFT ocean, in one wind\n\nUsage: ./offing [verb] "
      "[options]\n\nVerbs:\n";
  for (const auto& [verb, help] : kVerbs) text += fmt::format("  {:<8} {}\n", verb, help);
  return text + "  test     build and run every test (launcher only)\n\n";
}

// CLI11 wraps its messages over several lines; ours are one.
std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n') c = ' ';
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

void add_common(CLI::App& app, Options& options, std::string& size) {
  app.add_option("--scene", options.scene, "a name in assets/scenes/, or a file");
  app.add_option("--set", options.sets, "key=value: any scene key, repeatable")
      ->allow_extra_args(false);
  app.add_option("--size", size, "WxH in pixels");
  app.add_option("--quality", options.quality, "low, medium, high, ultra or auto")
      ->check(CLI::IsMember({"low", "medium", "high", "ultra", "auto"}));
  app.add_option("--seed", options.seed, "seed of the sea");
  app.add_option("--fps", options.fps, "fixed step of runs without a window")
      ->check(CLI::Range(1.0, 1000.0));
}

void add_for_verb(CLI::App& app, Options& options) {
  const std::string& verb = options.verb;
  if (verb == "export" || verb == "bench") app.add_option("what", options.what, "what")->required();
  if (verb == "render" || verb == "export") {
    app.add_option("--out", options.out, "the file to write")->required();
  }
  if (verb == "render" || verb == "bench") {
    app.add_option("--frames", options.frames, "frames to draw")->check(CLI::Range(1, 100000));
    app.add_option("--warmup", options.warmup, "frames before those")->check(CLI::Range(0, 100000));
  }
  if (verb == "render") app.add_option("--report", options.report, "write a JSON report here");
  if (verb == "bench") {
    app.add_option("--json", options.json, "write the report here, not to stdout");
    app.add_option("--plot", options.plot, "draw the curves here (SVG)");
    app.add_option("--method", options.method,
                   "clouds: pathtrace compares the light with the path tracer's and no more")
        ->check(CLI::IsMember({"pathtrace"}));
  }
  if (verb == "export") {
    app.add_option("--time", options.time, "the sea's clock, s")->check(CLI::Range(-1e12, 1e12));
    app.add_flag("--no-discs", options.no_discs, "sky: without sun, moon and stars");
    app.add_option("--points", options.points, "heights: CSV with x,z per line, m");
    app.add_option("--method", options.method,
                   "heights: readback (default) or direct; clouds: march (default), "
                   "reference or pathtrace");
    app.add_option("--samples", options.samples, "clouds by pathtrace: paths a pixel (64)")
        ->check(CLI::Range(1, 1000000));
    app.add_option("--tws", options.tws, "polar: true wind speeds, kn");
    app.add_option("--twa", options.twa, "polar: true wind angles, deg");
    app.add_option("--seconds", options.seconds, "boat: length of the run")
        ->check(CLI::Range(0.0, 1e6));
    app.add_option("--dt", options.dt, "boat: time step, s")->check(CLI::Range(1e-4, 0.1));
  }
}

}  // namespace

CommandLine parse_command_line(int count, const char* const* arguments) {
  CommandLine result;
  Options& options = result.options;
  std::vector<std::string> rest(arguments + std::min(count, 1), arguments + count);
  bool named = false;
  if (!rest.empty() && !rest.front().empty() && rest.front().front() != '-') {
    options.verb = rest.front();
    rest.erase(rest.begin());
    named = true;
    if (!kVerbs.contains(options.verb)) {
      throw InputError(
          fmt::format("{}: no such verb; use play, render, export, bench or test", options.verb));
    }
  }
  if (options.verb == "bench") {
    options.frames = 60;
    options.warmup = 10;
  }

  CLI::App app(named ? kVerbs.at(options.verb) : "", "offing " + (named ? options.verb : "[verb]"));
  app.set_version_flag("--version", std::string("offing ") + version());
  bool keys = false;
  app.add_flag("--list-keys", keys, "print every scene key, its value, meaning and range");
  std::string size;
  add_common(app, options, size);
  add_for_verb(app, options);
  std::reverse(rest.begin(), rest.end());  // as CLI11 wants them
  try {
    app.parse(rest);
  } catch (const CLI::CallForHelp&) {
    result.text = (named ? "" : overview()) + app.help();
    return result;
  } catch (const CLI::CallForVersion&) {
    result.text = std::string("offing ") + version() + "\n";
    return result;
  } catch (const CLI::ParseError& error) {
    if (keys && std::string(error.get_name()) == "RequiredError") {
      result.text = list_keys();
      return result;
    }
    throw InputError(
        fmt::format("{}; see ./offing {} --help", one_line(error.what()), options.verb));
  }
  if (keys) {
    result.text = list_keys();
    return result;
  }
  if (!size.empty()) options.size = parse_size(size);
  return result;
}

glm::ivec2 parse_size(const std::string& text) {
  glm::ivec2 size{0};
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.x);
  if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
    const auto height = std::from_chars(width.ptr + 1, end, size.y);
    if (height.ec == std::errc() && height.ptr == end && size.x >= 16 && size.y >= 16 &&
        size.x <= 16384 && size.y <= 16384) {
      return size;
    }
  }
  throw InputError(
      fmt::format("--size {}: must be WIDTHxHEIGHT, each 16 to 16384, as in 640x360", text));
}

std::vector<double> parse_numbers(const std::string& option, const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* end = at + text.size();
  while (true) {
    double value = 0.0;
    const auto read = std::from_chars(at, end, value);
    if (read.ec != std::errc() || !std::isfinite(value)) break;
    numbers.push_back(value);
    if (read.ptr == end) return numbers;
    if (*read.ptr != ',') break;
    at = read.ptr + 1;
  }
  throw InputError(fmt::format("{} {}: must be numbers with commas, as in 45,60,90", option, text));
}

}  // namespace offing
