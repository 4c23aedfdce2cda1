#pragma once
#include "engine/gl/texture.h"

namespace offing {

/// A repeating picture of bubbles and holes, one channel, with all its levels. Its values are
/// normally distributed with mean 1/2 and 3.2 deviations from there to 0 and 1, and so are sums of
/// them: a threshold makes any share of them white.
gl::Texture make_foam_pattern(int size);

}  // namespace offing
