#pragma once
#include <stdexcept>
#include <string>

namespace offing {

/// Process exit codes of every verb.
enum class ExitCode { kDone = 0, kFailed = 1, kBadInput = 2 };

/// Something that cannot go on. The message is one line: what, where, what to do.
/// Thrown while loading or at start, never per frame.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message, ExitCode code = ExitCode::kFailed)
      : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// The user's input is wrong (a file, an option, a value): ends with exit code 2.
class InputError : public Error {
 public:
  explicit InputError(const std::string& message) : Error(message, ExitCode::kBadInput) {}
};

}  // namespace offing
