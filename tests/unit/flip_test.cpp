#include "engine/post/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/error.h"
#include "support/paths.h"

namespace offing {
namespace {

Image plain(float red, float green, float blue, int width = 24, int height = 16) {
  Image image{width, height, 3, {}};
  for (int i = 0; i < width * height; ++i) {
    image.pixels.insert(image.pixels.end(), {red, green, blue});
  }
  return image;
}

Image grey(float value) { return plain(value, value, value); }

float& at(Image& image, int x, int y, int c) {
  return image.pixels[static_cast<std::size_t>((y * image.width + x) * image.channels + c)];
}

// Coloured waves, with a picture of the same waves a little later for `shift` > 0.
Image waves(double shift, int width = 40, int height = 28) {
  Image image{width, height, 3, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) {
        image.pixels.push_back(
            static_cast<float>(0.5 + 0.4 * std::sin(0.7 * (x + shift) + 0.31 * y * (c + 1))));
      }
    }
  }
  return image;
}

Image mirrored(const Image& image) {
  Image result = image;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < image.channels; ++c) {
        at(result, image.width - 1 - x, y, c) =
            image.pixels[static_cast<std::size_t>((y * image.width + x) * image.channels + c)];
      }
    }
  }
  return result;
}

Image transposed(const Image& image) {
  Image result{image.height, image.width, image.channels, image.pixels};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < image.channels; ++c) {
        at(result, y, x, c) =
            image.pixels[static_cast<std::size_t>((y * image.width + x) * image.channels + c)];
      }
    }
  }
  return result;
}

void expect_near(const Image& a, const Image& b, double tolerance) {
  ASSERT_EQ(a.width, b.width);
  ASSERT_EQ(a.height, b.height);
  ASSERT_EQ(a.pixels.size(), b.pixels.size());
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    ASSERT_NEAR(a.pixels[i], b.pixels[i], tolerance) << "value " << i;
  }
}

// ---- against its authors' programme -------------------------------------------------------------

struct Published : testing::Test {
  void SetUp() override {
    if (!reads_pictures()) GTEST_SKIP() << "this build has no OpenImageIO";
  }
  static Image picture(const std::string& name) {
    return read_image(test::test_data() / "data/flip" / name);
  }
  // Half a thousandth: what two implementations differ by in single precision, with room.
  static void expect(const FlipResult& result, double mean, double median, double maximum) {
    EXPECT_NEAR(result.mean, mean, 5e-4);
    EXPECT_NEAR(result.weighted_median, median, 5e-4);
    EXPECT_NEAR(result.maximum, maximum, 5e-4);
  }
};

TEST_F(Published, Noise) {
  expect(flip_ldr(picture("reference.png"), picture("noise.png")), 0.102945, 0.115548, 0.392755);
}

TEST_F(Published, Shift) {
  expect(flip_ldr(picture("reference.png"), picture("shift.png")), 0.049345, 0.082450, 0.589675);
}

TEST_F(Published, HighDynamicRange) {
  const Image reference = picture("hdr_reference.exr");
  const FlipExposures exposures = flip_exposures(reference);
  EXPECT_NEAR(exposures.start, -5.1394, 5e-4);
  EXPECT_NEAR(exposures.stop, 1.1998, 5e-4);
  EXPECT_EQ(exposures.count, 7);
  expect(flip_hdr(reference, picture("hdr_noise.exr")), 0.072842, 0.079884, 0.230109);
}

// ---- closed forms -------------------------------------------------------------------------------

// Filters and detectors leave a plain picture alone: what remains is the colour difference.
// Two greys differ by their lightnesses, and 0.4 of the scale is green against blue.
TEST(Flip, PlainGreysDifferByTheirLightness) {
  // CIELAB of sRGB's green and blue under D65, from published tables.
  const double green[] = {87.735, -86.183, 83.179}, blue[] = {32.297, 79.188, -107.860};
  const double chroma = std::hypot(0.01 * (green[0] * green[1] - blue[0] * blue[1]),
                                   0.01 * (green[0] * green[2] - blue[0] * blue[2]));
  const double largest = std::pow(green[0] - blue[0] + chroma, 0.7);
  const auto expected = [&](double lightness) {
    const double error = std::pow(lightness, 0.7) / largest;
    return error < 0.4 ? error * 0.95 / 0.4 : 0.95 + (error - 0.4) / 0.6 * 0.05;
  };
  // sRGB 119/255 is L* = 50.03, 188/255 is L* = 76.2; below 0.008856 L* = 903.3 Y.
  const double dark = 903.2963 * (5.0 / 255.0) / 12.92;
  EXPECT_NEAR(flip_ldr(grey(0.0f), grey(1.0f)).mean, expected(100.0), 1e-4);
  EXPECT_NEAR(flip_ldr(grey(0.0f), grey(119.0f / 255.0f)).mean, expected(50.034), 1e-4);
  EXPECT_NEAR(flip_ldr(grey(0.0f), grey(5.0f / 255.0f)).mean, expected(dark), 1e-4);
  EXPECT_NEAR(flip_ldr(plain(0.0f, 1.0f, 0.0f), plain(0.0f, 0.0f, 1.0f)).mean, 1.0, 1e-6);
}

TEST(Flip, IdenticalPicturesDoNotDiffer) {
  const FlipResult ldr = flip_ldr(waves(0.0), waves(0.0));
  const FlipResult hdr = flip_hdr(waves(0.0), waves(0.0));
  for (const FlipResult& result : {ldr, hdr}) {
    EXPECT_EQ(result.error_map.width, 40);
    EXPECT_EQ(result.error_map.height, 28);
    EXPECT_EQ(result.error_map.channels, 1);
    EXPECT_EQ(result.error_map.pixels, std::vector<float>(40 * 28));
    EXPECT_EQ(result.mean, 0.0);
    EXPECT_EQ(result.weighted_median, 0.0);
    EXPECT_EQ(result.percentile_99, 0.0);
    EXPECT_EQ(result.maximum, 0.0);
  }
}

TEST(Flip, ItDoesNotMatterWhichPictureIsFirst) {
  expect_near(flip_ldr(waves(0.0), waves(0.8)).error_map,
              flip_ldr(waves(0.8), waves(0.0)).error_map, 0.0);
}

TEST(Flip, ItDoesNotMatterHowThePicturesLie) {
  const Image a = waves(0.0), b = waves(0.8);
  const Image map = flip_ldr(a, b).error_map;
  EXPECT_GT(*std::max_element(map.pixels.begin(), map.pixels.end()), 0.05f);
  expect_near(flip_ldr(mirrored(a), mirrored(b)).error_map, mirrored(map), 1e-6);
  expect_near(flip_ldr(transposed(a), transposed(b)).error_map, transposed(map), 1e-6);
}

TEST(Flip, MoreDifferenceIsMoreError) {
  double last = 0.0;
  for (const float step : {0.01f, 0.03f, 0.1f, 0.3f, 0.6f}) {
    const double mean = flip_ldr(plain(0.2f, 0.3f, 0.4f), plain(0.2f + step, 0.3f, 0.4f)).mean;
    EXPECT_GT(mean, last) << step;
    EXPECT_LT(mean, 1.0) << step;
    last = mean;
  }
}

TEST(Flip, ADotIsSeenWhereItIsAndLessFromFarOff) {
  const Image without = plain(0.3f, 0.3f, 0.3f, 41, 31);
  Image with = without;
  for (int c = 0; c < 3; ++c) at(with, 12, 20, c) = 1.0f;
  double last = 1.0;
  for (const double pixels_per_degree : {20.0, 67.0, 200.0}) {
    FlipResult result = flip_ldr(without, with, pixels_per_degree);
    EXPECT_LT(result.maximum, last) << pixels_per_degree;
    last = result.maximum;
  }
  FlipResult result = flip_ldr(without, with, 20.0);
  const auto& map = result.error_map.pixels;
  const auto worst = std::max_element(map.begin(), map.end()) - map.begin();
  EXPECT_LE(std::abs(worst % 41 - 12), 1);
  EXPECT_LE(std::abs(worst / 41 - 20), 1);
  EXPECT_EQ(at(result.error_map, 40, 0, 0), 0.0f);
}

// As the definitions say, counted on the map that comes with them.
TEST(Flip, NumbersAreThoseOfTheMap) {
  const FlipResult result = flip_ldr(waves(0.0), waves(0.6));
  const auto& map = result.error_map.pixels;
  double sum = 0.0, below = 0.0, up_to = 0.0;
  std::size_t over = 0, at_least = 0;
  for (const float value : map) {
    const double error = static_cast<double>(value);
    sum += error;
    if (error < result.weighted_median - 1e-6) below += error;
    if (error < result.weighted_median + 1e-6) up_to += error;
    over += error > result.percentile_99 + 1e-6;
    at_least += error > result.percentile_99 - 1e-6;
  }
  EXPECT_NEAR(result.mean, sum / static_cast<double>(map.size()), 1e-7);
  EXPECT_NEAR(result.maximum, static_cast<double>(*std::max_element(map.begin(), map.end())), 1e-7);
  EXPECT_LE(below, 0.5 * sum);
  EXPECT_GE(up_to, 0.5 * sum);
  EXPECT_LE(over * 100, map.size());
  EXPECT_GE(at_least * 100, map.size());
}

TEST(Flip, AlphaAndTheOrderOfChannelsDoNotCount) {
  Image bgr = waves(0.8);
  bgr.channel_names = {"B", "G", "R"};
  Image rgba{bgr.width, bgr.height, 4, {}};
  for (std::size_t i = 0; i < bgr.pixels.size(); i += 3) {
    std::swap(bgr.pixels[i], bgr.pixels[i + 2]);
    rgba.pixels.insert(rgba.pixels.end(), {bgr.pixels[i + 2], bgr.pixels[i + 1], bgr.pixels[i],
                                           static_cast<float>(i % 2)});
  }
  const FlipResult expected = flip_ldr(waves(0.0), waves(0.8));
  expect_near(flip_ldr(waves(0.0), bgr).error_map, expected.error_map, 0.0);
  expect_near(flip_ldr(waves(0.0), rgba).error_map, expected.error_map, 0.0);
}

// ---- high dynamic range -------------------------------------------------------------------------

TEST(FlipHdr, ExposuresSpanFromTheBrightestToTheMedian) {
  Image image = plain(0.25f, 0.25f, 0.25f);
  for (int c = 0; c < 3; ++c) at(image, 3, 3, c) = 20.0f;
  const FlipExposures exposures = flip_exposures(image);
  EXPECT_NEAR(exposures.stop - exposures.start, std::log2(80.0), 1e-9);
  EXPECT_EQ(exposures.count, 7);
  // K. Narkowicz's curve as he printed it, for 0.6 of the light.
  const double light = 0.6 * 20.0 * std::exp2(exposures.start);
  EXPECT_NEAR(light * (2.51 * light + 0.03) / (light * (2.43 * light + 0.59) + 0.14), 0.85, 1e-9);

  EXPECT_EQ(flip_exposures(plain(3.0f, 3.0f, 3.0f)).count, 2);
}

TEST(FlipHdr, AMostlyBlackPictureHasExposuresToo) {
  Image image = grey(0.0f);
  at(image, 3, 3, 1) = 5.0f;
  const FlipExposures exposures = flip_exposures(image);
  EXPECT_NEAR(exposures.stop - exposures.start, 16.0, 1e-9);
  EXPECT_EQ(exposures.count, 16);
  Image none = image;
  at(none, 3, 3, 1) = 0.0f;
  EXPECT_GT(flip_hdr(image, none).maximum, 0.1);
}

TEST(FlipHdr, BrighterLightsAllOverChangeNothing) {
  Image a = waves(0.0), b = waves(0.8);
  const FlipResult expected = flip_hdr(a, b);
  for (Image* image : {&a, &b}) {
    for (float& value : image->pixels) value *= 1024.0f;
  }
  EXPECT_NEAR(flip_exposures(a).start, flip_exposures(waves(0.0)).start - 10.0, 1e-9);
  expect_near(flip_hdr(a, b).error_map, expected.error_map, 1e-6);
}

// A difference that only a short exposure shows: in a highlight, and only a long one: in the dark.
TEST(FlipHdr, FindsWhatOneExposureHides) {
  const FlipExposures shorter{-8.0, -7.0, 2}, longer{7.0, 8.0, 2}, all{-8.0, 8.0, 17};
  for (const float light : {100.0f, 0.002f}) {
    const Image a = grey(light), b = grey(light * 1.5f);
    const double seen = flip_hdr(a, b, light > 1.0f ? shorter : longer).maximum;
    EXPECT_GT(seen, 0.1) << light;
    EXPECT_LT(flip_hdr(a, b, light > 1.0f ? longer : shorter).maximum, 0.02) << light;
    EXPECT_GE(flip_hdr(a, b, all).maximum, seen) << light;
  }
}

TEST(FlipHdr, NegativeLightCountsAsNone) {
  Image a = waves(0.0), negative = waves(0.8), none = waves(0.8);
  at(negative, 5, 5, 0) = -7.0f;
  at(none, 5, 5, 0) = 0.0f;
  expect_near(flip_hdr(a, negative).error_map, flip_hdr(a, none).error_map, 0.0);
}

// ---- what is refused ----------------------------------------------------------------------------

template <class Function>
std::string refusal(Function&& function) {
  try {
    function();
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find("FLIP: "), 0u) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
  }
  return "not refused";
}

void expect_refused(const Image& reference, const Image& test, const std::string& why) {
  for (const std::string& message :
       {refusal([&] { flip_ldr(reference, test); }), refusal([&] { flip_hdr(reference, test); })}) {
    EXPECT_NE(message.find(why), std::string::npos) << message;
  }
}

TEST(FlipInput, PicturesOfDifferentSizesAreRefused) {
  expect_refused(waves(0, 40, 28), waves(0, 28, 40), "40x28 and a test of 28x40");
  expect_refused(waves(0, 40, 28), waves(0, 40, 27), "one size");
}

TEST(FlipInput, ValuesThatAreNotFiniteAreRefused) {
  for (const float value :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
        -std::numeric_limits<float>::infinity()}) {
    Image bad = waves(0.0);
    at(bad, 7, 9, 2) = value;
    expect_refused(bad, waves(0.0), "the reference picture is not finite at x = 7, y = 9");
    expect_refused(waves(0.0), bad, "the test picture is not finite at x = 7, y = 9");
  }
}

TEST(FlipInput, PicturesThatAreNotWholeAreRefused) {
  Image cut = waves(0.0);
  cut.pixels.pop_back();
  expect_refused(cut, waves(0.0), "give a whole one");
  expect_refused(Image{}, Image{}, "give a whole one");
  const Image depth{8, 8, 1, std::vector<float>(64)};
  expect_refused(depth, depth, "has 1 channels");
  Image unnamed = waves(0.0);
  unnamed.channel_names = {"X", "Y", "Z"};
  expect_refused(waves(0.0), unnamed, "R, G and B");
}

TEST(FlipInput, SightAndExposuresThatMakeNoSenseAreRefused) {
  const Image a = waves(0.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double sight : {0.0, -1.0, 1001.0, nan}) {
    EXPECT_NE(refusal([&] { flip_ldr(a, a, sight); }).find("per degree"), std::string::npos);
    EXPECT_NE(refusal([&] { flip_hdr(a, a, sight); }).find("per degree"), std::string::npos);
  }
  for (const FlipExposures& exposures :
       {FlipExposures{0.0, 1.0, 1}, FlipExposures{1.0, 0.0, 2}, FlipExposures{nan, 0.0, 2},
        FlipExposures{0.0, 1.0, 1001}, FlipExposures{0.0, 101.0, 2}}) {
    EXPECT_NE(refusal([&] { flip_hdr(a, a, exposures); }).find("exposures"), std::string::npos);
  }
  EXPECT_NE(refusal([&] { flip_hdr(grey(0.0f), grey(1.0f)); }).find("black"), std::string::npos);
}

}  // namespace
}  // namespace offing
