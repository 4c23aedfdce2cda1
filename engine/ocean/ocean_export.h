#pragma once
#include <vector>

#include "engine/ocean/ocean.h"

namespace offing {

/// The maps of one cascade at one moment, row by row; a value per point and field. Point (row,
/// column) lies at length × (column, row) / size in the cascade's own axes, which are turned by
/// `angle`.
struct CascadeExport {
  CascadeBand band;
  int size = 0;
  std::vector<float> dx, dy, dz, slope_x, slope_z, jacobian;  ///< jacobian: of this cascade alone
  double variance = 0.0;                                      ///< of dy, m^2
  double slope_variance = 0.0;                                ///< of both slopes together
};

/// Computes the sea at `time` (s) on the GPU, through `graph`, and reads it back. Waits: for
/// exports and tests, never in a frame.
std::vector<CascadeExport> export_cascades(Ocean& ocean, FrameGraph& graph, double time);

}  // namespace offing
