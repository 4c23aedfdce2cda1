#include "game/render/render.h"

#include <fmt/core.h>
#include <fmt/printf.h>

#include <cctype>

#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/io/file.h"
#include "engine/io/image.h"
#include "game/render/voyage.h"

namespace offing {
namespace {
namespace fs = std::filesystem;

// Where in the name a frame's number goes ("%d", "%04d"), or npos.
std::size_t number_place(const std::string& name, std::size_t* length) {
  const std::size_t percent = name.find('%');
  if (percent == std::string::npos) return percent;
  std::size_t end = percent + 1;
  while (end < name.size() && std::isdigit(static_cast<unsigned char>(name[end]))) ++end;
  if (end >= name.size() || name[end] != 'd' || end > percent + 3 ||
      name.find('%', end) != std::string::npos) {
    throw InputError(
        fmt::format("--out {}: only one %d or %04d may stand for the frame's number", name));
  }
  *length = end + 1 - percent;
  return percent;
}

fs::path numbered(const fs::path& pattern, int frame) {
  std::string name = pattern.filename().string();
  std::size_t length = 0;
  const std::size_t at = number_place(name, &length);
  if (at == std::string::npos) return pattern;
  const std::string format = name.substr(at, length);
  return pattern.parent_path() / name.replace(at, length, fmt::sprintf(format, frame));
}

}  // namespace

void run_render(const Options& options) {
  check_image_name(options.out);  // before an hour of rendering, not after it
  std::size_t length = 0;
  const bool all = number_place(options.out.filename().string(), &length) != std::string::npos;
  Voyage voyage(options, options.size.value_or(glm::ivec2(640, 360)));
  Renderer& renderer = voyage.renderer();
  renderer.graph().set_timing(!options.report.empty());
  for (int frame = 0; frame < options.warmup; ++frame) voyage.next_frame();
  voyage.reset_measures();
  for (int frame = 0; frame < options.frames; ++frame) {
    voyage.next_frame();
    if (!all && frame + 1 < options.frames) continue;
    const std::string extension = options.out.extension().string();
    const bool linear = extension == ".exr" || extension == ".pfm";
    write_image(numbered(options.out, frame),
                linear ? renderer.radiance(static_cast<double>(voyage.view().frame.time.z))
                       : renderer.picture());
  }
  if (!options.report.empty()) write_text(options.report, report_of(voyage, options));
  for (const auto& message : voyage.debug().messages()) log_warning("{}", message.text);
}

}  // namespace offing
