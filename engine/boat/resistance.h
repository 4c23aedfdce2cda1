#pragma once

namespace offing {

/// Resistance of R8's canoe body, N, upright, at `speed` m/s >= 0 through the water: the table of
/// the whole boat less 5.8 V^2, which the foils carry as their profile drag. Beyond 8 knots it goes
/// on along the last slope.
double upright_resistance(double speed);

/// What heel adds, N (Delft systematic yacht hull series: Keuning & Sonnenberg 1998), `heel` in
/// rad.
double heeled_resistance(double speed, double heel);

}  // namespace offing
