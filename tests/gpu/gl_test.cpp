#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "engine/core/error.h"
#include "engine/gl/buffer.h"
#include "engine/gl/readback.h"
#include "engine/gl/texture.h"
#include "engine/graph/frame_graph.h"
#include "engine/graph/gl_device.h"
#include "support/gl_test.h"
#include "support/scratch_folder.h"

namespace offing {
namespace {
namespace fs = std::filesystem;
using test::GlTest;

class GlObjects : public GlTest {};

TEST_F(GlObjects, BuffersAndTexturesKeepWhatTheyAreGiven) {
  std::vector<float> values(64);
  std::iota(values.begin(), values.end(), 0.0f);
  const auto buffer = gl::Buffer::of<float>("numbers", values);
  std::vector<float> back(64);
  buffer.read(back.data(), buffer.size());
  EXPECT_EQ(back, values);

  gl::Texture texture("picture", {.format = GL_RGBA32F, .width = 4, .height = 4});
  texture.upload(GL_RGBA, GL_FLOAT, values.data());
  EXPECT_EQ(texture.read_floats(4), values);

  gl::Texture moved = std::move(texture);
  EXPECT_FALSE(texture);  // NOLINT(bugprone-use-after-move): the point of the test
  EXPECT_EQ(moved.read_floats(4), values);
}

TEST_F(GlObjects, DriverErrorsReachTheLog) {
  gl::Texture("bad", {.format = GL_RGBA32F, .width = 1, .height = 1, .levels = 5});
  ASSERT_FALSE(debug().messages().empty());
  EXPECT_TRUE(debug().messages().front().error);
  debug().clear();
}

TEST_F(GlObjects, ReadbackBringsTheNewestResultWithItsTagAndNeverMixesThem) {
  gl::ReadbackRing ring("ring", sizeof(float), 3);
  gl::ReadbackRing::Result result{};
  EXPECT_FALSE(ring.poll(&result));
  int got = 0;
  for (int frame = 0; frame < 20; ++frame) {
    const float value = static_cast<float>(frame) * 1.5f;
    const gl::Buffer source("source", sizeof(float), 0, &value);
    if (const GLuint target = ring.begin(); target != 0) {
      glCopyNamedBufferSubData(source.id(), target, 0, 0, sizeof(float));
      ring.issue(frame);
    }
    if (frame % 3 == 0) glFinish();
    if (ring.poll(&result)) {
      float seen = -1.0f;
      std::memcpy(&seen, result.bytes.data(), sizeof(seen));
      EXPECT_FLOAT_EQ(seen, static_cast<float>(result.tag) * 1.5f);
      ++got;
    }
  }
  EXPECT_GE(got, 6);
}

class Shaders : public GlTest {
 protected:
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    // Two writes within one tick of the file system's clock must still be told apart.
    fs::last_write_time(folder_ / name,
                        fs::file_time_type::clock::now() + std::chrono::seconds(++tick_));
  }
  float run(const ShaderProgram& program) {
    const gl::Buffer out("out", sizeof(float));
    program.use();
    out.bind_storage(0);
    glDispatchCompute(1, 1, 1);
    float value = 0.0f;
    out.read(&value, sizeof(value));
    return value;
  }
  const test::ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
  int tick_ = 0;
};

constexpr const char* kMain =
    "layout(local_size_x = 1) in;\n"
    "layout(std430, binding = 0) buffer Out { float result; };\n"
    "#include \"value.glsl\"\n"
    "void main() { result = value() * SCALE; }\n";

TEST_F(Shaders, IncludesAndDefinesWork) {
  write("main.comp", kMain);
  write("value.glsl", "float value() { return 21.0; }\n");
  ShaderLibrary library(folder_);
  const ShaderProgram& twice = library.program({"main.comp"}, {{"SCALE", "2.0"}});
  const ShaderProgram& thrice = library.program({"main.comp"}, {{"SCALE", "3.0"}});
  EXPECT_FLOAT_EQ(run(twice), 42.0f);
  EXPECT_FLOAT_EQ(run(thrice), 63.0f);
  EXPECT_EQ(&library.program({"main.comp"}, {{"SCALE", "2.0"}}), &twice);
}

TEST_F(Shaders, AnErrorNamesFileAndLine) {
  write("main.comp", kMain);
  write("value.glsl", "\n\nfloat value() { return wrong; }\n");
  ShaderLibrary library(folder_);
  try {
    library.program({"main.comp"}, {{"SCALE", "1.0"}});
    FAIL() << "compiled";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("value.glsl:3"), std::string::npos) << error.what();
  }
  write("value.glsl", "#include \"gone.glsl\"\n");
  try {
    library.program({"main.comp"}, {{"SCALE", "1.0"}});
    FAIL() << "compiled";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("value.glsl:1: gone.glsl"), std::string::npos)
        << error.what();
  }
  write("value.glsl", "#include \"main.comp\"\n");
  EXPECT_THROW(library.program({"main.comp"}, {{"SCALE", "1.0"}}), InputError);
  debug().clear();  // Mesa reports a failed compilation as an error of its own
}

TEST_F(Shaders, AHotReloadKeepsTheLastGoodProgram) {
  write("main.comp", kMain);
  write("value.glsl", "float value() { return 1.0; }\n");
  ShaderLibrary library(folder_);
  const ShaderProgram& program = library.program({"main.comp"}, {{"SCALE", "1.0"}});
  const unsigned generation = program.generation();
  EXPECT_FALSE(library.reload_changed());

  write("value.glsl", "float value() { return broken }\n");
  EXPECT_TRUE(library.reload_changed());
  EXPECT_NE(library.error().find("value.glsl:1"), std::string::npos) << library.error();
  EXPECT_EQ(program.generation(), generation);
  EXPECT_FLOAT_EQ(run(program), 1.0f);
  debug().clear();

  write("value.glsl", "float value() { return 5.0; }\n");
  EXPECT_TRUE(library.reload_changed());
  EXPECT_EQ(library.error(), "");
  EXPECT_GT(program.generation(), generation);
  EXPECT_FLOAT_EQ(run(program), 5.0f);
}

class GraphOnGl : public GlTest {};

TEST_F(GraphOnGl, DrawsClearsAndTimesThroughItsPool) {
  GlDevice device;
  FrameGraph graph(device);
  graph.set_timing(true);
  for (int frame = 0; frame < 3; ++frame) {
    graph.begin_frame();
    const TextureId colour =
        graph.create("colour", {.format = GL_RGBA32F, .width = 8, .height = 8});
    graph.add(
        "clear",
        [&](PassBuilder& p) {
          p.write(colour, Access::kAttachment).render_to({colour}).side_effect();
        },
        [colour](PassContext& context) {
          const float red[4] = {1.0f, 0.0f, 0.5f, 1.0f};
          glClearBufferfv(GL_COLOR, 0, red);
          EXPECT_EQ(context.texture(colour).read_floats(4)[2], 0.5f);
        });
    graph.execute();
  }
  glFinish();
  graph.begin_frame();
  graph.execute();
  ASSERT_EQ(graph.report().size(), 1u);
  EXPECT_EQ(graph.report()[0].ran, 3);
  EXPECT_EQ(graph.report()[0].milliseconds.size(), 3u);
  EXPECT_GE(graph.frame_milliseconds().size(), 3u);
  EXPECT_GE(graph.frame_milliseconds()[0], graph.report()[0].milliseconds[0]);
}

}  // namespace
}  // namespace offing
