#include "engine/clouds/cloud_march.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/clouds/lay_over.h"
#include "engine/core/random.h"
#include "shaders/shared/bindings.h"

#define OFFING_GLSL "shaders/lib/phase.glsl"
#include "engine/core/glsl_double.h"
#define OFFING_GLSL "shaders/lib/scattering.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

constexpr int kDomeVertices = 96 * 3;  // as in sky/dome.vert
/// Farther in one frame than anything flies, m; a turn that leaves nothing of the picture.
constexpr double kCutDistance = 300.0, kCutCosine = 0.9;
constexpr double kCutExposure = 0.2;  // in its logarithm: fog that comes from one frame to the next

GLuint groups(int size) { return static_cast<GLuint>((size + 7) / 8); }

/// The order in which the pixels of a cell take their turns: each falls far from the ones before.
glm::ivec2 pixel_of_turn(glm::ivec2 cell, int turn) {
  // Bits of the turn, swapped between x and y and reversed: Bayer's matrix.
  glm::ivec2 at(0);
  int bits = turn % (cell.x * cell.y);
  glm::ivec2 half = cell / 2;
  while (half.x > 0 || half.y > 0) {
    const int low = bits & 1;
    bits >>= 1;
    int high = 0;
    if (half.x > 0 && half.y > 0) {
      high = bits & 1;
      bits >>= 1;
      at.x += half.x * (low ^ high);
      at.y += half.y * low;
    } else if (half.x > 0) {
      at.x += half.x * low;
    } else {
      at.y += half.y * low;
    }
    half /= 2;
  }
  return at;
}

const ShaderProgram& resolve_of(ShaderLibrary& shaders, glm::ivec2 cell) {
  return shaders.program({"clouds/resolve.comp"},
                         {{"CELL_X", std::to_string(cell.x)}, {"CELL_Y", std::to_string(cell.y)}});
}

ShaderDefines march_defines(const CloudQuality& quality) {
  ShaderDefines defines = {{"STEPS", std::to_string(quality.steps)},
                           {"SKIPS", "24"},
                           {"FINEST", fmt::format("{:.4f}", quality.finest)},
                           {"GROWTH", fmt::format("{:.5f}", quality.growth)},
                           {"REACH", fmt::format("{:.1f}", quality.reach)},
                           {"LEAST", fmt::format("{:.6f}", quality.least)},
                           {"LONGEST_SKIP", quality.skipping ? "4.0" : "0.0"},
                           {"SHADOW_MAP", quality.shadow_map ? "1" : "0"}};
  if (!quality.curl) defines.emplace_back("CLOUDS_WITHOUT_CURL", "1");
  return defines;
}

gl::Texture picture(const char* label, GLenum format, glm::ivec2 size) {
  return {label, {.format = format, .width = size.x, .height = size.y}};
}

/// Sine of the sea's horizon, below the level, for an eye at this height (m).
double horizon_dip(double height) { return glsl::horizon_dip_sine(1e-3 * std::max(height, 0.0)); }

/// The lowest row of pixels that shows anything above the sea's horizon, less a margin.
int first_sky_row(const CloudCamera& camera) {
  const glm::mat4 relative_from_clip = glm::inverse(camera.clip_from_relative);
  const double dip = horizon_dip(camera.eye.y) + 0.01;
  const auto sees_sky = [&](int row) {
    for (const float x : {-1.0f, 1.0f}) {
      const float y = 2.0f * static_cast<float>(row) / static_cast<float>(camera.size.y) - 1.0f;
      const glm::vec4 at = relative_from_clip * glm::vec4(x, y, 1.0f, 1.0f);
      if (glm::normalize(glm::vec3(at)).y > -dip) return true;
    }
    return false;
  };
  constexpr int kRows = 8;
  int row = 0;
  while (row + kRows < camera.size.y && !sees_sky(row + kRows)) row += kRows;
  return row;
}

/// The pixels that the picture showed before the camera moved: the first and the one after the
/// last.
glm::ivec4 known_pixels(const CloudCamera& camera, const CloudCamera& before) {
  const glm::mat4 relative_from_clip = glm::inverse(camera.clip_from_relative);
  const glm::vec2 size(camera.size);
  // How far beyond the picture's lower left and upper right lay what its sides show now.
  glm::vec2 below(0.0f), above(0.0f);
  constexpr int kPlaces = 8;
  for (int i = 0; i <= 4 * kPlaces; ++i) {
    const float along = 2.0f * static_cast<float>(i % kPlaces) / kPlaces - 1.0f;
    const glm::vec2 sides[] = {{along, -1}, {1, along}, {-along, 1}, {-1, -along}};
    const glm::vec4 place = relative_from_clip * glm::vec4(sides[i / kPlaces % 4], 1, 1);
    constexpr float kFar = 1e4f;  // m
    const glm::vec4 clip =
        before.clip_from_relative * glm::vec4(kFar * glm::normalize(glm::vec3(place)), 1.0f);
    const glm::vec2 at = (0.5f + 0.5f * glm::vec2(clip) / std::max(clip.w, 1e-3f)) * size;
    below = glm::max(below, -at);
    above = glm::max(above, at - size);
  }
  constexpr float kNothing = 0.05f;  // pixels
  const glm::ivec2 from(glm::ceil(glm::min(below, size) - kNothing));
  const glm::ivec2 to = camera.size - glm::ivec2(glm::ceil(glm::min(above, size) - kNothing));
  return {from, glm::max(to, from)};
}

/// The cells (the first and how many) whose chosen pixels pixels from `from` to before `to` lie
/// between.
glm::ivec4 cells_round(glm::ivec2 from, glm::ivec2 to, glm::ivec2 cell, glm::ivec2 cells) {
  const glm::ivec2 first = glm::min(from / cell, cells);
  return {first, glm::max(glm::min((to - 1 + cell - 1) / cell + 1, cells) - first, 0)};
}

glm::vec3 forward_of(const CloudCamera& camera) {
  const glm::vec4 ahead = glm::inverse(camera.clip_from_relative) * glm::vec4(0, 0, 1, 1);
  return glm::normalize(glm::vec3(ahead));
}

constexpr float kFresh = 0.65f;      // weight of what was marched now over what was there
constexpr double kShownFlash = 1e6;  // cd: less is not seen by night, either

}  // namespace

CloudQuality CloudQuality::of(int quality) {
  switch (quality) {
    case 0:
      return {.cell = {8, 4},
              .cut_cell = {2, 2},
              .steps = 32,
              .light_steps = 3,
              .light_steps_inside = 1,
              .finest = 20.0f,
              .growth = 0.013f,
              .reach = 70000.0f,
              .curl = false};
    case 1:
      return {.cell = {4, 4},
              .cut_cell = {2, 2},
              .steps = 96,
              .light_steps = 4,
              .light_steps_inside = 2,
              .finest = 11.0f,
              .growth = 0.006f,
              .reach = 90000.0f};
    case 2:
      return {.cell = {2, 2},
              .steps = 110,
              .light_steps = 4,
              .light_steps_inside = 2,
              .finest = 7.0f,
              .growth = 0.004f,
              .reach = 110000.0f};
    default:
      return {.cell = {1, 1},
              .steps = 160,
              .light_steps = 5,
              .light_steps_inside = 2,
              .finest = 8.0f,
              .growth = 0.0034f,
              .reach = 130000.0f};
  }
}

CloudMarch::CloudMarch(ShaderLibrary& shaders, const CloudQuality& quality)
    : quality_(quality),
      in_turn_{quality.cell, resolve_of(shaders, quality.cell), {}, {}},
      anew_{quality.cut_cell, resolve_of(shaders, quality.cut_cell), {}, {}},
      march_program_(shaders.program({"clouds/march.comp"}, march_defines(quality_))),
      far_program_(shaders.program({"sky/dome.vert", "clouds/composite.frag"})),
      all_program_(shaders.program({"post/full_screen.vert", "clouds/composite.frag"},
                                   {{"NEAR_THINGS", "1"}})),
      linear_("clouds history", GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE),
      no_vertices_("clouds without vertices") {}

void CloudMarch::resize(glm::ivec2 size) {
  if (pictures_[0] && glm::ivec2(pictures_[0].width(), pictures_[0].height()) == size) return;
  for (Marched* marched : {&in_turn_, &anew_}) {
    const glm::ivec2 cells = (size + marched->cell - 1) / marched->cell;
    marched->seen = picture("clouds seen", GL_RGBA16F, cells);
    marched->distance = picture("clouds distance", GL_R16F, cells);
  }
  pictures_[0] = picture("clouds picture a", GL_RGBA16F, size);
  pictures_[1] = picture("clouds picture b", GL_RGBA16F, size);
  for (const int which : {0, 1}) {
    empty_rows_[which] = 0;
    empty_rows(which, size.y);
  }
  known_ = false;
  for (PassMemory* memory : {&march_memory_, &resolve_memory_}) memory->reset();
}

void CloudMarch::empty_rows(int which, int rows) {
  const gl::Texture& picture = pictures_[which];
  const float nothing[4] = {0.0f, 0.0f, 0.0f, 1.0f};
  const int from = empty_rows_[which];
  if (rows > from) {
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    glClearTexSubImage(picture.id(), 0, 0, from, 0, picture.width(), rows - from, 1, GL_RGBA,
                       GL_FLOAT, nothing);
  }
  empty_rows_[which] = rows;
}

TextureId CloudMarch::add(FrameGraph& graph, const CloudField& field, const CloudIds& ids,
                          const Sky& sky, const SkyIds& sky_ids, const CloudShadow& shadow,
                          const CloudShadowIds& shadow_ids, const CloudView& view,
                          const CloudCamera& camera, bool visible) {
  resize(camera.size);
  const int turns = quality_.cell.x * quality_.cell.y;
  const glm::dvec2 carried = cloud_carried(view, view.parameters.base);
  // Somebody has turned a knob.
  const CloudParameters& p = view.parameters;
  const std::uint64_t settings = hash_of(
      view.weather, view.seed, p.scale, p.density_threshold, p.density, p.extinction, p.base,
      p.container, p.shape_weights, p.detail_weights, p.roughness, p.erosion, p.brightness);
  const bool cut = !known_ || settings != settings_ ||
                   std::abs(std::log(camera.exposure / before_.exposure)) > kCutExposure ||
                   glm::length(camera.eye - before_.eye) > kCutDistance ||
                   glm::dot(forward_of(camera), forward_of(before_)) < kCutCosine ||
                   glm::length(carried - carried_before_) > kCutDistance;
  settings_ = settings;
  // Lightning changes faster than a round of pixels.
  const bool flashing = view.flash.candela > kShownFlash;
  const bool without_past = cut || turns == 1 || flashing || flashing_before_;
  flashing_before_ = flashing;
  const int anew_turns = quality_.cut_cell.x * quality_.cut_cell.y;
  anew_turn_ = without_past ? 0 : std::min(anew_turn_ + 1, anew_turns);
  const bool anew = anew_turn_ < anew_turns;

  // While nothing moves two rounds say all there is to say.
  const std::uint64_t shows = hash_of(camera.clip_from_relative, camera.eye, camera.exposure,
                                      camera.size, field.state(), view.parameters.light_steps);
  still_frames_ = shows == shown_ && !cut ? std::min(still_frames_ + 1, 2 * turns) : 0;
  shown_ = shows;
  const bool settled = still_frames_ >= 2 * turns;
  if (!settled && !anew) ++turn_;
  const int old = newest_;
  if (visible && !settled) newest_ = 1 - newest_;
  const gl::Texture& result = pictures_[newest_];
  const gl::Texture& history = pictures_[settled ? 1 - newest_ : old];

  const TextureId result_id = graph.import(result), history_id = graph.import(history);
  const Marched& marched = anew ? anew_ : in_turn_;
  const glm::ivec2 cell = marched.cell;
  const bool direct = cell == glm::ivec2(1);  // nothing is left to fill in
  const gl::Texture& target = direct ? result : marched.seen;
  const glm::ivec2 chosen = pixel_of_turn(cell, anew ? anew_turn_ : turn_);
  const bool from_below = view.eye.y < field.lowest_base();
  const int first_row = from_below ? first_sky_row(camera) / cell.y : 0;
  const float sea_below = from_below ? -static_cast<float>(horizon_dip(view.eye.y)) : -1.0f;
  if (visible && !settled) empty_rows(newest_, first_row * cell.y);
  const bool inside = view.eye.y > field.lowest_base() && view.eye.y < field.highest_top();
  const int own_steps = inside && quality_.light_steps_inside > 0 ? quality_.light_steps_inside
                                                                  : quality_.light_steps;
  const int light_steps = view.parameters.light_steps > 0 ? view.parameters.light_steps : own_steps;
  // What a turn of the camera brings into the picture is marched as after a cut.
  const glm::ivec4 known = without_past ? glm::ivec4(0) : known_pixels(camera, before_);
  const glm::ivec2 from(0, first_row * cell.y), to = camera.size;
  std::vector<glm::ivec4> entered;
  if (!anew) {
    const glm::ivec2 whole(anew_.seen.width(), anew_.seen.height());
    const auto enter = [&](glm::ivec2 first, glm::ivec2 end) {
      if (first.x < end.x && first.y < end.y)
        entered.push_back(cells_round(first, end, anew_.cell, whole));
    };
    enter(from, {known.x, to.y});
    enter({known.z, from.y}, to);
    enter(from, {to.x, known.y});
    enter({from.x, known.w}, to);
  }
  const std::uint64_t key = hash_of(shows, still_frames_, turn_, anew_turn_,
                                    march_program_.generation(), marched.resolve.generation());
  graph.add(
      "clouds.march",
      [&](PassBuilder& pass) {
        ids.read_by(pass);
        sky_ids.read_by(pass);
        shadow_ids.read_by(pass);
        pass.write(graph.import(target)).write(graph.import(marched.distance));
        if (!entered.empty())
          pass.write(graph.import(anew_.seen)).write(graph.import(anew_.distance));
        pass.cache(march_memory_, key).skip_if(!visible);
      },
      [this, &field, &sky, &shadow, &target, &marched, ids, sky_ids, shadow_ids, chosen,
       light_steps, first_row, entered](const PassContext& context) {
        sky.bind(context, sky_ids);
        field.bind(context, ids);
        shadow.bind(context, shadow_ids);
        march_program_.use();
        const gl::Program& program = march_program_.program();
        program.set(2, light_steps);
        const auto march = [&](const Marched& into, const gl::Texture& light, glm::ivec2 pixel,
                               glm::ivec4 part) {
          program.set(0, into.cell);
          program.set(1, pixel);
          program.set(3, part);
          light.bind_image(0, GL_WRITE_ONLY);
          into.distance.bind_image(1, GL_WRITE_ONLY);
          const int least = std::min(part.z, part.w), most = std::max(part.z, part.w);
          glDispatchCompute(groups(most), groups(least), 1);
        };
        march(marched, target, chosen, {0, first_row, target.width(), target.height() - first_row});
        for (const glm::ivec4& part : entered) march(anew_, anew_.seen, glm::ivec2(0), part);
      });
  if (!direct) {
    const glm::dvec2 wind = carried - carried_before_;
    const glm::dvec3 moved = camera.eye - before_.eye - glm::dvec3(wind.x, 0.0, wind.y);
    const glm::mat4 clip_before = before_.clip_from_relative;
    graph.add(
        "clouds.resolve",
        [&](PassBuilder& pass) {
          pass.read(graph.import(marched.seen)).read(graph.import(marched.distance));
          if (!anew) pass.read(graph.import(anew_.seen));
          pass.read(history_id).write(result_id);
          pass.cache(resolve_memory_, key).skip_if(!visible);
        },
        [this, &result, &history, &marched, chosen, moved, clip_before, first_row, sea_below, known,
         anew, first_row_before = first_row_before_](PassContext&) {
          marched.resolve.use();
          const gl::Program& program = marched.resolve.program();
          program.set(1, chosen);
          program.set(2, glm::vec3(moved));
          program.set(3, clip_before);
          program.set(7, kFresh);
          program.set(8, first_row);
          program.set(9, first_row_before);
          program.set(10, known);
          program.set(11, sea_below);
          program.set(12, anew_.cell);
          program.set(13, anew ? chosen : glm::ivec2(0));
          marched.seen.bind(0);
          marched.distance.bind(1);
          history.bind(2);
          anew_.seen.bind(3);
          linear_.bind(3);
          result.bind_image(0, GL_WRITE_ONLY);
          const gl::Texture& seen = marched.seen;
          glDispatchCompute(groups(seen.width()), groups(seen.height() - first_row), 1);
          glBindSampler(3, 0);
        });
  }
  before_ = camera;
  first_row_before_ = first_row * cell.y;
  carried_before_ = carried;
  known_ = visible;
  return result_id;
}

void CloudMarch::add_composite(FrameGraph& graph, const CloudField& field, const CloudIds& ids,
                               const Sky& sky, const SkyIds& sky_ids, TextureId seen, TextureId hdr,
                               TextureId depth, bool visible, bool from_below) {
  graph.add(
      "clouds.composite",
      [&](PassBuilder& pass) {
        pass.read(seen);
        ids.read_by(pass);
        sky_ids.read_by(pass);
        pass.modify(hdr);
        if (from_below) {
          pass.read(depth, Access::kAttachment).render_to({hdr}, depth);
        } else {
          pass.read(depth).render_to({hdr});
        }
        pass.skip_if(!visible);
      },
      [this, &field, &sky, ids, sky_ids, seen, depth, from_below](const PassContext& context) {
        sky.bind(context, sky_ids);
        field.bind(context, ids);
        const gl::Texture& picture = context.texture(seen);
        picture.bind(0);
        const glm::vec2 units = 1.0f / glm::vec2(static_cast<float>(picture.width()),
                                                 static_cast<float>(picture.height()));
        no_vertices_.bind();
        const LayOver over(from_below ? LayOver::Depth::kCounts : LayOver::Depth::kIgnored);
        if (from_below) {
          far_program_.use();
          far_program_.program().set(0, 1.0f);
          far_program_.program().set(1, units);
          glDrawArrays(GL_TRIANGLES, 0, kDomeVertices);
        } else {
          context.texture(depth).bind(1);
          all_program_.use();
          all_program_.program().set(1, units);
          glDrawArrays(GL_TRIANGLES, 0, 3);
        }
      });
}

}  // namespace offing
