// Schwarz P walls, moved about by a random field: two amplitudes on two grids. See README.md.
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <cstdio>

using namespace cutwater;

int main(int argc, char** argv) {
  // [DOCS
  const Cuboid<double> box({0, 0, 0}, {30, 30, 30});
  std::vector<Solid<double>> all;
  for (const double spacing : {20.0, 8.0}) {
    for (const double amplitude : {0.1, 0.25}) {
      // Shifts of up to so much of the grid's spacing, at each of its nodes.
      const DeformationField<double> field{.amplitude = amplitude * spacing,
                                           .spacing = {spacing, spacing, spacing}};
      const TpmsField<double> moved(TpmsPattern::schwarzP(), TpmsMap<double>(10).deformed(field));
      const TpmsSolid<double> wall(moved, TpmsPart::Wall, 0.25);
      const auto column = double(all.size());
      all.push_back(translated(box & wall, {38 * column, 0, 0}));
      // DOCS]
      std::printf("nodes %g apart, shifts up to %g: they change by %.2f per length at most\n",
                  spacing, field.amplitude, field.lipschitz());
    }
  }
  if (argc > 1) {
    RenderOptions options;
    options.view = View::fromAngles(-80, 22);
    options.title = "Schwarz P, deformed: grids of 20 and 8, shifts of 0.1 and 0.25 of that";
    options.width = 2000;
    options.height = 800;
    writePng(argv[1], render(unionOf(all), options));
  }
  return all.size() == 4 ? 0 : 1;
}
