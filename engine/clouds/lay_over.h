#pragma once
#include <epoxy/gl.h>

namespace offing {

/// While it lives, what is drawn is laid over the picture: colour + behind × alpha, the picture's
/// own alpha kept and nothing written to the depth. Where depth `counts` only what lies before the
/// things in it shows (reversed depth: nearer is greater). At its end blending is off again and
/// texture unit 0 without a sampler.
class LayOver {
 public:
  enum class Depth { kCounts, kIgnored };

  explicit LayOver(Depth depth = Depth::kCounts) {
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_SRC_ALPHA, GL_ZERO, GL_ONE);
    glDepthMask(GL_FALSE);
    if (depth == Depth::kCounts) {
      glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
      glEnable(GL_DEPTH_TEST);
      glDepthFunc(GL_GEQUAL);
    } else {
      glDisable(GL_DEPTH_TEST);
    }
  }
  ~LayOver() {
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glBindSampler(0, 0);
  }
  LayOver(const LayOver&) = delete;
  LayOver& operator=(const LayOver&) = delete;
};

}  // namespace offing
