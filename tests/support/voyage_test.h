#pragma once
#include "support/gl_test.h"

namespace offing::test {

/// For tests that sail a Voyage, which opens a context of its own: only asks whether there is
/// OpenGL.
class VoyageTest : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    GlTest::TearDown();
  }
};

}  // namespace offing::test
