#include "engine/post/flip.h"

#include <fmt/core.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include "engine/core/angles.h"
#include "engine/core/error.h"

namespace offing {
namespace {

template <class T>
struct Plane {
  int width, height;
  std::vector<T> values;
};
using Colours = Plane<glm::dvec3>;
using Numbers = Plane<double>;

template <class T, class Function>
auto mapped(const Plane<T>& plane, Function&& function) {
  Plane<decltype(function(plane.values[0]))> result{plane.width, plane.height, {}};
  result.values.reserve(plane.values.size());
  for (const T& value : plane.values) result.values.push_back(function(value));
  return result;
}

// ---- colour -------------------------------------------------------------------------------------

// Linear sRGB to CIE XYZ, IEC 61966-2-1 with the digits that the FLIP papers work with.
const glm::dmat3 kXyzFromRgb = glm::transpose(glm::dmat3(  //
    10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0, 2613072.0 / 12288897.0,
    8788810.0 / 12288897.0, 887015.0 / 12288897.0, 1425312.0 / 73733382.0, 8788810.0 / 73733382.0,
    70074185.0 / 73733382.0));
const glm::dmat3 kRgbFromXyz = glm::inverse(kXyzFromRgb);
const glm::dvec3 kWhite = kXyzFromRgb * glm::dvec3(1.0);

double linear_from_srgb(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// YCxCz, a linear opponent space: FLIP (2020), section 4.1.
glm::dvec3 opponent_from_rgb(glm::dvec3 rgb) {
  const glm::dvec3 xyz = kXyzFromRgb * rgb / kWhite;
  return {116.0 * xyz.y - 16.0, 500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z)};
}

glm::dvec3 rgb_from_opponent(glm::dvec3 colour) {
  const double y = (colour.x + 16.0) / 116.0;
  const glm::dvec3 xyz(y + colour.y / 500.0, y, y - colour.z / 200.0);
  return kRgbFromXyz * (xyz * kWhite);
}

// CIELAB with the Hunt effect: chroma counts less in the dark. FLIP (2020), section 4.1.2.
glm::dvec3 hunt_lab_from_rgb(glm::dvec3 rgb) {
  const glm::dvec3 xyz = kXyzFromRgb * rgb / kWhite;
  const auto f = [](double t) {
    constexpr double kDelta = 6.0 / 29.0;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
  };
  const double lightness = 116.0 * f(xyz.y) - 16.0;
  return {lightness, 0.01 * lightness * 500.0 * (f(xyz.x) - f(xyz.y)),
          0.01 * lightness * 200.0 * (f(xyz.y) - f(xyz.z))};
}

// HyAB: city blocks in lightness, Euclid in chroma (S. Abasi et al. 2020).
double hyab(glm::dvec3 a, glm::dvec3 b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// ---- filters ------------------------------------------------------------------------------------

// Weights for offsets -radius … radius.
using Kernel = std::vector<double>;

Kernel sampled(int radius, const std::function<double(int)>& function) {
  Kernel kernel;
  for (int i = -radius; i <= radius; ++i) kernel.push_back(function(i));
  return kernel;
}

Kernel scaled(Kernel kernel, double factor) {
  for (double& weight : kernel) weight *= factor;
  return kernel;
}

double sum_of(const Kernel& kernel) { return std::accumulate(kernel.begin(), kernel.end(), 0.0); }

// Positive weights then sum to 1 and negative ones to -1, as FLIP's detectors have it.
Kernel balanced(Kernel kernel) {
  double positive = 0.0, negative = 0.0;
  for (const double weight : kernel) (weight > 0.0 ? positive : negative) += weight;
  for (double& weight : kernel) weight /= weight > 0.0 ? positive : -negative;
  return kernel;
}

// Convolves rows with `across` and columns with `down`; the border's pixels go on outside.
Numbers filtered(const Numbers& in, const Kernel& across, const Kernel& down) {
  const auto pass = [](const Numbers& from, const Kernel& kernel, bool rows) {
    const int radius = static_cast<int>(kernel.size() / 2);
    const int length = rows ? from.width : from.height;
    const int lines = rows ? from.height : from.width;
    const int step = rows ? 1 : from.width, next = rows ? from.width : 1;
    Numbers to{from.width, from.height, std::vector<double>(from.values.size())};
    for (int line = 0; line < lines; ++line) {
      for (int at = 0; at < length; ++at) {
        double sum = 0.0;
        for (int k = -radius; k <= radius; ++k) {
          const int other = std::clamp(at + k, 0, length - 1);
          sum += kernel[k + radius] * from.values[line * next + other * step];
        }
        to.values[line * next + at * step] = sum;
      }
    }
    return to;
  };
  return pass(pass(in, across, true), down, false);
}

// ---- what the eye makes of colour ---------------------------------------------------------------

// A contrast sensitivity function in space, as a sum of Gaussians
// a √(π/b) exp(-π² x² / b), x in degrees: FLIP (2020), equation 5 and table 1.
struct Sensitivity {
  struct Gaussian {
    double a, b;
  };
  std::vector<Gaussian> gaussians;
};
const Sensitivity kAchromatic{{{1.0, 0.0047}}};
const Sensitivity kRedGreen{{{1.0, 0.0053}}};
const Sensitivity kBlueYellow{{{34.1, 0.04}, {13.5, 0.025}}};
constexpr double kWidestB = 0.04;

// One channel as seen from so far off that details blur. Each Gaussian is separable; their sum is
// not, so each is filtered by itself.
Numbers seen(const Numbers& channel, const Sensitivity& sensitivity, double pixels_per_degree) {
  const int radius = static_cast<int>(
      std::ceil(3.0 * std::sqrt(kWidestB / (2.0 * kPi * kPi)) * pixels_per_degree));
  std::vector<double> volumes;
  std::vector<Kernel> kernels;
  for (const auto& [a, b] : sensitivity.gaussians) {
    kernels.push_back(sampled(radius, [&, b = b](int i) {
      const double x = i / pixels_per_degree;
      return std::exp(-kPi * kPi * x * x / b);
    }));
    const double length = sum_of(kernels.back());
    volumes.push_back(a * std::sqrt(kPi / b) * length * length);
    kernels.back() = scaled(kernels.back(), 1.0 / length);
  }
  const double volume = sum_of(volumes);
  Numbers result{channel.width, channel.height, std::vector<double>(channel.values.size())};
  for (std::size_t g = 0; g < kernels.size(); ++g) {
    const Numbers blurred = filtered(channel, kernels[g], kernels[g]);
    for (std::size_t i = 0; i < blurred.values.size(); ++i) {
      result.values[i] += volumes[g] / volume * blurred.values[i];
    }
  }
  return result;
}

// Hunt-adjusted CIELAB of what is seen of an opponent picture.
Colours perceived(const Colours& opponent, double pixels_per_degree) {
  const Sensitivity* sensitivities[] = {&kAchromatic, &kRedGreen, &kBlueYellow};
  Colours result = opponent;
  for (int c = 0; c < 3; ++c) {
    const Numbers channel = mapped(opponent, [c](const glm::dvec3& colour) { return colour[c]; });
    const Numbers blurred = seen(channel, *sensitivities[c], pixels_per_degree);
    for (std::size_t i = 0; i < blurred.values.size(); ++i) {
      result.values[i][c] = blurred.values[i];
    }
  }
  return mapped(result, [](const glm::dvec3& colour) {
    return hunt_lab_from_rgb(glm::clamp(rgb_from_opponent(colour), 0.0, 1.0));
  });
}

// Spreads HyAB distances over 0 to 1, leaving little room for the large: FLIP (2020), section
// 4.1.3.
double colour_error(double distance) {
  constexpr double kExponent = 0.7, kKnee = 0.4, kKneeError = 0.95;
  static const double largest = std::pow(
      hyab(hunt_lab_from_rgb({0.0, 1.0, 0.0}), hunt_lab_from_rgb({0.0, 0.0, 1.0})), kExponent);
  const double error = std::pow(distance, kExponent) / largest;
  return error < kKnee ? error * kKneeError / kKnee
                       : kKneeError + (error - kKnee) / (1.0 - kKnee) * (1.0 - kKneeError);
}

// ---- features -----------------------------------------------------------------------------------

// Strengths of edges (x) and points (y) in a picture's lightness, 0 to 1: FLIP (2020), section 4.2.
Plane<glm::dvec2> features(const Colours& opponent, double pixels_per_degree) {
  constexpr double kDetectorWidth = 0.082;  // degrees
  const double deviation = 0.5 * kDetectorWidth * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3.0 * deviation));
  const auto gauss = [&](int i) { return std::exp(-i * i / (2.0 * deviation * deviation)); };
  Kernel smooth = sampled(radius, gauss);
  smooth = scaled(smooth, 1.0 / sum_of(smooth));
  const Kernel edge = balanced(sampled(radius, [&](int i) { return -i * gauss(i); }));
  const Kernel point = balanced(
      sampled(radius, [&](int i) { return (i * i / (deviation * deviation) - 1.0) * gauss(i); }));

  const Numbers lightness =
      mapped(opponent, [](const glm::dvec3& colour) { return (colour.x + 16.0) / 116.0; });
  Plane<glm::dvec2> result{opponent.width, opponent.height,
                           std::vector<glm::dvec2>(opponent.values.size())};
  const Kernel* detectors[] = {&edge, &point};
  for (int d = 0; d < 2; ++d) {
    const Numbers across = filtered(lightness, *detectors[d], smooth);
    const Numbers down = filtered(lightness, smooth, *detectors[d]);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
      result.values[i][d] = std::hypot(across.values[i], down.values[i]);
    }
  }
  return result;
}

double feature_error(glm::dvec2 reference, glm::dvec2 test) {
  const glm::dvec2 difference = glm::abs(reference - test);
  return std::sqrt(std::max(difference.x, difference.y) / std::sqrt(2.0));
}

// ---- the metric ---------------------------------------------------------------------------------

void check_sight(double pixels_per_degree) {
  if (pixels_per_degree > 0.0 && pixels_per_degree <= 1000.0) return;
  throw InputError(
      fmt::format("FLIP: {} pixels per degree: must be above 0, up to 1000", pixels_per_degree));
}

// A stored picture's red, green and blue, whatever the order of its channels.
Colours colours_of(const Image& image, const char* role) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("FLIP: the {} picture {}", role, why));
  };
  const std::size_t count = static_cast<std::size_t>(image.width) * image.height;
  if (image.width < 1 || image.height < 1 || image.pixels.size() != count * image.channels) {
    refuse(fmt::format("has {}x{} pixels, {} channels but {} values; give a whole one", image.width,
                       image.height, image.channels, image.pixels.size()));
  }
  if (image.channels != 3 && image.channels != 4) {
    refuse(fmt::format("has {} channels; give one with 3, or 4", image.channels));
  }
  int order[] = {0, 1, 2};
  const auto& names = image.channel_names;
  if (!names.empty()) {
    for (int c = 0; c < 3; ++c) {
      const auto at = std::find(names.begin(), names.end(), std::string(1, "RGB"[c]));
      if (at == names.end() || at - names.begin() >= image.channels) {
        refuse("has no channels R, G and B; give one that has");
      }
      order[c] = static_cast<int>(at - names.begin());
    }
  }
  Colours result{image.width, image.height, std::vector<glm::dvec3>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    for (int c = 0; c < 3; ++c) {
      const float value = image.pixels[i * image.channels + order[c]];
      if (!std::isfinite(value)) {
        refuse(fmt::format("is not finite at x = {}, y = {}; mend what made it", i % image.width,
                           i / image.width));
      }
      result.values[i][c] = static_cast<double>(value);
    }
  }
  return result;
}

void check_sizes(const Image& reference, const Image& test) {
  if (reference.width == test.width && reference.height == test.height) return;
  throw InputError(fmt::format(
      "FLIP: a reference of {}x{} and a test of {}x{} pixels; give pictures of one size",
      reference.width, reference.height, test.width, test.height));
}

// Of linear pictures with values from 0 to 1.
Numbers errors_between(const Colours& reference, const Colours& test, double pixels_per_degree) {
  const Colours reference_opponent = mapped(reference, opponent_from_rgb);
  const Colours test_opponent = mapped(test, opponent_from_rgb);
  const Colours reference_seen = perceived(reference_opponent, pixels_per_degree);
  const Colours test_seen = perceived(test_opponent, pixels_per_degree);
  const auto reference_features = features(reference_opponent, pixels_per_degree);
  const auto test_features = features(test_opponent, pixels_per_degree);
  Numbers errors{reference.width, reference.height, std::vector<double>(reference.values.size())};
  for (std::size_t i = 0; i < errors.values.size(); ++i) {
    const double colour = colour_error(hyab(reference_seen.values[i], test_seen.values[i]));
    const double feature = feature_error(reference_features.values[i], test_features.values[i]);
    errors.values[i] = std::pow(colour, 1.0 - std::min(feature, 1.0));
  }
  return errors;
}

FlipResult summary(const Numbers& errors) {
  FlipResult result;
  result.error_map = {errors.width, errors.height, 1, {errors.values.begin(), errors.values.end()}};
  std::vector<double> sorted = errors.values;
  std::sort(sorted.begin(), sorted.end());
  const double sum = sum_of(sorted);
  result.mean = sum / static_cast<double>(sorted.size());
  result.maximum = sorted.back();
  result.percentile_99 =
      sorted[static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(sorted.size())) - 1.0)];
  double below = 0.0;
  for (const double error : sorted) {
    below += error;
    result.weighted_median = error;
    if (below >= 0.5 * sum) break;
  }
  return result;
}

// ---- high dynamic range -------------------------------------------------------------------------

// The ACES curve's fit by K. Narkowicz (2015) with its exposure of 0.6 left in, as HDR-FLIP has it:
// (p₀ x² + p₁ x) / (q₀ x² + q₁ x + q₂).
constexpr double kP0 = 0.6 * 0.6 * 2.51, kP1 = 0.6 * 0.03;
constexpr double kQ0 = 0.6 * 0.6 * 2.43, kQ1 = 0.6 * 0.59, kQ2 = 0.14;

double tone_mapped(double x) {
  return std::clamp((kP0 * x + kP1) * x / ((kQ0 * x + kQ1) * x + kQ2), 0.0, 1.0);
}

FlipExposures exposures_of(const Colours& reference) {
  // Where the curve reaches 0.85: HDR-FLIP (2021), section 3.
  constexpr double kLevel = 0.85;
  constexpr double kA = kP0 - kLevel * kQ0, kB = kP1 - kLevel * kQ1, kC = -kLevel * kQ2;
  const double level = (-kB + std::sqrt(kB * kB - 4.0 * kA * kC)) / (2.0 * kA);
  std::vector<double> luminances;
  for (const glm::dvec3& rgb : reference.values) luminances.push_back((kXyzFromRgb * rgb).y);
  std::sort(luminances.begin(), luminances.end());
  const std::size_t half = luminances.size() / 2;
  const double median = luminances.size() % 2 == 1
                            ? luminances[half]
                            : 0.5 * (luminances[half - 1] + luminances[half]);
  if (!(luminances.back() > 0.0)) {
    throw InputError("FLIP: the reference picture is black all over; give one with light in it");
  }
  FlipExposures exposures;
  exposures.start = std::log2(level / luminances.back());
  // A picture that is mostly black has no such median: sixteen stops are more than a display shows.
  exposures.stop = std::min(std::log2(level / median), exposures.start + 16.0);
  exposures.count = std::max(2, static_cast<int>(std::ceil(exposures.stop - exposures.start)));
  return exposures;
}

Colours lights_of(const Image& image, const char* role) {
  return mapped(colours_of(image, role), [](const glm::dvec3& rgb) { return glm::max(rgb, 0.0); });
}

FlipResult flip_lights(const Colours& reference, const Colours& test,
                       const FlipExposures& exposures, double pixels_per_degree) {
  Numbers worst{reference.width, reference.height, std::vector<double>(reference.values.size())};
  for (int e = 0; e < exposures.count; ++e) {
    const double stops =
        exposures.start + (exposures.stop - exposures.start) * e / (exposures.count - 1);
    const auto exposed = [gain = std::exp2(stops)](const glm::dvec3& rgb) {
      return glm::dvec3(tone_mapped(gain * rgb.x), tone_mapped(gain * rgb.y),
                        tone_mapped(gain * rgb.z));
    };
    const Numbers errors =
        errors_between(mapped(reference, exposed), mapped(test, exposed), pixels_per_degree);
    std::transform(errors.values.begin(), errors.values.end(), worst.values.begin(),
                   worst.values.begin(), [](double a, double b) { return std::max(a, b); });
  }
  return summary(worst);
}

}  // namespace

FlipResult flip_ldr(const Image& reference, const Image& test, double pixels_per_degree) {
  check_sight(pixels_per_degree);
  check_sizes(reference, test);
  const auto linear = [](const glm::dvec3& coded) {
    const glm::dvec3 clamped = glm::clamp(coded, 0.0, 1.0);
    return glm::dvec3(linear_from_srgb(clamped.x), linear_from_srgb(clamped.y),
                      linear_from_srgb(clamped.z));
  };
  return summary(errors_between(mapped(colours_of(reference, "reference"), linear),
                                mapped(colours_of(test, "test"), linear), pixels_per_degree));
}

FlipResult flip_hdr(const Image& reference, const Image& test, double pixels_per_degree) {
  check_sight(pixels_per_degree);
  check_sizes(reference, test);
  const Colours lights = lights_of(reference, "reference");
  return flip_lights(lights, lights_of(test, "test"), exposures_of(lights), pixels_per_degree);
}

FlipResult flip_hdr(const Image& reference, const Image& test, const FlipExposures& exposures,
                    double pixels_per_degree) {
  check_sight(pixels_per_degree);
  check_sizes(reference, test);
  const auto [start, stop, count] = exposures;
  if (!(start >= -100.0 && start <= stop && stop <= 100.0 && count >= 2 && count <= 1000)) {
    throw InputError(fmt::format(
        "FLIP: {} exposures from {} to {} stops: must be 2 to 1000 that rise within -100 to 100",
        count, start, stop));
  }
  return flip_lights(lights_of(reference, "reference"), lights_of(test, "test"), exposures,
                     pixels_per_degree);
}

FlipExposures flip_exposures(const Image& reference) {
  return exposures_of(lights_of(reference, "reference"));
}

}  // namespace offing
