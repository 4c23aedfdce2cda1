#pragma once
#include <string>
#include <vector>

namespace offing::gl {

/// What the driver said through KHR_debug since install(). Notifications are left out.
/// One per context; the messages arrive synchronously, on the thread of the context.
class DebugLog {
 public:
  DebugLog();
  ~DebugLog();
  DebugLog(const DebugLog&) = delete;
  DebugLog& operator=(const DebugLog&) = delete;

  struct Message {
    bool error;
    std::string text;
  };
  const std::vector<Message>& messages() const { return messages_; }
  void clear() { messages_.clear(); }
  /// Called by the driver's callback.
  void add(Message message);

 private:
  std::vector<Message> messages_;
};

/// A named region in a capture tool, for as long as the object lives.
class DebugGroup {
 public:
  explicit DebugGroup(const char* label);
  ~DebugGroup();
  DebugGroup(const DebugGroup&) = delete;
  DebugGroup& operator=(const DebugGroup&) = delete;
};

/// What this context runs on.
struct Renderer {
  std::string name, vendor, version;
  bool software;  ///< a CPU renderer: its timer queries are wrong, its times are not a GPU's
};
Renderer current_renderer();

/// Throws InputError naming the version found where the current context is below OpenGL 4.5 core.
void require_opengl_45();

}  // namespace offing::gl
