#include "engine/platform/file_watch.h"
#include "support/scratch_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <string>

namespace offing {
namespace {

namespace fs = std::filesystem;

class FileWatchTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "ocean");
    write("sky.frag", "one");
    write("ocean/sea.comp", "two");
  }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
  }

  const test::ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
};

TEST_F(FileWatchTest, SaysNothingWhileNothingHappens) {
  FileWatch watch(folder_);
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(watch.changed(i));
}

TEST_F(FileWatchTest, SeesAFileOfTheSameSizeWrittenLater) {
  FileWatch watch(folder_);
  write("ocean/sea.comp", "TWO");
  // Saved a moment later, however coarse the file system's clock is.
  const fs::path file = folder_ / "ocean/sea.comp";
  fs::last_write_time(file, fs::last_write_time(file) + std::chrono::milliseconds(1500));
  EXPECT_TRUE(watch.changed(0.0));
  EXPECT_FALSE(watch.changed(1.0));
}

TEST_F(FileWatchTest, SeesFilesAddedRemovedAndRenamed) {
  FileWatch watch(folder_);
  write("ocean/foam.comp", "three");
  EXPECT_TRUE(watch.changed(0.0));
  fs::rename(folder_ / "ocean/foam.comp", folder_ / "ocean/spray.comp");
  EXPECT_TRUE(watch.changed(1.0));
  fs::remove(folder_ / "ocean/spray.comp");
  EXPECT_TRUE(watch.changed(2.0));
  EXPECT_FALSE(watch.changed(3.0));
}

TEST_F(FileWatchTest, LooksAtMostEveryInterval) {
  FileWatch watch(folder_);
  EXPECT_FALSE(watch.changed(10.0));
  write("sky.frag", "longer");
  EXPECT_FALSE(watch.changed(10.0 + 0.9 * FileWatch::kInterval));
  EXPECT_TRUE(watch.changed(10.0 + 1.1 * FileWatch::kInterval));
}

TEST_F(FileWatchTest, FolderMayBeMissing) {
  FileWatch watch(folder_ / "clouds");
  EXPECT_FALSE(watch.changed(0.0));
  fs::create_directories(folder_ / "clouds");
  write("clouds/march.comp", "four");
  EXPECT_TRUE(watch.changed(1.0));
}

}  // namespace
}  // namespace offing
