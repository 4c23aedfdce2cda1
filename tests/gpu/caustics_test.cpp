// Light gathered by the waves against rays that are traced in double through the same waves.
#include <fftw3.h>
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include "engine/core/angles.h"
#include "game/render/voyage.h"
#include "shaders/shared/underwater.h"
#include "support/voyage_test.h"

namespace offing {
namespace {

using Complex = std::complex<double>;
using Fields = std::array<double, 8>;  // Dx, Dz, h, Dxz, sx, sz, Dxx, Dzz
constexpr int kFiner = 4;              // points for one of the cascade's

// A cascade's surface, on a grid that is finer than its own.
class FineWaves {
 public:
  FineWaves(const Cascade& cascade, double time, double choppiness)
      : band_(cascade.band), points_(kFiner * cascade.size) {
    const int n = cascade.size;
    std::vector<Complex> spectra[4];
    for (auto& spectrum : spectra) spectrum.resize(static_cast<std::size_t>(points_) * points_);
    const auto wrap = [this, n](int i) { return i < n / 2 ? i : i - n + points_; };
    const Complex i(0.0, 1.0);
    for (int z = 0; z < n; ++z) {
      for (int x = 0; x < n; ++x) {
        const auto at = static_cast<std::size_t>(z * n + x);
        const auto mirror = static_cast<std::size_t>(((n - z) % n) * n + (n - x) % n);
        const Complex phase = std::polar(1.0, -std::fmod(cascade.frequency[at] * time, kTau));
        const Complex h = cascade.h0[at] * phase + std::conj(cascade.h0[mirror] * phase);
        if (h == 0.0) continue;
        const glm::dvec2 k = cascade.wave_vector(x, z);
        const glm::dvec2 u = choppiness / glm::length(k) * k;
        const auto to = static_cast<std::size_t>(wrap(z)) * points_ + wrap(x);
        spectra[0][to] = i * u.x * h - u.y * h;
        spectra[1][to] = h - i * (u.x * k.y) * h;
        spectra[2][to] = i * k.x * h - k.y * h;
        spectra[3][to] = -u.x * k.x * h - i * (u.y * k.y) * h;
      }
    }
    for (int pair = 0; pair < 4; ++pair) {
      auto* data = reinterpret_cast<fftw_complex*>(spectra[pair].data());
      const fftw_plan plan =
          fftw_plan_dft_2d(points_, points_, data, data, FFTW_BACKWARD, FFTW_ESTIMATE);
      fftw_execute(plan);
      fftw_destroy_plan(plan);
    }
    values_.resize(spectra[0].size());
    for (std::size_t p = 0; p < values_.size(); ++p) {
      for (std::size_t pair = 0; pair < 4; ++pair) {
        values_[p][2 * pair] = spectra[pair][p].real();
        values_[p][2 * pair + 1] = spectra[pair][p].imag();
      }
    }
  }

  // Adds what it has at a point of water at rest (world x, z).
  void add(glm::dvec2 q, Fields& sum) const {
    const double c = std::cos(band_.angle), s = std::sin(band_.angle);
    const glm::dvec2 at = points_ / band_.length * glm::dvec2(c * q.x + s * q.y, c * q.y - s * q.x);
    const glm::dvec2 first = glm::floor(at), part = at - first;
    for (int corner = 0; corner < 4; ++corner) {
      const int dx = corner & 1, dz = corner >> 1;
      const double weight = (dx ? part.x : 1.0 - part.x) * (dz ? part.y : 1.0 - part.y);
      const int x = (static_cast<int>(first.x) + dx) & (points_ - 1);
      const int z = (static_cast<int>(first.y) + dz) & (points_ - 1);
      const Fields& value = values_[static_cast<std::size_t>(z) * points_ + x];
      for (std::size_t f = 0; f < 8; ++f) sum[f] += weight * value[f];
    }
  }

 private:
  CascadeBand band_;
  int points_;
  std::vector<Fields> values_;
};

// Snell's law in vectors; the power that passes, after Fresnel. `toward`: the light.
struct Ray {
  glm::dvec3 direction;
  double passing;
};
Ray refract(glm::dvec3 toward, glm::dvec3 normal) {
  constexpr double kIndex = 1.34;
  const double in = glm::dot(toward, normal);
  const double out = std::sqrt(1.0 - (1.0 - in * in) / (kIndex * kIndex));
  const double across = (in - kIndex * out) / (in + kIndex * out);
  const double along = (kIndex * in - out) / (kIndex * in + out);
  return {glm::normalize(-toward / kIndex + (in / kIndex - out) * normal),
          1.0 - 0.5 * (across * across + along * along)};
}

class Caustics : public test::VoyageTest {
 protected:
  void sail(const std::string& quality, double wind) {
    Options options;
    options.quality = quality;
    options.sets = {"camera.mode=free",
                    "camera.position=500,-2,500",
                    "camera.target=600,-2,500",
                    "sea.swell.height=0",
                    "sea.fetch=1",
                    fmt::format("environment.wind.speed={}", wind)};
    voyage_.emplace(options, glm::ivec2(96, 54));
    voyage_->next_frame();
    const Ocean& ocean = voyage_->renderer().ocean();
    waves_.clear();
    for (const Cascade& cascade : ocean.cascades()) {
      waves_.emplace_back(cascade, voyage_->view().sea_time, ocean.choppiness());
    }
  }

  // Adds a ray's power to what it meets at every layer's depth. `start`: where it enters, `from`:
  // the corner of the map; m.
  void lay(glm::dvec2 start, double height, const Ray& ray, double power, const Ray& level,
           glm::dvec2 from, int texels, std::vector<double>& gathered) const {
    const auto way = [](const Ray& r) {
      return glm::dvec2(r.direction.x, r.direction.z) / -r.direction.y;
    };
    double depth = shared::kCausticFirst;
    for (int layer = 0; layer < shared::kCausticLayers; ++layer) {
      const glm::dvec2 at = start + way(ray) * (depth + height) - way(level) * depth - from;
      const glm::ivec2 texel(glm::floor(at / kWidth * static_cast<double>(texels)));
      depth *= static_cast<double>(shared::kCausticRatio);
      if (std::min(texel.x, texel.y) < 0 || std::max(texel.x, texel.y) >= texels) continue;
      gathered[static_cast<std::size_t>((layer * texels + texel.y) * texels + texel.x)] += power;
    }
  }

  // Illuminance by layer and texel, over that of a level sea, of finer² rays a texel.
  std::vector<double> trace(int texels, int finer) {
    const Ocean& ocean = voyage_->renderer().ocean();
    const glm::dvec3 toward = voyage_->view().light.sun_direction;
    const Ray level = refract(toward, {0.0, 1.0, 0.0});
    // The map lies before the eye, on whole rays of its own.
    const glm::dvec2 eye(voyage_->view().camera.x, voyage_->view().camera.z);
    const double between = kWidth / (2 * texels);
    const glm::dvec2 middle =
        glm::floor((eye + 0.3 * kWidth * glm::dvec2(1.0, 0.0)) / between) * between;
    const glm::dvec2 from = middle - 0.5 * kWidth;
    // Ripples that no cascade carries turn rays at random.
    SlopeVariance ripples = ocean.slope_variance();
    for (const Cascade& cascade : ocean.cascades()) {
      ripples.xx -= cascade.resolved[0].xx;
      ripples.zz -= cascade.resolved[0].zz;
    }
    const glm::dvec2 rough(std::sqrt(ripples.xx), std::sqrt(ripples.zz));
    std::mt19937 dice(1);
    std::normal_distribution<double> normal_number;
    const int row = texels * finer;
    std::vector<double> gathered(
        static_cast<std::size_t>(shared::kCausticLayers * texels * texels));
    for (int j = 0; j < row; ++j) {
      for (int i = 0; i < row; ++i) {
        const glm::dvec2 q = from + kWidth / row * (glm::dvec2(i, j) + 0.5);
        Fields f{};
        for (const FineWaves& waves : waves_) waves.add(q, f);
        const double xx = 1.0 + f[6], zz = 1.0 + f[7], xz = f[3], jacobian = xx * zz - xz * xz;
        const glm::dvec2 slope =
            glm::dvec2(zz * f[4] - xz * f[5], xx * f[5] - xz * f[4]) / jacobian +
            rough * glm::dvec2(normal_number(dice), normal_number(dice));
        const glm::dvec3 normal = glm::normalize(glm::dvec3(-slope.x, 1.0, -slope.y));
        const double facing = glm::dot(toward, normal);
        if (jacobian <= 0.0 || facing <= 0.0) continue;
        const Ray ray = refract(toward, normal);
        const double power =
            jacobian * facing / normal.y * ray.passing / (toward.y * level.passing * finer * finer);
        lay(q + glm::dvec2(f[0], f[1]), f[2], ray, power, level, from, texels, gathered);
      }
    }
    return gathered;
  }

  static constexpr double kWidth = 20.0;  // m
  std::optional<Voyage> voyage_;
  std::vector<FineWaves> waves_;
};

TEST_F(Caustics, AreThoseOfTracedRays) {
  sail("low", 8.0);
  const gl::Texture& map = voyage_->renderer().ocean().underwater().caustics();
  const int n = map.width();
  const std::vector<float> values = map.read_floats(1);
  const std::vector<double> traced = trace(n, 8);
  for (int layer = 0; layer < shared::kCausticLayers; ++layer) {
    // Away from the edges, where rays come and go.
    double m = 0, t = 0, mm = 0, tt = 0, mt = 0, count = 0;
    for (int y = n / 4; y < 3 * n / 4; ++y) {
      for (int x = n / 4; x < 3 * n / 4; ++x) {
        const auto at = static_cast<std::size_t>((layer * n + y) * n + x);
        const double a = static_cast<double>(values[at]), b = traced[at];
        m += a, t += b, mm += a * a, tt += b * b, mt += a * b, count += 1.0;
      }
    }
    m /= count, t /= count;
    const double map_contrast = std::sqrt(mm / count - m * m) / m;
    const double true_contrast = std::sqrt(tt / count - t * t) / t;
    const double correlation = (mt / count - m * t) / (map_contrast * m * true_contrast * t);
    RecordProperty(
        fmt::format("contrast_{}", layer),
        fmt::format("{:.3f} of {:.3f}, r {:.3f}", map_contrast, true_contrast, correlation));
    EXPECT_NEAR(map_contrast / true_contrast, 1.0, 0.2) << "layer " << layer;
    EXPECT_GT(correlation, layer < 3 ? 0.85 : 0.5) << "layer " << layer;
  }
}

}  // namespace
}  // namespace offing
