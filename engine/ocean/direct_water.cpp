#include "engine/ocean/direct_water.h"

#include <algorithm>
#include <cmath>

#include "engine/core/angles.h"
#include "engine/ocean/surface_point.h"

#define OFFING_GLSL "shaders/lib/waves.glsl"
#include "engine/core/glsl_double.h"

namespace offing {

DirectWater::DirectWater(std::span<const Cascade> cascades, double choppiness) {
  for (const Cascade& cascade : cascades) {
    Waves waves{.dk = kTau / cascade.band.length,
                .cosine = std::cos(cascade.band.angle),
                .sine = std::sin(cascade.band.angle),
                .reach = 0,
                .waves = {}};
    for (int iz = 0; iz < cascade.size; ++iz) {
      for (int ix = 0; ix < cascade.size; ++ix) {
        const auto cell = static_cast<std::size_t>(iz * cascade.size + ix);
        if (cascade.h0[cell] == 0.0) continue;
        const int half = cascade.size / 2;
        const int nx = ix < half ? ix : ix - cascade.size, nz = iz < half ? iz : iz - cascade.size;
        waves.reach = std::max({waves.reach, std::abs(nx), std::abs(nz)});
        const glm::dvec2 k = cascade.wave_vector(ix, iz);
        const double w = cascade.frequency[cell], length = glm::length(k);
        waves.waves.push_back({nx, nz, 2.0 * cascade.h0[cell], w, k,
                               choppiness * glsl::wave_sideways(length, w) / length * k});
      }
    }
    cascades_.push_back(std::move(waves));
  }
}

std::vector<std::vector<std::complex<double>>> DirectWater::amplitudes(double time) const {
  std::vector<std::vector<std::complex<double>>> result;
  for (const Waves& cascade : cascades_) {
    auto& values = result.emplace_back();
    values.reserve(cascade.waves.size());
    for (const Wave& wave : cascade.waves) {
      const double turns = wave.frequency / kTau * time;
      values.push_back(wave.h0 * std::polar(1.0, -kTau * (turns - std::floor(turns))));
    }
  }
  return result;
}

DirectPoint DirectWater::sum(
    glm::dvec2 q, const std::vector<std::vector<std::complex<double>>>& amplitudes) const {
  DirectPoint point;
  std::vector<std::complex<double>> along_x, along_z;
  for (std::size_t c = 0; c < cascades_.size(); ++c) {
    const Waves& cascade = cascades_[c];
    // exp(i k.q) is a product of two factors that repeat along the grid's axes.
    const double x = cascade.cosine * q.x + cascade.sine * q.y;
    const double z = cascade.cosine * q.y - cascade.sine * q.x;
    along_x.clear();
    along_z.clear();
    for (int n = -cascade.reach; n <= cascade.reach; ++n) {
      along_x.push_back(std::polar(1.0, std::remainder(n * cascade.dk * x, kTau)));
      along_z.push_back(std::polar(1.0, std::remainder(n * cascade.dk * z, kTau)));
    }
    for (std::size_t i = 0; i < cascade.waves.size(); ++i) {
      const Wave& wave = cascade.waves[i];
      const std::complex<double> h = amplitudes[c][i] *
                                     along_x[static_cast<std::size_t>(wave.nx + cascade.reach)] *
                                     along_z[static_cast<std::size_t>(wave.nz + cascade.reach)];
      // For h = Re a: dh/dx = Re(i k a), dh/dt = Re(-i w a), D = Re(i u a).
      const double real = h.real(), imag = h.imag();
      const glm::dvec2 u = wave.u;
      point.displacement += glm::dvec3(-u.x * imag, real, -u.y * imag);
      point.velocity += wave.frequency * glm::dvec3(u.x * real, imag, u.y * real);
      point.slope -= wave.k * imag;
      point.dxx -= u.x * wave.k.x * real;
      point.dzz -= u.y * wave.k.y * real;
      point.dxz -= u.x * wave.k.y * real;
    }
  }
  return point;
}

std::vector<DirectPoint> DirectWater::at_parameter(std::span<const glm::dvec2> points,
                                                   double time) const {
  const auto waves = amplitudes(time);
  std::vector<DirectPoint> result;
  for (const glm::dvec2 point : points) result.push_back(sum(point, waves));
  return result;
}

void DirectWater::sample(std::span<const glm::dvec2> points, double time,
                         std::span<WaterSample> out) const {
  const auto waves = amplitudes(time);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto at = [&](glm::dvec2 q) {
      const DirectPoint p = sum(q, waves);
      return SurfacePoint{p.displacement, p.slope, p.dxx, p.dzz, p.dxz};
    };
    const Meeting met = meet_surface(points[i], 1e-6, 60, at);
    out[i] = {met.point.displacement.y, surface_normal(met.point),
              sum(met.parameter, waves).velocity};
  }
}

}  // namespace offing
