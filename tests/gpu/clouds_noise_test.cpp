#include <cmath>

#include "engine/clouds/cloud_field.h"
#include "support/graph_test.h"

namespace offing {
namespace {

class CloudNoiseTest : public test::GraphTest {
 protected:
  struct Volumes {
    std::vector<float> shape, detail, weather;
  };
  Volumes make(CloudNoise& noise) {
    Volumes volumes;
    graph_->begin_frame();
    const CloudNoise::Ids ids = noise.add(*graph_, CloudParameters{});
    graph_->add(
        "read",
        [&](PassBuilder& pass) {
          pass.read(ids.shape).read(ids.detail).read(ids.weather).side_effect();
        },
        [&](PassContext& context) {
          volumes.shape = context.texture(ids.shape).read_floats(1);
          volumes.detail = context.texture(ids.detail).read_floats(1);
          volumes.weather = context.texture(ids.weather).read_floats(4);
        });
    graph_->execute();
    return volumes;
  }
};

TEST_F(CloudNoiseTest, RepeatsWithoutASeam) {
  CloudNoise noise(*shaders_);
  const Volumes volumes = make(noise);
  // Across the seam neighbours differ as much as anywhere else.
  const auto roughness = [](const std::vector<float>& v, int side, int axis, bool seam) {
    double sum = 0.0;
    int count = 0;
    const auto at = [&](int x, int y, int z) {
      return v[static_cast<std::size_t>(((z % side) * side + y % side) * side + x % side)];
    };
    for (int a = 0; a < side; ++a) {
      for (int b = 0; b < side; ++b) {
        for (int along = seam ? side - 1 : side / 4; along < (seam ? side : side / 4 + 4);
             ++along) {
          const float from = axis == 0   ? at(along, a, b)
                             : axis == 1 ? at(a, along, b)
                                         : at(a, b, along);
          const float to = axis == 0   ? at(along + 1, a, b)
                           : axis == 1 ? at(a, along + 1, b)
                                       : at(a, b, along + 1);
          sum += (to - from) * (to - from);
          ++count;
        }
      }
    }
    return sum / count;
  };
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(roughness(volumes.shape, CloudNoise::kShapeTexels, axis, true) /
                    roughness(volumes.shape, CloudNoise::kShapeTexels, axis, false),
                1.0, 0.35);
    EXPECT_NEAR(roughness(volumes.detail, CloudNoise::kDetailTexels, axis, true) /
                    roughness(volumes.detail, CloudNoise::kDetailTexels, axis, false),
                1.0, 0.5);
  }
  double mean = 0.0, square = 0.0;
  for (const float value : volumes.shape) {
    mean += value;
    square += value * value;
  }
  mean /= static_cast<double>(volumes.shape.size());
  square /= static_cast<double>(volumes.shape.size());
  EXPECT_NEAR(mean, 0.5, 0.08);
  // An even distribution over 0 … 1 has .29: a third of that is relief, less would be fog.
  EXPECT_GT(std::sqrt(square - mean * mean), 0.29 / 3.0);
}

}  // namespace
}  // namespace offing
