// How an eye or a camera has adapted: kept on the GPU from frame to frame, never read back in play.
const int kBins = 64;
const float kLowestBin = -20.0;   // log2 of cd/m^2
const float kBinsPerStop = 1.6;   // up to log2 = 20
struct ExposureState {
  uint histogram[kBins];
  float stops;    // log2 of the exposure adapted to
  float factor;   // what the picture (radiance × its own exposure) is multiplied by
  float metered;  // log2 of the luminance it was last metered at, cd/m^2
  uint adapted;   // 0 before the first frame
};
