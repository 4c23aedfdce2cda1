#include "game/export/exports.h"
namespace offing {
void export_heights(const Scene&, const Options&) {}
void export_ocean(const Scene&, const Options&) {}
}  // namespace offing
