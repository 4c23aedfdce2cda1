// Every key of the clouds at its limits, in the whole frame.
#include <algorithm>

#include "game/render/voyage.h"
#include "support/voyage_test.h"

namespace offing {
namespace {

using CloudLimits = test::VoyageTest;

/// The least and the most that a field can hold, or all that it can be.
std::vector<FieldValue> limits(const Field& field) {
  if (const auto* choice = std::get_if<Choice>(&field.target)) {
    std::vector<FieldValue> all;
    for (const std::string_view name : choice->names) all.emplace_back(std::string(name));
    return all;
  }
  if (std::holds_alternative<std::string*>(field.target)) return {};
  if (std::holds_alternative<glm::dvec3*>(field.target))
    return {std::vector<double>(3, field.min), std::vector<double>(3, field.max)};
  return {field.min, field.max};
}

TEST_F(CloudLimits, OfEveryKeyGiveFinitePictures) {
  Options options;
  options.quality = "low";
  options.fps = 30.0;
  options.sets = {"camera.mode=free",
                  "camera.position=500,3,500",
                  "camera.target=600,120,400",
                  "environment.clouds.cover=0.6",
                  "environment.clouds.high=0.5",
                  "environment.clouds.middle=0.5",
                  "environment.clouds.precipitation=0.6"};
  Voyage voyage(options, {48, 27});
  const FieldTable table = voyage.world().scene().fields();
  const auto draw = [&](const std::string& what) {
    voyage.next_frame();
    EXPECT_EQ(voyage.renderer().take_nonfinite_pixels(), 0u) << what;
    const Image picture = voyage.renderer().radiance(1.0);
    EXPECT_GE(*std::min_element(picture.pixels.begin(), picture.pixels.end()), 0.0f) << what;
  };
  draw("the scene itself");
  int tried = 0;
  for (const Field& field : table.fields()) {
    const bool gardner = field.key.rfind("clouds.gardner.", 0) == 0;
    const bool weather = field.key.rfind("environment.clouds.", 0) == 0;
    if (field.key.rfind("clouds.", 0) != 0 && !weather) continue;
    const std::string before = FieldTable::to_text(field);
    if (gardner) table.set("clouds.method", std::string("ellipsoids"), "test");
    for (const FieldValue& value : limits(field)) {
      table.set(field.key, value, "test");
      draw(field.key + " = " + FieldTable::to_text(field));
      ++tried;
    }
    table.set_from_text(field.key, before, "test");
    if (gardner) table.set("clouds.method", std::string("volumetric"), "test");
  }
  EXPECT_GT(tried, 90);
  // No noise at all, and everything at once that makes clouds dense.
  for (const char* key : {"weight_connected", "weight_coarse", "weight_middle", "weight_fine"})
    table.set(std::string("clouds.") + key, 0.0, "test");
  draw("no weights");
  for (const auto& [key, value] :
       {std::pair("density", 8.0), {"extinction", 0.3}, {"scale", 4.0}, {"step_scale", 4.0}})
    table.set(std::string("clouds.") + key, value, "test");
  draw("as dense as can be");
  for (const auto& message : voyage.debug().messages()) ADD_FAILURE() << message.text;
}

}  // namespace
}  // namespace offing
