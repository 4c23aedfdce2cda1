#pragma once
#include <memory>
#include <stdexcept>
#include <string>

#include "engine/graph/frame_graph.h"
#include "engine/graph/gl_device.h"
#include "support/gl_test.h"

namespace offing::test {

/// A test of a technique: the project's shaders and an empty frame graph on a headless context.
class GraphTest : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    shaders_ = std::make_unique<ShaderLibrary>(data_root() / "shaders");
    device_ = std::make_unique<GlDevice>();
    graph_ = std::make_unique<FrameGraph>(*device_);
  }

  void TearDown() override {
    graph_.reset();
    device_.reset();
    shaders_.reset();
    GlTest::TearDown();
  }

  /// The report's row of a pass; throws where the graph never had it.
  const PassReport& row(const std::string& name) const {
    for (const PassReport& pass : graph_->report()) {
      if (pass.name == name) return pass;
    }
    throw std::runtime_error("no pass " + name);
  }

  std::unique_ptr<ShaderLibrary> shaders_;
  std::unique_ptr<GlDevice> device_;
  std::unique_ptr<FrameGraph> graph_;
};

}  // namespace offing::test
