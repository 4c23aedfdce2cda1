struct Cell {
  vec4 middle;  // xyz: unit direction; w: solid angle, sr
  vec4 light;   // rgb: radiance × solid angle
};
