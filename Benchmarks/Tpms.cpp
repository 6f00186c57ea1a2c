// Triply periodic patterns beside a plain loop with std::sin and std::cos: prints tables as
// Markdown. Needs no peer.
//
//   cutwater_tpms_benchmark

#include <Cutwater/Tpms/Detail/PatternDistance.hpp>
#include <Cutwater/Tpms/MetricWall.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <cstdio>
#include <exception>
#include <numbers>
#include <vector>

#include "Support/CpuTime.hpp"
#include "Support/Random.hpp"
#include "Tpms/PlainPatterns.hpp"

namespace cutwater::benchmarks {

namespace {

constexpr int kPoints = 20000;

template <typename T>
std::vector<Vec3<T>> randomPoints(T extent, int count) {
  test::RandomPoints<T> random(extent, 7);
  std::vector<Vec3<T>> points(static_cast<std::size_t>(count));
  for (auto& p : points) p = random.next();
  return points;
}

/// CPU time of the best of some rounds: others may have the cores meanwhile.
template <typename Work>
double bestCpuSeconds(const Work& work) {
  double best = test::cpuSeconds(work);
  for (int again = 0; again < 6; ++again) best = std::min(best, test::cpuSeconds(work));
  return best;
}

/// Nanoseconds per point.
template <typename Work>
double nanoseconds(int points, const Work& work) {
  return 1e9 * bestCpuSeconds(work) / points;
}

/// Of values one after the other.
template <typename T>
double oneByOne(const SignedDistanceFunction<T>& solid, const std::vector<Vec3<T>>& points) {
  T sum = 0;
  const double time = nanoseconds(static_cast<int>(points.size()), [&] {
    for (const auto& p : points) sum += solid.signedDistance(p);
  });
  if (sum == T(0.125)) std::printf("\n");  // keeps the sum
  return time;
}

template <typename T>
double together(const SignedDistanceFunction<T>& solid, const std::vector<Vec3<T>>& points) {
  std::vector<T> values(points.size());
  return nanoseconds(static_cast<int>(points.size()),
                     [&] { solid.signedDistances(points, values); });
}

/// What a user would write: F alone, with neither a gradient nor a bound.
double plainLoop(const test::PlainPattern& plain, const std::vector<Vec3<double>>& points) {
  double sum = 0;
  constexpr double kTurn = 2 * std::numbers::pi;
  const double time = nanoseconds(static_cast<int>(points.size()), [&] {
    for (const auto& p : points) sum += plain.value(kTurn * p.x, kTurn * p.y, kTurn * p.z);
  });
  if (sum == 0.125) std::printf("\n");
  return time;
}

double levelOf(const TpmsPattern& pattern) {
  return 0.4 * std::min(pattern.pinch(TpmsChannel::A), pattern.pinch(TpmsChannel::B));
}

template <typename T>
TpmsSolid<T> wallOf(const TpmsPattern& pattern) {
  return {TpmsField<T>(pattern, T(1)), TpmsPart::Wall, static_cast<T>(levelOf(pattern))};
}

void printLevelWalls() {
  std::printf(
      "Walls of a level, ns per value:\n\n"
      "| pattern | plain loop | one by one | batch | one by one, float | batch, float |\n"
      "|---|---:|---:|---:|---:|---:|\n");
  const auto plain = test::plainPatterns();
  const auto points = randomPoints<double>(2, kPoints);
  const auto floats = randomPoints<float>(2, kPoints);
  std::size_t next = 0;
  for (const auto& pattern : TpmsPattern::all()) {
    const auto wall = wallOf<double>(pattern);
    const auto small = wallOf<float>(pattern);
    std::printf("| %s | %.0f | %.0f | %.1f | %.0f | %.1f |\n", pattern.name().c_str(),
                plainLoop(plain[next++], points), oneByOne(wall, points), together(wall, points),
                oneByOne(small, floats), together(small, floats));
    std::fflush(stdout);
  }
}

void printMaps() {
  using D = double;
  std::printf(
      "\nThe gyroid by maps, ns per value:\n\n| cells | one by one | batch |\n|---|---:|---:|\n");
  const auto points = randomPoints<double>(2, kPoints);
  const auto row = [&](const char* name, const TpmsField<D>& field) {
    const TpmsSolid<D> wall(field, TpmsPart::Wall, 0.4);
    std::printf("| %s | %.0f | %.0f |\n", name, oneByOne(wall, points), together(wall, points));
    std::fflush(stdout);
  };
  const auto gyroid = TpmsPattern::gyroid();
  row("cubic", {gyroid, 1.0});
  row("a size per axis", {gyroid, TpmsMap<D>(Vec3<D>{1, 1.5, 0.75})});
  const CellSizes<D> along(std::vector<CellSizeAt<D>>{{-1, 0.5}, {0.25, 1}, {1, 0.75}});
  row("sizes along an axis", {gyroid, TpmsMap<D>(std::array<CellSizes<D>, 3>{1.0, along, 0.75})});
  row("around an axis", {gyroid, TpmsMap<D>::cylindrical({0.7, 5, 0.9, 0.1})});
  row("deformed", {gyroid, TpmsMap<D>(1.0).deformed({.amplitude = 0.15, .spacing = {1, 1, 1}})});
  const auto weight = GradedValue<D>::by([](const Vec3<D>& p) { return 0.5 + 0.2 * p.z; },
                                         {.lipschitz = 0.2, .least = 0, .most = 1});
  row("a transition",
      {TpmsTransition<D>{.from = gyroid, .to = TpmsPattern::schwarzP(), .weight = weight}, 1.0});
}

double smallerRadius(const TpmsPattern& pattern) {
  return std::min(pattern.inscribedRadius(TpmsChannel::A), pattern.inscribedRadius(TpmsChannel::B));
}

/// Mean and worst, the latter of points one by one, each the best of some rounds.
void printMetricWall(const TpmsPattern& pattern, double half) {
  const MetricWall<double> wall(pattern, 1, half);
  constexpr int kCount = 1000;
  const auto points = randomPoints<double>(1, kCount);
  double worst = 0;
  for (const auto& p : points) {
    double value = 0;
    const double seconds = bestCpuSeconds([&] { value += wall.signedDistance(p); });
    if (value == 0.125) std::printf("\n");
    worst = std::max(worst, seconds);
  }
  std::printf(" %.3f: %.1f, %.0f |", half, 1e-3 * oneByOne(wall, points), 1e6 * worst);
  std::fflush(stdout);
}

void printMetricWalls() {
  std::printf(
      "\nWalls of even thickness, half the thickness in cells: us per value in the mean, at "
      "worst:\n\n"
      "| pattern | certain to 1.6e-10 | 0.3 | 0.6 | 0.9 | 0.98 |\n"
      "|---|---:|---:|---:|---:|---:|\n");
  for (const auto& pattern : TpmsPattern::all()) {
    std::printf("| %s |", pattern.name().c_str());
    printMetricWall(pattern,
                    0.6 * detail::PatternDistance::certainReach(pattern) / (2 * std::numbers::pi));
    for (const double share : {0.3, 0.6, 0.9, 0.98}) {
      printMetricWall(pattern, share * smallerRadius(pattern));
    }
    std::printf("\n");
  }
}

}  // namespace

}  // namespace cutwater::benchmarks

int main() try {
  cutwater::benchmarks::printLevelWalls();
  cutwater::benchmarks::printMaps();
  cutwater::benchmarks::printMetricWalls();
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "cutwater_tpms_benchmark: %s\n", error.what());
  return 1;
}
