#include "engine/clouds/cloud_map.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/sky/probe_reference.h"
#include "engine/sky/sky_panorama.h"
#include "support/sky_graph_test.h"

namespace offing {
namespace {

class CloudMapTest : public test::SkyGraphTest {
 protected:
  void SetUp() override {
    SkyGraphTest::SetUp();
    if (IsSkipped()) return;
    field_ = std::make_unique<CloudField>(*shaders_);
    shadow_ = std::make_unique<CloudShadow>(*shaders_);
    map_ = std::make_unique<CloudMap>(*shaders_, CloudMapSettings::of_quality(0));
    probe_ = std::make_unique<Probe>(*shaders_, ProbeSettings::of_quality(0));
    view_.eye = {0.0, 3.0, 0.0};
    view_.elapsed = 100.0;
  }

  void TearDown() override {
    probe_.reset();
    map_.reset();
    shadow_.reset();
    field_.reset();
    SkyGraphTest::TearDown();
  }

  std::optional<ProbeClouds> add_map(const SkyIds& sky_ids) {
    shared::CloudData data = cloud_data(view_, light_);
    shadow_->plan(view_, data);
    const CloudIds ids = field_->add(*graph_, view_, data);
    const CloudShadowIds shadow = shadow_->add(*graph_, *field_, ids, view_);
    shadow_map_ = shadow.map;
    return map_->add(*graph_, *field_, ids, *sky_, sky_ids, *shadow_, shadow, view_, light_, data);
  }

  /// One frame of map and probe; the irradiance of a level surface over that of the clear sky.
  float frame() {
    light_ = model_.update(sun_, 0.1, view_.eye.y);
    const SkyIds sky_ids = begin_frame(light_);
    const auto clouds = add_map(sky_ids);
    const ProbeIds ids = probe_->add(*graph_, light_, 8.0, *sky_, sky_ids, clouds);
    float mean = 0.0f;
    graph_->add(
        "show",
        [&](PassBuilder& pass) {
          ids.read_by(pass);
          pass.side_effect();
        },
        [&](const PassContext& context) {
          const std::vector<float> texels = context.texture(ids.map).read_floats(4);
          for (std::size_t i = 1; i < texels.size(); i += 4) mean += texels[i];
          mean *= 4.0f / static_cast<float>(texels.size());
        });
    graph_->execute();
    return mean;
  }

  Panorama panorama() {
    light_ = model_.update(sun_, 0.1, view_.eye.y);
    return sky_panorama(*shaders_, *graph_, *sky_, light_, 8.0, 128, 64,
                        [this](FrameGraph&, const SkyIds& sky_ids) { return add_map(sky_ids); });
  }

  static double luminance(const glm::dvec3& c) {
    return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722));
  }

  std::unique_ptr<CloudField> field_;
  std::unique_ptr<CloudShadow> shadow_;
  std::unique_ptr<CloudMap> map_;
  std::unique_ptr<Probe> probe_;
  CelestialState sun_ = test::sun_at(200.0, 40.0);
  CloudView view_;
  TextureId shadow_map_;
};

TEST_F(CloudMapTest, AClearSkyCostsNothing) {
  view_.weather.cover = 0.0;
  frame();
  EXPECT_EQ(row("clouds.map").ran, 0);
  EXPECT_EQ(row("clouds.map").skipped, 1);
  EXPECT_EQ(row("clouds.noise").ran, 0);
}

TEST_F(CloudMapTest, StandsStillWithTheClockAndFollowsItInSlices) {
  for (int i = 0; i < 5; ++i) frame();
  EXPECT_EQ(row("clouds.map").ran, 1);
  EXPECT_EQ(row("clouds.map").cached, 4);
  // The air drifts on for one frame: one refresh, and the probe takes it in, then nothing.
  view_.elapsed += 2.0;
  view_.drift += glm::dvec2(16.0, 0.0);
  for (int i = 0; i < 2 * probe_->settings().slices + 12; ++i) frame();
  EXPECT_EQ(row("clouds.map").ran, 1 + map_->settings().slices);
  EXPECT_EQ(row("sky.probe").ran, 1 + 2 * probe_->settings().slices);
}

TEST_F(CloudMapTest, TheProbeShowsCloudsAndDoesNotFlickerAsTheyPass) {
  view_.weather.cover = 0.0;
  const float clear = frame();
  view_.weather.cover = 0.9;
  const float cloudy = frame();
  EXPECT_GT(std::abs(cloudy / clear - 1.0f), 0.1f);
  // Drift at 2.5 frames a second: what the probe holds in the mean changes, but smoothly, once it
  // has moved over to the other weather.
  view_.weather.cover = 0.5;
  std::vector<double> means;
  for (int i = 0; i < 3 * probe_->settings().slices + 8; ++i) {
    view_.elapsed += 0.4;
    view_.drift += glm::dvec2(3.2, 0.0);
    means.push_back(static_cast<double>(frame()));
  }
  double least = 1e9, most = 0.0;
  const auto settled = static_cast<std::size_t>(2 * probe_->settings().slices + 8);
  for (std::size_t i = settled; i < means.size(); ++i) {
    least = std::min(least, means[i]);
    most = std::max(most, means[i]);
    EXPECT_LT(std::abs(means[i] / means[i - 1] - 1.0), 1.0 / 255.0) << i;
  }
  EXPECT_GT(most / least, 1.002);
}

TEST_F(CloudMapTest, TheProbeOfACloudySkyAgreesWithBruteForce) {
  const ProbeReference reference(*shaders_);
  view_.weather.cover = 0.5;
  for (const int quality : {0, 1, 2}) {
    map_ = std::make_unique<CloudMap>(*shaders_, CloudMapSettings::of_quality(quality));
    probe_ = std::make_unique<Probe>(*shaders_, ProbeSettings::of_quality(quality));
    for (const double elevation : {40.0, 6.0}) {
      sun_ = test::sun_at(200.0, elevation);
      for (const float roughness : {0.1f, 0.2f, 0.4f, 1.0f}) {
        light_ = model_.update(sun_, 0.1, view_.eye.y);
        const SkyIds sky_ids = begin_frame(light_);
        const auto clouds = add_map(sky_ids);
        ASSERT_TRUE(clouds.has_value());
        const ProbeIds ids = probe_->add(*graph_, light_, 8.0, *sky_, sky_ids, clouds);
        graph_->add(
            "ask",
            [&](PassBuilder& pass) {
              sky_ids.read_by(pass);
              ids.read_by(pass);
              pass.read(clouds->map).side_effect();
            },
            [&](const PassContext& context) {
              const auto answers = reference.ask(context, *sky_, sky_ids, *probe_, ids,
                                                 queries_all_round(256, roughness), 4096, clouds);
              EXPECT_LT(relative_rms(answers), 0.02)
                  << "quality " << quality << ", " << elevation << " deg, roughness " << roughness;
            });
        graph_->execute();
      }
    }
  }
}

TEST_F(CloudMapTest, CloudsTakeAndGiveLightButMakeNone) {
  // What falls on a level surface through the clouds, scattered (the panorama's upper half) and as
  // a beam (the shadow), is never more than falls on one above them; and more cloud lets less
  // through.
  view_.weather = {.cover = 0.0, .type = 0.0, .precipitation = 0.0, .high = 0.0};
  const double sky = luminance(panorama().level_illuminance());
  const double sun = luminance(light_.sun_illuminance) * light_.sun_direction.y;
  const auto overcast = [&](double density) {
    view_.weather.cover = 1.0;
    view_.parameters.density = density;
    map_ = std::make_unique<CloudMap>(*shaders_, CloudMapSettings::of_quality(0));
    return luminance(panorama().level_illuminance());
  };
  double last = sky + sun;
  for (const double density : {1.0, 2.0, 4.0}) {
    const double lux = overcast(density);  // no beam comes through 200 m of stratus
    EXPECT_LT(lux, last) << density;
    EXPECT_GT(lux, 0.05 * (sky + sun)) << density;
    last = lux;
  }
}

}  // namespace
}  // namespace offing
