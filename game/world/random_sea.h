#pragma once
#include <cstdint>

#include "engine/environment/environment.h"
#include "engine/ocean/sea_state.h"

namespace offing {

/// A sea state drawn from the whole range of its keys, the limits themselves among them (each with
/// a chance of one in eight), at a time within a year.
struct RandomSea {
  SeaState state;
  Environment environment;
  double time = 0.0;
};
RandomSea random_sea(int seed, int number);

}  // namespace offing
