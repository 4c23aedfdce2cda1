#include "engine/platform/input.h"

#include <gtest/gtest.h>

namespace offing {
namespace {

TEST(Input, KeyHasEdgesOnlyInTheFrameTheyHappen) {
  Input input;
  input.begin_frame();
  input.on_key(Key::kT, true);
  EXPECT_TRUE(input.pressed(Key::kT));
  EXPECT_TRUE(input.held(Key::kT));
  EXPECT_FALSE(input.released(Key::kT));
  EXPECT_FALSE(input.held(Key::kA));

  input.begin_frame();
  EXPECT_FALSE(input.pressed(Key::kT));
  EXPECT_TRUE(input.held(Key::kT));

  input.begin_frame();
  input.on_key(Key::kT, false);
  EXPECT_TRUE(input.released(Key::kT));
  EXPECT_FALSE(input.held(Key::kT));

  input.begin_frame();
  EXPECT_FALSE(input.released(Key::kT));
}

TEST(Input, TapWithinOneFrameIsNotLost) {
  Input input;
  input.begin_frame();
  input.on_key(Key::kSpace, true);
  input.on_key(Key::kSpace, false);
  EXPECT_TRUE(input.pressed(Key::kSpace));
  EXPECT_TRUE(input.held(Key::kSpace));
  EXPECT_TRUE(input.released(Key::kSpace));
  input.begin_frame();
  EXPECT_FALSE(input.held(Key::kSpace));
}

TEST(Input, SecondPressOfAHeldKeyIsNoEdge) {
  Input input;
  input.begin_frame();
  input.on_key(Key::kA, true);
  input.begin_frame();
  input.on_key(Key::kA, true);
  EXPECT_FALSE(input.pressed(Key::kA));
}

TEST(Input, MouseMovesAddUpWithinAFrame) {
  Input input;
  input.begin_frame();
  input.on_cursor({300.0, 200.0});  // the first position is where the pointer is, not a motion
  EXPECT_EQ(input.mouse_delta(), glm::dvec2(0.0, 0.0));
  input.on_cursor({303.0, 198.0});
  input.on_cursor({304.0, 190.0});
  EXPECT_EQ(input.mouse_delta(), glm::dvec2(4.0, -10.0));
  input.on_scroll({0.0, 1.0});
  input.on_scroll({0.0, 0.5});
  EXPECT_EQ(input.scroll(), glm::dvec2(0.0, 1.5));
  input.begin_frame();
  EXPECT_EQ(input.mouse_delta(), glm::dvec2(0.0, 0.0));
  EXPECT_EQ(input.scroll(), glm::dvec2(0.0, 0.0));
}

TEST(Input, CapturingTheMouseDoesNotTurnTheView) {
  Input input;
  input.begin_frame();
  input.on_cursor({10.0, 10.0});
  input.capture_mouse(true);
  input.on_cursor({640.0, 360.0});  // the jump to the window's middle
  EXPECT_EQ(input.mouse_delta(), glm::dvec2(0.0, 0.0));
  input.on_cursor({641.0, 360.0});
  EXPECT_EQ(input.mouse_delta(), glm::dvec2(1.0, 0.0));
}

TEST(Input, DeadZoneIsContinuousOddAndReachesOne) {
  EXPECT_EQ(without_dead_zone(0.0f, 0.2f), 0.0f);
  EXPECT_EQ(without_dead_zone(0.2f, 0.2f), 0.0f);
  EXPECT_EQ(without_dead_zone(-0.19f, 0.2f), 0.0f);
  EXPECT_NEAR(without_dead_zone(0.2001f, 0.2f), 0.0f, 2e-4f);
  EXPECT_NEAR(without_dead_zone(0.6f, 0.2f), 0.5f, 1e-6f);  // half-way between rest and end
  EXPECT_NEAR(without_dead_zone(-0.6f, 0.2f), -0.5f, 1e-6f);
  EXPECT_EQ(without_dead_zone(1.0f, 0.2f), 1.0f);
  EXPECT_EQ(without_dead_zone(-1.02f, 0.2f), -1.0f);
}

TEST(Input, GamepadHasEdgesAndRestsAtZero) {
  Input input;
  GamepadState state;
  state.connected = true;
  state.left_stick = {0.05f, 1.0f};
  state.right_trigger = 0.5f;
  state.buttons[static_cast<std::size_t>(PadButton::kY)] = true;
  input.begin_frame();
  input.on_gamepad(state);
  EXPECT_TRUE(input.pressed(PadButton::kY));
  EXPECT_EQ(input.gamepad().left_stick, glm::vec2(0.0f, 1.0f));
  EXPECT_EQ(input.gamepad().right_trigger, 0.5f);
  input.begin_frame();
  input.on_gamepad(state);
  EXPECT_FALSE(input.pressed(PadButton::kY));
  EXPECT_TRUE(input.held(PadButton::kY));
  input.begin_frame();
  input.on_gamepad({});  // unplugged
  EXPECT_TRUE(input.released(PadButton::kY));
  EXPECT_FALSE(input.gamepad().connected);
}

}  // namespace
}  // namespace offing
