#pragma once
#include "engine/graph/frame_graph.h"
#include "engine/graph/gl_device.h"
#include "engine/ocean/ocean.h"
#include "engine/ocean/ocean_export.h"
#include "engine/platform/headless_context.h"
#include "engine/shader/shader_library.h"
#include "game/options.h"
#include "game/world/scene.h"

namespace offing {

/// The sea that --quality asks for, all cascades read back; `auto` is high, whatever the machine,
/// so that exports are the same everywhere.
OceanSettings sea_settings(const Options& options);

/// A scene's sea at the moment of its clock, on a GPU without a window: maps and water queries.
class SeaRun {
 public:
  SeaRun(const Scene& scene, const Options& options);

  const Ocean& ocean() const { return ocean_; }
  const WaterSurface& water() const { return ocean_.water(); }
  /// The maps of this moment, on the CPU.
  std::vector<CascadeExport> maps() { return export_cascades(ocean_, graph_, time_); }

 private:
  HeadlessContext context_;
  ShaderLibrary shaders_;
  GlDevice device_;
  FrameGraph graph_;
  Ocean ocean_;
  double time_;
};

}  // namespace offing
