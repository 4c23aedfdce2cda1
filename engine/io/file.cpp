#include "engine/io/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "engine/core/error.h"

namespace offing {
namespace {
namespace fs = std::filesystem;

class FileDescriptor {
 public:
  FileDescriptor(const fs::path& file, int flags) : value_(::open(file.c_str(), flags, 0666)) {}
  ~FileDescriptor() {
    if (value_ >= 0) ::close(value_);
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  explicit operator bool() const { return value_ >= 0; }
  int get() const { return value_; }
  // Closing is the last moment at which a write can fail (quotas, network folders).
  bool close() { return ::close(std::exchange(value_, -1)) == 0; }

 private:
  int value_;
};

std::string reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void refuse_reading(const fs::path& file, std::string_view why,
                                 std::string_view advice) {
  throw InputError(fmt::format("{}: cannot be read: {}; {}", file.string(), why, advice));
}

// Where the user named a place that can't be written to, it is their input that is wrong; anything
// else, a full disk above all, is a failure.
[[noreturn]] void refuse_writing(const fs::path& file, int error) {
  const std::string start =
      fmt::format("{}: cannot be written: {}; ", file.string(), reason(error));
  switch (error) {
    case ENOENT:
    case ENOTDIR:
      throw InputError(start + "make its folder first");
    case EISDIR:
      throw InputError(start + "give the name of a file");
    case EACCES:
    case EPERM:
    case EROFS:
      throw InputError(start + "choose a folder that you may write to");
    case ENAMETOOLONG:
    case ELOOP:
      throw InputError(start + "choose another name");
    case ENOSPC:
    case EDQUOT:
      throw Error(start + "free some space or choose another folder");
    default:
      throw Error(start + "choose another folder");
  }
}

// 0, or the error number of the write or close that failed.
int write_all(FileDescriptor& descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor.get(), text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return descriptor.close() ? 0 : errno;
}

void write_in_place(const fs::path& file, std::string_view text) {
  FileDescriptor descriptor(file, O_WRONLY | O_CLOEXEC | O_NOCTTY);
  if (!descriptor) refuse_writing(file, errno);
  if (const int error = write_all(descriptor, text)) refuse_writing(file, error);
}

fs::path temporary_beside(const fs::path& file) {
  static std::atomic<unsigned> count{0};
  return file.parent_path() / fmt::format(".offing-{}-{}.tmp", ::getpid(), count++);
}

}  // namespace

std::string read_text(const fs::path& file, std::size_t max_bytes) {
  FileDescriptor descriptor(file, O_RDONLY | O_CLOEXEC | O_NOCTTY);
  if (!descriptor) refuse_reading(file, reason(errno), "check the path");
  std::string text;
  char block[1 << 16];
  while (true) {
    const ssize_t size = ::read(descriptor.get(), block, sizeof block);
    if (size < 0 && errno == EINTR) continue;
    if (size < 0 && errno == EISDIR) refuse_reading(file, "is a folder", "give the name of a file");
    if (size < 0) refuse_reading(file, reason(errno), "check the file");
    if (size == 0) return text;
    if (text.size() + static_cast<std::size_t>(size) > max_bytes) {
      refuse_reading(file, fmt::format("larger than {} MiB", max_bytes >> 20),
                     "give a smaller file");
    }
    text.append(block, static_cast<std::size_t>(size));
  }
}

void write_text(const fs::path& file, std::string_view text) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::is_directory(status)) refuse_writing(file, EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_in_place(file, text);
  if (fs::exists(status) && ::access(file.c_str(), W_OK) != 0) refuse_writing(file, errno);

  // Through a link to the file itself, so that the link stays one.
  const fs::path target = fs::is_symlink(fs::symlink_status(file, ignored))
                              ? fs::weakly_canonical(file, ignored)
                              : file;
  const fs::path temporary = temporary_beside(target);
  FileDescriptor descriptor(temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC);
  if (!descriptor) refuse_writing(file, errno);
  int error = write_all(descriptor, text);
  if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error == 0) return;
  ::unlink(temporary.c_str());
  refuse_writing(file, error);
}

}  // namespace offing
