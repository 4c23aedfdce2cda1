#include "game/play/play.h"

#include <fmt/chrono.h>
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "engine/core/angles.h"
#include "engine/core/log.h"
#include "engine/core/paths.h"
#include "engine/gl/debug.h"
#include "engine/platform/file_watch.h"
#include "engine/platform/input.h"
#include "engine/platform/window.h"
#include "game/frame/renderer.h"
#include "game/hud/hud.h"
#include "game/hud/imgui_layer.h"
#include "game/play/controls.h"
#include "game/render/render.h"
#include "game/world/world.h"

namespace offing {
namespace {

double seconds_now() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

// The window, what is in it, and the loop between them.
class Play {
 public:
  explicit Play(const Options& options)
      : window_({.title = "Offing",
                 .size = options.size.value_or(glm::ivec2(1280, 720)),
                 .vsync = true}),
        renderer_(quality_named(options.quality, gl::current_renderer().software),
                  scene_of(options).boat.model),
        shader_watch_(data_root() / "shaders"),
        world_(scene_of(options), primed(options)) {
    input_.attach(window_);
    imgui_ = std::make_unique<ImGuiLayer>(window_.handle());
    const gl::Renderer machine = gl::current_renderer();
    if (machine.software) window_.set_vsync(false);
    info_.renderer = machine.name;
    info_.quality = renderer_.quality().name;
    extractor_.set_in_background(true);
    world_.start();
    // Nobody is at the helm yet: left alone she would luff up into the wind.
    world_.boat().hold_heading(true);
    log_state_ = std::getenv("OFFING_LOG_STATE") != nullptr;
  }

  void run() {
    double last = seconds_now();
    while (!window_.should_close() && !hud_.quit) {
      input_.begin_frame();
      if (window_.minimised()) {
        window_.wait_events(0.1);
        last = seconds_now();  // nobody sails an icon
        continue;
      }
      window_.poll_events();
      const double now = seconds_now();
      const double dt = std::clamp(now - last, 0.0, 0.1);
      last = now;
      obey(dt);
      if (shader_watch_.changed(now)) renderer_.shaders().reload_changed();
      draw(dt);
      measure(now, dt);
      for (const auto& message : debug_.messages()) log_warning("{}", message.text);
      debug_.clear();
    }
  }

 private:
  static Scene scene_of(const Options& options) {
    Scene scene = make_scene(options.scene, options.sets);
    if (options.seed) scene.seed = *options.seed;
    return scene;
  }

  // The water must be known before the boat is put on it.
  const WaterSurface& primed(const Options& options) {
    const Scene scene = scene_of(options);
    renderer_.set_sea(scene);
    renderer_.prime(scene.environment.elapsed());
    return renderer_.water();
  }

  bool sailing() const { return !hud_.panel && !hud_.menu; }

  void obey(double dt) {
    const Commands commands = Controls::commands(input_, sailing() && !imgui_->wants_mouse());
    hud_.panel ^= commands.toggle_panel && !hud_.menu;
    hud_.menu ^= commands.toggle_menu;
    hud_.help ^= commands.toggle_help;
    hud_.hidden ^= commands.toggle_hud;
    if (input_.mouse_captured() != sailing()) input_.capture_mouse(sailing());

    Environment& environment = world_.environment();
    environment.paused ^= commands.toggle_pause;
    if (commands.faster) environment.quicken();
    if (commands.slower) environment.slow_down();
    change_weather(commands, dt);
    Camera& camera = world_.camera();
    if (commands.next_camera) camera.next_mode();
    camera.set_look_astern(commands.look_astern);
    camera.look(commands.look_yaw, commands.look_pitch);
    camera.zoom(commands.zoom);
    if (commands.reload_shaders) renderer_.shaders().reload_all();
    photo_wanted_ = commands.photo;

    const Helm helm = hud_.menu ? Helm{} : controls_.helm(input_, dt);
    if (!hud_.menu) world_.update(helm, dt);
  }

  void change_weather(const Commands& commands, double dt) {
    Scene& scene = world_.scene();
    Wind& wind = scene.environment.wind;
    wind.speed = std::clamp(wind.speed + 2.0 * commands.wind_change * dt, 0.0, 60.0);
    Swell& swell = scene.sea.swell;
    swell.height = std::clamp(swell.height + 0.5 * commands.swell_change * dt, 0.0, 15.0);
  }

  void draw(double dt) {
    renderer_.turn_sea(world_.scene());
    const glm::ivec2 size = window_.framebuffer_size();
    if (size.x < 1 || size.y < 1) return;
    const FrameView view = extractor_.extract(world_, size, dt, frame_++);
    imgui_->begin_frame();
    info_.shader_error = renderer_.shaders().error();
    const SeaStatistics sea = renderer_.ocean().statistics();
    info_.hs = sea.hs;
    info_.tp = sea.tp;
    info_.passes = &shown_passes_;
    draw_hud(hud_, world_, info_);
    renderer_.graph().set_timing(hud_.panel);
    renderer_.build(view, [&](const gl::Texture& picture) { present(picture, size); });
    renderer_.execute();
    window_.swap();
    if (photo_wanted_) take_photo();
  }

  void present(const gl::Texture& picture, glm::ivec2 size) {
    picture.blit_to_window(size.x, size.y);
    imgui_->end_frame();
  }

  void take_photo() {
    const std::time_t now = std::time(nullptr);
    const std::string name = fmt::format("offing-{:%Y%m%d-%H%M%S}.png", fmt::localtime(now));
    try {
      write_image(name, renderer_.picture());
      log_info("photo: {}", name);
    } catch (const Error& error) {
      log_warning("{}", error.what());
    }
  }

  void measure(double now, double dt) {
    info_.frame_ms += (dt * 1000.0 - info_.frame_ms) * 0.1;
    info_.frames_per_second = info_.frame_ms > 0.0 ? 1000.0 / info_.frame_ms : 0.0;
    if (now < next_report_) return;
    next_report_ = now + 1.0;
    shown_passes_ = renderer_.graph().report();
    renderer_.graph().reset_report();
    if (log_state_) log_state();
  }

  // One line a second for whoever watches from outside.
  void log_state() const {
    const Navigation& n = world_.boat().navigation();
    const BoatState& s = world_.boat().state();
    fmt::print(
        "state t={:.2f} heading={:05.1f} speed={:.2f} rudder={:.2f} heel={:.1f} boat_x={:.2f} "
        "boat_z={:.2f} "
        "paused={:d} clock_rate={:g} panel={:d} menu={:d} trim={:d} fps={:.1f}\n",
        world_.environment().elapsed(), degrees(wrap_tau(n.heading)), n.stw,
        s.rudder_angle / world_.boat().parameters().rudder_most, degrees(n.heel), s.position.x,
        s.position.z, world_.environment().paused, world_.environment().clock_rate, hud_.panel,
        hud_.menu, world_.boat().controls().auto_trim, info_.frames_per_second);
    std::fflush(stdout);
  }

  Window window_;
  gl::DebugLog debug_;
  Renderer renderer_;
  FileWatch shader_watch_;
  World world_;
  Input input_;
  std::unique_ptr<ImGuiLayer> imgui_;
  Controls controls_;
  Extractor extractor_;
  HudState hud_;
  HudInfo info_;
  std::vector<PassReport> shown_passes_;
  int frame_ = 0;
  double next_report_ = 0.0;
  bool photo_wanted_ = false, log_state_ = false;
};

}  // namespace

void run_play(const Options& options) {
  if (!Window::display_available()) {
    log_info("no display to open a window on; rendering the scene to offing.png instead");
    Options still = options;
    still.out = "offing.png";
    still.frames = 1;
    run_render(still);
    return;
  }
  Play(options).run();
}

}  // namespace offing
