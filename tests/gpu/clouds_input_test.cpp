// What is given to the clouds from outside: weather pictures, the noise that was kept, and
// parameters at their limits.
#include <glm/vec4.hpp>

#include <cmath>
#include <fstream>

#include "engine/clouds/cloud_field.h"
#include "engine/clouds/noise_cache.h"
#include "engine/core/error.h"
#include "engine/io/file.h"
#include "engine/io/image.h"
#include "support/graph_test.h"
#include "support/scratch_folder.h"
#include "unit/png_bytes.h"

namespace offing {
namespace {
namespace fs = std::filesystem;

class CloudInputTest : public test::GraphTest {
 protected:
  std::string keep(const std::string& name, const std::string& bytes) const {
    write_text(folder_ / name, bytes);
    return (folder_ / name).string();
  }

  const test::ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
};

class WeatherPictureTest : public CloudInputTest {
 protected:
  /// The mean of the weather's four channels with this picture (none where empty).
  glm::dvec4 weather(const std::string& picture) {
    WeatherMap map(*shaders_);
    const gl::Texture patterns("patterns", {.format = GL_RGBA8, .width = 1, .height = 1});
    const unsigned char grey[4] = {128, 128, 128, 128};
    patterns.upload(GL_RGBA, GL_UNSIGNED_BYTE, grey);
    CloudParameters parameters;
    parameters.weather_picture = picture;
    std::vector<float> texels;
    graph_->begin_frame();
    const WeatherMap::Ids ids =
        map.add(*graph_, graph_->import(patterns), {.cover = 0.5, .type = 0.9}, 0.0, parameters, 1);
    graph_->add(
        "read", [&](PassBuilder& pass) { pass.read(ids.weather).side_effect(); },
        [&](PassContext& context) { texels = context.texture(ids.weather).read_floats(4); });
    graph_->execute();
    glm::dvec4 sum(0.0);
    for (std::size_t i = 0; i < texels.size(); i += 4)
      sum += glm::dvec4(texels[i], texels[i + 1], texels[i + 2], texels[i + 3]);
    return sum * (4.0 / static_cast<double>(texels.size()));
  }
  std::string refusal(const std::string& picture) {
    try {
      weather(picture);
    } catch (const InputError& error) {
      return error.what();
    }
    return "not refused";
  }
};

TEST_F(WeatherPictureTest, OfAnySizeAndNumberOfChannelsIsTakenForWhatItHas) {
  if (!reads_pictures()) GTEST_SKIP() << "this build has no OpenImageIO";
  const glm::dvec4 made = weather("");
  const double values[4] = {0.25, 0.4, 0.75, 0.6};
  for (const int bits : {8, 16}) {
    for (int channels = 1; channels <= 4; ++channels) {
      for (const auto& [width, height] : {std::pair(1, 1), {7, 5}, {3, 64}}) {
        std::string rows;
        for (int i = 0; i < width * height * channels; ++i) {
          const int most = bits == 8 ? 255 : 65535;
          const int value = static_cast<int>(std::lround(most * values[i % channels]));
          if (bits == 16) rows += static_cast<char>(value >> 8);
          rows += static_cast<char>(value & 0xff);
        }
        const glm::dvec4 seen = weather(keep(
            "any.png", PngBytes::make(static_cast<std::uint32_t>(width),
                                      static_cast<std::uint32_t>(height), channels, rows, bits)));
        for (int c = 0; c < 4; ++c) {
          EXPECT_NEAR(seen[c], c < channels ? values[c] : made[c], 0.004)
              << bits << " bits, " << channels << " channels, " << width << "x" << height
              << ", channel " << c;
        }
      }
    }
  }
}

TEST_F(WeatherPictureTest, AnythingElseIsRefusedInOneLine) {
  if (!reads_pictures()) GTEST_SKIP() << "this build has no OpenImageIO";
  const std::string whole = PngBytes::make(16, 16, 3, std::string(768, 'x'));
  const std::pair<std::string, const char*> refused[] = {
      {(folder_ / "nowhere.png").string(), "no such file"},
      {folder_.string(), "is no file with a picture"},
      {keep("text.png", "no picture at all"), "cannot be read"},
      {keep("empty.png", ""), "cannot be read"},
      {keep("short.png", whole.substr(0, whole.size() / 2)), "cannot be read"},
      {keep("wide.png", PngBytes::make(4097, 1, 3, std::string(4097 * 3, 'x'))),
       "4097x1 pixels; keep to 4096"}};
  for (const auto& [file, why] : refused) {
    const std::string message = refusal(file);
    EXPECT_EQ(message.find("clouds.weather_picture = " + file), 0u) << message;
    EXPECT_NE(message.find(why), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

class KeptNoiseTest : public CloudInputTest {
 protected:
  std::vector<float> shape(const fs::path& file) {
    CloudNoise noise(*shaders_);
    noise.set_cache_file(file);
    std::vector<float> values;
    graph_->begin_frame();
    const CloudNoise::Ids ids = noise.add(*graph_, CloudParameters{});
    graph_->add(
        "read", [&](PassBuilder& pass) { pass.read(ids.shape).side_effect(); },
        [&](PassContext& context) { values = context.texture(ids.shape).read_floats(1); });
    graph_->execute();
    return values;
  }
};

// Which files are refused, and with which word: unit/noise_cache_test.cpp.
TEST_F(KeptNoiseTest, ThatIsCutShortIsMadeAgainWithAWord) {
  const fs::path file = keep("clouds.noise", "OFFNOISE, but little else");
  ::testing::internal::CaptureStderr();
  const std::vector<float> made = shape(file);
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("clouds.noise is cut short: made again"), std::string::npos) << said;
  EXPECT_GT(fs::file_size(file), 8u * 1000 * 1000) << "kept whole";
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(shape(file), made);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace offing
