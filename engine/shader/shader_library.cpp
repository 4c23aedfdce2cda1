#include "engine/shader/shader_library.h"

#include <fmt/core.h>

#include <algorithm>

#include "engine/core/error.h"

namespace offing {
namespace {
namespace fs = std::filesystem;

GLenum stage_of(const fs::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".vert") return GL_VERTEX_SHADER;
  if (extension == ".frag") return GL_FRAGMENT_SHADER;
  if (extension == ".comp") return GL_COMPUTE_SHADER;
  throw InputError(
      fmt::format("{}: a shader's name must end in .vert, .frag or .comp", file.string()));
}

// The first complaint of a compiler's log, and how many lines follow: what one line can hold.
std::string first_complaint(const std::string& log) {
  const std::size_t end = log.find('\n');
  const auto more = std::count(log.begin(), log.end(), '\n') - 1;
  std::string line = log.substr(0, end);
  if (more > 0) line += fmt::format(" (and {} more lines)", more);
  return line + "; mend the shader";
}

fs::file_time_type time_of(const fs::path& file) {
  std::error_code missing;
  const fs::file_time_type time = fs::last_write_time(file, missing);
  return missing ? fs::file_time_type::min() : time;
}
}  // namespace

ShaderLibrary::ShaderLibrary(fs::path root) : root_(std::move(root)) {}

const ShaderProgram& ShaderLibrary::program(std::vector<fs::path> stages, ShaderDefines defines) {
  for (const auto& known : programs_) {
    if (known->stages_ == stages && known->defines_ == defines) return *known;
  }
  auto program = std::make_unique<ShaderProgram>();
  program->stages_ = std::move(stages);
  program->defines_ = std::move(defines);
  build(*program);
  programs_.push_back(std::move(program));
  return *programs_.back();
}

void ShaderLibrary::build(ShaderProgram& program) {
  std::vector<gl::StageSource> sources;
  std::vector<ShaderText> texts;
  std::vector<fs::path> files;
  std::string label;
  for (const fs::path& stage : program.stages_) {
    // Even where it fails, the files are known, so that mending one of them is noticed.
    texts.push_back(preprocess_shader(root_, stage, program.defines_));
    sources.push_back({stage_of(stage), texts.back().text});
    files.insert(files.end(), texts.back().files.begin(), texts.back().files.end());
    label += (label.empty() ? "" : " + ") + stage.string();
  }
  for (const fs::path& file : files) read_at_[file] = time_of(root_ / file);
  program.files_ = std::move(files);
  try {
    program.program_ = gl::Program(label, sources);
    ++program.generation_;
  } catch (const gl::ShaderError& error) {
    for (std::size_t i = 0; i < sources.size(); ++i) {
      if (sources[i].stage == error.stage())
        throw InputError(first_complaint(texts[i].map_log(error.what())));
    }
    throw InputError(first_complaint(error.what()));
  }
}

void ShaderLibrary::reload(ShaderProgram& program) {
  try {
    build(program);
    errors_.erase(&program);
  } catch (const Error& error) {
    errors_[&program] = error.what();
  }
}

bool ShaderLibrary::reload_changed() {
  std::vector<fs::path> changed;
  for (auto& [file, read_at] : read_at_) {
    const fs::file_time_type now = time_of(root_ / file);
    if (now == read_at) continue;
    read_at = now;
    changed.push_back(file);
  }
  if (changed.empty()) return false;
  reload_where([&](const ShaderProgram& program) {
    return std::any_of(changed.begin(), changed.end(), [&](const fs::path& file) {
      return std::find(program.files_.begin(), program.files_.end(), file) != program.files_.end();
    });
  });
  return true;
}

void ShaderLibrary::reload_all() {
  reload_where([](const ShaderProgram&) { return true; });
}

template <class Wanted>
void ShaderLibrary::reload_where(Wanted wanted) {
  for (const auto& program : programs_) {
    if (wanted(*program)) reload(*program);
  }
  error_.clear();
  for (const auto& [program, message] : errors_) error_ += message + "\n";
}

}  // namespace offing
