#include "engine/clouds/noise_cache.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "engine/io/file.h"
#include "support/scratch_folder.h"

namespace offing {
namespace {

class NoiseCacheTest : public ::testing::Test {
 protected:
  void SetUp() override { write_noise_cache(file_, 7, "sixteen bytes .."); }
  std::optional<std::string> read(std::uint64_t parameters = 7, std::size_t bytes = 16) const {
    return read_noise_cache(file_, parameters, bytes);
  }
  void rewrite(const std::string& text) const {
    std::ofstream(file_, std::ios::binary | std::ios::trunc) << text;
  }
  const test::ScratchFolder scratch_;
  const std::filesystem::path file_ = scratch_ / "clouds.noise";
};

TEST_F(NoiseCacheTest, GivesBackWhatWasKept) { EXPECT_EQ(read(), "sixteen bytes .."); }

TEST_F(NoiseCacheTest, OtherParametersOrSizeAreMadeAgain) {
  ::testing::internal::CaptureStderr();
  EXPECT_FALSE(read(8));
  EXPECT_FALSE(read(7, 17));
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("was made with other parameters: made again"), std::string::npos) << said;
}

TEST_F(NoiseCacheTest, CutShortDamagedOrForeignIsMadeAgain) {
  const std::string whole = read_text(file_);
  ::testing::internal::CaptureStderr();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    rewrite(whole.substr(0, length));
    EXPECT_FALSE(read()) << length;
  }
  std::string version = whole;
  version[8] = static_cast<char>(version[8] + 1);
  rewrite(version);
  EXPECT_FALSE(read());
  for (std::size_t at = 0; at < whole.size(); ++at) {
    if (at >= 12 && at < 16) continue;  // reserved
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    rewrite(damaged);
    EXPECT_FALSE(read()) << at;
  }
  rewrite("a text of somebody else's, longer than the header of ours would be");
  EXPECT_FALSE(read());
  const std::string said = ::testing::internal::GetCapturedStderr();
  for (const char* word :
       {"is cut short", "is of another version", "is damaged", "is no noise cache"}) {
    EXPECT_NE(said.find(word), std::string::npos) << word;
  }
  rewrite(whole);
  EXPECT_TRUE(read());
}

TEST_F(NoiseCacheTest, AFileThatIsNotThereIsNoNews) {
  std::filesystem::remove(file_);
  ::testing::internal::CaptureStderr();
  EXPECT_FALSE(read());
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace offing
