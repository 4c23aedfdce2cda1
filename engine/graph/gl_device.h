#pragma once
#include <deque>
#include <map>
#include <vector>

#include "engine/graph/device.h"

namespace offing {

/// The current OpenGL context. Times come from GL_TIMESTAMP pairs, read frames later; on a software
/// renderer, whose queries are wrong, from finishing and reading the CPU clock.
class GlDevice : public GraphDevice {
 public:
  GlDevice();
  ~GlDevice() override;
  gl::Texture make_texture(const std::string& label, const gl::TextureDesc& desc) override;
  gl::Buffer make_buffer(const std::string& label, std::size_t bytes) override;
  void barrier(std::uint32_t bits) override;
  void begin_pass(const std::string& name) override;
  void end_pass() override;
  void bind_attachments(const std::vector<const gl::Texture*>& colours,
                        const gl::Texture* depth) override;
  void begin_timer(std::size_t pass) override;
  void end_timer() override;
  std::vector<Time> collect_times() override;

  /// "gpu" or "finish", as in reports.
  const char* timer_kind() const { return software_ ? "finish" : "gpu"; }

 private:
  struct Pending {
    std::size_t pass;
    GLuint begin, end;
  };
  struct Framebuffer {
    GLuint id;
    std::uint64_t last_used;
  };
  GLuint take_query();
  void forget_old_framebuffers();
  bool software_;
  struct Open {
    std::size_t pass;
    double started_ms;
    GLuint query;
  };
  std::vector<Open> open_;  ///< timers begun and not ended, innermost last
  std::deque<Pending> pending_;
  std::vector<GLuint> free_queries_;
  std::vector<Time> known_;
  std::map<std::vector<std::uint64_t>, Framebuffer> framebuffers_;  ///< by texture serials
  std::uint64_t frame_ = 0;
};

}  // namespace offing
