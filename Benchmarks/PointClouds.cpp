// Points found by PointCloud and by nanoflann, beds of balls, and bounds of a volume; prints tables
// as Markdown.
//
//   cutwater_point_benchmark [most points]

#include <Cutwater/Bvh/PointCloud.hpp>
#include <Cutwater/Grid/SolidVolume.hpp>
#include <Cutwater/Lattice/PackedBed.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <malloc.h>
#include <numbers>
#include <stdexcept>

#include "Support/Random.hpp"
#ifdef CUTWATER_BENCHMARK_NANOFLANN
#include "Peers/Nanoflann.hpp"
#endif

namespace cutwater::benchmarks {

namespace {

using Points = std::vector<Vec3<double>>;

constexpr int kQueries = 20'000;
constexpr int kRounds = 11;

/// In [-1, 1]^3, or on the unit sphere.
Points randomPoints(int count, bool areOnSphere, unsigned seed) {
  test::RandomPoints<double> random(1, seed);
  Points points;
  while (points.size() < static_cast<std::size_t>(count)) {
    const auto p = random.next();
    if (!areOnSphere) points.push_back(p);
    if (areOnSphere && lengthSquared(p) < 1) points.push_back(normalized(p));
  }
  return points;
}

/// In processor time, in which others on the machine count less: all of it is one thread's work.
template <typename Work>
double processorSecondsOf(const Work& work) {
  const auto start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Contestants that take turns: the best round of each, in nanoseconds per query.
class Turns {
 public:
  template <typename Ask>
  void ask(std::size_t contestant, const Ask& ask) {
    if (best_.size() <= contestant) best_.resize(contestant + 1, Box<double>::kInf);
    best_[contestant] = std::min(best_[contestant], 1e9 * processorSecondsOf(ask) / kQueries);
  }
  [[nodiscard]] double operator[](std::size_t contestant) const { return best_[contestant]; }

 private:
  std::vector<double> best_;
};

#ifdef CUTWATER_BENCHMARK_NANOFLANN

void requireSame(bool isSame) {
  if (!isSame) throw std::logic_error("nanoflann finds other points");
}

void printNearest(const char* name, const Points& points, const Points& queries, std::size_t k,
                  const PointCloud<double>& cloud, const NanoflannTree& peer) {
  std::vector<Neighbor<double>> found(k * queries.size());
  std::vector<std::uint32_t> ids(k * queries.size());
  std::vector<double> squares(k * queries.size());
  Turns turns;
  for (int round = 0; round < kRounds; ++round) {
    turns.ask(0, [&] {
      for (std::size_t n = 0; n < queries.size(); ++n) {
        peer.nearest(queries[n], std::span(ids).subspan(n * k, k),
                     std::span(squares).subspan(n * k, k));
      }
    });
    turns.ask(1, [&] {
      for (std::size_t n = 0; n < queries.size(); ++n) {
        if (k == 1) {
          found[n] = cloud.nearest(queries[n]);
        } else {
          cloud.nearest(queries[n], std::span(found).subspan(n * k, k));
        }
      }
    });
    turns.ask(2, [&] { cloud.nearest(queries, k, found, {.threads = 1}); });
  }
  for (std::size_t i = 0; i < found.size(); ++i) requireSame(found[i].primitive == ids[i]);
  std::printf("| %s | %zu | %zu nearest | %.0f | %.0f | %.0f | %.2f |\n", name, points.size(), k,
              turns[0], turns[1], turns[2], turns[0] / turns[1]);
  std::fflush(stdout);
}

void printWithin(const char* name, const Points& points, const Points& queries, double radius,
                 const PointCloud<double>& cloud, const NanoflannTree& peer) {
  std::size_t theirs = 0;
  std::size_t ours = 0;
  std::vector<Neighbor<double>> found;
  Turns turns;
  for (int round = 0; round < kRounds; ++round) {
    theirs = ours = 0;
    turns.ask(0, [&] {
      for (const auto& p : queries) theirs += peer.within(p, radius);
    });
    turns.ask(1, [&] {
      for (const auto& p : queries) {
        found.clear();
        cloud.within(p, radius, [&](const Neighbor<double>& neighbor) {
          found.push_back(neighbor);
          return true;
        });
        ours += found.size();
      }
    });
    turns.ask(2, [&] { static_cast<void>(cloud.within(queries, radius, {.threads = 1})); });
  }
  requireSame(theirs == ours);
  std::printf("| %s | %zu | radius, %.0f found | %.0f | %.0f | %.0f | %.2f |\n", name,
              points.size(), static_cast<double>(ours) / kQueries, turns[0], turns[1], turns[2],
              turns[0] / turns[1]);
  std::fflush(stdout);
}

void printClouds(int most) {
  std::printf(
      "| points | number | asked | nanoflann ns | PointCloud ns | in a batch | ratio |\n"
      "|---|---:|---|---:|---:|---:|---:|\n");
  for (const bool areOnSphere : {false, true}) {
    for (int count = 10'000; count <= most; count *= 10) {
      const auto points = randomPoints(count, areOnSphere, 1);
      const auto queries = randomPoints(kQueries, areOnSphere, 2);
      const auto* const name = areOnSphere ? "on a sphere" : "in a cube";
      const PointCloud<double> cloud(points);
      const NanoflannTree peer(points);
      for (const std::size_t k : {1, 8}) printNearest(name, points, queries, k, cloud, peer);
      // About 30 of them.
      const double radius =
          areOnSphere ? 2 * std::sqrt(30.0 / count) : 2 * std::cbrt(30.0 / count / 4.2);
      printWithin(name, points, queries, radius, cloud, peer);
    }
  }
}

#else

void printClouds(int) {
  std::printf("nanoflann was not found.\n");
}

#endif

/// Balls of radius 0.45 spacings on a cubic grid, shaken by up to 0.05 spacings; in [-1, 1]^3.
std::vector<Ball<double>> packedBalls(int n) {
  const double spacing = 2.0 / n;
  test::RandomPoints<double> random(0.05 * spacing, 3);
  std::vector<Ball<double>> balls;
  for (int i = 0; i < n * n * n; ++i) {
    const auto cell = [&](int index) { return (index % n + 0.5) * spacing - 1; };
    const Vec3<double> center{cell(i), cell(i / n), cell(i / n / n)};
    balls.push_back({center + random.next(), 0.45 * spacing});
  }
  return balls;
}

std::size_t allocatedBytes() {
  const auto heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

/// Bytes that are kept of what is built.
template <typename Build>
std::size_t bytesOf(const Build& build) {
  const auto before = allocatedBytes();
  build();
  return allocatedBytes() - before;
}

void printBeds(int most) {
  std::printf(
      "\n| balls | union of Spheres ns | PackedBed ns | in a batch | ratio | built in s | bytes "
      "per "
      "ball | the same, union of Spheres |\n"
      "|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const int n : {22, 46, 100}) {
    if (n * n * n > most) return;
    const auto balls = packedBalls(n);
    std::optional<Solid<double>> whole;
    const auto unionBytes = bytesOf([&] {
      std::vector<Solid<double>> spheres;
      for (const auto& [center, radius] : balls) spheres.push_back(Sphere<double>(center, radius));
      whole = unionOf(spheres);
    });
    std::optional<PackedBed<double>> bed;
    double building = 0;
    const auto bytes = bytesOf([&] { building = processorSecondsOf([&] { bed.emplace(balls); }); });
    const auto queries = randomPoints(kQueries, false, 2);
    std::vector<double> theirs(queries.size());
    std::vector<double> ours(queries.size());
    std::vector<double> together(queries.size());
    Turns turns;
    for (int round = 0; round < kRounds; ++round) {
      turns.ask(0, [&] {
        for (std::size_t i = 0; i < queries.size(); ++i)
          theirs[i] = whole->signedDistance(queries[i]);
      });
      turns.ask(1, [&] {
        for (std::size_t i = 0; i < queries.size(); ++i) ours[i] = bed->signedDistance(queries[i]);
      });
      turns.ask(2, [&] { bed->signedDistances(queries, together, {.threads = 1}); });
    }
    if (ours != theirs || together != ours) throw std::logic_error("the beds differ");
    std::printf("| %zu | %.0f | %.0f | %.0f | %.2f | %.2f | %zu | %zu |\n", balls.size(), turns[0],
                turns[1], turns[2], turns[0] / turns[1], building, bytes / balls.size(),
                unionBytes / balls.size());
    std::fflush(stdout);
  }
}

void printVolumes() {
  std::printf(
      "\n| fraction | cells classified | s | error of the lower bound | of the upper bound | of "
      "the "
      "estimate |\n"
      "|---:|---:|---:|---:|---:|---:|\n");
  const Sphere<double> ball({0.1, 0, 0}, 0.7);
  const Box<double> box{{-1.31, -1.22, -1.24}, {1.13, 1.27, 1.6}};
  const double exact = 4 * std::numbers::pi / 3 * 0.343;
  for (const double fraction : {0.1, 0.03, 0.01, 0.003, 0.001}) {
    VolumeBounds found;
    double best = Box<double>::kInf;
    for (int round = 0; round < kRounds; ++round) {
      best = std::min(best, processorSecondsOf([&] {
                        found = solidVolume(ball, box, {.fraction = fraction, .threads = 1});
                      }));
    }
    std::printf("| %g | %zu | %.4f | %.5f | %.5f | %.7f |\n", fraction, found.cells, best,
                found.volume.lower - exact, found.volume.upper - exact, found.estimate - exact);
    std::fflush(stdout);
  }
}

}  // namespace

}  // namespace cutwater::benchmarks

int main(int count, char** arguments) try {
  const int most = count > 1 ? std::atoi(arguments[1]) : 1'000'000;
  cutwater::benchmarks::printClouds(most);
  cutwater::benchmarks::printBeds(most);
  cutwater::benchmarks::printVolumes();
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "cutwater_point_benchmark: %s\n", error.what());
  return 1;
}
