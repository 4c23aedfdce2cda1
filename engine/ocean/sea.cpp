#include "engine/ocean/sea.h"

#include <algorithm>
#include <cmath>

#include "engine/core/random.h"
#include "engine/ocean/crossfade.h"
#include "engine/ocean/sea_water.h"

#define OFFING_GLSL "shaders/lib/water.glsl"
#include "engine/core/glsl_double.h"

namespace offing {
namespace {

SlopeVariance scaled(const SlopeVariance& v, double factor) {
  return {factor * v.xx, factor * v.zz, factor * v.xz};
}

SlopeVariance mixed(const SlopeVariance& a, double wa, const SlopeVariance& b, double wb) {
  SlopeVariance sum = scaled(a, wa);
  return sum += scaled(b, wb);
}

Cascade blend(const Cascade& from, const Cascade& to, double seconds) {
  const bool straight = same_grid(from, to);
  const Crossfade fade = crossfade(seconds, straight);
  Cascade result = straight || fade.to > 0.0 ? to : from;
  if (!straight) {  // one of the two weights is 0
    const double weight = fade.to > 0.0 ? fade.to : fade.from;
    for (std::complex<double>& h0 : result.h0) h0 *= weight;
    result.variance *= weight * weight;
    for (SlopeVariance& resolved : result.resolved) resolved = scaled(resolved, weight * weight);
    for (SlopeVariance& cell : result.slope_cells) cell = scaled(cell, weight * weight);
    result.slope_rate *= weight * weight;
    return result;
  }
  for (std::size_t i = 0; i < result.h0.size(); ++i) {
    result.h0[i] = fade.from * from.h0[i] + fade.to * to.h0[i];
  }
  result.variance = fade.from * from.variance + fade.to * to.variance;
  for (int level = 0; level < kVarianceLevels; ++level) {
    result.resolved[level] = mixed(from.resolved[level], fade.from, to.resolved[level], fade.to);
  }
  for (std::size_t i = 0; i < result.slope_cells.size(); ++i) {
    result.slope_cells[i] = mixed(from.slope_cells[i], fade.from, to.slope_cells[i], fade.to);
  }
  result.slope_rate = fade.from * from.slope_rate + fade.to * to.slope_rate;
  return result;
}

}  // namespace

Sea make_sea(const SeaState& state, const Environment& environment, std::uint64_t seed,
             int cascades, int size) {
  Sea sea;
  sea.wind_speed = environment.wind.speed;
  sea.wind_to = environment.wind_to();
  const SeaSpectrum spectrum(state, sea.wind_speed, sea.wind_to);
  SlopeVariance carried;
  for (const CascadeBand& band : choose_bands(spectrum, cascades, size)) {
    sea.cascades.push_back(
        make_cascade(spectrum, band, size, seed, static_cast<int>(sea.cascades.size())));
    carried += sea.cascades.back().resolved[0];
  }
  sea.statistics = spectrum.statistics();
  sea.choppiness = state.choppiness;
  sea.white_share = glsl::whitecap_share(sea.wind_speed);
  // Ripples that no cascade carries: what Cox and Munk saw beyond the waves we have.
  sea.slope_variance = cox_munk(sea.wind_speed, sea.wind_to);
  sea.slope_variance.xx = std::max(sea.slope_variance.xx, carried.xx + 5e-4);
  sea.slope_variance.zz = std::max(sea.slope_variance.zz, carried.zz + 5e-4);
  return sea;
}

std::uint64_t key_of(const SeaState& state, const Environment& environment, std::uint64_t seed) {
  return hash_of(state.spectrum, state.spreading, state.elongation, state.fetch_km, state.depth_m,
                 state.choppiness, state.swell.height, state.swell.period, state.swell.from_deg,
                 state.swell.spreading, environment.wind.speed, environment.wind_to(), seed);
}

Sea blend(const Sea& from, const Sea& to, double seconds) {
  const Crossfade fade = crossfade(seconds, true);
  const auto mix = [&](double a, double b) { return fade.from * a + fade.to * b; };
  Sea sea;
  for (std::size_t c = 0; c < to.cascades.size(); ++c) {
    sea.cascades.push_back(blend(from.cascades[c], to.cascades[c], seconds));
  }
  const SeaStatistics &a = from.statistics, &b = to.statistics;
  sea.statistics = {mix(a.m0, b.m0), mix(a.hs, b.hs), mix(a.tp, b.tp),
                    mix(a.mean_square_slope, b.mean_square_slope)};
  sea.slope_variance = mixed(from.slope_variance, fade.from, to.slope_variance, fade.to);
  sea.choppiness = mix(from.choppiness, to.choppiness);
  sea.white_share = mix(from.white_share, to.white_share);
  sea.wind_speed = mix(from.wind_speed, to.wind_speed);
  const glm::dvec2 wind = fade.from * from.wind_to + fade.to * to.wind_to;
  const double length = glm::length(wind);
  sea.wind_to = length > 1e-3 ? wind / length : to.wind_to;
  return sea;
}

}  // namespace offing
