#include <fmt/core.h>

#include "engine/graph/device.h"

namespace offing {

gl::Texture NullDevice::make_texture(const std::string& label, const gl::TextureDesc&) {
  log.push_back("make " + label);
  return {};
}
gl::Buffer NullDevice::make_buffer(const std::string& label, std::size_t) {
  log.push_back("make " + label);
  return {};
}
void NullDevice::barrier(std::uint32_t bits) { log.push_back(fmt::format("barrier {:#x}", bits)); }
void NullDevice::begin_pass(const std::string& name) { log.push_back("pass " + name); }

}  // namespace offing
