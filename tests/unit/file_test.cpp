#include "engine/io/file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <iterator>

#include "engine/core/error.h"
#include "support/scratch_folder.h"

namespace offing {
namespace {
namespace fs = std::filesystem;

struct File : testing::Test {
  // Entries left in the folder, hidden ones included: a temporary file would be one.
  std::ptrdiff_t count() const {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  }

  const test::ScratchFolder scratch;
  const fs::path folder = scratch.path();
};

template <class Function>
std::pair<ExitCode, std::string> outcome(Function&& function) {
  try {
    function();
  } catch (const Error& error) {
    return {error.code(), error.what()};
  }
  return {ExitCode::kDone, ""};
}

TEST_F(File, EveryByteComesBack) {
  std::string bytes;
  for (int i = 0; i < 300000; ++i) bytes += static_cast<char>(i * 7);
  write_text(folder / "a.bin", bytes);
  EXPECT_EQ(read_text(folder / "a.bin"), bytes);
  write_text(folder / "a.bin", "");
  EXPECT_EQ(read_text(folder / "a.bin"), "");
  EXPECT_EQ(count(), 1);
}

TEST_F(File, ANewFileMayBeReadByWhomTheUserAllows) {
  const mode_t mask = ::umask(022);
  write_text(folder / "a.txt", "x");
  ::umask(mask);
  struct ::stat status {};
  ASSERT_EQ(::stat((folder / "a.txt").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0644u);
}

TEST_F(File, ALinkStaysALink) {
  write_text(folder / "real.txt", "old");
  fs::create_symlink("real.txt", folder / "link.txt");
  write_text(folder / "link.txt", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(read_text(folder / "real.txt"), "new");
}

TEST_F(File, MissingFolderIsBadInput) {
  const auto [code, message] = outcome([&] { write_text(folder / "no" / "a.txt", "x"); });
  EXPECT_EQ(code, ExitCode::kBadInput);
  EXPECT_EQ(message, (folder / "no" / "a.txt").string() +
                         ": cannot be written: No such file or directory; make its folder first");
}

TEST_F(File, AFolderOrAFileAsFolderIsBadInput) {
  write_text(folder / "a.txt", "x");
  EXPECT_EQ(outcome([&] { write_text(folder, "x"); }).first, ExitCode::kBadInput);
  EXPECT_EQ(outcome([&] { write_text(folder / "a.txt" / "b", "x"); }).first, ExitCode::kBadInput);
  EXPECT_EQ(outcome([&] { write_text("", "x"); }).first, ExitCode::kBadInput);
  EXPECT_EQ(outcome([&] { write_text(folder / std::string(300, 'n'), "x"); }).first,
            ExitCode::kBadInput);
  EXPECT_EQ(read_text(folder / "a.txt"), "x");
  EXPECT_EQ(count(), 1);
}

TEST_F(File, AFullDiskFailsAndLeavesTheDeviceAlone) {
  if (!fs::is_character_file("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const auto [code, message] = outcome([] { write_text("/dev/full", "x"); });
  EXPECT_EQ(code, ExitCode::kFailed);
  EXPECT_EQ(message,
            "/dev/full: cannot be written: No space left on device; free some space or choose "
            "another folder");
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(File, AFullDiskFailsThroughALinkToo) {
  if (!fs::is_character_file("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  fs::create_symlink("/dev/full", folder / "link.txt");
  EXPECT_EQ(outcome([&] { write_text(folder / "link.txt", "x"); }).first, ExitCode::kFailed);
  EXPECT_EQ(count(), 1);
}

TEST_F(File, AClosedFolderIsBadInput) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  const ExitCode code = outcome([&] { write_text(folder / "a.txt", "x"); }).first;
  fs::permissions(folder, fs::perms::owner_all);
  EXPECT_EQ(code, ExitCode::kBadInput);
}

TEST_F(File, ReadingSaysWhatIsWrong) {
  const auto [code, message] = outcome([&] { read_text(folder / "no.txt"); });
  EXPECT_EQ(code, ExitCode::kBadInput);
  EXPECT_EQ(message, (folder / "no.txt").string() +
                         ": cannot be read: No such file or directory; check the path");
  EXPECT_EQ(outcome([&] { read_text(folder); }).second,
            folder.string() + ": cannot be read: is a folder; give the name of a file");
  EXPECT_EQ(outcome([] { read_text("/dev/zero", 1 << 20); }).second,
            "/dev/zero: cannot be read: larger than 1 MiB; give a smaller file");
}

}  // namespace
}  // namespace offing
