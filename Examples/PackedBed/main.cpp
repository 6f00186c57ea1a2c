// Balls of two sizes shaken into a cylinder, and how much room they leave. See README.md.
#include <Cutwater/Bvh/PointCloud.hpp>
#include <Cutwater/Grid/SolidVolume.hpp>
#include <Cutwater/Lattice/PackedBed.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>

using namespace cutwater;

namespace {

constexpr double kRadius = 5;  // of the cylinder, which stands on z = 0

std::vector<Ball<double>> looseBalls(int count) {
  std::mt19937 random(1);
  const auto number = [&](double to) { return to * static_cast<double>(random()) / 0x1p32; };
  std::vector<Ball<double>> balls;
  for (int i = 0; i < count; ++i) {
    const double angle = number(2 * std::numbers::pi);
    const double away = 0.8 * kRadius * std::sqrt(number(1));
    const Vec3<double> center{away * std::cos(angle), away * std::sin(angle), 0.04 * i};
    balls.push_back({center, i % 3 == 0 ? 0.9 : 0.6});
  }
  return balls;
}

/// Moves balls that overlap apart by half of that, down a little, and back into the cylinder.
/// After Jodrey and Tory (1985), "Computer simulation of close random packing of equal spheres".
void settle(std::vector<Ball<double>>& balls, double fall) {
  // [DOCS
  std::vector<Vec3<double>> centers;
  for (const auto& ball : balls) centers.push_back(ball.center);
  const PointCloud<double> cloud(centers);
  const auto near = cloud.within(centers, 1.8);  // the larger balls' diameter
  // DOCS]
  for (std::size_t i = 0; i < balls.size(); ++i) {
    auto& [center, radius] = balls[i];
    center.z -= fall;
    for (const auto& [other, distance] : near.of(i)) {
      const double overlap = radius + balls[other].radius - distance;
      if (other == i || overlap <= 0 || distance == 0) continue;
      center = center + (0.5 * overlap / distance) * (centers[i] - centers[other]);
    }
    center.z = std::max(center.z, radius);
    const double away = std::hypot(center.x, center.y);
    const double allowed = kRadius - radius;
    if (away > allowed) {
      center.x *= allowed / away;
      center.y *= allowed / away;
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  auto balls = looseBalls(argc > 2 ? std::stoi(argv[2]) : 300);
  constexpr int kSteps = 2000;
  for (int step = 0; step < kSteps; ++step) settle(balls, 0.02 * (1 - 1.0 * step / kSteps));

  // [BED
  const PackedBed<double> bed(balls);
  const double top = bed.boundingBox().upper.z;
  // What is between the balls, in the middle of the bed.
  const Box<double> core{{-2, -2, 0.3 * top}, {2, 2, 0.6 * top}};
  const auto known = solidVolume(bed, core, {.fraction = 0.1});
  // BED]
  std::printf("%zu balls; porosity about %.3f, certainly %.3f to %.3f\n", bed.size(),
              1 - known.estimate / known.boxVolume, known.porosity().lower, known.porosity().upper);

  if (argc > 1) {
    RenderOptions options;
    options.view = View::fromAngles(-60, 22);
    const auto jacket = Cylinder<double>({0, 0, -0.3}, {0, 0, 0.9 * top}, kRadius + 0.3) -
                        Cylinder<double>({0, 0, 0}, {0, 0, top}, kRadius);
    options.cuts = {CutPlane::through({0, 0, 0}, {0.3, -1, 0})};
    options.legend = false;
    options.title = "A packed bed";
    writePng(argv[1], render(named(jacket, "jacket") | named(bed, "bed"), options));
  }
  return known.isWithinTolerance ? 0 : 1;
}
