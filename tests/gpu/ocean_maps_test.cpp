#include <fftw3.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <span>

#include "engine/core/angles.h"
#include "engine/ocean/direct_water.h"
#include "engine/ocean/ocean.h"
#include "engine/ocean/ocean_export.h"
#include "engine/ocean/sea_maps.h"
#include "support/graph_test.h"

namespace offing {
namespace {

std::vector<Cascade> make_sea(int count, int size, double wind, std::uint64_t seed,
                              const SeaState& state = {}) {
  const SeaSpectrum spectrum(state, wind, {0.6, 0.8});
  std::vector<Cascade> cascades;
  const auto bands = choose_bands(spectrum, count, size);
  for (int c = 0; c < count; ++c) {
    cascades.push_back(make_cascade(spectrum, bands[static_cast<std::size_t>(c)], size, seed, c));
  }
  return cascades;
}

class OceanMaps : public test::GraphTest {
 protected:
  /// Runs one frame in which the maps are wanted.
  void run(SeaMaps& maps, double time) {
    graph_->begin_frame();
    const SeaIds ids = maps.add(*graph_, time);
    graph_->add(
        "reader",
        [&](PassBuilder& pass) { pass.read(ids.displacement).read(ids.slopes).side_effect(); },
        [](PassContext&) {});
    graph_->execute();
  }
};

/// One field of one cascade by FFTW in double, from H(k, t) times i^a kx^b kz^c c^d / |k|^d.
std::vector<double> field_by_fftw(const Cascade& cascade, double time, double choppiness,
                                  int field) {
  const int n = cascade.size;
  std::vector<std::complex<double>> spectrum(cascade.h0.size()), out(cascade.h0.size());
  const std::complex<double> i(0.0, 1.0);
  for (int z = 0; z < n; ++z) {
    for (int x = 0; x < n; ++x) {
      const auto at = static_cast<std::size_t>(z * n + x);
      const auto mirror = static_cast<std::size_t>(((n - z) % n) * n + (n - x) % n);
      const double turns = cascade.frequency[at] / kTau * time;
      const auto phase = std::polar(1.0, -kTau * (turns - std::floor(turns)));
      const auto h = cascade.h0[at] * phase + std::conj(cascade.h0[mirror] * phase);
      const glm::dvec2 k = cascade.wave_vector(x, z);
      const double length = std::max(glm::length(k), 1e-12);
      const double inverse = choppiness / (length * std::tanh(length * SeaState{}.depth_m));
      const std::complex<double> factors[8] = {
          i * k.x * inverse, 1.0,     i * k.y * inverse,    -k.x * k.y * inverse,
          i * k.x,           i * k.y, -k.x * k.x * inverse, -k.y * k.y * inverse};
      spectrum[at] = factors[field] * h;
    }
  }
  auto* in = reinterpret_cast<fftw_complex*>(spectrum.data());
  auto* result = reinterpret_cast<fftw_complex*>(out.data());
  fftw_plan plan = fftw_plan_dft_2d(n, n, in, result, FFTW_BACKWARD, FFTW_ESTIMATE);
  fftw_execute(plan);
  fftw_destroy_plan(plan);
  std::vector<double> real;
  for (const auto& value : out) real.push_back(value.real());
  return real;
}

double snr_db(const std::vector<double>& truth, const std::vector<float>& map, std::size_t layer,
              int channel) {
  double signal = 0.0, noise = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double value = map[(layer * truth.size() + i) * 4 + static_cast<std::size_t>(channel)];
    signal += truth[i] * truth[i];
    noise += (value - truth[i]) * (value - truth[i]);
  }
  return 10.0 * std::log10(signal / noise);
}

TEST_F(OceanMaps, TransformAgreesWithFftw) {
  for (const int size : {64, 128, 256, 512}) {
    const int count = size <= 128 ? 3 : 1;
    const auto cascades = make_sea(count, size, 12.0, 7);
    SeaMaps maps(*shaders_, count, size);
    maps.set_waves(cascades, 0.9);
    const double time = 1234.5;
    run(maps, time);
    const auto displacement = maps.displacement().read_floats(4);
    const auto slopes = maps.slopes().read_floats(4);
    for (int c = 0; c < count; ++c) {
      const auto layer = static_cast<std::size_t>(c);
      for (int field = 0; field < 8; ++field) {
        const auto truth = field_by_fftw(cascades[layer], time, 0.9, field);
        const double snr = snr_db(truth, field < 4 ? displacement : slopes, layer, field % 4);
        EXPECT_GT(snr, 120.0) << size << " cascade " << c << " field " << field;
      }
    }
  }
}

// The option: half floats have 11 bits.
TEST_F(OceanMaps, HalfFloatSlopesAreTheSameToTheirElevenBits) {
  const auto cascades = make_sea(1, 64, 12.0, 7);
  SeaMaps single(*shaders_, 1, 64), half(*shaders_, 1, 64, MapStorage::kHalfSlopes);
  std::vector<float> values[2];
  for (SeaMaps* maps : {&single, &half}) {
    maps->set_waves(cascades, 0.9);
    run(*maps, 77.0);
    values[maps == &half] = maps->slopes().read_floats(4);
  }
  for (std::size_t i = 0; i < values[0].size(); ++i) {
    EXPECT_NEAR(values[1][i], values[0][i], std::abs(values[0][i]) * 0x1p-11 + 1e-7);
  }
}

TEST_F(OceanMaps, RunningBackwardsReturnsToTheStart) {
  const auto cascades = make_sea(2, 64, 10.0, 11);
  SeaMaps maps(*shaders_, 2, 64);
  maps.set_waves(cascades, 1.0);
  run(maps, 12.25);
  const auto start = maps.displacement().read_floats(4);
  for (const double time : {30.0, 86400.0 * 30.0, 5.0, -3.0}) run(maps, time);
  run(maps, 12.25);
  EXPECT_EQ(maps.displacement().read_floats(4), start);
}

// Bilinear weights would hide what is asked here, so points of the grid are compared.
TEST_F(OceanMaps, AgreeWithTheDirectSumAfterThirtyDays) {
  const auto cascades = make_sea(3, 64, 10.0, 11);
  const DirectWater direct(cascades, 1.0);
  SeaMaps maps(*shaders_, 3, 64);
  maps.set_waves(cascades, 1.0);
  for (const double time : {0.0, 3600.5, 30.0 * 86400.0 + 0.123, -500.0}) {
    run(maps, time);
    const auto values = maps.displacement().read_floats(4);
    double error = 0.0, height = 0.0;
    int count = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const DirectWater one(std::span<const Cascade>(cascades).subspan(c, 1), 1.0);
      for (int i = 0; i < 40; ++i) {
        const int x = (i * 23) % 64, z = (i * 41) % 64;
        const CascadeBand& band = cascades[c].band;
        const double u = band.length * x / 64.0, v = band.length * z / 64.0;
        const double cosine = std::cos(band.angle), sine = std::sin(band.angle);
        const std::vector<glm::dvec2> q = {{cosine * u - sine * v, sine * u + cosine * v}};
        const auto truth = one.at_parameter(q, time)[0].displacement;
        const std::size_t at =
            ((c * 64 + static_cast<std::size_t>(z)) * 64 + static_cast<std::size_t>(x)) * 4;
        for (int k = 0; k < 3; ++k) {
          error += std::pow(values[at + static_cast<std::size_t>(k)] - truth[k], 2);
          height += truth[k] * truth[k];
          ++count;
        }
      }
    }
    // A tenth of a millimetre is far below what single precision is asked to keep of 2 m waves.
    EXPECT_LT(std::sqrt(error / count), 1e-4) << time;
    EXPECT_GT(std::sqrt(height / count), 0.05);
  }
}

TEST_F(OceanMaps, CoarserLevelsAreMeansOfTheirPoints) {
  const auto cascades = make_sea(2, 64, 10.0, 4);
  SeaMaps maps(*shaders_, 2, 64);
  maps.set_waves(cascades, 1.0);
  run(maps, 3.0);
  const auto fine = maps.displacement().read_floats(4);
  for (int level = 1; level < 6; ++level) {
    const auto coarse = maps.displacement().read_floats(4, level);
    const int size = 64 >> level, block = 1 << level;
    for (int i = 0; i < 20; ++i) {
      const int layer = i % 2, x = (i * 7) % size, z = (i * 13) % size;
      double mean = 0.0;
      for (int b = 0; b < block * block; ++b) {
        const int at = (layer * 64 + z * block + b / block) * 64 + x * block + b % block;
        mean += static_cast<double>(fine[static_cast<std::size_t>(at) * 4 + 1]) / (block * block);
      }
      const int at = (layer * size + z) * size + x;
      EXPECT_NEAR(coarse[static_cast<std::size_t>(at) * 4 + 1], mean, 1e-5) << level;
    }
  }
}

TEST_F(OceanMaps, PausedSeaIsCachedAndUnseenSeaIsNotComputed) {
  Ocean ocean(*shaders_, {.cascades = 2, .size = 64});
  Environment environment;
  ocean.set_sea({}, environment, 1);
  const auto frame = [&](double time, bool visible, bool readback) {
    graph_->begin_frame();
    const SeaIds sea = ocean.add_maps(*graph_, time, readback);
    if (visible) {
      graph_->add(
          "look", [&](PassBuilder& pass) { pass.read(sea.displacement).side_effect(); },
          [](PassContext&) {});
    }
    graph_->execute();
    ocean.collect();
  };
  frame(1.0, true, false);
  frame(1.0, true, false);
  frame(1.0, true, false);
  EXPECT_EQ(row("sea.spectrum").ran, 1);
  EXPECT_EQ(row("sea.fft").ran, 1);
  EXPECT_EQ(row("sea.fft").cached, 2);
  EXPECT_EQ(row("sea.maps").cached, 2);
  frame(2.0, true, false);
  EXPECT_EQ(row("sea.spectrum").ran, 1);
  EXPECT_EQ(row("sea.fft").ran, 2);
  graph_->reset_report();
  frame(3.0, false, false);  // nobody looks
  EXPECT_EQ(row("sea.fft").ran, 0);
  EXPECT_EQ(row("sea.fft").culled, 1);
  environment.wind.speed += 2.0;
  ocean.set_sea({}, environment, 1);
  frame(3.0, true, false);
  EXPECT_EQ(row("sea.spectrum").ran, 1);
  EXPECT_EQ(row("sea.fft").ran, 1);
}

TEST_F(OceanMaps, EveryLimitGivesFiniteMaps) {
  Ocean ocean(*shaders_, {.cascades = 3, .size = 64});
  Environment environment;
  for (const double wind : {0.0, 60.0}) {
    for (const double depth : {0.5, 1e4}) {
      environment.wind.speed = wind;
      SeaState state;
      state.fetch_km = 2000.0;
      state.depth_m = depth;
      state.choppiness = 1.5;
      state.swell = {.height = wind > 0.0 ? 15.0 : 0.0, .period = 25.0, .from_deg = 0.0};
      ocean.set_sea(state, environment, 2);
      for (const auto& cascade : export_cascades(ocean, *graph_, 1e6)) {
        for (const auto* map : {&cascade.dx, &cascade.dy, &cascade.dz, &cascade.slope_x,
                                &cascade.slope_z, &cascade.jacobian}) {
          for (const float value : *map) ASSERT_TRUE(std::isfinite(value));
        }
      }
    }
  }
}

}  // namespace
}  // namespace offing
