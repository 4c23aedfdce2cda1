#pragma once
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include "game/export/cloud_run.h"

namespace offing {

/// A camera before clouds.
struct BenchView {
  std::string name, scene;
  std::vector<std::string> sets;  ///< "key=value"
};

/// Views of other light and other weather than those in which time is measured.
std::vector<BenchView> lit_views();

/// The model's light over the path tracer's in clear air, where both see a thick cloud: of the mean
/// and of the darkest and the brightest sixth, and what is noise of the paths in each (one standard
/// error). The sixths are the model's own: to sort pixels by the path tracer's light would sort its
/// noise. Null where hardly a pixel is thick.
nlohmann::ordered_json path_traced(CloudRun& run, const BenchView& view,
                                   const std::vector<std::string>& sets);

}  // namespace offing
