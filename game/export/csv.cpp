#include "game/export/csv.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "engine/core/error.h"
#include "engine/io/file.h"
#include "game/options.h"

namespace offing {

std::vector<glm::dvec2> read_points(const std::filesystem::path& file) {
  std::istringstream text(read_text(file));
  std::vector<glm::dvec2> points;
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    std::erase_if(line, [](unsigned char c) { return std::isspace(c) != 0; });
    if (line.empty() || (points.empty() && line == "x,z")) continue;
    const std::string where = fmt::format("{}:{}:", file.string(), number);
    const std::vector<double> values = parse_numbers(where, line);
    if (values.size() != 2 || std::abs(values[0]) > 1e9 || std::abs(values[1]) > 1e9) {
      throw InputError(fmt::format("{} {}: must be x,z in metres, within 1e9 m", where, line));
    }
    points.emplace_back(values[0], values[1]);
  }
  if (points.empty())
    throw InputError(fmt::format("{}: no points; write x,z per line", file.string()));
  return points;
}

}  // namespace offing
