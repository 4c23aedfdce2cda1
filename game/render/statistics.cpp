#include "game/render/statistics.h"

#include <algorithm>
#include <cmath>

namespace offing {

nlohmann::ordered_json statistics_of(std::vector<double> milliseconds) {
  if (milliseconds.empty()) return nullptr;
  std::sort(milliseconds.begin(), milliseconds.end());
  const auto rank = [&](double share) {
    const double place = std::ceil(share * static_cast<double>(milliseconds.size()));
    const auto index = static_cast<std::size_t>(std::max(place, 1.0)) - 1;
    return milliseconds[std::min(index, milliseconds.size() - 1)];
  };
  return {{"min", milliseconds.front()},
          {"median", rank(0.5)},
          {"p95", rank(0.95)},
          {"p99", rank(0.99)},
          {"max", milliseconds.back()}};
}

}  // namespace offing
