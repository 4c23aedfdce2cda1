#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gl/buffer.h"
#include "engine/gl/texture.h"
#include "engine/graph/device.h"

namespace offing {

class FrameGraph;

/// A resource of this frame. Typed, so that a buffer cannot be passed for a texture.
template <class Kind>
struct ResourceId {
  std::uint32_t index = UINT32_MAX;
  bool valid() const { return index != UINT32_MAX; }
  bool operator==(const ResourceId&) const = default;
};
using TextureId = ResourceId<gl::Texture>;
using BufferId = ResourceId<gl::Buffer>;

/// Remembers, for one pass of one technique, what it last ran with. Lives in the technique beside
/// the textures that the pass fills; a technique that makes those anew resets it.
class PassMemory {
 public:
  void reset() { valid_ = false; }

 private:
  friend class FrameGraph;
  bool valid_ = false;
  std::uint64_t key_ = 0;
};

/// How often a pass ran and why not, and what it took, summed over the frames since reset_report().
struct PassReport {
  std::string name;
  int ran = 0, cached = 0, culled = 0, skipped = 0;
  std::vector<double> milliseconds;  ///< one per frame in which it ran and was timed
};

/// What a pass does with a resource; decides the barrier before it.
enum class Access : std::uint8_t {
  kSampled,     ///< texture fetch
  kImage,       ///< image load/store
  kStorage,     ///< shader storage buffer
  kUniform,     ///< uniform buffer
  kVertex,      ///< vertex or index fetch
  kAttachment,  ///< colour or depth attachment, blending
  kTransfer,    ///< copies, clears, uploads, mipmap generation
};

/// Where a pass declares what it needs.
class PassBuilder {
 public:
  PassBuilder& read(TextureId id, Access access = Access::kSampled);
  PassBuilder& read(BufferId id, Access access = Access::kStorage);
  /// The whole contents are replaced; what was there before is not needed.
  PassBuilder& write(TextureId id, Access access = Access::kImage);
  PassBuilder& write(BufferId id, Access access = Access::kStorage);
  /// What was there is kept where this pass does not draw.
  PassBuilder& modify(TextureId id, Access access = Access::kAttachment);
  PassBuilder& modify(BufferId id, Access access = Access::kStorage);

  /// Draws into these (in attachment order); the graph binds them and sets the viewport.
  /// Declare them with write() or modify() as well.
  PassBuilder& render_to(std::vector<TextureId> colours, TextureId depth = {});

  /// Has an effect outside the graph (the window, a read-back): never culled.
  PassBuilder& side_effect();
  /// The outputs depend on nothing but `key` and the resources read: where both are as they were
  /// when the pass last ran and all outputs are imported, it does not run again.
  PassBuilder& cache(PassMemory& memory, std::uint64_t key);
  /// For a pass that knows by itself whether there is work: where `condition`, its outputs are as
  /// they were when it last ran, and it counts as cached. Declare what it writes either way, all of
  /// it imported.
  PassBuilder& cached_if(bool condition);
  /// Nothing on screen shows the subject: the pass does not run, and what only it needed neither.
  PassBuilder& skip_if(bool condition);

 private:
  friend class FrameGraph;
  PassBuilder(FrameGraph& graph, std::size_t pass) : graph_(graph), pass_(pass) {}
  FrameGraph& graph_;
  std::size_t pass_;
};

/// What a running pass can reach.
class PassContext {
 public:
  const gl::Texture& texture(TextureId id) const;
  const gl::Buffer& buffer(BufferId id) const;

 private:
  friend class FrameGraph;
  explicit PassContext(const FrameGraph& graph) : graph_(graph) {}
  const FrameGraph& graph_;
};

/// One frame as a list of passes that declare what they read and write. Runs only those whose
/// outputs somebody uses (cull), whose inputs changed (cache) and whose subject is visible (skip),
/// in the order in which they were added, with the memory barriers that GL needs between them.
class FrameGraph {
 public:
  /// `device` must outlive the graph; a NullDevice makes everything run without a GPU.
  explicit FrameGraph(GraphDevice& device);
  ~FrameGraph();
  FrameGraph(const FrameGraph&) = delete;
  FrameGraph& operator=(const FrameGraph&) = delete;

  /// Forgets the passes and ids of the last frame. Transient textures go back to the pool.
  void begin_frame();

  /// Lives for this frame only; the memory comes from a pool and starts undefined.
  TextureId create(std::string_view label, const gl::TextureDesc& desc);
  BufferId create_buffer(std::string_view label, std::size_t bytes);
  /// Belongs to the caller and keeps its contents from frame to frame. Importing the same object
  /// twice in a frame gives the same id.
  TextureId import(const gl::Texture& texture);
  BufferId import(const gl::Buffer& buffer);

  /// Adds a pass: `setup(PassBuilder&)` declares now, `execute(PassContext&)` runs in execute().
  /// `name` is for people ("sea.fft") and for the report.
  template <class Setup, class Execute>
  void add(std::string_view name, Setup&& setup, Execute&& execute) {
    PassBuilder builder = add_pass(name, std::forward<Execute>(execute));
    setup(builder);
  }

  /// Runs the frame.
  void execute();

  /// Every pass seen since reset_report(), in order of first appearance.
  const std::vector<PassReport>& report() const { return report_; }
  /// What whole frames took, from their first pass to their last; empty while timing is off.
  const std::vector<double>& frame_milliseconds() const { return frame_milliseconds_; }
  void reset_report();
  /// Off by default: on a software renderer timing waits for every pass.
  void set_timing(bool on);

  /// The shape of a resource, for passes that derive theirs from it.
  const gl::TextureDesc& desc(TextureId id) const;

 private:
  friend class PassBuilder;
  friend class PassContext;
  struct Impl;
  PassBuilder add_pass(std::string_view name, std::function<void(PassContext&)> execute);
  std::size_t report_row(const std::string& name);
  std::unique_ptr<Impl> impl_;
  std::vector<PassReport> report_;
  std::vector<double> frame_milliseconds_;
};

}  // namespace offing
