#include "engine/io/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/io/file.h"
#include "engine/io/pfm.h"

#ifdef OFFING_OPENIMAGEIO
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#endif

namespace offing {
namespace {
namespace fs = std::filesystem;

// A device has no extension; it gets the bytes of a PNG.
std::string extension(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_character_file(file, ignored)) return ".png";
  std::string text = file.extension().string();
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

[[noreturn]] void refuse_reading(std::string_view name, std::string_view why,
                                 std::string_view advice) {
  throw InputError(fmt::format("{}: cannot be read: {}; {}", name, why, advice));
}

void check_readable(const fs::path& file) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (!fs::exists(status)) {
    refuse_reading(file.string(), "no such file", "check the path");
  }
  if (!fs::is_regular_file(status)) {
    refuse_reading(file.string(), "is no file with a picture", "give the name of a file");
  }
}

void check_whole(const fs::path& file, const Image& image,
                 const std::vector<std::string>& channel_names) {
  const bool sizes = image.width > 0 && image.height > 0 && image.channels > 0 &&
                     image.width <= kMaxImageSide && image.height <= kMaxImageSide;
  const bool whole = sizes && image.pixels.size() == static_cast<std::size_t>(image.width) *
                                                         image.height * image.channels;
  const bool named =
      channel_names.empty() || channel_names.size() == static_cast<std::size_t>(image.channels);
  if (whole && named) return;
  throw Error(
      fmt::format("{}: cannot be written: {}x{} pixels, {} channels, {} values and {} channel "
                  "names do not fit; "
                  "fix the caller",
                  file.string(), image.width, image.height, image.channels, image.pixels.size(),
                  channel_names.size()));
}

[[noreturn]] void refuse_channels(const fs::path& file, int channels, std::string_view allowed) {
  throw InputError(fmt::format("{}: cannot be written: {} channels, and it holds {}; use .exr",
                               file.string(), channels, allowed));
}

void write_pfm(const fs::path& file, const Image& image) {
  if (image.channels != 1 && image.channels != 3) refuse_channels(file, image.channels, "1 or 3");
  write_text(file, encode_pfm(image));
}

#ifdef OFFING_OPENIMAGEIO

// One line of what OpenImageIO has to say.
std::string one_line(std::string text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.empty() ? "no reason given" : text;
}

// "as stored" in image.h: OpenImageIO would multiply colours by alpha.
OIIO::ImageSpec as_stored() {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  return config;
}

Image read_opened(OIIO::ImageInput* input, std::string_view name) {
  const std::string advice = "give a PNG, JPEG, EXR or PFM picture";
  if (!input) refuse_reading(name, one_line(OIIO::geterror()), advice);
  const OIIO::ImageSpec& spec = input->spec();
  const bool sound =
      spec.width > 0 && spec.height > 0 && spec.depth <= 1 && spec.nchannels > 0 && !spec.deep;
  if (!sound) refuse_reading(name, "is no flat picture", advice);
  const std::size_t values =
      static_cast<std::size_t>(spec.width) * spec.height * static_cast<std::size_t>(spec.nchannels);
  if (spec.width > kMaxImageSide || spec.height > kMaxImageSide || values > kMaxImageValues) {
    refuse_reading(
        name, fmt::format("is {}x{} with {} channels", spec.width, spec.height, spec.nchannels),
        fmt::format("keep to {} on a side and 1 GiB", kMaxImageSide));
  }
  Image image{spec.width,
              spec.height,
              spec.nchannels,
              std::vector<float>(values),
              {spec.channelnames.begin(), spec.channelnames.end()}};
  if (!input->read_image(0, 0, 0, image.channels, OIIO::TypeDesc::FLOAT, image.pixels.data())) {
    refuse_reading(name, one_line(input->geterror()), advice);
  }
  return image;
}

// Decoders of damaged files throw too.
template <class Function>
Image guarded(std::string_view name, Function&& read) {
  try {
    return read();
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    refuse_reading(name, one_line(error.what()), "give a sound picture");
  }
}

unsigned char quantised(float value) {
  return static_cast<unsigned char>(value > 0.0f ? std::lround(std::min(value, 1.0f) * 255.0f) : 0);
}

// The file's bytes in memory: write_text() then sees to the disk.
std::string encode(const fs::path& file, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                   const void* pixels) {
  const auto fail = [&](const std::string& why) {
    throw Error(fmt::format("{}: cannot be written: {}; try another type of picture", file.string(),
                            one_line(why)));
  };
  OIIO::Filesystem::IOVecOutput memory;
  try {
    const std::string name = "picture" + extension(file);
    const auto output = OIIO::ImageOutput::create(name, &memory);
    if (!output) fail(OIIO::geterror());
    const bool done =
        output->open(name, spec) && output->write_image(type, pixels) && output->close();
    if (!done) fail(output->geterror());
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    fail(error.what());
  }
  return {memory.buffer().begin(), memory.buffer().end()};
}

std::string encode_png(const fs::path& file, const Image& image) {
  if (image.channels > 4) refuse_channels(file, image.channels, "1 to 4");
  std::vector<unsigned char> bytes(image.pixels.size());
  std::transform(image.pixels.begin(), image.pixels.end(), bytes.begin(), quantised);
  OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("oiio:UnassociatedAlpha", 1);
  return encode(file, spec, OIIO::TypeDesc::UINT8, bytes.data());
}

std::string encode_exr(const fs::path& file, const Image& image,
                       const std::vector<std::string>& channel_names,
                       const std::map<std::string, double>& attributes) {
  OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeDesc::FLOAT);
  if (!channel_names.empty()) spec.channelnames = channel_names;
  spec.attribute("compression", "zip");
  for (const auto& [name, value] : attributes) spec.attribute(name, static_cast<float>(value));
  return encode(file, spec, OIIO::TypeDesc::FLOAT, image.pixels.data());
}

void write_picture(const fs::path& file, const Image& image,
                   const std::vector<std::string>& channel_names,
                   const std::map<std::string, double>& attributes) {
  write_text(file, extension(file) == ".png" ? encode_png(file, image)
                                             : encode_exr(file, image, channel_names, attributes));
}

#else

void write_picture(const fs::path& file, const Image& image,
                   const std::vector<std::string>& channel_names,
                   const std::map<std::string, double>&) {
  if (image.channels == 1 || image.channels == 3) {
    const fs::path pfm = fs::path(file).replace_extension(".pfm");
    write_pfm(pfm, image);
    log_warning("{}: written as {}: this build has no OpenImageIO", file.string(), pfm.string());
    return;
  }
  for (int c = 0; c < image.channels; ++c) {
    Image channel{image.width, image.height, 1, {}};
    for (std::size_t i = c; i < image.pixels.size(); i += image.channels) {
      channel.pixels.push_back(image.pixels[i]);
    }
    const std::string name = channel_names.empty() ? std::to_string(c) : channel_names[c];
    write_pfm(fs::path(file).replace_extension("." + name + ".pfm"), channel);
  }
  log_warning("{}: written as one .pfm per channel: this build has no OpenImageIO", file.string());
}

#endif

}  // namespace

Image read_image(const fs::path& file) {
  check_readable(file);
  if (extension(file) == ".pfm") {
    constexpr std::size_t kHeader = 256;
    return decode_pfm(read_text(file, kMaxImageValues * sizeof(float) + kHeader), file.string());
  }
#ifdef OFFING_OPENIMAGEIO
  return guarded(file.string(), [&] {
    const OIIO::ImageSpec config = as_stored();
    return read_opened(OIIO::ImageInput::open(file.string(), &config).get(), file.string());
  });
#else
  refuse_reading(file.string(), "this build has no OpenImageIO", "give a .pfm picture");
#endif
}

bool reads_pictures() {
#ifdef OFFING_OPENIMAGEIO
  return true;
#else
  return false;
#endif
}

#ifdef OFFING_OPENIMAGEIO
Image decode_image(std::span<const unsigned char> bytes, std::string_view name) {
  constexpr unsigned char kPng[] = {0x89, 'P', 'N', 'G'};
  const bool is_png = bytes.size() > 4 && std::equal(kPng, kPng + 4, bytes.begin());
  return guarded(name, [&] {
    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    OIIO::Filesystem::IOProxy* proxy = &memory;
    OIIO::ImageSpec config = as_stored();
    config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    const auto input = OIIO::ImageInput::open(is_png ? "picture.png" : "picture.jpg", &config);
    return read_opened(input.get(), name);
  });
}
#else
Image decode_image(std::span<const unsigned char>, std::string_view name) {
  refuse_reading(name, "this build has no OpenImageIO", "build with -DOFFING_OPENIMAGEIO=ON");
}
#endif

void check_image_name(const fs::path& file) {
  const std::string type = extension(file);
  if (type != ".png" && type != ".exr" && type != ".pfm") {
    throw InputError(fmt::format(
        "{}: cannot be written: unknown type of picture; use .png, .exr or .pfm", file.string()));
  }
  std::error_code ignored;
  const fs::path folder = file.parent_path();
  if (!folder.empty() && !fs::is_directory(folder, ignored)) {
    throw InputError(
        fmt::format("{}: cannot be written: no such folder; make its folder first", file.string()));
  }
}

void write_image(const fs::path& file, const Image& image,
                 const std::vector<std::string>& channel_names,
                 const std::map<std::string, double>& attributes) {
  check_image_name(file);
  check_whole(file, image, channel_names);
  if (extension(file) == ".pfm") return write_pfm(file, image);
  write_picture(file, image, channel_names, attributes);
}

}  // namespace offing
