#pragma once
#include <ostream>
#include <string>
#include <vector>

#include "engine/io/image.h"

namespace offing::test {

/// One of the pictures that are kept: a scene, settings on top of it, and its file's name.
struct View {
  std::string name;
  std::string scene;
  std::vector<std::string> sets{};
};

inline void PrintTo(const View& view, std::ostream* stream) { *stream << view.name; }

/// All of them, in the order in which a reader may want to look at them.
const std::vector<View>& views();

/// What `offing render` writes for it; a warning of the driver fails the test. Throws as Voyage.
Image render_view(const View& view);

/// The command that writes the same picture, for messages.
std::string command_of(const View& view);

}  // namespace offing::test
