// These need a display, so ctest's own run of them skips where there is none; app/platform.sh runs
// them under Xvfb.
#include "engine/platform/window.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <string>

#include "engine/core/error.h"

namespace offing {
namespace {

class WindowTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!Window::display_available()) GTEST_SKIP() << "no display: run tests/app/platform.sh";
  }
};

TEST_F(WindowTest, GivesACoreDebugContextOfTheSizeAskedFor) {
  Window window({.title = "Offing test", .size = {320, 180}, .visible = false});
  EXPECT_GE(epoxy_gl_version(), 45);
  GLint profile = 0, flags = 0;
  glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
  EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
  EXPECT_TRUE(flags & GL_CONTEXT_FLAG_DEBUG_BIT);
  EXPECT_EQ(window.framebuffer_size(), glm::ivec2(320, 180));
  EXPECT_GT(window.content_scale(), 0.0f);
  EXPECT_FALSE(window.minimised());
  EXPECT_FALSE(window.should_close());
  window.request_close();
  EXPECT_TRUE(window.should_close());
}

TEST_F(WindowTest, ShowsWhatWasDrawn) {
  Window window({.size = {64, 32}, .vsync = false});
  window.poll_events();
  glClearColor(1.0f, 0.5f, 0.0f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  std::array<unsigned char, 4> pixel{};
  glReadPixels(32, 16, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  window.swap();
  EXPECT_EQ(pixel[0], 255);
  EXPECT_NEAR(pixel[1], 128, 1);
  EXPECT_EQ(pixel[2], 0);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(WindowTest, FollowsAResize) {
  Window window({.size = {320, 180}});
  window.resize({400, 300});
  for (int i = 0; i < 100 && window.framebuffer_size() != glm::ivec2(400, 300); ++i) {
    window.wait_events(0.02);
  }
  EXPECT_EQ(window.framebuffer_size(), glm::ivec2(400, 300));
}

TEST_F(WindowTest, NamesTheVersionOfADriverThatIsTooOld) {
  // Mesa reports the version it is told to; another driver takes no notice.
  setenv("MESA_GL_VERSION_OVERRIDE", "4.1", 1);
  std::string message;
  try {
    Window window({.size = {64, 64}, .visible = false});
    GTEST_SKIP() << "this driver cannot pretend to be old";
  } catch (const InputError& error) {
    message = error.what();
  }
  unsetenv("MESA_GL_VERSION_OVERRIDE");
  EXPECT_NE(message.find("OpenGL 4.5"), std::string::npos) << message;
  EXPECT_NE(message.find("4.1"), std::string::npos) << message;
}

TEST(WindowWithoutDisplay, SaysSo) {
  unsetenv("WAYLAND_DISPLAY");
  setenv("DISPLAY", ":4094", 1);  // a display that nobody has
  EXPECT_FALSE(Window::display_available());
  try {
    Window window({});
    FAIL() << "opened a window without a display";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("no display: ", 0), 0u) << error.what();
  }
}

}  // namespace
}  // namespace offing
