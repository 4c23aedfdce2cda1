#include "engine/environment/squall_field.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/core/angles.h"

namespace offing {
namespace {

using Complex = std::complex<double>;

/// Outflow without swirl whose divergence is the rain's, less its mean: u = grad of the solution of
/// Poisson's equation, by Fourier transform. In units of its largest speed.
std::vector<glm::dvec2> outflow(const std::vector<float>& rain, int size) {
  const auto count = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  std::vector<Complex> field(rain.begin(), rain.end()), x(count), z(count);
  const auto transform = [size](std::vector<Complex>& values, int sign) {
    auto* data = reinterpret_cast<fftw_complex*>(values.data());
    const fftw_plan plan = fftw_plan_dft_2d(size, size, data, data, sign, FFTW_ESTIMATE);
    fftw_execute(plan);
    fftw_destroy_plan(plan);
  };
  transform(field, FFTW_FORWARD);
  for (int row = 0; row < size; ++row) {
    const double kz = row < size / 2 ? row : row - size;
    for (int column = 0; column < size; ++column) {
      const double kx = column < size / 2 ? column : column - size;
      const auto i = static_cast<std::size_t>(row * size + column);
      const double k2 = kx * kx + kz * kz;
      const Complex potential = k2 > 0.0 ? -field[i] / k2 : Complex(0.0);
      x[i] = Complex(0.0, kx) * potential;
      z[i] = Complex(0.0, kz) * potential;
    }
  }
  transform(x, FFTW_BACKWARD);
  transform(z, FFTW_BACKWARD);
  std::vector<glm::dvec2> flow(count);
  double fastest = 1e-12;
  for (std::size_t i = 0; i < count; ++i) {
    flow[i] = {x[i].real(), z[i].real()};
    fastest = std::max(fastest, glm::length(flow[i]));
  }
  for (glm::dvec2& v : flow) v /= fastest;
  return flow;
}

}  // namespace

SquallField::SquallField(const std::vector<float>& rain, int size, double period, glm::dvec2 wind,
                         double strength)
    : size_(size), period_(period) {
  const float heaviest = *std::max_element(rain.begin(), rain.end());
  if (heaviest <= 0.0f || strength <= 0.0) return;
  added_ = outflow(rain, size);
  strength_.resize(rain.size());
  const double mean = std::max(glm::length(wind), 1.0);
  for (std::size_t i = 0; i < rain.size(); ++i) {
    added_[i] = strength * (kOutflow * static_cast<double>(heaviest) * added_[i] +
                            kBroughtDown * static_cast<double>(rain[i]) * wind);
    strength_[i] = static_cast<float>((glm::length(wind + added_[i]) - glm::length(wind)) / mean);
  }
}

glm::dvec2 SquallField::added(glm::dvec2 place) const {
  if (!any()) return glm::dvec2(0.0);
  const glm::dvec2 at = place * (size_ / period_) - 0.5;
  const glm::dvec2 cell = glm::floor(at), share = at - cell;
  const auto wrapped = [this](double i) {
    return static_cast<std::size_t>(i - size_ * std::floor(i / size_)) %
           static_cast<std::size_t>(size_);
  };
  const std::size_t i0 = wrapped(cell.x), i1 = wrapped(cell.x + 1.0);
  const std::size_t j0 = wrapped(cell.y) * static_cast<std::size_t>(size_);
  const std::size_t j1 = wrapped(cell.y + 1.0) * static_cast<std::size_t>(size_);
  return glm::mix(glm::mix(added_[j0 + i0], added_[j0 + i1], share.x),
                  glm::mix(added_[j1 + i0], added_[j1 + i1], share.x), share.y);
}

}  // namespace offing
