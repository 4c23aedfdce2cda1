#pragma once
#include <memory>
#include <string>
#include <vector>

#include "engine/gl/debug.h"
#include "engine/platform/headless_context.h"
#include "game/frame/renderer.h"
#include "game/options.h"
#include "game/world/world.h"

namespace offing {

/// A scene that sails by itself, without any window, in fixed steps: what `render` and `bench
/// frame` have in common. Deterministic: each frame is finished before the next begins.
class Voyage {
 public:
  Voyage(const Options& options, glm::ivec2 size);

  /// Sails 1/fps seconds and draws. The first frame shows the start.
  void next_frame();
  /// Forgets what was counted and timed so far.
  void reset_measures();

  World& world() { return *world_; }
  Renderer& renderer() { return *renderer_; }
  const FrameView& view() const { return view_; }
  glm::ivec2 size() const { return size_; }
  const gl::DebugLog& debug() const { return debug_; }
  /// Of each frame since reset_measures(): simulation, extraction and building the graph, ms.
  const std::vector<double>& cpu_milliseconds() const { return cpu_milliseconds_; }

 private:
  HeadlessContext context_;
  gl::DebugLog debug_;
  glm::ivec2 size_;
  double step_;
  std::unique_ptr<Renderer> renderer_;
  std::unique_ptr<World> world_;
  Extractor extractor_;
  FrameView view_;
  int frame_ = 0;
  std::vector<double> cpu_milliseconds_;
};

/// The report of the contract, as JSON text, of the frames since reset_measures(). Waits.
std::string report_of(Voyage& voyage, const Options& options);

}  // namespace offing
