#pragma once
#include "game/options.h"

namespace offing {

/// One function per benchmark; each prints its report or writes options.json, and draws
/// options.plot where it is given and the benchmark has curves.
void bench_boat(const Options& options);
void bench_frame(const Options& options);
void bench_ocean(const Options& options);
void bench_probe(const Options& options);
void bench_query(const Options& options);
void bench_stress(const Options& options);

}  // namespace offing
