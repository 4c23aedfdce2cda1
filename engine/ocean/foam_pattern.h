#pragma once
#include "engine/gl/texture.h"

namespace offing {

/// A repeating picture of bubbles and holes, one channel, with all its levels. Its values are
/// evenly distributed over 0 … 1, so that the share of points above 1 - c is c.
gl::Texture make_foam_pattern(int size);

}  // namespace offing
