#include "engine/ocean/ocean_export.h"

#include <cmath>

#define OFFING_GLSL "shaders/lib/water.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

double variance_of(const std::vector<float>& values) {
  double mean = 0.0, square = 0.0;
  for (const float value : values) mean += value;
  mean /= static_cast<double>(values.size());
  for (const float value : values) square += (value - mean) * (value - mean);
  return square / static_cast<double>(values.size());
}

}  // namespace

std::vector<CascadeExport> export_cascades(Ocean& ocean, FrameGraph& graph, double time) {
  graph.begin_frame();
  const SeaIds ids = ocean.add_maps(graph, time, false);
  graph.add(
      "sea.export",
      [&](PassBuilder& pass) {
        pass.read(ids.displacement, Access::kTransfer).read(ids.slopes, Access::kTransfer);
        pass.side_effect();
      },
      [](const PassContext&) {});
  graph.execute();

  const auto displacement = ocean.maps().displacement().read_floats(4);
  const auto slopes = ocean.maps().slopes().read_floats(4);
  std::vector<CascadeExport> result;
  std::size_t at = 0;
  for (const Cascade& cascade : ocean.cascades()) {
    CascadeExport& out = result.emplace_back();
    out.band = cascade.band;
    out.size = cascade.size;
    for (std::size_t i = 0; i < cascade.h0.size(); ++i, at += 4) {
      out.dx.push_back(displacement[at]);
      out.dy.push_back(displacement[at + 1]);
      out.dz.push_back(displacement[at + 2]);
      out.slope_x.push_back(slopes[at]);
      out.slope_z.push_back(slopes[at + 1]);
      out.jacobian.push_back(static_cast<float>(
          glsl::surface_jacobian(slopes[at + 2], slopes[at + 3], displacement[at + 3])));
    }
    out.variance = variance_of(out.dy);
    out.slope_variance = variance_of(out.slope_x) + variance_of(out.slope_z);
  }
  return result;
}

}  // namespace offing
