#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include "engine/core/paths.h"
#include "engine/gl/debug.h"
#include "engine/platform/headless_context.h"
#include "engine/shader/shader_library.h"

namespace offing::test {

/// A headless context for each test; any warning or error of the driver's debug output fails it.
/// Skips, saying so, only where there is no OpenGL 4.5 at all.
class GlTest : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      context_ = std::make_unique<HeadlessContext>();
    } catch (const InputError& error) {
      // A machine that tests for others must have it, or a green run would mean nothing.
      if (std::getenv("CI") != nullptr) FAIL() << error.what();
      GTEST_SKIP() << error.what();
    }
    debug_ = std::make_unique<gl::DebugLog>();
  }

  void TearDown() override {
    if (debug_ == nullptr) return;
    for (const auto& message : debug_->messages()) ADD_FAILURE() << message.text;
    debug_.reset();
  }

  gl::DebugLog& debug() { return *debug_; }

 private:
  std::unique_ptr<HeadlessContext> context_;
  std::unique_ptr<gl::DebugLog> debug_;
};

}  // namespace offing::test
