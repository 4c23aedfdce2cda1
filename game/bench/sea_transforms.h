#pragma once
#include <string>
#include <vector>

#include "engine/shader/shader_library.h"
#include "game/bench/stopwatch.h"

namespace offing {

/// One way to transform the spectra of a sea's maps: four complex fields for each cascade.
struct TransformRun {
  std::string name;
  Taken taken;
  double gflops = 0.0;      ///< of least time, counting 5 N² log2 N² for each field as all do
  double columns_ms = 0.0;  ///< of ours: processor time of the first half
  double snr_db = 0.0;      ///< of the heights against FFTW in double precision
};

/// Ours (waves evolved in time and maps' points written in the same passes), a plain radix-2 in
/// many passes and FFTW in single precision on one thread, in one run on the same spectra. `size`
/// is 64 to 512.
std::vector<TransformRun> time_transforms(ShaderLibrary& shaders, int size, int cascades,
                                          int repeats);

}  // namespace offing
