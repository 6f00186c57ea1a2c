// Four triply periodic walls side by side, each in a box of two cells. See README.md.
#include <Cutwater/Grid/SolidVolume.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <algorithm>
#include <cstdio>
#include <numbers>

using namespace cutwater;

int main(int argc, char** argv) {
  // [DOCS
  constexpr double kCell = 10;
  const Cuboid<double> box({0, 0, 0}, {20, 20, 20});
  std::vector<Solid<double>> row;
  for (const auto& pattern : {TpmsPattern::gyroid(), TpmsPattern::lidinoid(),
                              TpmsPattern::schwarzP(), TpmsPattern::schwarzD()}) {
    // About 1 thick, if that leaves channels on both sides.
    const double level =
        std::min({std::numbers::pi / kCell * pattern.meanSlope(),
                  0.8 * pattern.pinch(TpmsChannel::A), 0.8 * pattern.pinch(TpmsChannel::B)});
    const TpmsSolid<double> wall(TpmsField<double>(pattern, kCell), TpmsPart::Wall, level);
    row.push_back(named(translated(box & wall, {28.0 * double(row.size()), 0, 0}), pattern.name()));
    // DOCS]
    const Box<double> cell{{0, 0, 0}, {kCell, kCell, kCell}};
    const auto filled = solidVolume(wall, cell, {.fraction = 0.05}).solidFraction();
    std::printf("%-10s level %.3f: the wall fills %.3f to %.3f of space\n", pattern.name().c_str(),
                level, filled.lower, filled.upper);
  }
  if (argc > 1) {
    RenderOptions options;
    options.view = View::fromAngles(-80, 22);
    options.title = "Gyroid, lidinoid, Schwarz P and D";
    options.width = 2000;
    options.height = 800;
    options.legend = false;
    writePng(argv[1], render(unionOf(row), options));
  }
  // A wall is where it should be: on the surface, and not in the middle of a channel.
  return row[0].signedDistance({5, 5, 5}) < 0 && row[2].signedDistance({61, 5, 5}) > 0 ? 0 : 1;
}
