#pragma once
#include <glm/vec2.hpp>

#include <array>
#include <cstdint>

#include "engine/gl/buffer.h"
#include "engine/gl/texture.h"
#include "engine/graph/frame_graph.h"
#include "engine/ocean/sea_maps.h"
#include "engine/shader/shader_library.h"
#include "shaders/shared/ocean.h"

namespace offing {

/// Foam that lasts. Squares of cells about the viewer, fixed to the world and laid over the water
/// at rest, so that waves carry the foam; each four times as wide as the one inside it. Every step
/// looks after as many of the rows as keep each seen to every 0.15 s: these let their foam fade by
/// the time since they were last looked after and take in what breaks now. Cells that come into a
/// square start with what lies under the sea's lower Jacobians at that moment. The same steps make
/// the same foam.
class FoamMap {
 public:
  /// `size`: cells per side of a square, a power of two and a multiple of 64.
  FoamMap(ShaderLibrary& shaders, int size);

  /// Adds sea.foam, and gives the map: layer by layer the thin foam and the thick, shares of the
  /// surface. `bind` makes the sea's block, maps (units 0, 1) and roughness table
  /// readable. Nothing is done while `time` (s) stands still, the viewer stays and `sea_key` is the
  /// same; going back in time, or ahead by more than 2 s, starts anew.
  template <class Bind>
  TextureId add(FrameGraph& graph, const SeaIds& sea, glm::dvec2 eye, double time,
                std::uint64_t sea_key, bool visible, Bind bind) {
    const TextureId map = graph.import(map_);
    graph.add(
        "sea.foam",
        [&](PassBuilder& pass) {
          pass.read(sea.displacement).read(sea.slopes).write(map);
          // (What it writes follows from what it wrote last: not an input, or it would never rest.)
          pass.cache(memory_, key(eye, time, sea_key)).skip_if(!visible);
        },
        [this, eye, time, bind](const PassContext& context) {
          bind(context);
          run(eye, time);
        });
    return map;
  }

  /// Side of a layer's square, m.
  double width(int layer) const;
  const gl::Texture& map() const { return map_; }

 private:
  static constexpr int kSlices = 8;  ///< steps in which all rows have had their turn
  struct Slice {
    double time = 0.0;
    std::array<glm::dvec2, shared::kFoamLayers> cell{};  ///< the viewer's, whole numbers
    bool valid = false;
  };

  std::uint64_t key(glm::dvec2 eye, double time, std::uint64_t sea_key) const;
  void run(glm::dvec2 eye, double time);
  void dispatch(glm::dvec2 eye, double time, int slice, bool anew);

  int size_;
  const ShaderProgram& program_;
  gl::Texture map_;
  gl::Buffer block_;
  std::array<Slice, kSlices> slices_;
  int next_ = 0;
  PassMemory memory_;
};

}  // namespace offing
