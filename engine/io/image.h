#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace offing {

/// A picture in memory. Row 0 is the top. Values are as stored: 0 to 1 for 8- and 16-bit files
/// (still sRGB-coded where the file is, alpha not multiplied in), linear for EXR and PFM.
struct Image {
  int width = 0, height = 0, channels = 0;
  std::vector<float> pixels;  ///< width × height × channels
  /// As read from a file that names its channels, in the order of `pixels`: an EXR keeps them in
  /// alphabetic order. write_image() takes its own list.
  std::vector<std::string> channel_names{};
};

/// Reads any picture OpenImageIO knows (PFM only in a build without it). Throws InputError for a
/// file that is missing, no picture, empty, cut short, or larger than 16384 on a side or 1 GiB in
/// memory.
Image read_image(const std::filesystem::path& file);

/// The same from the bytes of a PNG or JPEG file; `name` stands in messages. Needs OpenImageIO.
Image decode_image(std::span<const unsigned char> bytes, std::string_view name);

/// Whether this build has OpenImageIO.
bool reads_pictures();

/// Writes by extension: .png (8 bit, values 0 to 1, already sRGB-coded, 1 to 4 channels), .exr
/// (32-bit float, linear, any channels), .pfm (float, 1 or 3 channels). Complete or not at all,
/// like write_text(). `channel_names` and `attributes` (as 32-bit floats) go into an EXR. Throws
/// InputError for an extension that it can't write and for a folder that is not there, Error for a
/// disk that is full. In a build without OpenImageIO .png and .exr become .pfm beside the given
/// name
/// ("a.exr": a.pfm, or with other than 1 or 3 channels a.NAME.pfm each), with a word about it.
void write_image(const std::filesystem::path& file, const Image& image,
                 const std::vector<std::string>& channel_names = {},
                 const std::map<std::string, double>& attributes = {});

/// Throws InputError where write_image() would for the name alone: its extension or folder. For
/// checking a command line before the work is done.
void check_image_name(const std::filesystem::path& file);

}  // namespace offing
