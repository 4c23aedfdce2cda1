#include "engine/ocean/fft_moments.h"

#include <fftw3.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <complex>

#include "engine/core/angles.h"

#define OFFING_GLSL "shaders/lib/waves.glsl"
#include "engine/core/glsl_double.h"

namespace offing {

// The transforms of one set of waves: along z for the columns that carry waves, then along x to
// real numbers. Half of a real field's columns suffice, and a quarter of those have waves at all.
class FftMoments::Transform {
 public:
  explicit Transform(std::shared_ptr<const QueryWaves> waves)
      : waves_(std::move(waves)), size_(waves_->size()) {
    const std::size_t n = static_cast<std::size_t>(size_);
    columns_ = static_cast<int>(n / 4);
    // FFTW_ESTIMATE: plans that were timed may differ between runs, and so would the last bits.
    const std::size_t half = n * (n / 2 + 1);
    spectrum_ = fftwf_alloc_complex(half);
    std::fill_n(&spectrum_[0][0], 2 * half, 0.0f);
    along_z_ = fftwf_plan_many_dft(1, &size_, columns_, spectrum_, nullptr, 1, size_, spectrum_,
                                   nullptr, 1, size_, FFTW_BACKWARD, FFTW_ESTIMATE);
    constexpr int kStride = WaveMoment::kFloats;
    std::vector<float> field(n * n * WaveMoment::kFloats);
    along_x_ = fftwf_plan_many_dft_c2r(1, &size_, size_, spectrum_, nullptr, size_, 1, field.data(),
                                       nullptr, kStride, kStride * size_,
                                       FFTW_ESTIMATE | FFTW_PRESERVE_INPUT | FFTW_UNALIGNED);
    for (const Cascade& cascade : waves_->cascades()) modes_.push_back(modes_of(cascade));
  }
  ~Transform() {
    fftwf_destroy_plan(along_z_);
    fftwf_destroy_plan(along_x_);
    fftwf_free(spectrum_);
  }
  Transform(const Transform&) = delete;
  Transform& operator=(const Transform&) = delete;

  const std::shared_ptr<const QueryWaves>& waves() const { return waves_; }

  std::shared_ptr<const WaveMoment> at(std::int64_t index) {
    auto moment = std::make_shared<WaveMoment>();
    moment->index = index;
    moment->values.assign(waves_->points() * WaveMoment::kFloats, 0.0f);
    const double time = static_cast<double>(index) * kMomentStep;
    const std::size_t patch = moment->values.size() / modes_.size();
    float* out = moment->values.data();
    for (const std::vector<Mode>& modes : modes_) {
      heights_.clear();
      for (const Mode& mode : modes) {
        const double turns = mode.turns * time;
        const std::complex<float> phase(std::polar(1.0, kTau * (turns - std::floor(turns))));
        const std::complex<float> a = mode.h0 * std::conj(phase), b = mode.back * phase;
        const std::complex<float> d = mode.frequency * (a - b);
        heights_.push_back({a + b, {d.imag(), -d.real()}});  // -i w (a - b)
      }
      // Dx, h, Dz and their rates: D = i u H.
      for (int field = 0; field < 6; ++field) {
        std::fill_n(&spectrum_[0][0], 2 * static_cast<std::size_t>(columns_ * size_), 0.0f);
        for (std::size_t i = 0; i < modes.size(); ++i) {
          const Mode& mode = modes[i];
          const std::complex<float> h = field < 3 ? heights_[i].value : heights_[i].rate;
          auto& cell = spectrum_[mode.cell];
          if (field % 3 == 1) {
            cell[0] = h.real();
            cell[1] = h.imag();
          } else {
            const float u = field % 3 == 0 ? mode.ux : mode.uz;
            cell[0] = -u * h.imag();
            cell[1] = u * h.real();
          }
        }
        fftwf_execute(along_z_);
        const int place = field < 3 ? field : field + 1;
        fftwf_execute_dft_c2r(along_x_, spectrum_, out + place);
      }
      out += patch;
    }
    return moment;
  }

 private:
  struct Mode {
    std::size_t cell;              // [column x][z]
    std::complex<float> h0, back;  // h0(k) and conj(h0(-k))
    float frequency, ux, uz;       // rad/s; D = i u H at choppiness 1
    double turns;                  // per second
  };
  struct Height {
    std::complex<float> value, rate;
  };

  std::vector<Mode> modes_of(const Cascade& cascade) const {
    std::vector<Mode> modes;
    for (int x = 0; x < columns_; ++x) {
      for (int z = 0; z < size_; ++z) {
        const auto cell = static_cast<std::size_t>(z * size_ + x);
        const auto back =
            static_cast<std::size_t>(((size_ - z) % size_) * size_ + (size_ - x) % size_);
        if (cascade.h0[cell] == 0.0 && cascade.h0[back] == 0.0) continue;
        const double w = std::max(cascade.frequency[cell], cascade.frequency[back]);
        const glm::dvec2 k = cascade.wave_vector(x, z);
        const double length = glm::length(k);
        const glm::dvec2 u = glsl::wave_sideways(length, w) / length * k;
        modes.push_back({static_cast<std::size_t>(x * size_ + z),
                         std::complex<float>(cascade.h0[cell]),
                         std::conj(std::complex<float>(cascade.h0[back])), static_cast<float>(w),
                         static_cast<float>(u.x), static_cast<float>(u.y), w / kTau});
      }
    }
    return modes;
  }

  std::shared_ptr<const QueryWaves> waves_;
  int size_, columns_ = 0;
  fftwf_complex* spectrum_ = nullptr;  // [column][z]; columns without waves stay 0
  fftwf_plan along_z_ = nullptr, along_x_ = nullptr;
  std::vector<std::vector<Mode>> modes_;
  std::vector<Height> heights_;
};

FftMoments::FftMoments() : thread_([this] { work_ahead(); }) {}

FftMoments::~FftMoments() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

std::shared_ptr<const WaveMoment> FftMoments::find(const Key& key) const {
  for (const Entry& entry : known_) {
    if (entry.key == key) return entry.moment;
  }
  return nullptr;
}

void FftMoments::take(const std::shared_ptr<const QueryWaves>& waves) {
  constexpr std::size_t kMostSeas = 2;  // one that comes and one that goes
  // FFTW's planner is not safe in threads: hence here and not where moments are made.
  auto transform = std::make_unique<Transform>(waves);
  const std::lock_guard transforming(transforming_);
  if (transforms_.size() >= kMostSeas) transforms_.erase(transforms_.begin());
  transforms_.push_back(std::move(transform));
}

MomentPair FftMoments::around(const std::shared_ptr<const QueryWaves>& waves, std::int64_t index) {
  MomentPair pair{find_or_make({waves, index}), find_or_make({waves, index + 1})};
  if (pair.before == nullptr || pair.after == nullptr) return {};
  {
    const std::lock_guard lock(mutex_);
    if (index != asked_) backwards_ = index < asked_;
    asked_ = index;
    const Key next{waves, backwards_ ? index - 1 : index + 2};
    if (find(next) != nullptr) return pair;
    wanted_ = next;
  }
  wake_.notify_one();
  return pair;
}

std::shared_ptr<const WaveMoment> FftMoments::find_or_make(const Key& key) {
  {
    const std::lock_guard lock(mutex_);
    if (auto known = find(key)) return known;
  }
  const std::lock_guard transforming(transforming_);
  {
    const std::lock_guard lock(mutex_);  // made while this call waited?
    if (auto known = find(key)) return known;
  }
  for (const auto& transform : transforms_) {
    if (transform->waves() != key.waves) continue;
    auto moment = transform->at(key.index);
    constexpr std::size_t kMostMoments = 12;
    const std::lock_guard lock(mutex_);
    known_.push_back({key, moment});
    if (known_.size() > kMostMoments) known_.pop_front();
    return moment;
  }
  return nullptr;  // waves of a sea that has gone
}

void FftMoments::work_ahead() {
  while (true) {
    Key key;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return stop_ || wanted_.has_value(); });
      if (stop_) return;
      key = *wanted_;
      wanted_.reset();
    }
    find_or_make(key);
  }
}

}  // namespace offing
