#include "engine/graph/frame_graph.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <deque>
#include <limits>
#include <unordered_map>

#include "engine/core/random.h"

namespace offing {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
constexpr std::uint64_t kFramesPooled = 8;  // a transient that nobody took for so long is freed

// The barrier that makes an incoherent write visible to this kind of access.
std::uint32_t barrier_bits(Access access) {
  switch (access) {
    case Access::kSampled:
      return GL_TEXTURE_FETCH_BARRIER_BIT;
    case Access::kImage:
      return GL_SHADER_IMAGE_ACCESS_BARRIER_BIT;
    case Access::kStorage:
      return GL_SHADER_STORAGE_BARRIER_BIT;
    case Access::kUniform:
      return GL_UNIFORM_BARRIER_BIT;
    case Access::kVertex:
      return GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT;
    case Access::kAttachment:
      return GL_FRAMEBUFFER_BARRIER_BIT;
    case Access::kTransfer:
      return GL_TEXTURE_UPDATE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT |
             GL_PIXEL_BUFFER_BARRIER_BIT;
  }
  return 0;
}

// GL orders these against everything else by itself.
bool is_coherent(Access access) { return access != Access::kImage && access != Access::kStorage; }

// What is known of a piece of memory, across frames.
struct MemoryState {
  std::uint64_t content = 0;    // equal values mean equal contents
  bool incoherent = false;      // last written by image or storage access
  std::uint32_t visible = ~0u;  // barriers issued since
};

struct Resource {
  std::string label;
  gl::TextureDesc desc;
  std::size_t bytes = 0;  // buffers
  const gl::Texture* texture = nullptr;
  const gl::Buffer* buffer = nullptr;
  bool is_buffer = false;
  bool imported = false;
  std::size_t last_use = kNone;  // the last pass that runs with it
  const void* memory() const {
    return is_buffer ? static_cast<const void*>(buffer) : static_cast<const void*>(texture);
  }
};

struct Use {
  std::uint32_t resource;
  Access access;
  bool reads, writes;
};

struct Pass {
  std::string name;
  std::function<void(PassContext&)> execute;
  std::vector<Use> uses;
  std::vector<TextureId> colours;
  TextureId depth;
  bool draws = false;
  bool side_effect = false;
  bool skip = false;
  bool unchanged = false;
  PassMemory* memory = nullptr;
  std::uint64_t key = 0;
  bool live = false;
};

template <class T, class Shape>
struct Pooled {
  T object;
  Shape shape;
  bool taken = false;
  std::uint64_t last_used = 0;
};

}  // namespace

struct FrameGraph::Impl {
  explicit Impl(GraphDevice& graph_device) : device(graph_device) {}

  GraphDevice& device;
  std::vector<Resource> resources;
  std::vector<Pass> passes;
  std::unordered_map<const void*, std::uint32_t> imported;
  std::unordered_map<const void*, MemoryState> states;
  // Deques: what was handed out keeps its address.
  std::deque<Pooled<gl::Texture, gl::TextureDesc>> textures;
  std::deque<Pooled<gl::Buffer, std::size_t>> buffers;
  std::uint64_t frame = 0;
  std::uint64_t next_content = 1;
  bool timing = false;

  template <class Pool, class Shape, class Make>
  auto& take(Pool& pool, const Shape& shape, Make make) {
    for (auto& entry : pool) {
      if (!entry.taken && entry.shape == shape) {
        entry.taken = true;
        entry.last_used = frame;
        return entry.object;
      }
    }
    pool.push_back({make(), shape, true, frame});
    return pool.back().object;
  }

  void acquire(Resource& resource) {
    if (resource.memory() != nullptr) return;
    if (resource.is_buffer) {
      resource.buffer = &take(buffers, resource.bytes,
                              [&] { return device.make_buffer(resource.label, resource.bytes); });
    } else {
      resource.texture = &take(textures, resource.desc,
                               [&] { return device.make_texture(resource.label, resource.desc); });
    }
  }

  void release(const Resource& resource) {
    const auto give = [&](auto& pool, const void* memory) {
      for (auto& entry : pool) {
        if (&entry.object == memory) entry.taken = false;
      }
    };
    give(textures, resource.texture);
    give(buffers, resource.buffer);
  }

  // Only at the ends: a deque keeps the addresses of the others.
  template <class Pool>
  void trim(Pool& pool) {
    while (!pool.empty() && pool.front().last_used + kFramesPooled < frame) {
      states.erase(&pool.front().object);
      pool.pop_front();
    }
    while (!pool.empty() && pool.back().last_used + kFramesPooled < frame) {
      states.erase(&pool.back().object);
      pool.pop_back();
    }
  }

  // Backwards from what leaves the graph: a pass lives if a living pass needs what it writes.
  void find_live_passes() {
    std::vector<bool> needed(resources.size(), false);
    for (std::size_t i = passes.size(); i-- > 0;) {
      Pass& pass = passes[i];
      if (pass.skip) continue;
      pass.live = pass.side_effect ||
                  std::any_of(pass.uses.begin(), pass.uses.end(),
                              [&](const Use& use) { return use.writes && needed[use.resource]; });
      if (!pass.live) continue;
      for (const Use& use : pass.uses) {
        if (use.writes && !use.reads) needed[use.resource] = false;
      }
      for (const Use& use : pass.uses) {
        if (use.reads) needed[use.resource] = true;
      }
    }
    for (std::size_t i = 0; i < passes.size(); ++i) {
      if (!passes[i].live) continue;
      for (const Use& use : passes[i].uses) resources[use.resource].last_use = i;
    }
  }

  std::uint64_t content_of(const Resource& resource) {
    const void* memory = resource.memory();
    return memory == nullptr ? next_content++ : states[memory].content;
  }

  // The pass's own key and the contents of all it reads.
  std::uint64_t full_key(const Pass& pass) {
    std::uint64_t key = hash_of(pass.key);
    for (const Use& use : pass.uses) {
      if (use.reads) key = hash_of(key, content_of(resources[use.resource]));
    }
    return key;
  }

  void set_contents(const Pass& pass, std::uint64_t key) {
    std::uint64_t index = 0;
    for (const Use& use : pass.uses) {
      if (!use.writes) continue;
      const std::uint64_t content =
          pass.memory != nullptr
              ? hash_of(key, reinterpret_cast<std::uintptr_t>(pass.memory), ++index)
              : next_content++;
      states[resources[use.resource].memory()].content = content;
    }
  }

  void issue_barriers(const Pass& pass) {
    std::uint32_t bits = 0;
    for (const Use& use : pass.uses) {
      const MemoryState& state = states[resources[use.resource].memory()];
      if (state.incoherent) bits |= barrier_bits(use.access) & ~state.visible;
    }
    if (bits == 0) return;
    device.barrier(bits);
    for (auto& [memory, state] : states) state.visible |= bits;
  }

  void note_writes(const Pass& pass) {
    for (const Use& use : pass.uses) {
      if (!use.writes) continue;
      MemoryState& state = states[resources[use.resource].memory()];
      state.incoherent = !is_coherent(use.access);
      state.visible = 0;
    }
  }

  void bind_targets(const Pass& pass) {
    std::vector<const gl::Texture*> colours;
    for (const TextureId id : pass.colours) colours.push_back(resources[id.index].texture);
    device.bind_attachments(colours,
                            pass.depth.valid() ? resources[pass.depth.index].texture : nullptr);
  }
};

FrameGraph::FrameGraph(GraphDevice& device) : impl_(std::make_unique<Impl>(device)) {}
FrameGraph::~FrameGraph() = default;

void FrameGraph::begin_frame() {
  ++impl_->frame;
  impl_->passes.clear();
  impl_->resources.clear();
  impl_->imported.clear();
  for (auto& entry : impl_->textures) entry.taken = false;
  for (auto& entry : impl_->buffers) entry.taken = false;
  impl_->trim(impl_->textures);
  impl_->trim(impl_->buffers);
}

TextureId FrameGraph::create(std::string_view label, const gl::TextureDesc& desc) {
  Resource resource;
  resource.label = label;
  resource.desc = desc;
  impl_->resources.push_back(std::move(resource));
  return {static_cast<std::uint32_t>(impl_->resources.size() - 1)};
}

BufferId FrameGraph::create_buffer(std::string_view label, std::size_t bytes) {
  Resource resource;
  resource.label = label;
  resource.bytes = bytes;
  resource.is_buffer = true;
  impl_->resources.push_back(std::move(resource));
  return {static_cast<std::uint32_t>(impl_->resources.size() - 1)};
}

TextureId FrameGraph::import(const gl::Texture& texture) {
  const auto [found, is_new] =
      impl_->imported.try_emplace(&texture, static_cast<std::uint32_t>(impl_->resources.size()));
  if (is_new) {
    Resource resource;
    resource.desc = texture.desc();
    resource.texture = &texture;
    resource.imported = true;
    impl_->resources.push_back(std::move(resource));
  }
  return {found->second};
}

BufferId FrameGraph::import(const gl::Buffer& buffer) {
  const auto [found, is_new] =
      impl_->imported.try_emplace(&buffer, static_cast<std::uint32_t>(impl_->resources.size()));
  if (is_new) {
    Resource resource;
    resource.bytes = buffer.size();
    resource.buffer = &buffer;
    resource.is_buffer = true;
    resource.imported = true;
    impl_->resources.push_back(std::move(resource));
  }
  return {found->second};
}

const gl::TextureDesc& FrameGraph::desc(TextureId id) const {
  return impl_->resources[id.index].desc;
}

PassBuilder FrameGraph::add_pass(std::string_view name, std::function<void(PassContext&)> execute) {
  Pass pass;
  pass.name = name;
  pass.execute = std::move(execute);
  impl_->passes.push_back(std::move(pass));
  return PassBuilder(*this, impl_->passes.size() - 1);
}

void FrameGraph::execute() {
  Impl& impl = *impl_;
  impl.find_live_passes();
  PassContext context(*this);
  if (impl.timing) impl.device.begin_timer(GraphDevice::kWholeFrame);
  for (std::size_t i = 0; i < impl.passes.size(); ++i) {
    Pass& pass = impl.passes[i];
    const std::size_t row = report_row(pass.name);
    if (!pass.live) {
      ++(pass.skip ? report_[row].skipped : report_[row].culled);
      continue;
    }
    for (const Use& use : pass.uses) impl.acquire(impl.resources[use.resource]);
    const std::uint64_t key = pass.memory != nullptr ? impl.full_key(pass) : 0;
    const bool keeps_outputs = std::all_of(pass.uses.begin(), pass.uses.end(), [&](const Use& use) {
      return !use.writes || impl.resources[use.resource].imported;
    });
    if (pass.unchanged) {
      ++report_[row].cached;
      continue;
    }
    if (pass.memory != nullptr && keeps_outputs && pass.memory->valid_ &&
        pass.memory->key_ == key) {
      ++report_[row].cached;
    } else {
      impl.issue_barriers(pass);
      impl.device.begin_pass(pass.name);
      if (impl.timing) impl.device.begin_timer(row);
      if (pass.draws) impl.bind_targets(pass);
      pass.execute(context);
      if (impl.timing) impl.device.end_timer();
      impl.device.end_pass();
      impl.note_writes(pass);
      ++report_[row].ran;
      if (pass.memory != nullptr) {
        pass.memory->key_ = key;
        pass.memory->valid_ = true;
      }
    }
    impl.set_contents(pass, key);
    for (const Use& use : pass.uses) {
      const Resource& resource = impl.resources[use.resource];
      if (!resource.imported && resource.last_use == i) impl.release(resource);
    }
  }
  if (impl.timing) impl.device.end_timer();
  for (const GraphDevice::Time& time : impl.device.collect_times()) {
    std::vector<double>& times = time.pass == GraphDevice::kWholeFrame
                                     ? frame_milliseconds_
                                     : report_[time.pass].milliseconds;
    times.push_back(time.milliseconds);
  }
}

std::size_t FrameGraph::report_row(const std::string& name) {
  const auto found = std::find_if(report_.begin(), report_.end(),
                                  [&](const PassReport& row) { return row.name == name; });
  if (found != report_.end()) return static_cast<std::size_t>(found - report_.begin());
  report_.push_back({.name = name, .milliseconds = {}});
  return report_.size() - 1;
}

void FrameGraph::reset_report() {
  frame_milliseconds_.clear();
  for (PassReport& row : report_) row = {.name = std::move(row.name), .milliseconds = {}};
}
void FrameGraph::set_timing(bool on) { impl_->timing = on; }

const gl::Texture& PassContext::texture(TextureId id) const {
  return *graph_.impl_->resources[id.index].texture;
}
const gl::Buffer& PassContext::buffer(BufferId id) const {
  return *graph_.impl_->resources[id.index].buffer;
}

namespace {
// One use per resource and access; reading and writing the same one merges.
void add_use(std::vector<Use>& uses, Use use) {
  for (Use& known : uses) {
    if (known.resource == use.resource && known.access == use.access) {
      known.reads |= use.reads;
      known.writes |= use.writes;
      return;
    }
  }
  uses.push_back(use);
}
}  // namespace

PassBuilder& PassBuilder::read(TextureId id, Access access) {
  add_use(graph_.impl_->passes[pass_].uses, {id.index, access, true, false});
  return *this;
}
PassBuilder& PassBuilder::read(BufferId id, Access access) {
  add_use(graph_.impl_->passes[pass_].uses, {id.index, access, true, false});
  return *this;
}
PassBuilder& PassBuilder::write(TextureId id, Access access) {
  add_use(graph_.impl_->passes[pass_].uses, {id.index, access, false, true});
  return *this;
}
PassBuilder& PassBuilder::write(BufferId id, Access access) {
  add_use(graph_.impl_->passes[pass_].uses, {id.index, access, false, true});
  return *this;
}
PassBuilder& PassBuilder::modify(TextureId id, Access access) {
  add_use(graph_.impl_->passes[pass_].uses, {id.index, access, true, true});
  return *this;
}
PassBuilder& PassBuilder::modify(BufferId id, Access access) {
  add_use(graph_.impl_->passes[pass_].uses, {id.index, access, true, true});
  return *this;
}

PassBuilder& PassBuilder::render_to(std::vector<TextureId> colours, TextureId depth) {
  Pass& pass = graph_.impl_->passes[pass_];
  pass.colours = std::move(colours);
  pass.depth = depth;
  pass.draws = true;
  return *this;
}

PassBuilder& PassBuilder::side_effect() {
  graph_.impl_->passes[pass_].side_effect = true;
  return *this;
}

PassBuilder& PassBuilder::cache(PassMemory& memory, std::uint64_t key) {
  graph_.impl_->passes[pass_].memory = &memory;
  graph_.impl_->passes[pass_].key = key;
  return *this;
}

PassBuilder& PassBuilder::cached_if(bool condition) {
  graph_.impl_->passes[pass_].unchanged |= condition;
  return *this;
}

PassBuilder& PassBuilder::skip_if(bool condition) {
  graph_.impl_->passes[pass_].skip |= condition;
  return *this;
}

}  // namespace offing
