#pragma once
#include <nlohmann/json.hpp>

#include <vector>

namespace offing {

/// min, median, p95, p99 and max of some times in ms (nearest rank); null where there are none.
nlohmann::ordered_json statistics_of(std::vector<double> milliseconds);

}  // namespace offing
