// A program of somebody else's that makes a picture of a sphere.
#include <Cutwater/Render.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <cstdio>

int main() {
  const auto image = cutwater::render(cutwater::Sphere<double>({0, 0, 0}, 1));
  cutwater::writePng("sphere.png", image);
  std::printf("%d x %d pixels\n", image.width(), image.height());
  return 0;
}
