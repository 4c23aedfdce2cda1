#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace offing {

/// A picture in memory. Row 0 is the top. Values are as stored: 0 to 1 for 8- and 16-bit files
/// (still sRGB-coded where the file is), linear for EXR and PFM.
struct Image {
  int width = 0, height = 0, channels = 0;
  std::vector<float> pixels;  ///< width × height × channels
};

/// Reads any picture OpenImageIO knows (PFM only in a build without it). Throws InputError for a
/// file that is missing, no picture, empty, or larger than 16384 on a side.
Image read_image(const std::filesystem::path& file);

/// Writes by extension: .png (8 bit, values 0 to 1, already sRGB-coded), .exr (float, linear),
/// .pfm. Complete or not at all: to a temporary file beside it, then renamed. `channel_names` and
/// `attributes` go into an EXR. Throws InputError for an extension that it can't write and for a
/// folder that is not there, Error for a disk that is full. In a build without OpenImageIO .png and
/// .exr become .pfm, with a word about it.
void write_image(const std::filesystem::path& file, const Image& image,
                 const std::vector<std::string>& channel_names = {},
                 const std::map<std::string, double>& attributes = {});

}  // namespace offing
