#include "game/frame/quality.h"

#include <array>

namespace offing {

Quality quality_named(std::string_view name, bool software) {
  static constexpr std::array kQualities = {
      Quality{"low", 0},
      Quality{"medium", 1},
      Quality{"high", 2},
      Quality{"ultra", 3},
  };
  for (const Quality& quality : kQualities) {
    if (name == quality.name) return quality;
  }
  return software ? kQualities[0] : kQualities[2];
}

}  // namespace offing
