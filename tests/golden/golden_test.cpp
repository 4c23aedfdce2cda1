// Small pictures of the whole frame against references that a person has looked at. See README.md.
#include <gtest/gtest.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <random>

#include "engine/core/error.h"
#include "engine/post/flip.h"
#include "golden/views.h"

namespace offing::test {
namespace {
namespace fs = std::filesystem;

const fs::path kReferences = fs::path(OFFING_TEST_DATA) / "golden" / "references";
const fs::path kOutput = fs::path(OFFING_TEST_OUTPUT) / "golden";

// Two pictures of one view count as the same up to these.
constexpr double kMean = 0.02;
constexpr double kPercentile99 = 0.25;

bool same(const FlipResult& flip) {
  return flip.mean < kMean && flip.percentile_99 < kPercentile99;
}

std::string numbers_of(const FlipResult& flip) {
  return fmt::format("FLIP mean {:.4f} (below {}), 99th percentile {:.4f} (below {}), max {:.4f}",
                     flip.mean, kMean, flip.percentile_99, kPercentile99, flip.maximum);
}

fs::path reference_file(const View& view) { return kReferences / (view.name + ".png"); }

bool updating() {
  const char* value = std::getenv("OFFING_UPDATE_GOLDEN");
  return value != nullptr && std::string(value) == "1";
}

struct Golden : testing::TestWithParam<View> {
  void SetUp() override {
    if (!reads_pictures()) GTEST_SKIP() << "this build has no OpenImageIO";
  }
};

std::string name_of(const testing::TestParamInfo<View>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Views, Golden, testing::ValuesIn(views()), name_of);

// As the file holds it: references are 8 bit.
Image as_written(const Image& image, const fs::path& file) {
  write_image(file, image);
  return read_image(file);
}

TEST_P(Golden, LooksAsItsReferenceDoes) {
  const View& view = GetParam();
  fs::create_directories(kOutput);
  const fs::path picture_file = kOutput / (view.name + ".png");
  Image picture;
  try {
    picture = as_written(render_view(view), picture_file);
  } catch (const InputError& error) {
    GTEST_SKIP() << error.what();
  }
  if (updating()) {
    write_image(reference_file(view), picture);
    GTEST_SKIP() << "rewrote " << reference_file(view).string() << "; look at it";
  }
  ASSERT_TRUE(fs::exists(reference_file(view)))
      << reference_file(view).string() << " is missing; look at " << picture_file.string()
      << ", and if it is good run this test with OFFING_UPDATE_GOLDEN=1";
  const Image reference = read_image(reference_file(view));
  const FlipResult flip = flip_ldr(reference, picture);
  RecordProperty("flip", numbers_of(flip));
  if (same(flip)) {
    fs::remove(picture_file);
    return;
  }
  write_image(kOutput / (view.name + ".reference.png"), reference);
  write_image(kOutput / (view.name + ".error.png"), flip.error_map);
  ADD_FAILURE() << view.name << ": " << numbers_of(flip) << "\nlook at " << kOutput.string() << "/"
                << view.name << "{,.reference,.error}.png\nmade by: " << command_of(view);
}

}  // namespace
}  // namespace offing::test
