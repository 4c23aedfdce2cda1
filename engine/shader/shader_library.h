#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/gl/program.h"

namespace offing {

/// A preprocessed shader: what the compiler sees, and where each of its lines came from.
struct ShaderText {
  std::string text;
  struct Line {
    int file;  ///< index into files
    int line;  ///< 1-based
  };
  std::vector<Line> lines;
  std::vector<std::filesystem::path> files;

  /// The compiler's log with its line numbers replaced by "file:line:".
  std::string map_log(const std::string& log) const;
};

using ShaderDefines = std::vector<std::pair<std::string, std::string>>;

/// Reads `file` under `root`, resolves #include "path" (paths from `root`, each file once) and puts
/// `#version 450 core` and the defines first. Throws InputError naming the file and line of a
/// missing or circular include.
ShaderText preprocess_shader(const std::filesystem::path& root, const std::filesystem::path& file,
                             const ShaderDefines& defines);

/// A program of a ShaderLibrary: stays valid while the library lives and keeps the last good
/// version across reloads. `generation` grows when the program changes: hash it into pass keys.
class ShaderProgram {
 public:
  const gl::Program& program() const { return program_; }
  unsigned generation() const { return generation_; }
  void use() const { program_.use(); }

 private:
  friend class ShaderLibrary;
  std::vector<std::filesystem::path> stages_;  ///< relative to the library's root
  ShaderDefines defines_;
  std::vector<std::filesystem::path> files_;  ///< everything that was included
  gl::Program program_;
  unsigned generation_ = 0;
};

/// Compiles the shaders of a folder and recompiles them when their files change.
class ShaderLibrary {
 public:
  explicit ShaderLibrary(std::filesystem::path root);

  /// Stage by extension: .vert .frag .comp. The same stages and defines give the same program.
  /// Throws InputError with "file:line: message" lines where it does not compile.
  const ShaderProgram& program(std::vector<std::filesystem::path> stages,
                               ShaderDefines defines = {});

  /// Recompiles every program of which a file has changed since it was read. A failure keeps the
  /// last good program and is kept in error() until the file compiles. Returns true if any changed.
  bool reload_changed();
  /// Recompiles everything (F5).
  void reload_all();
  /// The message to show on screen; empty when all is well.
  const std::string& error() const { return error_; }

 private:
  void build(ShaderProgram& program);
  void reload(ShaderProgram& program);
  template <class Wanted>
  void reload_where(Wanted wanted);

  std::filesystem::path root_;
  std::vector<std::unique_ptr<ShaderProgram>> programs_;
  std::map<std::filesystem::path, std::filesystem::file_time_type> read_at_;
  std::map<const ShaderProgram*, std::string> errors_;
  std::string error_;
};

}  // namespace offing
