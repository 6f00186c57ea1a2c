// A flanged pipe, drawn with a quarter of it cut open. See README.md.
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>

using namespace cutwater;

namespace {

Solid<double> flange(double z) {
  Solid<double> disc = Cylinder<double>({0, 0, z}, {0, 0, z + 0.3}, 1.6);
  for (int i = 0; i < 8; ++i) {
    const double angle = (i + 0.5) * std::numbers::pi / 4;
    const Vec3<double> hole{1.3 * std::cos(angle), 1.3 * std::sin(angle), z};
    disc =
        disc - Cylinder<double>(hole - Vec3<double>{0, 0, 1}, hole + Vec3<double>{0, 0, 1}, 0.12);
  }
  return disc;
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path file = argc > 1 ? argv[1] : "pipe.png";
  // [DOCS
  const Solid<double> tube = Cylinder<double>({0, 0, 0.1}, {0, 0, 3.9}, 0.9);
  const Solid<double> bore = Cylinder<double>({0, 0, -1}, {0, 0, 5}, 0.7);
  const Solid<double> body = named(tube, "tube") | named(flange(0) | flange(3.7), "flanges");

  RenderOptions options;
  options.view = View::fromAngles(-60, 25);
  options.cuts = {CutPlane::through({0, 0, 0}, {0.4, -1, 0})};
  options.title = "Flanged pipe";
  options.unit = "m";
  const Image picture = render(body - named(bore, "bore"), options);
  writePng(file, picture);
  // DOCS]

  std::size_t drawn = 0;
  for (const auto& pixel : picture.pixels()) drawn += pixel == Rgb{255, 255, 255} ? 0 : 1;
  std::printf("%d x %d pixels, %zu of them not white\n", picture.width(), picture.height(), drawn);
  return drawn > picture.pixels().size() / 8 ? 0 : 1;
}
