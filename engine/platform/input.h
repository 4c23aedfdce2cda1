#pragma once
#include <glm/vec2.hpp>

#include <array>
#include <cstddef>

namespace offing {

class Window;

/// The keys that do something. Letters and signs are places on the keyboard, named as on a US one,
/// so A and D lie side by side on every layout.
enum class Key {
  kA,
  kB,
  kC,
  kD,
  kF,
  kG,
  kH,
  kI,
  kO,
  kP,
  kR,
  kS,
  kT,
  kV,
  kW,
  kX,
  kOne,
  kTwo,
  kThree,
  kLeft,
  kRight,
  kUp,
  kDown,
  kLeftBracket,
  kRightBracket,
  kComma,
  kPeriod,
  kSpace,
  kEscape,
  kF1,
  kF5,
  kF10,
  kF12,
  kCount
};

enum class MouseButton { kLeft, kRight, kMiddle, kCount };

/// Buttons of an Xbox-like pad, by place.
enum class PadButton { kA, kX, kY, kLeftBumper, kRightBumper, kStart, kRightStick, kCount };

/// What a game pad reports at one moment.
struct GamepadState {
  bool connected = false;
  glm::vec2 left_stick{0.0f};  ///< right and down are positive, -1 to 1, as the pad has it
  glm::vec2 right_stick{0.0f};
  float left_trigger = 0.0f;  ///< 0 released to 1 pulled
  float right_trigger = 0.0f;
  std::array<bool, static_cast<std::size_t>(PadButton::kCount)> buttons{};
};

/// A stick's axis without the wobble near its rest: 0 up to `rest`, then linear to 1 (or -1).
float without_dead_zone(float axis, float rest = 0.15f);

/// What the player does, one frame at a time: begin_frame(), then the events of that frame, then
/// questions. Works without a window, through the on_… functions.
class Input {
 public:
  Input() = default;
  ~Input();
  Input(const Input&) = delete;  // callbacks point here
  Input& operator=(const Input&) = delete;

  /// Receives the window's events from now on; the window must outlive this. Panels that install
  /// callbacks of their own afterwards must call the earlier ones, as ImGui's backend does.
  void attach(Window& window);

  /// Forgets the edges and motions of the last frame and reads the game pad.
  /// Call it before the window's poll_events().
  void begin_frame();

  /// Went down, or up, since begin_frame(). A tap within one frame is both.
  bool pressed(Key key) const { return keys_.pressed[index(key)]; }
  bool released(Key key) const { return keys_.released[index(key)]; }
  /// Is down, or was for a part of this frame.
  bool held(Key key) const { return keys_.down[index(key)] || pressed(key); }

  bool pressed(MouseButton button) const { return mouse_.pressed[index(button)]; }
  bool released(MouseButton button) const { return mouse_.released[index(button)]; }
  bool held(MouseButton button) const { return mouse_.down[index(button)] || pressed(button); }

  bool pressed(PadButton button) const { return pad_.pressed[index(button)]; }
  bool released(PadButton button) const { return pad_.released[index(button)]; }
  bool held(PadButton button) const { return pad_.down[index(button)]; }
  /// Sticks have no dead zone left in them.
  const GamepadState& gamepad() const { return gamepad_; }

  /// This frame's motion, in screen coordinates: right and down are positive.
  glm::dvec2 mouse_delta() const { return mouse_delta_; }
  /// This frame's turns of the wheel: y positive away from the user.
  glm::dvec2 scroll() const { return scroll_; }

  /// Hides the pointer and keeps it in the window, for looking round; or gives it back.
  void capture_mouse(bool captured);
  bool mouse_captured() const { return captured_; }

  void on_key(Key key, bool down) { keys_.set(index(key), down); }
  void on_button(MouseButton button, bool down) { mouse_.set(index(button), down); }
  void on_cursor(glm::dvec2 position);
  void on_scroll(glm::dvec2 turns) { scroll_ += turns; }
  void on_gamepad(const GamepadState& state);

 private:
  template <class Name>
  static constexpr std::size_t index(Name name) {
    return static_cast<std::size_t>(name);
  }

  template <class Name>
  struct Buttons {
    using Flags = std::array<bool, static_cast<std::size_t>(Name::kCount)>;
    Flags down{}, pressed{}, released{};

    void set(std::size_t i, bool now) {
      pressed[i] |= now && !down[i];
      released[i] |= !now && down[i];
      down[i] = now;
    }
    void begin_frame() { pressed = released = {}; }
  };

  Buttons<Key> keys_;
  Buttons<MouseButton> mouse_;
  Buttons<PadButton> pad_;
  GamepadState gamepad_;
  glm::dvec2 cursor_{0.0}, mouse_delta_{0.0}, scroll_{0.0};
  bool cursor_known_ = false;  // the first position after a jump is no motion
  bool captured_ = false;
  Window* window_ = nullptr;
};

}  // namespace offing
