#include "engine/graph/frame_graph.h"

#include <gtest/gtest.h>

#include <epoxy/gl.h>

#include <algorithm>

namespace offing {
namespace {

class FrameGraphTest : public ::testing::Test {
 protected:
  // Adds a pass that only notes that it ran.
  template <class Setup>
  void pass(const char* name, Setup setup) {
    graph.add(name, setup, [this, name](PassContext&) { ran.emplace_back(name); });
  }

  void run() {
    ran.clear();
    graph.execute();
  }

  const PassReport& row(const std::string& name) {
    const auto& rows = graph.report();
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [&](const PassReport& report) { return report.name == name; });
    if (found == rows.end()) throw std::out_of_range(name);
    return *found;
  }

  using Names = std::vector<std::string>;
  NullDevice device;
  FrameGraph graph{device};
  Names ran;
};

// a → [t] → b → screen        c → [u]
TEST_F(FrameGraphTest, CullsWhatNobodyReads) {
  graph.begin_frame();
  const TextureId t = graph.create("t", {});
  const TextureId u = graph.create("u", {});
  pass("a", [&](PassBuilder& p) { p.write(t); });
  pass("c", [&](PassBuilder& p) { p.write(u); });
  pass("b", [&](PassBuilder& p) { p.read(t).side_effect(); });
  run();
  EXPECT_EQ(ran, (Names{"a", "b"}));
  EXPECT_EQ(row("c").culled, 1);
  EXPECT_EQ(row("c").ran, 0);
  EXPECT_EQ(row("a").ran, 1);
}

// a → [t] → b (skipped) → [u] → screen: nothing needs a.     d → [u] stays
TEST_F(FrameGraphTest, SkippingAPassCullsWhatOnlyItNeeded) {
  graph.begin_frame();
  const TextureId t = graph.create("t", {});
  const TextureId u = graph.create("u", {});
  pass("a", [&](PassBuilder& p) { p.write(t); });
  pass("d", [&](PassBuilder& p) { p.write(u, Access::kAttachment); });
  pass("b", [&](PassBuilder& p) { p.read(t).modify(u).skip_if(true); });
  pass("screen", [&](PassBuilder& p) { p.read(u).side_effect(); });
  run();
  EXPECT_EQ(ran, (Names{"d", "screen"}));
  EXPECT_EQ(row("b").skipped, 1);
  EXPECT_EQ(row("a").culled, 1);
}

// a → [t], b overwrites [t] → screen: a's result is lost, so a need not run.
TEST_F(FrameGraphTest, AnOverwrittenResultIsCulledButAModifiedOneIsNot) {
  for (const bool modify : {false, true}) {
    graph.begin_frame();
    const TextureId t = graph.create("t", {});
    pass("a", [&](PassBuilder& p) { p.write(t); });
    pass("b", [&](PassBuilder& p) { modify ? p.modify(t) : p.write(t); });
    pass("screen", [&](PassBuilder& p) { p.read(t).side_effect(); });
    run();
    EXPECT_EQ(ran, modify ? (Names{"a", "b", "screen"}) : (Names{"b", "screen"}));
  }
}

class CacheTest : public FrameGraphTest {
 protected:
  void frame(std::uint64_t key_a, std::uint64_t key_b, bool read = true) {
    graph.begin_frame();
    const TextureId t = graph.import(first), u = graph.import(second);
    pass("a", [&](PassBuilder& p) { p.write(t).cache(memory_a, key_a); });
    pass("mips", [&](PassBuilder& p) { p.modify(t, Access::kTransfer).cache(memory_mips, 0); });
    pass("b", [&](PassBuilder& p) { p.read(t).write(u).cache(memory_b, key_b); });
    pass("screen", [&](PassBuilder& p) {
      if (read) p.read(u);
      p.side_effect();
    });
    run();
  }
  gl::Texture first, second;
  PassMemory memory_a, memory_b, memory_mips;
};

// a(key) → [first] → mips (in place) → b(key) → [second] → screen
TEST_F(CacheTest, TheSameKeysRunOnce) {
  for (int i = 0; i < 3; ++i) frame(1, 1);
  EXPECT_EQ(row("a").ran, 1);
  EXPECT_EQ(row("a").cached, 2);
  EXPECT_EQ(row("mips").ran, 1);
  EXPECT_EQ(row("b").ran, 1);
  EXPECT_EQ(row("b").cached, 2);
  EXPECT_EQ(row("screen").ran, 3);
}

TEST_F(CacheTest, AChangedInputRunsEverythingBehindIt) {
  frame(1, 1);
  frame(2, 1);
  EXPECT_EQ(ran, (Names{"a", "mips", "b", "screen"}));
  frame(2, 5);
  EXPECT_EQ(ran, (Names{"b", "screen"}));
  memory_mips.reset();
  frame(2, 5);
  EXPECT_EQ(ran, (Names{"mips", "screen"})) << "same key, same input: the same contents";
}

TEST_F(CacheTest, WhatChangedWhileNobodyLookedRunsWhenLookedAtAgain) {
  frame(1, 1);
  frame(2, 1, false);
  EXPECT_EQ(ran, (Names{"screen"}));
  frame(2, 1);
  EXPECT_EQ(ran, (Names{"a", "mips", "b", "screen"}));
  frame(2, 1, false);
  frame(2, 1);
  EXPECT_EQ(ran, (Names{"screen"}));
}

TEST_F(CacheTest, AnotherWriterInvalidates) {
  frame(1, 1);
  graph.begin_frame();
  const TextureId t = graph.import(first);
  pass("vandal", [&](PassBuilder& p) { p.modify(t).side_effect(); });
  run();
  frame(1, 1);
  // a's own key still holds, so its output counts as before; only a reader would notice the vandal
  // if a did not come first in the list.
  EXPECT_EQ(ran.back(), "screen");
  graph.begin_frame();
  const TextureId t2 = graph.import(first), u2 = graph.import(second);
  pass("vandal", [&](PassBuilder& p) { p.modify(t2); });
  pass("b", [&](PassBuilder& p) { p.read(t2).write(u2).cache(memory_b, 1); });
  pass("screen", [&](PassBuilder& p) { p.read(u2).side_effect(); });
  run();
  EXPECT_EQ(ran, (Names{"vandal", "b", "screen"}));
}

TEST_F(FrameGraphTest, ATransientOutputIsNeverCached) {
  PassMemory memory;
  for (int i = 0; i < 2; ++i) {
    graph.begin_frame();
    const TextureId t = graph.create("t", {});
    pass("a", [&](PassBuilder& p) { p.write(t).cache(memory, 7); });
    pass("screen", [&](PassBuilder& p) { p.read(t).side_effect(); });
    run();
  }
  EXPECT_EQ(row("a").ran, 2);
}

TEST_F(FrameGraphTest, BarriersComeBetweenIncoherentWriteAndUseOnlyOnce) {
  graph.begin_frame();
  const TextureId t = graph.create("t", {});
  const BufferId s = graph.create_buffer("s", 16);
  const TextureId target = graph.create("target", {});
  pass("write", [&](PassBuilder& p) { p.write(t, Access::kImage).write(s, Access::kStorage); });
  pass("first",
       [&](PassBuilder& p) { p.read(t, Access::kSampled).write(target, Access::kAttachment); });
  pass("second", [&](PassBuilder& p) {
    p.read(t, Access::kSampled).read(s, Access::kStorage).modify(target, Access::kAttachment);
  });
  pass("screen", [&](PassBuilder& p) { p.read(target).side_effect(); });
  run();
  const std::string fetch = "barrier 0x8", storage = "barrier 0x2000";
  std::vector<std::string> order;
  std::copy_if(device.log.begin(), device.log.end(), std::back_inserter(order),
               [](const std::string& line) { return line.rfind("make", 0) != 0; });
  EXPECT_EQ(order,
            (Names{"pass write", fetch, "pass first", storage, "pass second", "pass screen"}));
}

TEST_F(FrameGraphTest, BarriersReachIntoTheNextFrame) {
  gl::Buffer buffer;
  for (int i = 0; i < 2; ++i) {
    graph.begin_frame();
    const BufferId b = graph.import(buffer);
    pass("read", [&](PassBuilder& p) { p.read(b, Access::kVertex).side_effect(); });
    pass("write", [&](PassBuilder& p) { p.write(b, Access::kStorage).side_effect(); });
    run();
  }
  EXPECT_EQ(device.log, (Names{"pass read", "pass write", "barrier 0x3", "pass read",
                               "barrier 0x2000", "pass write"}));
}

TEST_F(FrameGraphTest, TransientsShareMemoryWhenTheirLivesDoNotOverlap) {
  graph.begin_frame();
  const TextureId a = graph.create("a", {}), b = graph.create("b", {}), c = graph.create("c", {});
  pass("1", [&](PassBuilder& p) { p.write(a); });
  pass("2", [&](PassBuilder& p) { p.read(a).write(b); });
  pass("3", [&](PassBuilder& p) { p.read(b).write(c); });
  pass("4", [&](PassBuilder& p) { p.read(c).side_effect(); });
  run();
  EXPECT_EQ(std::count(device.log.begin(), device.log.end(), "make a"), 1);
  EXPECT_EQ(std::count(device.log.begin(), device.log.end(), "make b"), 1);
  EXPECT_EQ(std::count(device.log.begin(), device.log.end(), "make c"), 0) << "c takes a's";
  device.log.clear();
  graph.begin_frame();
  const TextureId again = graph.create("again", {});
  pass("1", [&](PassBuilder& p) { p.write(again).side_effect(); });
  run();
  EXPECT_EQ(device.log, (Names{"barrier 0x20", "pass 1"}))
      << "the pool outlives the frame, and so does the write that the next one must wait for";
}

TEST_F(FrameGraphTest, ReportCountsEveryFrameUntilReset) {
  for (int i = 0; i < 5; ++i) {
    graph.begin_frame();
    pass("p", [&](PassBuilder& p) { p.side_effect().skip_if(i % 2 == 1); });
    run();
  }
  EXPECT_EQ(row("p").ran, 3);
  EXPECT_EQ(row("p").skipped, 2);
  graph.reset_report();
  EXPECT_EQ(row("p").ran, 0);
}

}  // namespace
}  // namespace offing
