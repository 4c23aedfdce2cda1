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
#include "engine/platform/headless_context.h"
#include "engine/post/flip.h"
#include "golden/views.h"
#include "support/paths.h"

namespace offing::test {
namespace {
namespace fs = std::filesystem;

const fs::path kReferences = test::test_data() / "golden" / "references";
const fs::path kOutput = test::test_output() / "golden";

// Two pictures of one view count as the same up to these. The same binary and driver give 0. Other
// compilers and drivers round otherwise: a boat and wind whose speeds are 10⁻⁶ off give a mean of
// 0.0002 and a 99th percentile of 0.004; outlines that fall otherwise by a twentieth of a pixel
// (0.02° more field of view), 0.009 and 0.05. Twice and three times that is let through. Each
// of the faults that the tests below make gives a mean of 0.026 or more, or a percentile of 0.48.
constexpr double kMean = 0.02;
constexpr double kPercentile99 = 0.15;

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

// Empty where pictures can be drawn and compared. Whatever else goes wrong is a failure.
const std::string& obstacle() {
  static const std::string kObstacle = []() -> std::string {
    if (!reads_pictures()) return "this build has no OpenImageIO";
    try {
      const HeadlessContext context;
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }();
  return kObstacle;
}

struct Golden : testing::TestWithParam<View> {
  void SetUp() override {
    if (!obstacle().empty()) GTEST_SKIP() << obstacle();
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
  const Image picture = as_written(render_view(view), picture_file);
  if (updating()) {
    write_image(reference_file(view), picture);
    GTEST_SKIP() << "rewrote " << reference_file(view).string() << "; look at it";
  }
  ASSERT_TRUE(fs::exists(reference_file(view)))
      << reference_file(view).string() << " is missing; look at " << picture_file.string()
      << ", and if it is good run this test with OFFING_UPDATE_GOLDEN=1";
  const Image reference = read_image(reference_file(view));
  const FlipResult flip = flip_ldr(reference, picture);
  RecordProperty("FLIP", numbers_of(flip));
  if (same(flip)) {
    fs::remove(picture_file);
    return;
  }
  write_image(kOutput / (view.name + ".reference.png"), reference);
  write_image(kOutput / (view.name + ".error.png"), flip.error_map);
  ADD_FAILURE() << view.name << ": " << numbers_of(flip) << "\nlook at " << kOutput.string() << "/"
                << view.name << "{,.reference,.error}.png\nmade by: " << command_of(view);
}

// ---- what the tolerances are worth --------------------------------------------------------------

// Each pixel of the result from the picture and a place in it.
Image changed(const Image& image, const std::function<float(int x, int y, int channel)>& value) {
  Image result = image;
  std::size_t i = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < image.channels; ++c) result.pixels[i++] = value(x, y, c);
    }
  }
  return result;
}

// A fault in any view would be caught, as far as damage to its reference can stand for one.
TEST_P(Golden, ADamagedPictureIsNotTheSame) {
  const Image reference = read_image(reference_file(GetParam()));
  const auto at = [&](int x, int y, int c) {
    x = std::clamp(x, 0, reference.width - 1);
    y = std::clamp(y, 0, reference.height - 1);
    return reference
        .pixels[static_cast<std::size_t>((y * reference.width + x) * reference.channels + c)];
  };
  ASSERT_TRUE(same(flip_ldr(reference, reference)));
  std::mt19937 random(7);
  const struct {
    const char* what;
    std::function<float(int, int, int)> value;
  } damages[] = {
      {"two pixels to the right", [&](int x, int y, int c) { return at(x - 2, y, c); }},
      {"one pixel down", [&](int x, int y, int c) { return at(x, y - 1, c); }},
      {"a twentieth brighter", [&](int x, int y, int c) { return 1.05f * at(x, y, c); }},
      {"a twentieth less blue",
       [&](int x, int y, int c) { return (c == 2 ? 0.95f : 1.0f) * at(x, y, c); }},
      {"noisy",
       [&](int x, int y, int c) {
         return at(x, y, c) + (static_cast<float>(random()) / 4294967296.0f - 0.5f) * 0.1f;
       }},
      {"mirrored", [&](int x, int y, int c) { return at(reference.width - 1 - x, y, c); }},
      {"a hole in the middle", [&](int x, int y, int c) {
         const bool hole =
             std::abs(x - reference.width / 2) < 12 && std::abs(y - reference.height / 2) < 12;
         return hole ? 0.0f : at(x, y, c);
       }}};
  for (const auto& damage : damages) {
    const FlipResult flip = flip_ldr(reference, changed(reference, damage.value));
    RecordProperty(damage.what, numbers_of(flip));
    EXPECT_FALSE(same(flip)) << damage.what << ": " << numbers_of(flip);
  }
}

// And so would a scene that is not quite the one asked for.
TEST(GoldenScene, AnotherSceneIsNotTheSame) {
  if (!obstacle().empty()) GTEST_SKIP() << obstacle();
  View view = views().front();
  const Image reference = read_image(reference_file(view));
  for (const char* set :
       {"seed=2", "environment.wind.from=50", "environment.time=16:35:00", "camera.fov=55.5"}) {
    view.sets = {set};
    const FlipResult flip = flip_ldr(reference, render_view(view));
    RecordProperty(set, numbers_of(flip));
    EXPECT_FALSE(same(flip)) << set << ": " << numbers_of(flip);
  }
}

}  // namespace
}  // namespace offing::test
