#include "engine/io/image.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "engine/core/error.h"
#include "engine/io/file.h"
#include "engine/io/pfm.h"
#include "support/scratch_folder.h"
#include "unit/png_bytes.h"

namespace offing {
namespace {
namespace fs = std::filesystem;

Image gradient(int width, int height, int channels) {
  Image image{width, height, channels, {}};
  for (int i = 0; i < width * height * channels; ++i) {
    image.pixels.push_back(static_cast<float>(i) / 7.0f - 3.0f);
  }
  return image;
}

struct Pictures : testing::Test {
  std::string reading_of(const fs::path& file) {
    try {
      read_image(file);
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find(file.string()), 0u) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_LT(message.size(), file.string().size() + 300) << message;
      return message;
    }
    return "";
  }
  std::string reading_of_bytes(const std::string& name, const std::string& bytes) {
    write_text(folder / name, bytes);
    return reading_of(folder / name);
  }

  const test::ScratchFolder scratch;
  const fs::path folder = scratch.path();
};

struct OpenImageIO : Pictures {
  void SetUp() override {
    if (!reads_pictures()) GTEST_SKIP() << "this build has no OpenImageIO";
  }
};

// What the OpenEXR file layout says: magic, version, then attributes "name\0type\0size data" until
// an empty name; "channels" is a list of "name\0" and 16 bytes (pixel type: 2 is float).
struct ExrHeader {
  explicit ExrHeader(const std::string& bytes) {
    std::size_t at = 8;
    const auto word = [&] {
      std::string text = bytes.c_str() + at;
      at += text.size() + 1;
      return text;
    };
    while (at < bytes.size()) {
      const std::string name = word();
      if (name.empty()) return;
      const std::string type = word();
      std::int32_t size = 0;
      std::memcpy(&size, bytes.data() + at, 4);
      at += 4;
      const std::size_t end = at + static_cast<std::size_t>(size);
      if (type == "float") std::memcpy(&numbers[name], bytes.data() + at, 4);
      while (type == "chlist" && at < end - 1) {
        const std::string channel = word();
        channels.push_back(channel + (bytes[at] == 2 ? "" : " is no float"));
        at += 16;
      }
      at = end;
    }
  }
  std::vector<std::string> channels;
  std::map<std::string, float> numbers;
};

TEST_F(Pictures, PfmComesBackExactly) {
  for (const int channels : {1, 3}) {
    Image image = gradient(5, 3, channels);
    image.pixels[4] = std::numeric_limits<float>::quiet_NaN();
    image.pixels[5] = 1e30f;
    write_image(folder / "a.pfm", image);
    const Image back = read_image(folder / "a.pfm");
    EXPECT_EQ(back.width, 5);
    EXPECT_EQ(back.height, 3);
    ASSERT_EQ(back.channels, channels);
    EXPECT_EQ(std::memcmp(back.pixels.data(), image.pixels.data(), image.pixels.size() * 4), 0);
  }
}

TEST_F(Pictures, PfmBytesAreAsTheFormatSays) {
  // Two rows of one value: the bottom row comes first; 1.0f is 0x3f800000, 2.0f 0x40000000.
  const std::string little("Pf\n1 2\n-1.0\n\x00\x00\x00\x40\x00\x00\x80\x3f", 20);
  const std::string big("Pf 1\t2\r1.0\n\x40\x00\x00\x00\x3f\x80\x00\x00", 19);
  EXPECT_EQ(encode_pfm(Image{1, 2, 1, {1.0f, 2.0f}}), little);
  EXPECT_EQ(decode_pfm(little, "a").pixels, (std::vector{1.0f, 2.0f}));
  EXPECT_EQ(decode_pfm(big, "a").pixels, (std::vector{1.0f, 2.0f}));
}

TEST_F(Pictures, BadPfmIsRefused) {
  const std::string good = encode_pfm(gradient(3, 2, 3));
  for (std::size_t size = 0; size < good.size(); ++size) {
    EXPECT_NE(reading_of_bytes("cut.pfm", good.substr(0, size)), "") << size;
  }
  for (const char* bytes :
       {"P6\n1 1\n-1.0\nxxxx", "PF\n0 1\n-1.0\n", "PF\n-1 -1\n-1.0\n", "Pf\n1 1\nnan\nxxxx",
        "Pf\n1 1\n0\nxxxx", "PF\n99999 99999\n-1\nxxxx", "PF\n16384 16384\n-1\nxxxx",
        "PF\n4294967297 1\n-1\nxxxx", "Pf\n1 1\n-1\nxxxxx", "PF\n1x 1\n-1\nxxxxxxxxxxxx"}) {
    EXPECT_NE(reading_of_bytes("bad.pfm", bytes), "") << bytes;
  }
}

TEST_F(Pictures, WhatIsNoFileIsRefused) {
  for (const char* name : {"none.png", "none.pfm"}) {
    EXPECT_EQ(reading_of(folder / name),
              (folder / name).string() + ": cannot be read: no such file; check the path");
  }
  EXPECT_NE(reading_of(folder), "");
  EXPECT_NE(reading_of("/dev/null"), "");
}

TEST_F(Pictures, NamesAreCheckedBeforeTheWork) {
  const Image image = gradient(2, 2, 3);
  for (const fs::path& file :
       {folder / "a.gif", folder / "a", folder / "no" / "a.png", fs::path()}) {
    EXPECT_THROW(check_image_name(file), InputError) << file;
    EXPECT_THROW(write_image(file, image), InputError) << file;
  }
  check_image_name("a.png");
  check_image_name(folder / "A.EXR");
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(Pictures, APictureThatDoesNotFitItsSizesIsNotWritten) {
  Image image = gradient(2, 2, 3);
  EXPECT_THROW(write_image(folder / "a.pfm", image, {"only one name"}), Error);
  image.pixels.pop_back();
  EXPECT_THROW(write_image(folder / "a.pfm", image), Error);
  EXPECT_THROW(write_image(folder / "a.pfm", Image{}), Error);
  EXPECT_THROW(write_image(folder / "a.pfm", gradient(2, 2, 2)), InputError);
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(Pictures, AFullDiskFails) {
  if (!fs::is_character_file("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  for (const char* name : {"a.pfm", "a.png", "a.exr"}) {
    if (!reads_pictures() && std::string_view(name) != "a.pfm") continue;
    fs::create_symlink("/dev/full", folder / name);
    try {
      write_image(folder / name, gradient(2, 2, 3));
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::kFailed) << error.what();
    }
  }
}

TEST_F(Pictures, ABuildWithoutOpenImageIOWritesPfmInstead) {
  if (reads_pictures()) GTEST_SKIP() << "this build has OpenImageIO";
  write_image(folder / "a.png", gradient(3, 2, 3));
  EXPECT_EQ(read_image(folder / "a.pfm").pixels, gradient(3, 2, 3).pixels);
  const Image many = gradient(3, 2, 5);
  write_image(folder / "b.exr", many, {"dx", "dy", "dz", "slope_x", "jacobian"});
  EXPECT_EQ(read_image(folder / "b.jacobian.pfm").pixels[2], many.pixels[14]);
  write_text(folder / "c.png", "");
  EXPECT_NE(reading_of(folder / "c.png").find("no OpenImageIO"), std::string::npos);
  EXPECT_THROW(decode_image({}, "c"), InputError);
}

TEST_F(OpenImageIO, ReadsAPngMadeByHand) {
  const std::string rows("\x00\x80\xff\x10\x20\x30\xff\xff\xff\x01\x02\x03", 12);
  write_text(folder / "a.png", PngBytes::make(2, 2, 3, rows));
  const Image image = read_image(folder / "a.png");
  ASSERT_EQ(image.channels, 3);
  ASSERT_EQ(image.pixels.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_FLOAT_EQ(image.pixels[i], static_cast<unsigned char>(rows[i]) / 255.0f) << i;
  }
}

TEST_F(OpenImageIO, AlphaIsNotMultipliedIn) {
  const std::string bytes = PngBytes::make(1, 1, 4, "\x40\x80\xff\x20");
  const Image image = decode_image(
      std::span(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()), "here");
  ASSERT_EQ(image.pixels.size(), 4u);
  EXPECT_FLOAT_EQ(image.pixels[0], 64.0f / 255.0f);
  EXPECT_FLOAT_EQ(image.pixels[3], 32.0f / 255.0f);
  write_image(folder / "b.png", image);
  EXPECT_EQ(read_image(folder / "b.png").pixels, image.pixels);
}

TEST_F(OpenImageIO, PngRoundsClampsAndIsEightBit) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  write_image(folder / "a.png",
              Image{3, 2, 1, {-1.0f, 2.0f, 0.5f, nan, 100.4f / 255.0f, 100.6f / 255.0f}});
  const std::string bytes = read_text(folder / "a.png");
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(bytes.substr(16, 10), std::string("\0\0\0\3\0\0\0\2\x08\x00", 10));
  const std::vector<float> expected{0, 255, 128, 0, 100, 101};
  const Image image = read_image(folder / "a.png");
  ASSERT_EQ(image.pixels.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_FLOAT_EQ(image.pixels[i] * 255.0f, expected[i]) << i;
}

TEST_F(OpenImageIO, ExrHasOneNamedChannelEachAndItsNumbers) {
  const std::vector<std::string> names{"dx", "dy", "dz", "slope_x", "slope_z", "jacobian"};
  const Image image = gradient(7, 4, 6);
  write_image(folder / "c0.exr", image, names, {{"length_m", 250.5}, {"time_s", 1e6}});
  const ExrHeader header(read_text(folder / "c0.exr"));
  EXPECT_EQ(header.channels,
            (std::vector<std::string>{"dx", "dy", "dz", "jacobian", "slope_x", "slope_z"}));
  ASSERT_TRUE(header.numbers.count("length_m"));
  EXPECT_EQ(header.numbers.at("length_m"), 250.5f);
  EXPECT_EQ(header.numbers.at("time_s"), 1e6f);

  const Image back = read_image(folder / "c0.exr");
  ASSERT_EQ(back.channel_names.size(), 6u);
  ASSERT_EQ(back.pixels.size(), image.pixels.size());
  for (std::size_t c = 0; c < 6; ++c) {
    const auto from = std::find(names.begin(), names.end(), back.channel_names[c]) - names.begin();
    ASSERT_LT(from, 6) << back.channel_names[c];
    for (std::size_t i = 0; i < 28; ++i) {
      EXPECT_EQ(back.pixels[i * 6 + c], image.pixels[i * 6 + static_cast<std::size_t>(from)]);
    }
  }
}

TEST_F(OpenImageIO, ExrKeepsRgbInOrder) {
  const Image image = gradient(3, 2, 3);
  write_image(folder / "a.exr", image);
  EXPECT_EQ(read_image(folder / "a.exr").pixels, image.pixels);
}

TEST_F(OpenImageIO, WhatIsNoPictureIsRefused) {
  for (const char* name : {"a.png", "a.jpg", "a.exr", "a.hdr", "a.tif", "a"}) {
    EXPECT_NE(reading_of_bytes(name, ""), "") << name;
    EXPECT_NE(reading_of_bytes(name, "This is no picture.\n"), "") << name;
  }
  const std::string rows(12, 'x');
  EXPECT_NE(reading_of_bytes("zero.png", PngBytes::make(0, 0, 3, "")), "");
  EXPECT_NE(reading_of_bytes("huge.png", PngBytes::make(2000000000, 2000000000, 3, rows)), "");
  EXPECT_NE(reading_of_bytes("wide.png", PngBytes::make(16385, 1, 3, rows)), "");
  EXPECT_NE(reading_of_bytes("short.png", PngBytes::make(2, 200, 3, rows)), "");
}

TEST_F(OpenImageIO, CutOrDamagedPicturesNeverCrash) {
  write_image(folder / "good.exr", gradient(16, 16, 3));
  write_image(folder / "good.png", gradient(16, 16, 3));
  int refused = 0;
  for (const char* type : {".png", ".exr"}) {
    const std::string good = read_text(folder / (std::string("good") + type));
    for (std::size_t i = 0; i < 40; ++i) {
      const std::size_t at = i * good.size() / 40;
      refused += reading_of_bytes("cut" + std::string(type), good.substr(0, at)) != "";
      std::string damaged = good;
      damaged[at] = static_cast<char>(damaged[at] ^ (0x11 << (i % 4)));
      reading_of_bytes("damaged" + std::string(type), damaged);
    }
  }
  EXPECT_GE(refused, 60) << "of 80 pictures that were cut short";
}

}  // namespace
}  // namespace offing
