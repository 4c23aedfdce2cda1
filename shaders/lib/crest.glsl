// Light on its way through a wave's crest. Compiled as GLSL and as double-precision C++.

// Sea water turns most scattered light by little, and it goes on: this share of the scattering is lost to a beam.
const float kScatteringLost = 0.15;

// Light that comes out turned by 40 to 60 degrees over what one turn alone brings, where no more than that is
// lost; `scattered`: scattering times the way, up to 3. Fitted to paths that were drawn by chance
// (tests/formula/crest_test.cpp), whatever the absorption.
float crest_turned_again(float scattered) { return 1.0 + 0.18 * scattered; }
