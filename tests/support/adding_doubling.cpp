#include "support/adding_doubling.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace offing::test {
namespace {

/// A square matrix, just large enough for this.
class Matrix {
 public:
  explicit Matrix(std::size_t size) : size_(size), values_(size * size, 0.0) {}
  double& at(std::size_t i, std::size_t j) { return values_[i * size_ + j]; }
  double at(std::size_t i, std::size_t j) const { return values_[i * size_ + j]; }
  std::size_t size() const { return size_; }

  friend Matrix operator*(const Matrix& a, const Matrix& b) {
    Matrix c(a.size_);
    for (std::size_t i = 0; i < a.size_; ++i) {
      for (std::size_t k = 0; k < a.size_; ++k) {
        for (std::size_t j = 0; j < a.size_; ++j) c.at(i, j) += a.at(i, k) * b.at(k, j);
      }
    }
    return c;
  }

 private:
  std::size_t size_;
  std::vector<double> values_;
};

/// (1 - m)^-1 by Gauss and Jordan; the diagonal of what comes here is near one.
Matrix inverse_of_rest(const Matrix& m) {
  const std::size_t n = m.size();
  Matrix a(n), b(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) a.at(i, j) = (i == j ? 1.0 : 0.0) - m.at(i, j);
    b.at(i, i) = 1.0;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double scale = 1.0 / a.at(i, i);
    for (std::size_t j = 0; j < n; ++j) {
      a.at(i, j) *= scale;
      b.at(i, j) *= scale;
    }
    for (std::size_t r = 0; r < n; ++r) {
      const double factor = a.at(r, i);
      if (r == i || factor == 0.0) continue;
      for (std::size_t j = 0; j < n; ++j) {
        a.at(r, j) -= factor * a.at(i, j);
        b.at(r, j) -= factor * b.at(i, j);
      }
    }
  }
  return b;
}

}  // namespace

Quadrature gauss_legendre(int count) {
  Quadrature q;
  for (int i = 0; i < count; ++i) {
    double z = std::cos(3.14159265358979323846 * (i + 0.75) / (count + 0.5)), slope = 1.0;
    for (int pass = 0; pass < 20; ++pass) {
      double value = 1.0, before = 0.0;
      for (int j = 0; j < count; ++j)
        before = std::exchange(value, ((2 * j + 1) * z * value - j * before) / (j + 1));
      slope = count * (z * value - before) / (z * z - 1.0);
      z -= value / slope;
    }
    q.points.push_back(0.5 * (1.0 - z));
    q.weights.push_back(1.0 / ((1.0 - z * z) * slope * slope));
  }
  return q;
}

std::vector<double> slab_albedo(double depth, double g, const std::vector<double>& cosines,
                                double albedo) {
  constexpr int kStreams = 20, kTerms = 2 * kStreams;
  Quadrature q = gauss_legendre(kStreams);
  // The beams ride along as streams without weight: by reciprocity, what such a stream sends back
  // of an even light of 1 is the albedo for a beam that comes in along it.
  for (const double cosine : cosines) {
    q.points.push_back(cosine);
    q.weights.push_back(0.0);
  }
  const std::size_t n = q.points.size();

  std::vector<std::vector<double>> legendre(n, std::vector<double>(kTerms));
  for (std::size_t i = 0; i < n; ++i) {
    legendre[i][0] = 1.0;
    legendre[i][1] = q.points[i];
    for (std::size_t l = 1; l + 1 < kTerms; ++l) {
      const auto order = static_cast<double>(l);
      legendre[i][l + 1] =
          ((2 * order + 1) * q.points[i] * legendre[i][l] - order * legendre[i][l - 1]) /
          (order + 1);
    }
  }
  const double peak = std::pow(g, kTerms);  // what the streams cannot tell from going straight on
  const double scaled_depth = depth * (1.0 - albedo * peak);
  const double scaled_albedo = albedo * (1.0 - peak) / (1.0 - albedo * peak);

  int doublings = 0;
  double thin = scaled_depth;
  for (; thin > 1e-7; thin *= 0.5) ++doublings;
  Matrix reflect(n), transmit(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      double back = 0.0, on = 0.0, moment = 1.0;
      for (std::size_t l = 0; l < kTerms; ++l, moment *= g) {
        const double term = (2.0 * static_cast<double>(l) + 1.0) * (moment - peak) / (1.0 - peak) *
                            legendre[i][l] * legendre[j][l];
        on += term;
        back += l % 2 == 1 ? -term : term;
      }
      const double share = thin / q.points[i] * 0.5 * scaled_albedo * q.weights[j];
      reflect.at(i, j) = share * back;
      transmit.at(i, j) = share * on + (i == j ? 1.0 - thin / q.points[i] : 0.0);
    }
  }
  for (int step = 0; step < doublings; ++step) {
    const Matrix bounced = transmit * inverse_of_rest(reflect * reflect);
    const Matrix returned = bounced * reflect * transmit;
    transmit = bounced * transmit;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) reflect.at(i, j) += returned.at(i, j);
    }
  }
  std::vector<double> result;
  for (std::size_t i = kStreams; i < n; ++i) {
    double sum = 0.0;
    for (std::size_t j = 0; j < kStreams; ++j) sum += reflect.at(i, j);
    result.push_back(sum);
  }
  return result;
}

}  // namespace offing::test
