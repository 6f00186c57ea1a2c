// The library's unit cells side by side. See README.md.
#include <Cutwater/Lattice/PeriodicLattice.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>

#include <cmath>
#include <cstdio>
#include <string>

using namespace cutwater;

namespace {

void paste(const Image& part, Image& sheet, int x0, int y0) {
  for (int y = 0; y < part.height(); ++y) {
    for (int x = 0; x < part.width(); ++x) sheet.at(x0 + x, y0 + y) = part.at(x, y);
  }
}

}  // namespace

int main(int argc, char** argv) {
  // The sheet to write, and the width of each picture on it.
  const int width = argc > 2 ? std::stoi(argv[2]) : 320;
  const auto cells = UnitCell::all();
  constexpr int kColumns = 6;
  const int rows = (static_cast<int>(cells.size()) + kColumns - 1) / kColumns;
  Image sheet(kColumns * width, rows * width);

  int shown = 0;
  for (const auto& cell : cells) {
    // [DOCS
    // Two cells along each axis; the thicker, the less length there is.
    const double radius = 0.12 / std::sqrt(cell.lengthPerCell());
    const PeriodicLattice<double> array(cell, {.period = {1, 1, 1}, .count = {2, 2, 2}}, radius);
    RenderOptions options;
    options.view = View::fromAngles(-62, 24);
    options.width = options.height = width;
    options.title = cell.name();
    options.axes = false;
    // DOCS]
    if (argc > 1) {
      paste(render(array, options), sheet, shown % kColumns * width, shown / kColumns * width);
    }
    ++shown;
    std::printf("%-22s %3zu struts of length %7.4f a cell; the centre is %7.4f away\n",
                cell.name().c_str(), cell.struts().size(), cell.lengthPerCell(),
                array.signedDistance({1, 1, 1}));
  }
  if (argc > 1) writePng(argv[1], sheet);
  return shown == 18 ? 0 : 1;
}
