#pragma once
#include <filesystem>

#include "engine/gl/texture.h"
#include "engine/io/image.h"

namespace offing {

/// Pictures of the cloth, luff on the left and head at the top: where its colours change (grey, or
/// red for its port and green for its starboard side), and where there is cloth.
struct BoatTextures {
  Image main_alpha, main_pattern, jib_pattern, flag_alpha, flag_pattern;
};

/// Those of assets/textures. Throws InputError where one is missing.
BoatTextures load_boat_textures(const std::filesystem::path& folder);

/// Red and green: the pattern seen from port and from starboard; a grey picture is the same from
/// both. Blue: where there is cloth; all of it without a picture of that.
gl::Texture cloth_texture(const char* label, const Image& pattern, const Image& alpha);

/// Base colours of a material, one texel a pixel.
gl::Texture colour_texture(const Image& image);

}  // namespace offing
