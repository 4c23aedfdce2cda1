#pragma once
#include <filesystem>
#include <functional>

#include "engine/graph/frame_graph.h"
#include "engine/graph/gl_device.h"
#include "engine/io/image.h"
#include "engine/ocean/sea_measurement.h"
#include "engine/shader/shader_library.h"
#include "game/frame/frame.h"
#include "game/frame/frame_view.h"
#include "game/frame/quality.h"

namespace offing {

/// The picture in one place: device, shaders, graph and techniques, on the current GL context.
class Renderer {
 public:
  explicit Renderer(const Quality& quality, const std::filesystem::path& boat_model = {});

  /// Where the boat floats.
  const WaterSurface& water() const { return techniques_.ocean.water(); }
  /// Takes over the sea state, wind and seed of a scene; does nothing where they are unchanged.
  void set_sea(const Scene& scene) {
    techniques_.ocean.set_sea(scene.sea, scene.environment, seed_of(scene));
  }
  /// The same by and by, where anything has changed; to be called every frame.
  void turn_sea(const Scene& scene) {
    techniques_.ocean.turn_to(scene.sea, scene.environment, seed_of(scene),
                              scene.environment.elapsed());
  }
  /// Makes the water known around `time` before the first frame. Waits: for starts only.
  void prime(double time);

  /// Declares the frame. `present` is the last pass; it gets the finished picture.
  void build(const FrameView& view, const std::function<void(const gl::Texture& picture)>& present);
  /// Runs it, and takes in what has come back of the sea.
  void execute();

  FrameGraph& graph() { return graph_; }
  const GlDevice& device() const { return device_; }
  ShaderLibrary& shaders() { return shaders_; }
  const Ocean& ocean() const { return techniques_.ocean; }
  const Quality& quality() const { return quality_; }

  /// The sea as it lies in the maps now; waits.
  SeaMeasurement measure_sea() const;
  /// The finished picture, sRGB-coded; waits.
  Image picture() const;
  /// Linear radiance in cd/m^2; waits. `exposure` as of the frame's view.
  Image radiance(double exposure) const;
  /// How many pixels were not finite in all the frames since the last call; waits.
  std::uint32_t take_nonfinite_pixels() { return techniques_.tonemap.take_nonfinite_pixels(); }

 private:
  static std::uint64_t seed_of(const Scene& scene) {
    return static_cast<std::uint64_t>(scene.seed);
  }
  void resize(glm::ivec2 size);

  Quality quality_;
  GlDevice device_;
  ShaderLibrary shaders_;
  FrameGraph graph_;
  Techniques techniques_;
  FramePictures pictures_;
};

}  // namespace offing
