// Unions of many shapes, and boxes classified by them: prints tables as Markdown. Needs no peer.
//
//   cutwater_union_benchmark [elephant.off]

#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>

#include "Seconds.hpp"
#include "Support/Random.hpp"

namespace cutwater::benchmarks {

namespace {

std::vector<Vec3<double>> pointsIn(double extent, int count) {
  test::RandomPoints<double> random(extent, 7);
  std::vector<Vec3<double>> points(static_cast<std::size_t>(count));
  for (auto& p : points) p = random.next();
  return points;
}

/// Spheres and boxes by turns, in [-1, 1]^3; together of about a tenth of its volume, however many.
std::vector<Solid<double>> scattered(int count) {
  test::RandomPoints<double> random(1, 5);
  const double size = 0.35 / std::cbrt(count);
  std::vector<Solid<double>> result;
  result.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const auto p = random.next();
    const double radius = size * (1 + 0.5 * random.next().x);
    const Vec3<double> half{radius, radius, radius};
    if (i % 2 == 0) {
      result.push_back(Sphere<double>(p, radius));
    } else {
      result.push_back(Cuboid<double>(p - half, p + half));
    }
  }
  return result;
}

/// Balls of radius 0.45 spacings on a cubic grid of n^3, shaken by up to 0.05 spacings; in
/// [-1, 1]^3.
std::vector<Solid<double>> packedBed(int n) {
  const double spacing = 2.0 / n;
  test::RandomPoints<double> random(0.05 * spacing, 3);
  std::vector<Solid<double>> result;
  for (int i = 0; i < n * n * n; ++i) {
    const auto cell = [&](int index) { return (index % n + 0.5) * spacing - 1; };
    const Vec3<double> center{cell(i), cell(i / n), cell(i / n / n)};
    result.push_back(Sphere<double>(center + random.next(), 0.45 * spacing));
  }
  return result;
}

/// Seconds per value of the union, one thread, one point after the other; the best of three.
double secondsPerValue(const Solid<double>& solid, const std::vector<Vec3<double>>& points,
                       std::vector<double>& values) {
  const double best = bestSecondsOf([&] {
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = solid.signedDistance(points[i]);
  });
  return best / static_cast<double>(points.size());
}

/// The same by a plain loop over all shapes, for the first of the points, as many as about 3 10^7
/// shapes allow. @throws std::logic_error if a value differs.
double secondsByLoop(const std::vector<Solid<double>>& shapes,
                     const std::vector<Vec3<double>>& points, const std::vector<double>& values) {
  const auto count = std::clamp<std::size_t>(30'000'000 / shapes.size(), 10, points.size());
  std::size_t wrong = 0;
  const double seconds = secondsOf([&] {
    for (std::size_t i = 0; i < count; ++i) {
      double least = Box<double>::kInf;
      for (const auto& shape : shapes) least = std::min(least, shape.signedDistance(points[i]));
      wrong += least != values[i] ? 1 : 0;
    }
  });
  if (wrong > 0) throw std::logic_error("the union's values are not those of the plain loop");
  return seconds / static_cast<double>(count);
}

void printUnion(const char* name, const std::vector<Solid<double>>& shapes, double& before) {
  const auto points = pointsIn(1, 100'000);
  std::vector<double> values(points.size());
  std::optional<Solid<double>> whole;
  const double building = secondsOf([&] { whole = unionOf(shapes); });
  const double ours = 1e9 * secondsPerValue(*whole, points, values);
  const double loop = 1e9 * secondsByLoop(shapes, points, values);
  std::printf("| %s | %zu | %.3f | %.0f | %.2f | %.0f | %.0f |\n", name, shapes.size(), building,
              ours, before > 0 ? ours / before : 1.0, loop, loop / ours);
  std::fflush(stdout);
  before = ours;
}

/// Classifies the box and, unless that decides it, its octants.
std::size_t descend(const Solid<double>& solid, const Box<double>& box, int levels,
                    const BoxHint* above) {
  BoxHint hint = above != nullptr ? *above : BoxHint{};
  const auto kind = solid.classify(box, above != nullptr ? &hint : nullptr);
  std::size_t count = 1;
  if (levels == 0 || kind == BoxClass::Inside || kind == BoxClass::Outside) return count;
  const auto center = box.center();
  for (int i = 0; i < 8; ++i) {
    const auto corner = box.corner(i);
    count += descend(solid, {min(center, corner), max(center, corner)}, levels - 1,
                     above != nullptr ? &hint : nullptr);
  }
  return count;
}

void printBoxes(const char* name, const Solid<double>& solid, const Box<double>& box, int levels) {
  const BoxHint none;
  std::size_t count = 0;
  double seconds[2] = {Box<double>::kInf, Box<double>::kInf};
  for (int round = 0; round < 4; ++round) {
    const BoxHint* const above = round % 2 == 0 ? nullptr : &none;
    auto& best = seconds[round % 2];
    best = std::min(best, secondsOf([&] { count = descend(solid, box, levels, above); }));
  }
  const double thousands = static_cast<double>(count) / 1000;
  std::printf("| %s | %d | %zu | %.0f | %.0f |\n", name, levels, count, thousands / seconds[0],
              thousands / seconds[1]);
  std::fflush(stdout);
}

void run(const char* meshFile) {
  std::printf(
      "| union of | shapes | built in s | ns per value | growth | plain loop | ratio |\n"
      "|---|---:|---:|---:|---:|---:|---:|\n");
  double before = 0;
  for (const int count : {100, 1000, 10'000, 100'000, 1'000'000}) {
    printUnion("spheres and boxes", scattered(count), before);
  }
  before = 0;
  const auto bed = packedBed(80);
  printUnion("packed bed, 80^3 spheres", bed, before);

  std::printf(
      "\n| boxes of | levels | boxes | 1000/s without hints | with |\n"
      "|---|---:|---:|---:|---:|\n");
  const Box<double> cube{{-1, -1, -1}, {1, 1, 1}};
  printBoxes("100 spheres and boxes", unionOf(scattered(100)), cube, 6);
  printBoxes("10^4 spheres and boxes", unionOf(scattered(10'000)), cube, 6);
  printBoxes("packed bed, 80^3 spheres", unionOf(bed), cube, 5);
  if (meshFile == nullptr) return;
  const Solid<double> mesh = MeshSDF<double>(readSurface(meshFile).soup);
  const auto around = mesh.boundingBox();
  const Box<double> room{around.center(), around.center()};
  printBoxes("mesh", mesh, room.grown(0.55 * maxComponent(around.upper - around.lower)), 7);
}

}  // namespace

}  // namespace cutwater::benchmarks

int main(int count, char** arguments) try {
  cutwater::benchmarks::run(count > 1 ? arguments[1] : nullptr);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "cutwater_union_benchmark: %s\n", error.what());
  return 1;
}
