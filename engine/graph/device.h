#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gl/buffer.h"
#include "engine/gl/texture.h"

namespace offing {

/// What a frame graph asks of the machine below it.
class GraphDevice {
 public:
  virtual ~GraphDevice() = default;
  virtual gl::Texture make_texture(const std::string& label, const gl::TextureDesc& desc) = 0;
  virtual gl::Buffer make_buffer(const std::string& label, std::size_t bytes) = 0;
  /// glMemoryBarrier bits.
  virtual void barrier(std::uint32_t bits) = 0;
  virtual void begin_pass(const std::string& name) = 0;
  virtual void end_pass() = 0;
  /// Binds the attachments and sets the viewport to their size.
  virtual void bind_attachments(const std::vector<const gl::Texture*>& colours,
                                const gl::Texture* depth) = 0;
  /// Brackets a pass, or with kWholeFrame the frame round its passes; `pass` comes back in
  /// collect_times().
  static constexpr std::size_t kWholeFrame = static_cast<std::size_t>(-1);
  virtual void begin_timer(std::size_t pass) = 0;
  virtual void end_timer() = 0;
  struct Time {
    std::size_t pass;
    double milliseconds;
  };
  /// Called once after each frame: the times that have become known, without waiting for any.
  virtual std::vector<Time> collect_times() = 0;
};

/// Records what it is asked to do and does nothing: for tests.
class NullDevice : public GraphDevice {
 public:
  gl::Texture make_texture(const std::string& label, const gl::TextureDesc& desc) override;
  gl::Buffer make_buffer(const std::string& label, std::size_t bytes) override;
  void barrier(std::uint32_t bits) override;
  void begin_pass(const std::string& name) override;
  void end_pass() override {}
  void bind_attachments(const std::vector<const gl::Texture*>&, const gl::Texture*) override {}
  void begin_timer(std::size_t) override {}
  void end_timer() override {}
  std::vector<Time> collect_times() override { return {}; }

  /// "make label", "barrier 0x28", "pass name", in order.
  std::vector<std::string> log;
};

}  // namespace offing
