#include "game/render/voyage.h"

#include <chrono>

namespace offing {

Voyage::Voyage(const Options& options, glm::ivec2 size) : size_(size), step_(1.0 / options.fps) {
  gl::require_opengl_45();
  Scene scene = make_scene(options.scene, options.sets);
  if (options.seed) scene.seed = *options.seed;
  renderer_ = std::make_unique<Renderer>(
      quality_named(options.quality, gl::current_renderer().software), scene.boat.model);
  renderer_->set_sea(scene);
  renderer_->prime(scene.environment.elapsed());
  world_ = std::make_unique<World>(std::move(scene), renderer_->water());
  world_->start();
}

void Voyage::next_frame() {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  if (frame_ > 0) world_->update({}, step_);
  view_ = extractor_.extract(*world_, size_, step_, frame_++);
  renderer_->build(view_, [](const gl::Texture&) {});
  cpu_milliseconds_.push_back(
      std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
  renderer_->execute();
}

void Voyage::reset_measures() {
  renderer_->graph().reset_report();
  cpu_milliseconds_.clear();
}

}  // namespace offing
