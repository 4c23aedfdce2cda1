// The sky as it is drawn through a whole day, minute by minute; the light behind it:
// unit/sky_day_test.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/environment/calendar.h"
#include "engine/sky/sky_panorama.h"
#include "support/sky_graph_test.h"

namespace offing {
namespace {

using SkyDayTest = test::SkyGraphTest;

double luminance(const glm::dvec3& c) { return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722)); }

// All round, sea included. Of three minutes that follow each other, the middle one's mean luminance
// lies where its neighbours say, as a ratio: a light that falls by decades at dusk has no step.
TEST_F(SkyDayTest, TheDrawnSkyTurnsWithoutAStepOrABadPixel) {
  model_ = SkyLightModel(Starlight(load_stars(star_file()), load_milky_way(milky_way_file())));
  std::vector<double> means;
  for (int minute = 0; minute < 1440; ++minute) {
    const double utc = *parse_date("2026-08-27") + 60.0 * minute;  // a moon nearly full
    light_ = model_.update(celestial_state(utc, 43.3623, -8.4115), 0.1, 3.0);
    const Panorama all = sky_panorama(*shaders_, *graph_, *sky_, light_, 8.0, 24, 12);
    double sum = 0.0;
    for (std::size_t i = 0; i < all.pixels.size(); ++i) {
      const glm::dvec3& p = all.pixels[i];
      const double least = std::min({p.x, p.y, p.z});
      ASSERT_TRUE(std::isfinite(luminance(p)) && least >= 0.0) << minute << " " << i;
      sum += luminance(p) * all.solid_angle(static_cast<int>(i) / all.width);
    }
    means.push_back(sum);
  }
  double worst = 0.0;
  for (std::size_t i = 1; i + 1 < means.size(); ++i) {
    const double step = std::abs(std::log(means[i] * means[i] / (means[i - 1] * means[i + 1])));
    EXPECT_LT(step, 0.03) << i;
    worst = std::max(worst, step);
  }
  EXPECT_GT(*std::max_element(means.begin(), means.end()),
            1e5 * *std::min_element(means.begin(), means.end()));
  RecordProperty("worst", std::to_string(worst));
}

}  // namespace
}  // namespace offing
