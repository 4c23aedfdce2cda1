#include "golden/views.h"

#include <gtest/gtest.h>

#include <fmt/core.h>

#include "game/render/voyage.h"

namespace offing::test {
namespace {

constexpr glm::ivec2 kSize{240, 135};
// One second at the sail, so that hull, cloth, foam and read-backs have moved on from the start.
constexpr int kFrames = 20;
constexpr double kFps = 20.0;

}  // namespace

const std::vector<View>& views() {
  static const std::vector<View> kViews = {
      {"chase", "default"},
      {"helm", "default", {"camera.mode=helm"}},
      // The sun stands 5.6° high in azimuth 285°, behind the boat.
      {"sunset", "sunset", {"camera.mode=free", "camera.position=21,4,5.7", "camera.target=0,5,0"}},
      // The moon stands 36° high in azimuth 149°; the glade lies under it, right of the boat.
      {"moonlight",
       "moonlight",
       {"camera.mode=free", "camera.position=-17,5,-10", "camera.target=-4,7,6", "camera.fov=80"}},
      {"gale", "gale"},
      {"above",
       "default",
       {"camera.mode=free", "camera.position=0,200,250", "camera.target=0,0,-150"}},
      {"fog", "default", {"environment.haze=1"}},
      // Where the sea's far field, the air and the sky meet, 5.5 times nearer.
      {"horizon",
       "default",
       {"camera.mode=free", "camera.position=60,4,60", "camera.target=1060,4,560",
        "camera.fov=10"}},
  };
  return kViews;
}

Image render_view(const View& view) {
  Options options;
  options.scene = view.scene;
  options.sets = view.sets;
  options.quality = "low";
  options.fps = kFps;
  Voyage voyage(options, kSize);
  for (int frame = 0; frame < kFrames; ++frame) voyage.next_frame();
  Image picture = voyage.renderer().picture();
  for (const auto& message : voyage.debug().messages()) ADD_FAILURE() << message.text;
  return picture;
}

std::string command_of(const View& view) {
  std::string command = fmt::format(
      "offing render --scene {} --quality low --fps {} --size {}x{} --warmup {} --out "
      "{}.png",
      view.scene, kFps, kSize.x, kSize.y, kFrames - 1, view.name);
  for (const std::string& set : view.sets) command += " --set " + set;
  return command;
}

}  // namespace offing::test
