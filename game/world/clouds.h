#pragma once
#include "engine/clouds/cloud_view.h"
#include "game/world/scene.h"

namespace offing {

/// The clouds of a scene in this environment, seen from `eye` (world, m).
CloudView cloud_view(const Scene& scene, const Environment& environment, glm::dvec3 eye);

}  // namespace offing
