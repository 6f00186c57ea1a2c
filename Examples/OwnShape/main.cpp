// A shape of one's own: a lens, beside the intersection of two balls, which is the same solid with
// lesser values. See README.md.
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <cstdio>

#include "Lens.hpp"

using namespace cutwater;

int main(int argc, char** argv) {
  // [DOCS
  const Solid<double> lens = Lens(1, 0.7);
  const Solid<double> both = Sphere<double>({0, 0, 0.7}, 1) & Sphere<double>({0, 0, -0.7}, 1);
  std::printf("%s%s", lens.describe().c_str(), both.describe().c_str());

  const Vec3<double> p{2, 0, 0};                   // level with the rim
  const double distance = lens.signedDistance(p);  // 2 - sqrt(0.51), the distance
  const double bound = both.signedDistance(p);     // sqrt(4.49) - 1, which is less

  // Grown by 0.15: the lens gets a round rim, the intersection keeps its sharp one.
  Solid<double> round = offset(lens, 0.15);
  const Solid<double> sharp = offset(both, 0.15);
  round.translate({0, 2.2, 0});
  const auto grown = named(round, "Lens") | named(sharp, "intersection");
  // DOCS]

  std::printf("at (2, 0, 0): %.6f and %.6f\n", distance, bound);
  if (argc > 1) {
    RenderOptions options;
    options.view = View::fromAngles(15, 30);
    options.cuts = {CutPlane::through({0, 0, 0}, {1, 0, 0})};
    options.title = "Two balls' common part, grown by 0.15";
    options.width = 960;
    options.height = 600;
    writePng(argv[1], render(grown, options));
  }
  const bool isRight = std::abs(distance - (2 - std::sqrt(0.51))) < 1e-15 &&
                       std::abs(bound - (std::sqrt(4.49) - 1)) < 1e-15 && bound < distance;
  return isRight ? 0 : 1;
}
