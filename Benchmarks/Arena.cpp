#include "Arena.hpp"

#include <algorithm>
#include <stdexcept>

#include "Meshes.hpp"

namespace cutwater::benchmarks {

Arena::Arena(std::string surface, const Settings& settings, Report& report)
    : name_(std::move(surface)),
      settings_(settings),
      report_(report),
      soup_(loadSurface(name_, settings.data)),
      diagonal_(soup_.boundingBox().diagonal()) {
  for (const auto& p : soup_.points) farthest_ = std::max(farthest_, length(p));
  report_.surfaces[name_].triangles = soup_.polygonCount();
}

const MeshSDF<double>& Arena::ours() {
  if (!ours_) {
    ours_.emplace(soup_);
    report_.surfaces[name_].memoryBytes = ours_->memoryBytes();
    report_.surfaces[name_].signs = ours_->signReport().summary();
  }
  return *ours_;
}

const Peer& Arena::peer(const std::string& name) {
  auto& built = peers_[name];
  if (built) return *built;
  for (const auto& kind : peers()) {
    if (kind.name == name) built = kind.build(soup_, availableThreads());
  }
  if (!built) throw std::out_of_range("no peer " + name);
  return *built;
}

void Arena::ask(const std::string& contestant, std::span<const Vec3<double>> points,
                std::span<double> distances, int threads) {
  const ParallelOptions options{.threads = threads, .grain = 1000};
  if (contestant == kOurs) {
    const auto& solid = ours();
    parallelFor(points.size(), options, [&](std::size_t begin, std::size_t end) {
      for (auto i = begin; i < end; ++i) distances[i] = solid.signedDistance(points[i]);
    });
    return;
  }
  const auto& other = peer(contestant);
  parallelFor(points.size(), options, [&](std::size_t begin, std::size_t end) {
    other.signedDistances(points.subspan(begin, end - begin),
                          distances.subspan(begin, end - begin));
  });
}

bool Arena::isSimple() {
  const auto& signs = ours().signReport();
  return signs.isClosed() && signs.isSound();
}

void Arena::check(const std::string& workload, const std::string& contestant,
                  const std::string& truth, Comparison comparison) {
  comparison.diagonal = diagonal_;
  if (!comparison.tolerance && contestant == kOurs) {
    comparison.tolerance = [this](const Vec3<double>& p) {
      return 8 * std::numeric_limits<double>::epsilon() * (length(p) + farthest_);
    };
  } else if (!comparison.tolerance) {
    comparison.tolerance = [this](const Vec3<double>&) { return 1e-9 * diagonal_; };
  }
  comparison.withSigns = comparison.withSigns && (contestant == kOurs || isSimple());
  Check check{.surface = name_, .workload = workload, .contestant = contestant, .truth = truth};
  compare(comparison, check);
  report_.checks.push_back(check);
}

void Arena::checkAgainst(const std::string& peer, const std::string& workload,
                         Comparison comparison) {
  std::vector<double> truth(comparison.points.size());
  ask(peer, comparison.points, truth, 0);
  comparison.truth = truth;
  comparison.tolerance = [this](const Vec3<double>&) { return 1e-9 * diagonal_; };
  comparison.withSigns = isSimple();
  check(workload, kOurs, peer, comparison);
}

void Arena::count(const std::string& workload, std::span<const Vec3<double>> points,
                  std::span<double> distances) {
  if (!counted_) {
    counted_.emplace(soup_);
    report_.surfaces[name_].leafNanoseconds = leafFetchNanoseconds(ours().memoryBytes());
  }
  report_.efforts[{name_, workload}] = counted_->ask(points, distances);
}

}  // namespace cutwater::benchmarks
