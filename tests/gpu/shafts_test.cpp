#include <cmath>
#include <glm/geometric.hpp>

#include "engine/clouds/cloud_veils.h"
#include "engine/core/angles.h"
#include "engine/sky/air_reference.h"
#include "support/sky_graph_test.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/scattering.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

using glm::dvec3;

constexpr int kWidth = 96, kHeight = 64;

/// Shafts alone, over the clear sky, under scattered clouds.
class ShaftsTest : public test::SkyGraphTest {
 protected:
  void SetUp() override {
    SkyGraphTest::SetUp();
    if (IsSkipped()) return;
    make_picture(GL_RGBA32F, kWidth, kHeight);
  }

  struct Seen {
    std::vector<double> taken;  ///< of each pixel, green, cd/m^2
    std::vector<float> shadow;  ///< the shadow map's texels
    shared::CloudData data;
    shared::FrameData frame;
  };

  Seen draw(const CelestialState& sun, double haze, double azimuth_deg, double pitch_deg) {
    CloudField field(*shaders_);
    CloudShadow shadow(*shaders_);
    CloudVeils veils(*shaders_, 0);
    CloudView view;
    view.eye = {0.0, kEye, 0.0};
    view.elapsed = 100.0;
    view.weather.cover = 0.7;
    view.weather.precipitation = 0.0;
    light_ = model_.update(sun, haze, kEye);
    Seen seen;
    seen.frame =
        test::camera_toward(test::toward(azimuth_deg, pitch_deg), 20.0, kWidth, kHeight, kEye);
    const float black[4] = {0, 0, 0, 1}, nothing = 0.0f;
    std::vector<float> clear;
    glClearTexImage(hdr_.id(), 0, GL_RGBA, GL_FLOAT, black);
    glClearTexImage(depth_.id(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, &nothing);
    const SkyIds sky = begin_frame(seen.frame, light_);
    seen.data = cloud_data(view, light_);
    shadow.plan(view, seen.data);
    const CloudIds ids = field.add(*graph_, view, seen.data);
    const CloudShadowIds shadow_ids = shadow.add(*graph_, field, ids, view);
    const TextureId picture = graph_->import(hdr_);
    sky_->add_background(*graph_, light_, sky, picture, graph_->import(depth_), true);
    graph_->add(
        "clear", [&](PassBuilder& pass) { pass.modify(picture).side_effect(); },
        [&](const PassContext& context) { clear = context.texture(picture).read_floats(4); });
    veils.add(*graph_, field, ids, *sky_, sky, shadow, shadow_ids, view,
              {{kWidth, kHeight}, seen.frame.clip_from_relative, view.eye, light_.exposure},
              picture, graph_->import(depth_), true);
    graph_->add(
        "read", [&](PassBuilder& pass) { pass.read(picture).read(shadow_ids.map).side_effect(); },
        [&](const PassContext& context) {
          seen.shadow = context.texture(shadow_ids.map).read_floats(4);
        });
    graph_->execute();
    const std::vector<float> shaded = hdr_.read_floats(4);
    for (std::size_t i = 1; i < shaded.size(); i += 4) {
      seen.taken.push_back((clear[i] - shaded[i]) / light_.exposure);
    }
    return seen;
  }

  static constexpr double kEye = 3.0;  // m
};

/// Optical depth of cloud between a place (from the camera, m) and the light: the shadow map, read
/// bilinearly in double; as shadow.comp lays it out.
double cloud_depth(const shared::CloudData& data, const std::vector<float>& map, const dvec3& p,
                   double altitude) {
  const int size = CloudShadow::kTexels;
  const dvec3 toward(data.shadow_light);
  const double up = (data.shadow.w - altitude) / toward.y;
  const double x = ((p.x + toward.x * up - data.shadow.x) * data.shadow.z + 0.5) * size - 0.5;
  const double y = ((p.z + toward.z * up - data.shadow.y) * data.shadow.z + 0.5) * size - 0.5;
  const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  EXPECT_TRUE(i > 8 && j > 8 && i < size - 9 && j < size - 9);  // where it is known
  double depth = 0.0;
  for (int k = 0; k < 4; ++k) {
    const double weight = (k % 2 ? x - i : 1.0 - (x - i)) * (k / 2 ? y - j : 1.0 - (y - j));
    depth += weight * map.at(static_cast<std::size_t>(4 * ((j + k / 2) * size + i + k % 2)));
  }
  return depth;  // below the bases, as here, all of the cloud is above
}

TEST_F(ShaftsTest, TakeTheLightThatTheAirInShadowDoesNotScatter) {
  // Toward a low sun, where the beam counts most: single scattering of the shadowed air, integrated
  // in double along each ray from the sea to the bases.
  for (const double haze : {0.1, 0.4}) {
    const double elevation = 12.0, azimuth = 240.0;
    const Seen seen = draw(test::sun_at(azimuth, elevation), haze, azimuth + 12.0, 22.0);
    const AirReference reference(haze);
    const auto aerosol = glsl::aerosol_of_haze(haze);
    const dvec3 sun = light_.sun_direction;
    // The light above the air that the model says stands in the sky.
    const dvec3 at_sea = reference.transmittance(0.0, sun.y),
                at_base = reference.transmittance(0.001 * seen.data.layer.w, sun.y);
    double wanted = 0.0, shown = 0.0, both = 0.0, wanted2 = 0.0, shown2 = 0.0;
    int count = 0;
    for (int y = 4; y < kHeight; y += 8) {
      for (int x = 4; x < kWidth; x += 8) {
        const glm::vec4 far =
            seen.frame.relative_from_clip *
            glm::vec4(2.0f * (static_cast<float>(x) + 0.5f) / kWidth - 1.0f,
                      2.0f * (static_cast<float>(y) + 0.5f) / kHeight - 1.0f, 1.0f, 1.0f);
        const dvec3 d = glm::normalize(dvec3(glm::vec3(far) / far.w));
        const double angle = glm::dot(d, sun);
        const double base = seen.data.layer.w;
        constexpr int kSteps = 300;
        const double step = (base - kEye) / d.y / kSteps;
        dvec3 depth(0.0), sum(0.0);
        for (int i = 0; i < kSteps; ++i) {
          const dvec3 p = d * ((i + 0.5) * step);
          const double altitude = kEye + p.y;
          const auto air = glsl::air_at(aerosol, 1e-3 * altitude);
          depth += air.extinction * (1e-3 * step);
          const dvec3 scattered = air.rayleigh * glsl::rayleigh_phase(angle) +
                                  air.mie * glsl::cornette_shanks(glsl::kMieG, angle);
          const dvec3 light = glm::mix(at_sea, at_base, altitude / base);
          // Of the beam e^-cloud is left; with what cloud of albedo 1 and g = 0.85 lets through
          // scattered, which comes from all sides, Eddington's transmittance.
          const double cloud = cloud_depth(seen.data, seen.shadow, p, altitude);
          const double beam = std::exp(-cloud), scaled = 0.15 * cloud;
          const double all = (5.0 - std::exp(-scaled)) / (4.0 + 3.0 * scaled);
          const dvec3 lost =
              (1.0 - beam) * scattered - (all - beam) / (4.0 * kPi) * (air.rayleigh + air.mie);
          sum += lost * light * glm::exp(-depth) * (1e-3 * step);
        }
        const dvec3 rgb = glsl::srgb_from_bands(sum) * light_.sun_source;
        const double missing = rgb.y;
        const double taken = seen.taken[static_cast<std::size_t>(y * kWidth + x)];
        wanted += missing;
        shown += taken;
        both += missing * taken;
        wanted2 += missing * missing;
        shown2 += taken * taken;
        ++count;
      }
    }
    EXPECT_GT(wanted / count, 20.0) << haze;  // cd/m^2: there are shafts
    EXPECT_NEAR(shown / wanted, 1.0, 0.1) << haze;
    const double covariance = both - wanted * shown / count;
    const double correlation = covariance / std::sqrt((wanted2 - wanted * wanted / count) *
                                                      (shown2 - shown * shown / count));
    EXPECT_GT(correlation, 0.9) << haze;
    RecordProperty("ratio_at_haze_" + std::to_string(haze), std::to_string(shown / wanted));
  }
}

}  // namespace
}  // namespace offing
