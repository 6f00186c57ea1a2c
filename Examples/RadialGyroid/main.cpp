// A gyroid bent round an axis: whole cells on each turn, so that it has no seam. See README.md.
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <cmath>
#include <cstdio>

using namespace cutwater;

int main(int argc, char** argv) {
  // [DOCS
  const auto round =
      TpmsMap<double>::cylindrical({.radialSize = 10, .cellsPerTurn = 16, .axialSize = 10});
  const TpmsSolid<double> wall(TpmsField<double>(TpmsPattern::gyroid(), round), TpmsPart::Wall,
                               0.3);
  const Cylinder<double> outside({0, 0, 0}, {0, 0, 30}, 35);
  const Cylinder<double> bore({0, 0, -1}, {0, 0, 31}, 15);
  const auto core = (outside - bore) & wall;
  // DOCS]

  // Both sides of where the angle jumps from pi to -pi.
  double jump = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3<double> above{-15 - 0.02 * i, 1e-9, 0.03 * i};
    const Vec3<double> below{above.x, -1e-9, above.z};
    jump = std::max(jump, std::abs(wall.signedDistance(above) - wall.signedDistance(below)));
  }
  std::printf("values at the seam differ by %.1e at most\n", jump);
  if (argc > 1) {
    RenderOptions options;
    options.view = View::fromAngles(-60, 35);
    options.cuts = {CutPlane::through({0, 0, 0}, {0.5, -1, 0})};
    options.title = "A gyroid round an axis";
    writePng(argv[1], render(core, options));
  }
  return jump < 1e-8 ? 0 : 1;
}
