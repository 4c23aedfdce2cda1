#include "game/bench/sea_transforms.h"

#include <epoxy/gl.h>
#include <fftw3.h>

#include <cmath>
#include <complex>

#include "engine/core/angles.h"
#include "engine/gl/texture.h"
#include "engine/ocean/sea_transform.h"
#include "engine/ocean/spectrum.h"

namespace offing {
namespace {

using Complex = std::complex<double>;
constexpr int kFields = 4;
constexpr double kTime = 1234.5;

std::vector<Cascade> bench_sea(int size, int cascades) {
  const SeaSpectrum spectrum(SeaState{}, 10.0, {0.6, 0.8});
  std::vector<Cascade> result;
  for (const CascadeBand& band : choose_bands(spectrum, cascades, size)) {
    result.push_back(make_cascade(spectrum, band, size, 1, static_cast<int>(result.size())));
  }
  return result;
}

// Spectra of Dx + i Dz, h, sx + i sz, Dxx + i Dzz by cascade and field: [z][x].
std::vector<std::vector<Complex>> spectra_of(const std::vector<Cascade>& cascades) {
  std::vector<std::vector<Complex>> result;
  const Complex i(0.0, 1.0);
  for (const Cascade& cascade : cascades) {
    const int n = cascade.size;
    std::vector<std::vector<Complex>> fields(kFields, std::vector<Complex>(cascade.h0.size()));
    for (int z = 0; z < n; ++z) {
      for (int x = 0; x < n; ++x) {
        const auto at = static_cast<std::size_t>(z * n + x);
        const auto mirror = static_cast<std::size_t>(((n - z) % n) * n + (n - x) % n);
        const Complex phase = std::polar(1.0, -std::fmod(cascade.frequency[at] * kTime, kTau));
        const Complex h = cascade.h0[at] * phase + std::conj(cascade.h0[mirror] * phase);
        const glm::dvec2 k = cascade.wave_vector(x, z);
        const double length = std::max(std::hypot(k.x, k.y), 1e-12);
        const Complex dx = i * k.x / length * h, dz = i * k.y / length * h;
        fields[0][at] = dx + i * dz;
        fields[1][at] = h;
        fields[2][at] = i * k.x * h - k.y * h;
        fields[3][at] = i * k.x * dx - k.y * dz;
      }
    }
    for (auto& field : fields) result.push_back(std::move(field));
  }
  return result;
}

// Heights of the first cascade in double precision.
std::vector<double> true_heights(std::vector<Complex> spectrum, int size) {
  auto* data = reinterpret_cast<fftw_complex*>(spectrum.data());
  const fftw_plan plan = fftw_plan_dft_2d(size, size, data, data, FFTW_BACKWARD, FFTW_ESTIMATE);
  fftw_execute(plan);
  fftw_destroy_plan(plan);
  std::vector<double> heights;
  heights.reserve(spectrum.size());
  for (const Complex& value : spectrum) heights.push_back(value.real());
  return heights;
}

template <class Height>
double snr_db(const std::vector<double>& truth, const Height& height_at) {
  double signal = 0.0, noise = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double miss = static_cast<double>(height_at(i)) - truth[i];
    signal += truth[i] * truth[i];
    noise += miss * miss;
  }
  return 10.0 * std::log10(signal / noise);
}

gl::Texture array_of(const std::string& label, GLenum format, int size, int layers) {
  return gl::Texture(label, {.format = format, .width = size, .height = size, .layers = layers});
}

TransformRun run_ours(ShaderLibrary& shaders, const std::vector<Cascade>& cascades, int repeats,
                      const std::vector<double>& truth) {
  const int size = cascades.front().size, count = static_cast<int>(cascades.size());
  const SeaModes packed = pack_modes(cascades, 1.0);
  const gl::Buffer modes = gl::Buffer::of<float>("bench.modes", packed.modes);
  const gl::Buffer grids = gl::Buffer::of<float>("bench.grids", packed.grids);
  const gl::Buffer twiddles = make_twiddles(size);
  const gl::Buffer work("bench.work", work_bytes(count, size, kFields), 0);
  const std::size_t points = cascades.size() * cascades.front().h0.size();
  const gl::Buffer displacement("bench.displacement", points * 4 * sizeof(float), 0);
  const gl::Buffer slopes("bench.slopes", points * 4 * sizeof(float), 0);
  const ShaderProgram& columns =
      shaders.program({"ocean/columns.comp"}, transform_defines(size, kFields));
  const ShaderProgram& rows =
      shaders.program({"ocean/rows.comp"}, transform_defines(size, kFields));
  const auto run_columns = [&] {
    modes.bind_storage(0);
    twiddles.bind_storage(1);
    work.bind_storage(2);
    grids.bind_storage(3);
    columns.use();
    set_time(columns, kTime);
    glDispatchCompute(static_cast<GLuint>(groups_for(size / 2, size)), static_cast<GLuint>(count),
                      1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  };
  const auto run_rows = [&] {
    displacement.bind_storage(4);
    slopes.bind_storage(5);
    rows.use();
    glDispatchCompute(static_cast<GLuint>(groups_for(size, size)), static_cast<GLuint>(count), 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  };
  TransformRun run{.name = "ours", .taken = {}};
  run.taken = time_of(repeats, [&] {
    run_columns();
    run_rows();
  });
  run.columns_ms = time_of(repeats, run_columns).processor;
  std::vector<float> values(points * 4);
  displacement.read(values.data(), values.size() * sizeof(float));
  run.snr_db = snr_db(truth, [&](std::size_t i) { return values[4 * i + 1]; });
  return run;
}

// Twiddle factor and the two indices of every point, stage by stage; the first takes the inputs in
// bit-reversed order.
std::vector<float> butterflies_of(int size, int stages) {
  std::vector<float> table;
  for (int stage = 0; stage < stages; ++stage) {
    const int span = 1 << stage;
    for (int i = 0; i < size; ++i) {
      const int inside = i % (2 * span);
      int top = i - inside + inside % span, bottom = top + span;
      if (stage == 0) {
        const auto reversed = [stages](int value) {
          int result = 0;
          for (int bit = 0; bit < stages; ++bit)
            result |= ((value >> bit) & 1) << (stages - 1 - bit);
          return result;
        };
        top = reversed(top);
        bottom = reversed(bottom);
      }
      const double angle = kTau * inside / (2 * span);
      table.insert(table.end(),
                   {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)),
                    static_cast<float>(top), static_cast<float>(bottom)});
    }
  }
  return table;
}

TransformRun run_plain(ShaderLibrary& shaders, const std::vector<std::vector<Complex>>& spectra,
                       int size, int repeats, const std::vector<double>& truth) {
  const int layers = static_cast<int>(spectra.size());
  const int stages = static_cast<int>(std::lround(std::log2(size)));
  const gl::Buffer butterflies =
      gl::Buffer::of<float>("bench.butterflies", butterflies_of(size, stages));
  const gl::Texture source = array_of("bench.source", GL_RG32F, size, layers);
  const gl::Texture ping = array_of("bench.ping", GL_RG32F, size, layers);
  const gl::Texture pong = array_of("bench.pong", GL_RG32F, size, layers);
  for (int layer = 0; layer < layers; ++layer) {
    std::vector<float> values;
    for (const Complex& value : spectra[static_cast<std::size_t>(layer)]) {
      values.push_back(static_cast<float>(value.real()));
      values.push_back(static_cast<float>(value.imag()));
    }
    source.upload(GL_RG, GL_FLOAT, values.data(), 0, layer);
  }
  const ShaderProgram& stage_program = shaders.program({"ocean/plain_stage.comp"});
  const gl::Texture* last = nullptr;
  TransformRun run{.name = "plain radix-2", .taken = {}};
  run.taken = time_of(repeats, [&] {
    stage_program.use();
    butterflies.bind_storage(0);
    const gl::Texture* from = &source;
    const gl::Texture* to = &ping;
    for (int along_y = 0; along_y < 2; ++along_y) {
      for (int stage = 0; stage < stages; ++stage) {
        from->bind_image(0, GL_READ_ONLY);
        to->bind_image(1, GL_WRITE_ONLY);
        stage_program.program().set(0, glm::ivec2(stage, along_y));
        const auto groups = static_cast<GLuint>(size / 16);
        glDispatchCompute(groups, groups, static_cast<GLuint>(layers));
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        last = to;
        from = to;
        to = to == &ping ? &pong : &ping;
      }
    }
  });
  const std::vector<float> values = last->read_floats(2);
  const std::size_t first = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  run.snr_db = snr_db(truth, [&](std::size_t i) { return values[2 * (first + i)]; });
  return run;
}

TransformRun run_fftw(const std::vector<std::vector<Complex>>& spectra, int size, int repeats,
                      const std::vector<double>& truth) {
  const std::size_t points = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  fftwf_complex* in = fftwf_alloc_complex(points * spectra.size());
  fftwf_complex* out = fftwf_alloc_complex(points * spectra.size());
  const int shape[2] = {size, size};
  const fftwf_plan plan = fftwf_plan_many_dft(
      2, shape, static_cast<int>(spectra.size()), in, nullptr, 1, static_cast<int>(points), out,
      nullptr, 1, static_cast<int>(points), FFTW_BACKWARD, FFTW_MEASURE);
  for (std::size_t f = 0; f < spectra.size(); ++f) {
    for (std::size_t i = 0; i < points; ++i) {
      in[f * points + i][0] = static_cast<float>(spectra[f][i].real());
      in[f * points + i][1] = static_cast<float>(spectra[f][i].imag());
    }
  }
  TransformRun run{.name = "FFTW, one thread", .taken = {}};
  run.taken = time_of(repeats, [&] { fftwf_execute(plan); });
  run.snr_db = snr_db(truth, [&](std::size_t i) { return out[points + i][0]; });
  fftwf_destroy_plan(plan);
  fftwf_free(in);
  fftwf_free(out);
  return run;
}

}  // namespace

std::vector<TransformRun> time_transforms(ShaderLibrary& shaders, int size, int cascades,
                                          int repeats) {
  const std::vector<Cascade> sea = bench_sea(size, cascades);
  const auto spectra = spectra_of(sea);
  const std::vector<double> truth = true_heights(spectra[1], size);
  std::vector<TransformRun> runs = {run_ours(shaders, sea, repeats, truth),
                                    run_plain(shaders, spectra, size, repeats, truth),
                                    run_fftw(spectra, size, repeats, truth)};
  const double points = static_cast<double>(size) * size;
  for (TransformRun& run : runs) {
    const double operations = 5.0 * points * std::log2(points) * kFields * cascades;
    run.gflops = operations / run.taken.least * 1e-6;
  }
  return runs;
}

}  // namespace offing
