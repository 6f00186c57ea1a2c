// From Schwarz P to D, in cells that become smaller and walls that become thicker. See README.md.
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <cstdio>

using namespace cutwater;

int main(int argc, char** argv) {
  // [DOCS
  // Along z cells shrink from 12 to 6; by the integral of their number, so that none is distorted.
  const TpmsMap<double> map(
      std::array<CellSizes<double>, 3>{12, 12, CellSizes<double>({{0, 12}, {60, 6}})});
  // The distance above z = 15 takes the pattern from P to D within 30, and the walls from 0.1 to
  // 0.3.
  const Plane<double> below({0, 0, 15}, {0, 0, 1});
  const auto weight = GradedValue<double>::byValueOf(below, {.start = 0, .end = 1, .over = 30});
  const auto level = GradedValue<double>::byValueOf(below, {.start = 0.1, .end = 0.3, .over = 45});
  const TpmsField<double> field(
      TpmsTransition<double>{TpmsPattern::schwarzP(), TpmsPattern::schwarzD(), weight}, map);
  const auto block =
      Cuboid<double>({0, 0, 0}, {36, 36, 60}) & TpmsSolid<double>(field, TpmsPart::Wall, level);
  // DOCS]

  // How much of a layer is wall, by samples.
  for (const double z : {5.0, 30.0, 55.0}) {
    int inside = 0;
    for (int i = 0; i < 3600; ++i) {
      const int row = i / 60;
      inside += block.signedDistance({0.6 * (i % 60), 0.6 * row, z}) < 0 ? 1 : 0;
    }
    std::printf("at z = %2.0f the wall fills about %.2f of the plane\n", z, inside / 3600.0);
  }
  if (argc > 1) {
    RenderOptions options;
    options.view = View::fromAngles(-60, 20);
    options.title = "From Schwarz P to D, smaller and thicker";
    options.height = 1400;
    writePng(argv[1], render(block, options));
  }
  return block.signedDistance({18, 18, 70}) > 0 ? 0 : 1;
}
