#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engine/gl/buffer.h"

namespace offing::gl {

/// Brings data from the GPU without ever waiting for it: a ring of persistently mapped buffers,
/// each with a fence that is polled. What arrives carries the tag it was issued with (a simulation
/// time).
class ReadbackRing {
 public:
  /// `slots` results may be on their way at once; `size` in bytes each.
  ReadbackRing(const std::string& label, std::size_t size, int slots = 4);
  ~ReadbackRing();
  ReadbackRing(const ReadbackRing&) = delete;
  ReadbackRing& operator=(const ReadbackRing&) = delete;

  /// Where to copy to now: the buffer of a free slot, or 0 when all are on their way (then this
  /// frame's result is simply not asked for). After the copy commands call issue().
  GLuint begin();
  /// Sets the fence of the slot that begin() gave.
  void issue(double tag);

  struct Result {
    double tag;
    std::span<const std::byte> bytes;  ///< valid until the next poll()
  };
  /// The newest result that has arrived since the last call, if any; older ones are dropped.
  /// Never blocks. `out` is only written on true.
  bool poll(Result* out);
  /// The oldest result that has arrived and has not been taken, for who needs every one.
  bool poll_oldest(Result* out);

 private:
  struct Slot {
    Buffer buffer;
    const std::byte* mapped = nullptr;
    GLsync fence = nullptr;
    double tag = 0.0;
    unsigned long long sequence = 0;  ///< order of issue: time may run backwards
  };
  std::vector<Slot> slots_;
  unsigned long long issued_ = 0;
  int writing_ = -1;
  int held_ = -1;  ///< the slot whose bytes the caller may be reading
};

}  // namespace offing::gl
