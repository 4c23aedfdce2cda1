#include "engine/sky/probe.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/core/angles.h"
#include "engine/environment/calendar.h"
#include "engine/sky/probe_reference.h"
#include "support/sky_graph_test.h"

namespace offing {
namespace {

using test::sun_at;

class ProbeTest : public test::SkyGraphTest {
 protected:
  void SetUp() override {
    SkyGraphTest::SetUp();
    if (IsSkipped()) return;
    probe_ = std::make_unique<Probe>(*shaders_, ProbeSettings::of_quality(0));
    reference_ = std::make_unique<ProbeReference>(*shaders_);
  }

  /// One frame; the answers to the queries, where there are any.
  std::vector<ProbeAnswer> frame(const CelestialState& celestial,
                                 std::vector<ProbeQuery> queries = {}, int samples = 1) {
    light_ = model_.update(celestial, 0.1, 3.0);
    const SkyIds sky = begin_frame(light_);
    const ProbeIds ids = probe_->add(*graph_, light_, 8.0, *sky_, sky, {}, on_);
    std::vector<ProbeAnswer> answers;
    graph_->add(
        "ask",
        [&](PassBuilder& pass) {
          sky.read_by(pass);
          ids.read_by(pass);
          pass.side_effect();
        },
        [&](const PassContext& context) {
          if (!queries.empty()) {
            answers = reference_->ask(context, *sky_, sky, *probe_, ids, queries, samples);
          }
        });
    graph_->execute();
    return answers;
  }

  PassReport row() const { return SkyGraphTest::row("sky.probe"); }

  static double luminance(const glm::vec3& c) {
    return glm::dot(glm::dvec3(c), glm::dvec3(0.2126, 0.7152, 0.0722));
  }

  std::unique_ptr<Probe> probe_;
  std::unique_ptr<ProbeReference> reference_;
  bool on_ = true;
};

TEST_F(ProbeTest, RoughMirrorsAgreeWithBruteForce) {
  // The first frame is whole. Most of these lie between two levels of the map. The mean is that of
  // the whole sphere; with the sun at 6 degrees red light beside it is seventy times as much.
  for (const double elevation : {50.0, 6.0, -4.0}) {
    for (const float roughness :
         {0.0f, 0.05f, 0.07f, 0.1f, 0.15f, 0.2f, 0.3f, 0.4f, 0.6f, 0.8f, 1.0f}) {
      const int samples = roughness == 0.0f ? 1 : 4096;
      const auto answers =
          frame(sun_at(240.0, elevation), queries_all_round(256, roughness), samples);
      EXPECT_LT(relative_rms(answers), 0.02) << elevation << " " << roughness;
    }
  }
}

TEST_F(ProbeTest, ALowSunsGlowIsKept) {
  for (const float roughness : {0.07f, 0.1f, 0.2f, 0.3f, 0.4f, 0.6f, 0.8f, 1.0f}) {
    const auto answers = frame(sun_at(240.0, 6.0), queries_all_round(256, roughness), 4096);
    double most = 0.0, shown = 0.0;
    for (const ProbeAnswer& answer : answers) {
      const double wanted = luminance(answer.reference);
      if (wanted <= most) continue;
      most = wanted;
      shown = luminance(answer.probe);
    }
    EXPECT_NEAR(shown / most, 1.0, 0.02) << roughness;
  }
}

TEST_F(ProbeTest, IrradianceIsThatOfTheSky) {
  for (const double elevation : {50.0, 6.0, -4.0}) {
    const auto answers = frame(sun_at(240.0, elevation), queries_all_round(96, -1.0f), 2048);
    // Harmonics of order 2 leave out what changes faster (Ramamoorthi & Hanrahan 2001): 1 % where
    // light comes from all over the sky, some more about a low sun.
    EXPECT_LT(relative_rms(answers), elevation > 30.0 ? 0.015 : 0.045) << elevation;
    // Upward it is what the CPU's light model says, which is worked out elsewhere.
    const ProbeAnswer up = frame(sun_at(240.0, elevation), {{{0, 1, 0}, -1.0f}}, 4096)[0];
    const double model = luminance(glm::vec3(light_.sky_illuminance));
    EXPECT_NEAR(luminance(up.reference) / model, 1.0, 0.05) << elevation;
    EXPECT_NEAR(luminance(up.probe) / model, 1.0, 0.08) << elevation;
  }
}

TEST_F(ProbeTest, HoldsNoonAndNight) {
  CelestialState night = sun_at(240.0, -60.0);
  for (const CelestialState& state : {sun_at(180.0, 70.0), night}) {
    const auto answers = frame(state, queries_all_round(64, 0.4f), 1024);
    EXPECT_LT(relative_rms(answers), 0.03);
    for (const ProbeAnswer& answer : answers) EXPECT_GT(luminance(answer.probe), 0.0);
  }
}

TEST_F(ProbeTest, SwitchedOffItShowsThePlainSky) {
  const CelestialState state = sun_at(240.0, 30.0);
  const glm::vec3 up(0, 1, 0), out = glm::normalize(glm::vec3(1, 0.4, 0.2));
  const std::vector<ProbeQuery> queries = {{out, 0.0f}, {out, 0.5f}, {out, 1.0f}, {up, -1.0f}};
  const auto on = frame(state, queries, 256);
  on_ = false;
  const auto off = frame(state, queries, 256);  // a switch is a leap: shown at once
  const double sky = luminance(off[0].reference);
  // The roughest level has 16 texels a side, with straight lines between them: 3 % here.
  for (const int i : {0, 1, 2}) {
    EXPECT_NEAR(luminance(off[i].probe) / sky, 1.0, i < 2 ? 0.02 : 0.04) << i;
  }
  EXPECT_GT(std::abs(luminance(on[2].probe) / sky - 1.0), 0.1);
  EXPECT_NEAR(luminance(off[3].probe) / luminance(glm::vec3(light_.sky_illuminance)), 1.0, 0.01);
  on_ = true;
  EXPECT_NEAR(luminance(frame(state, queries)[2].probe) / luminance(on[2].probe), 1.0, 1e-3);
}

TEST_F(ProbeTest, StandsStillWithTheClock) {
  const CelestialState s = sun_at(200.0, 25.0);
  for (int i = 0; i < 6; ++i) frame(s);
  EXPECT_EQ(row().ran, 1);
  EXPECT_EQ(row().cached, 5);
  // Time goes on for one frame and stops: the refresh is finished and brought in, then nothing.
  const CelestialState later = sun_at(200.1, 25.0);
  for (int i = 0; i < 140; ++i) frame(later);
  EXPECT_EQ(row().ran, 1 + 2 * probe_->frames());
  EXPECT_EQ(row().cached, 5 + 140 - 2 * probe_->frames());
}

TEST_F(ProbeTest, KeepsUpWithAFastClock) {
  // A day in a minute at 15 frames a second, and at 60; at true speed there is time enough.
  const auto frames_at = [&](double degrees) {
    frame(sun_at(200.0, 0.0));
    frame(sun_at(200.0 + degrees, 0.0));
    const int frames = probe_->frames();
    for (int i = 0; i < 2 * frames; ++i) frame(sun_at(200.0 + degrees, 0.0));
    return frames;
  };
  for (const double degrees : {0.4, 0.1}) {
    const int frames = frames_at(degrees);
    EXPECT_LE(frames * degrees, 5.0);
    EXPECT_GE(frames, 8);
  }
  EXPECT_EQ(frames_at(0.02), probe_->settings().slices);
}

TEST_F(ProbeTest, IsTheNewMapWhenItHasMovedOver) {
  // In slices and turns it comes to the same as at once.
  const auto queries = queries_all_round(64, 0.3f);
  frame(sun_at(200.0, 20.0));
  frame(sun_at(201.0, 20.0));
  for (int i = 0; i < 2 * probe_->frames(); ++i) frame(sun_at(201.0, 20.0));
  const auto in_slices = frame(sun_at(201.0, 20.0), queries);
  probe_ = std::make_unique<Probe>(*shaders_, ProbeSettings::of_quality(0));
  const auto at_once = frame(sun_at(201.0, 20.0), queries);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    EXPECT_NEAR(luminance(in_slices[i].probe) / luminance(at_once[i].probe), 1.0, 2e-3) << i;
  }
}

TEST_F(ProbeTest, SlicesAreEven) {
  double sum = 0.0;
  for (const double share : probe_->slice_shares()) {
    EXPECT_LE(share, 1.0 / 6.0);
    sum += share;
  }
  EXPECT_NEAR(sum, 1.0, 1e-9);
}

TEST_F(ProbeTest, NeitherFlickersNorJumpsAsTheSunSets) {
  // A quarter of a degree a frame, as a day in 1440 frames has it, from 4 degrees up to 4 down.
  // What counts is how much the change changes: a flicker or a jump is a frame unlike its
  // neighbours.
  const std::vector<ProbeQuery> queries = {{{0, 1, 0}, -1.0f},
                                           {glm::normalize(glm::vec3(-1, 0.3, 0.2)), 0.4f},
                                           {glm::normalize(glm::vec3(1, 0.1, 0.2)), 0.2f},
                                           {glm::normalize(glm::vec3(0, -0.5, -1)), 0.6f}};
  std::vector<std::vector<double>> logs(queries.size());
  for (int i = 0; i < 34; ++i) {
    const auto answers = frame(sun_at(280.0 + 0.2 * i, 4.0 - 0.25 * i), queries);
    for (std::size_t q = 0; q < queries.size(); ++q) {
      logs[q].push_back(std::log(luminance(answers[q].probe)));
    }
  }
  double worst = 0.0;
  for (std::size_t q = 0; q < queries.size(); ++q) {
    for (std::size_t i = 1; i + 1 < logs[q].size(); ++i) {
      const double bend = logs[q][i + 1] - 2.0 * logs[q][i] + logs[q][i - 1];
      // The pace changes a little where one generation follows another; one that was shown at once
      // would bend by the change of sixteen frames, 0.4 and more.
      worst = std::max(worst, std::abs(bend));
      EXPECT_LT(std::abs(bend), 0.04) << "query " << q << " frame " << i;
    }
  }
  RecordProperty("worst_bend", std::to_string(worst));
}

TEST_F(ProbeTest, ALeapInTimeIsShownAtOnce) {
  frame(sun_at(200.0, 50.0));
  const auto answers = frame(sun_at(280.0, 5.0), queries_all_round(64, 0.6f), 1024);
  EXPECT_LT(relative_rms(answers), 0.05);
  EXPECT_EQ(row().ran, 2);
}

}  // namespace
}  // namespace offing
