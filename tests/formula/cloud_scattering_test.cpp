#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/angles.h"
#include "support/adding_doubling.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/cloud_scattering.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {
using namespace glsl;

/// What a slab does to a beam of illuminance 1, as a march sees it: the source function of the
/// approximation seen through exp(-tau / mu), summed over all directions.
struct SlabLight {
  double reflected = 0.0, transmitted = 0.0;  ///< shares of the beam, without what goes straight
  double absorbed_if_negative(double straight) const {
    return 1.0 - reflected - transmitted - straight;
  }
};

SlabLight approximate_slab(double depth, double cosine, double g) {
  constexpr int kStreams = 12, kAzimuths = 32, kDepths = 72;
  static const test::Quadrature q = test::gauss_legendre(kStreams);
  SlabLight light;
  for (int k = 0; k < kDepths; ++k) {
    const double u = (k + 0.5) / kDepths, v = std::min(u, 1.0 - u);  // finest at both faces
    const double at = depth * (u < 0.5 ? 4.0 * v * v * v : 1.0 - 4.0 * v * v * v);
    const double step = depth * 12.0 * v * v / kDepths;
    const CloudField field = cloud_field(at / cosine, depth / cosine, cosine, g, 0.0);
    for (int i = 0; i < kStreams; ++i) {
      const double mu = q.points[static_cast<std::size_t>(i)];
      const double weight = kTau * q.weights[static_cast<std::size_t>(i)] * step / cosine;
      for (const double way : {-1.0, 1.0}) {  // up, down: with the beam
        double source = 0.0;
        for (int p = 0; p < kAzimuths; ++p) {
          const double angle =
              way * mu * cosine + std::sqrt((1.0 - mu * mu) * (1.0 - cosine * cosine)) *
                                      std::cos(kTau * (p + 0.5) / kAzimuths);
          source += cloud_source(field, henyey_greenstein(g, angle), angle, way * mu, g);
        }
        source /= kAzimuths;
        (way < 0.0 ? light.reflected : light.transmitted) +=
            weight * source * std::exp(-(way < 0.0 ? at : depth - at) / mu);
      }
    }
  }
  return light;
}

TEST(AddingDoubling, GivesKnownAlbedos) {
  // Conservative slabs over black ground, worked out elsewhere by Monte Carlo.
  const struct {
    double depth, g, overhead, slanting;
  } known[] = {{4.0, 0.0, 0.6909, 0.7857},
               {4.0, 0.85, 0.1911, 0.4162},
               {40.0, 0.0, 0.9594, 0.9720},
               {40.0, 0.85, 0.7718, 0.8444}};
  for (const auto& k : known) {
    const std::vector<double> albedo = test::slab_albedo(k.depth, k.g, {1.0, 0.5});
    EXPECT_NEAR(albedo[0], k.overhead, 5e-4);
    EXPECT_NEAR(albedo[1], k.slanting, 5e-4);
  }
  // A thin slab scatters once: back goes depth / cosine times the phase function's backward share.
  EXPECT_NEAR(test::slab_albedo(1e-4, 0.0, {1.0}, 1.0)[0], 0.5e-4, 1e-7);
  // Half-infinite, isotropic, albedo .9, overhead: 1 - H(1) sqrt(1 - .9), Chandrasekhar's H = 2.07.
  EXPECT_NEAR(test::slab_albedo(200.0, 0.0, {1.0}, 0.9)[0], 0.4144, 2e-3);
}

TEST(CloudField, ReturnsWhatASlabReturns) {
  const std::vector<double> cosines = {1.0, 0.85, 0.5, 0.3, 0.2};
  double worst = 0.0, worst_thick = 0.0;
  for (const double g : {0.0, 0.4, 0.75, 0.85, 0.9}) {
    for (const double depth : {0.3, 1.5, 4.0, 7.0, 22.0, 40.0, 100.0}) {
      const std::vector<double> exact = test::slab_albedo(depth, g, cosines);
      for (std::size_t i = 0; i < cosines.size(); ++i) {
        const double c = cosines[i];
        const SlabLight slab = approximate_slab(depth, c, g);
        const double error = slab.reflected - exact[i];
        worst = std::max(worst, std::abs(error));
        if (depth >= 4.0) worst_thick = std::max(worst_thick, std::abs(error));
        EXPECT_LT(std::abs(error), depth >= 4.0 ? 0.045 : 0.06)
            << "g " << g << " depth " << depth << " cosine " << c << ": " << slab.reflected
            << " instead of " << exact[i];
        if (depth < 4.0) continue;  // a sharp peak straight on: not for this quadrature
        const double through = 1.0 - exact[i] - std::exp(-depth / c);
        EXPECT_NEAR(slab.transmitted, through, 0.055)
            << "g " << g << " depth " << depth << " cosine " << c;
      }
    }
  }
  RecordProperty("worst", std::to_string(worst));
  RecordProperty("worst_thick", std::to_string(worst_thick));
}

TEST(CloudField, MakesNoLight) {
  // Light of 1 from the whole sky above a slab comes out again as at most 1.
  static const test::Quadrature q = test::gauss_legendre(6);
  for (const double g : {0.0, 0.5, 0.85}) {
    for (const double depth : {4.0, 15.0, 60.0}) {
      double out = 0.0;
      for (std::size_t i = 0; i < q.points.size(); ++i) {
        const double c = q.points[i];
        const SlabLight slab = approximate_slab(depth, c, g);
        out += 2.0 * c * q.weights[i] * (slab.reflected + slab.transmitted + std::exp(-depth / c));
      }
      EXPECT_LE(out, 1.0) << g << " " << depth;
      EXPECT_GT(out, 0.95) << g << " " << depth;
    }
  }
}

TEST(CloudField, StaysFiniteAndPositive) {
  for (const double g : {-0.9, 0.0, 0.9}) {
    for (const double c : {-1.0, 0.0, 1e-3, 1.0}) {
      for (const double above : {-1.0, 0.0, 1e-4, 1.0, 1e4}) {
        for (const auto& [total, leak] :
             {std::pair{0.0, 0.0}, {1.0, 0.0}, {1e5, 0.0}, {0.0, 5.0}, {1.0, 0.1}, {1e5, 0.5}}) {
          const CloudField f = cloud_field(above, total, c, g, leak);
          for (const double angle : {-1.0, 0.0, 1.0}) {
            const double source = cloud_source(f, henyey_greenstein(g, angle), angle, angle, g);
            EXPECT_TRUE(std::isfinite(source) && source >= 0.0)
                << g << " " << c << " " << above << " " << total;
          }
        }
      }
    }
  }
}

/// Diffusion in a scaled slab (depth `end`, beam straight in) that loses k² of its light on the
/// way, by finite differences: I0 in the middle of each cell. dI1/dt = -(k²/turned) I0 + q e^-t,
/// dI0/dt = -turned I1 + q g' e^-t, I0 = -2/3 I1 at the top and 2/3 I1 at the end.
std::vector<double> leaking_slab(double end, double k, double g, int cells) {
  const double q = 3.0 / (2.0 * kTau), turned = 1.0 / (1.0 + g), step = end / cells;
  // J = I1 + q e^-t at the faces between cells: J = (q e^-t - I0') / turned, and J' = -(k²/turned)
  // I0.
  const double within = k * k * step / turned, between = 1.0 / (turned * step);
  const double out = 1.0 / (2.0 / 3.0 + 0.5 * turned * step);  // J across half a cell and a face
  std::vector<double> diagonal, right;
  for (int i = 0; i < cells; ++i) {
    const double beam = q * std::exp(-i * step), beam_end = q * std::exp(-(i + 1) * step);
    double d = within, r = 0.0;
    if (i > 0) {
      d += between;
      r += beam / turned;
    } else {
      // At the face I0 = -2/3 J + .68 q; half a cell on, I0 - turned J step / 2 + q step / 2.
      d += out;
      r += out * (q * 0.68 + 0.5 * step * beam);
    }
    if (i + 1 < cells) {
      d += between;
      r -= beam_end / turned;
    } else {
      d += out;
      r -= out * (0.68 * beam_end + 0.5 * step * beam_end);
    }
    diagonal.push_back(d);
    right.push_back(r);
  }
  for (int i = 1; i < cells; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double share = -between / diagonal[at - 1];
    diagonal[at] += share * between;
    right[at] -= share * right[at - 1];
  }
  for (int i = cells - 1; i >= 0; --i) {
    const auto at = static_cast<std::size_t>(i);
    right[at] = (right[at] + (i + 1 < cells ? between * right[at + 1] : 0.0)) / diagonal[at];
  }
  return right;
}

TEST(CloudField, SolvesASlabThatLeaks) {
  constexpr int kCells = 4000;
  for (const double g : {0.0, 0.6, 0.86}) {
    for (const double depth : {3.0, 20.0, 80.0}) {
      for (const double k : {0.02, 0.15, 0.6}) {
        const double end = (1.0 - g * g) * depth;
        const std::vector<double> exact = leaking_slab(end, k, g, kCells);
        for (const int i : {0, 200, 1000, 2500, 3999}) {
          const double at = (i + 0.5) / kCells;
          EXPECT_NEAR(cloud_field(at * depth, depth, 1.0, g, k).mean,
                      std::max(exact[static_cast<std::size_t>(i)], 0.0), 2e-4)
              << "g " << g << " depth " << depth << " k " << k << " at " << at;
        }
      }
    }
  }
}

TEST(CloudAmbient, KeepsAnEvenLight) {
  for (const double g : {0.0, 0.6, 0.86}) {
    for (const double total : {0.0, 0.1, 3.0, 500.0}) {
      for (const double at : {0.0, 0.3, 1.0}) {
        for (const double mu : {-1.0, 0.2, 1.0}) {
          EXPECT_NEAR(cloud_ambient(at * total, total, vec3(1.0), vec3(1.0), mu, g).x, 1.0, 1e-12);
          const double dark = cloud_ambient(at * total, total, vec3(1.0), vec3(0.0), mu, g).x;
          EXPECT_GE(dark, 0.0);
          EXPECT_LE(dark, 1.0);
        }
      }
    }
  }
  // Seen from below, a slab under an even sky passes on what the adding method says.
  static const test::Quadrature q = test::gauss_legendre(8);
  for (const double g : {0.0, 0.5, 0.85}) {
    for (const double depth : {2.0, 10.0, 50.0}) {
      const std::vector<double> albedo = test::slab_albedo(depth, g, q.points);
      double exact = 0.0, passed = 0.0;
      for (std::size_t i = 0; i < q.points.size(); ++i) {
        const double mu = q.points[i];
        exact += 2.0 * mu * q.weights[i] * (1.0 - albedo[i]);
        double radiance = std::exp(-depth / mu);
        constexpr int kSteps = 400;
        for (int k = 0; k < kSteps; ++k) {
          const double at = depth * (k + 0.5) / kSteps;
          radiance += cloud_ambient(at, depth, vec3(1.0), vec3(0.0), mu, g).x *
                      std::exp(-(depth - at) / mu) * depth / kSteps / mu;
        }
        passed += 2.0 * mu * q.weights[i] * radiance;
      }
      EXPECT_NEAR(passed, exact, depth >= 4.0 ? 0.045 : 0.06) << g << " " << depth;
    }
  }
}

TEST(CloudStep, IsExactForAnyNumberOfSteps) {
  // A constant source through .05 /m and 100 m: (S / sigma)(1 - T), whether in 1 step or in 64.
  const double sigma = 0.05, length = 100.0;
  for (const int steps : {1, 7, 64, 1000}) {
    double transmittance = 1.0, light = 0.0;
    for (int i = 0; i < steps; ++i) {
      light += transmittance * cloud_step(sigma, length / steps);
      transmittance *= std::exp(-sigma * length / steps);
    }
    EXPECT_NEAR(transmittance, 0.006738, 1e-6) << steps;
    EXPECT_NEAR(light, (1.0 - std::exp(-5.0)) / sigma, 1e-8) << steps;
  }
  EXPECT_NEAR(cloud_step(0.0, 30.0), 30.0, 1e-12);
  for (const double sigma_near : {0.9e-3, 1.1e-3}) {  // where the series takes over
    EXPECT_NEAR(cloud_step(sigma_near, 1.0), -std::expm1(-sigma_near) / sigma_near, 1e-10);
  }
}

TEST(CloudOctaves, FirstIsSingleScattering) {
  EXPECT_NEAR(cloud_octaves(1.3, 0.2, 0.8, 1, 0.5, 0.5, 0.5),
              henyey_greenstein(0.8, 0.2) * std::exp(-1.3), 1e-12);
  // Octaves that change nothing are that many times the first.
  EXPECT_NEAR(cloud_octaves(0.4, -0.3, 0.5, 3, 1.0, 1.0, 1.0),
              3.0 * henyey_greenstein(0.5, -0.3) * std::exp(-0.4), 1e-12);
}

TEST(CloudGlow, LeavesAPlaneAsHalfOfWhatThePointGives) {
  // Exitance pi J over a plane that all but holds the point: of 4 pi candela 2 pi.
  double sum = 0.0;
  for (double r = 0.5; r < 3e5; r *= 1.001) {
    sum += kPi * glsl::cloud_glow(r * std::sqrt(1.001)) * kPi * r * r * (1.001 * 1.001 - 1.0);
  }
  EXPECT_NEAR(sum, 2.0 * kPi, 0.01 * 2.0 * kPi);
}

}  // namespace
}  // namespace offing
