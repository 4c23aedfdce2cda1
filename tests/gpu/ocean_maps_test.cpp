#include <fftw3.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <complex>

#include "engine/core/angles.h"
#include "engine/core/random.h"
#include "engine/graph/gl_device.h"
#include "engine/ocean/direct_water.h"
#include "engine/ocean/sea_maps.h"
#include "support/gl_test.h"

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

class OceanMaps : public test::GlTest {
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
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    shaders_ = std::make_unique<ShaderLibrary>(data_root() / "shaders");
    device_ = std::make_unique<GlDevice>();
    graph_ = std::make_unique<FrameGraph>(*device_);
  }
  void TearDown() override {
    graph_.reset();
    device_.reset();
    shaders_.reset();
    GlTest::TearDown();
  }
  std::unique_ptr<ShaderLibrary> shaders_;
  std::unique_ptr<GlDevice> device_;
  std::unique_ptr<FrameGraph> graph_;
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
      const double inverse = choppiness / std::max(glm::length(k), 1e-12);
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
        // Single precision with two exact-table steps; half-float storage has 11 bits.
        EXPECT_GT(snr, field < 4 ? 110.0 : 66.0) << size << " cascade " << c << " field " << field;
      }
    }
  }
}

TEST_F(OceanMaps, Timing) {
  for (const int size : {128, 256}) {
    const auto cascades = make_sea(3, size, 12.0, 7);
    SeaMaps maps(*shaders_, 3, size);
    maps.set_waves(cascades, 0.9);
    graph_->set_timing(true);
    graph_->reset_report();
    run(maps,0.05); glFinish(); auto c0=clock(); for (int i = 0; i < 40; ++i) run(maps, 0.1 * i);
 glFinish(); printf("%d cpu %.2f ms/2\n", size, double(clock()-c0)/CLOCKS_PER_SEC*1e3/40/2);
    for (const auto& pass : graph_->report()) {
      auto ms = pass.milliseconds;
      std::sort(ms.begin(), ms.end());
      if (!ms.empty()) printf("%d %s %.2f ms\n", size, pass.name.c_str(), ms[0]);
    }
  }
}

}  // namespace
}  // namespace offing
