#pragma once
#include "game/options.h"
#include "game/world/scene.h"

namespace offing {

/// One function per export; each writes options.out, whole or not at all.
void export_clouds(const Scene& scene, const Options& options);
void export_ephemeris(const Scene& scene, const Options& options);
void export_heights(const Scene& scene, const Options& options);
void export_ocean(const Scene& scene, const Options& options);
void export_sky(const Scene& scene, const Options& options);
void export_polar(const Scene& scene, const Options& options);
void export_boat(const Scene& scene, const Options& options);

}  // namespace offing
