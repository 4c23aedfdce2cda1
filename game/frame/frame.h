#pragma once
#include <filesystem>
#include <optional>

#include "engine/clouds/clouds.h"
#include "engine/clouds/gardner.h"
#include "engine/gl/buffer.h"
#include "engine/gl/texture.h"
#include "engine/graph/frame_graph.h"
#include "engine/ocean/ocean.h"
#include "engine/post/antialias.h"
#include "engine/post/bloom.h"
#include "engine/post/exposure.h"
#include "engine/post/tonemap.h"
#include "engine/shader/shader_library.h"
#include "engine/sky/probe.h"
#include "engine/sky/sky.h"
#include "game/frame/boat_pass.h"
#include "game/frame/boat_shadow.h"
#include "game/frame/flotsam_pass.h"
#include "game/frame/frame_view.h"
#include "game/frame/quality.h"

namespace offing {

/// Everything that draws, and what it keeps from frame to frame.
struct Techniques {
  /// `boat_model`: a glTF file; empty for R8's own.
  Techniques(ShaderLibrary& shaders, const Quality& quality,
             const std::filesystem::path& boat_model);

  Sky sky;
  Probe probe;
  Cloudscape clouds;
  Ocean ocean;
  GardnerClouds gardner;
  BoatPass boat;
  BoatShadow boat_shadow;
  FlotsamPass flotsam;
  Exposure exposure;
  Bloom bloom;
  Tonemap tonemap;
  std::optional<Antialias> antialias;  ///< from medium on
  gl::Buffer frame_block;              ///< shared::FrameData
};

/// What a frame draws into; outlives it, so that it can be looked at and kept.
struct FramePictures {
  gl::Texture hdr;      ///< radiance × exposure, RGBA16F
  gl::Texture depth;    ///< reversed
  gl::Texture display;  ///< sRGB-coded, RGBA8
  explicit FramePictures(glm::ivec2 size = glm::ivec2(1));
};

/// The whole frame, top to bottom. Returns the finished picture.
TextureId build_frame(FrameGraph& graph, const FrameView& view, Techniques& techniques,
                      const FramePictures& pictures);

}  // namespace offing
