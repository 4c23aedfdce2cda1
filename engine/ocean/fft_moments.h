#pragma once
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "engine/ocean/query_waves.h"

namespace offing {

/// Moments by FFTW on the CPU, in single precision with phases in double: exact at any time, never
/// late. A moment takes about a millisecond; the one that will be wanted next is made ahead by a
/// thread of its own, so that in a steady run nobody waits. The same moment always has the same
/// bits, whoever makes it and whatever the frame rate.
class FftMoments final : public MomentSource {
 public:
  FftMoments();
  ~FftMoments() override;
  FftMoments(const FftMoments&) = delete;
  FftMoments& operator=(const FftMoments&) = delete;

  void take(const std::shared_ptr<const QueryWaves>& waves) override;
  MomentPair around(const std::shared_ptr<const QueryWaves>& waves, std::int64_t index) override;

 private:
  class Transform;
  struct Key {
    std::shared_ptr<const QueryWaves> waves;
    std::int64_t index = 0;
    bool operator==(const Key&) const = default;
  };
  struct Entry {
    Key key;
    std::shared_ptr<const WaveMoment> moment;
  };
  std::shared_ptr<const WaveMoment> find(const Key& key) const;  // with mutex_ held
  std::shared_ptr<const WaveMoment> find_or_make(const Key& key);
  void work_ahead();

  mutable std::mutex mutex_;  // guards what follows
  std::condition_variable wake_;
  std::deque<Entry> known_;  // newest last
  std::optional<Key> wanted_;
  std::int64_t asked_ = 0;  // the last index
  bool backwards_ = false;  // time runs that way
  bool stop_ = false;

  std::mutex transforming_;  // guards transforms_
  std::vector<std::unique_ptr<Transform>> transforms_;
  std::thread thread_;
};

}  // namespace offing
