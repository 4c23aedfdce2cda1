// What the probe sees as a list: cells of 4x4 texels of its level 0, and after them the texels themselves.
struct Cell {
  vec4 middle;  // xyz: unit direction; w: solid angle, sr
  vec4 light;   // rgb: radiance × solid angle
};
const int kCellTexels = 4;  // per side

const int kInCell = kCellTexels * kCellTexels;

// Cells follow each other row by row through both squares, and so do their texels, cell by cell. `side`:
// cells per side of a square.
int first_texel_of_cell(int cell, int side) { return 2 * side * side + kInCell * cell; }
