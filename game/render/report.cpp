#include <nlohmann/json.hpp>

#include "engine/core/angles.h"
#include "game/render/statistics.h"
#include "game/render/voyage.h"

namespace offing {
namespace {
using Json = nlohmann::ordered_json;

Json passes_of(const FrameGraph& graph) {
  Json passes = Json::array();
  for (const PassReport& pass : graph.report()) {
    passes.push_back({{"name", pass.name},
                      {"ran", pass.ran},
                      {"cached", pass.cached},
                      {"culled", pass.culled},
                      {"skipped", pass.skipped},
                      {"gpu_ms", statistics_of(pass.milliseconds)}});
  }
  return passes;
}

Json boat_of(const Boat& boat) {
  const BoatState& state = boat.state();
  const Navigation& navigation = boat.navigation();
  return {{"x_m", state.position.x},
          {"y_m", state.position.y},
          {"z_m", state.position.z},
          {"heading_deg", degrees(wrap_tau(navigation.heading))},
          {"speed_kn", knots(navigation.stw)},
          {"heel_deg", degrees(navigation.heel)},
          {"pitch_deg", degrees(navigation.pitch)},
          {"twa_deg", degrees(navigation.twa)},
          {"awa_deg", degrees(navigation.awa)},
          {"aws_kn", knots(navigation.aws)},
          {"point_of_sail", name(navigation.point)},
          {"trouble", name(navigation.trouble)},
          {"limit_hits", boat.limit_hits()}};
}

}  // namespace

std::string report_of(Voyage& voyage, const Options& options) {
  Renderer& renderer = voyage.renderer();
  const gl::Renderer machine = gl::current_renderer();
  Json messages = Json::array();
  for (const auto& message : voyage.debug().messages()) messages.push_back(message.text);
  const SeaStatistics expected = renderer.ocean().statistics();

  Json json;
  json["scene"] = options.scene;
  json["renderer"] = machine.name;
  json["software"] = machine.software;
  json["timer"] = renderer.device().timer_kind();
  json["size"] = {voyage.size().x, voyage.size().y};
  json["quality"] = renderer.quality().name;
  json["frames"] = voyage.cpu_milliseconds().size();
  json["frame"] = {{"gpu_ms", statistics_of(renderer.graph().frame_milliseconds())},
                   {"cpu_ms", statistics_of(voyage.cpu_milliseconds())}};
  json["passes"] = passes_of(renderer.graph());
  json["nonfinite_pixels"] = renderer.take_nonfinite_pixels();
  json["gl_messages"] = std::move(messages);
  json["boat"] = boat_of(voyage.world().boat());
  const SeaMeasurement measured = renderer.measure_sea();
  json["sea"] = {{"hs_m", measured.hs},
                 {"tp_s", measured.tp},
                 {"hs_theoretical_m", expected.hs},
                 {"tp_theoretical_s", expected.tp},
                 {"time_s", voyage.view().sea_time}};
  return json.dump(2) + "\n";
}

}  // namespace offing
