#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/P4est/Agreement.hpp>
#include <Cutwater/P4est/Detail/ForestBuilder.hpp>
#include <Cutwater/P4est/Detail/GhostLeaves.hpp>
#include <Cutwater/P4est/Detail/OwnLeaves.hpp>

namespace cutwater {

namespace {

template <std::floating_point T>
void check(const OctreeDomain<T>& domain, int deepest, const DistributedOctreeOptions& options) {
  constexpr std::int64_t kMostRoots = std::int64_t{1} << 24U;
  const auto& n = domain.roots();
  require(std::int64_t{n.i} * n.j * n.k <= kMostRoots, "DistributedOctree: need at most 2^24 roots",
          Named{"along x", n.i}, Named{"along y", n.j}, Named{"along z", n.k});
  const int finest = std::min(domain.deepest(), P8EST_QMAXLEVEL);
  require(deepest <= finest, "DistributedOctree: need fewer levels", Named{"level", deepest},
          Named{"finest possible", finest});
  require(1 <= options.cutWeight && options.cutWeight <= 1000,
          "DistributedOctree: need a weight from 1 to 1000", Named{"cutWeight", options.cutWeight});
  require(options.threads >= 0, "DistributedOctree: need threads >= 0",
          Named{"threads", options.threads});
}

/// Bytes of numbers, for a checksum.
class Bytes {
 public:
  template <typename... Numbers>
  Bytes& add(const Numbers&... numbers) {
    (append(std::as_bytes(std::span(&numbers, 1))), ...);
    return *this;
  }
  template <std::floating_point T>
  Bytes& add(const Vec3<T>& p) {
    return add(p.x, p.y, p.z);
  }
  [[nodiscard]] std::uint64_t checksum() const { return xxHash64(bytes_); }

 private:
  void append(std::span<const std::byte> some) {
    bytes_.insert(bytes_.end(), some.begin(), some.end());
  }

  std::vector<std::byte> bytes_;
};

template <std::floating_point T>
std::uint64_t checksumOf(const Refinement<T>& rules) {
  Bytes bytes;
  bytes.add(rules.cut, rules.bands.size(), rules.patches.size());
  for (const auto& [distance, level] : rules.bands) bytes.add(distance, level);
  for (const auto& [patch, level] : rules.patches) bytes.add(patch, level);
  for (const auto& rule : {rules.curvature, rules.edges}) {
    bytes.add(rule.has_value());
    if (rule) bytes.add(rule->degrees, rule->level);
  }
  for (const auto& rule : {rules.gaps, rules.walls}) {
    bytes.add(rule.has_value());
    if (rule) bytes.add(rule->cells, rule->level);
  }
  return bytes.checksum();
}

/// Ranks that divide cells by different rules would wait for one another without end.
template <std::floating_point T>
void requireSameArguments(const SignedDistanceFunction<T>& solid, const OctreeDomain<T>& domain,
                          const Refinement<T>& rules, MPI_Comm comm,
                          const DistributedOctreeOptions& options) {
  const std::string begin = "DistributedOctree: the ranks have different ";
  const auto& n = domain.roots();
  const auto box = solid.boundingBox();
  requireSame(comm, Bytes().add(domain.origin()).add(domain.spacing(), n.i, n.j, n.k).checksum(),
              begin + "domains");
  requireSame(comm, checksumOf(rules), begin + "refinements");
  requireSame(comm, Bytes().add(options.balance, options.cutWeight, options.maxCells).checksum(),
              begin + "options");
  requireSame(comm, Bytes().add(box.lower).add(box.upper).checksum(), begin + "solids");
}

}  // namespace

template <std::floating_point T>
DistributedOctree<T>::DistributedOctree(const SignedDistanceFunction<T>& solid,
                                        const OctreeDomain<T>& domain,
                                        const Refinement<T>& refinement, MPI_Comm comm,
                                        const DistributedOctreeOptions& options)
    : comm_(comm), balance_(options.balance) {
  requireSameArguments(solid, domain, refinement, comm, options);
  std::optional<detail::CellTagger<T>> tagger;
  const int deepest = refinement.deepest();
  agreed(comm, [&] {
    tagger.emplace(solid, refinement);
    check(domain, deepest, options);
  });
  detail::ForestBuilder<T> builder(*tagger, domain, options);
  forest_ = builder.run(comm, deepest);
  agreed(comm, [&] { local_.emplace(domain, deepest, builder.takeCells()); });
  forest_->user_pointer = nullptr;
  firstNumber_ = static_cast<std::uint64_t>(forest_->global_first_quadrant[forest_->mpirank]);
  cellCount_ = static_cast<std::uint64_t>(forest_->global_num_quadrants);
}

template <std::floating_point T>
std::uint64_t DistributedOctree<T>::checksum(const OctreeTargets<T>& values) const {
  std::uint64_t sum = 0;
  agreed(comm_, [&] { sum = cutwater::checksum(local(), values); });
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_UINT64_T, MPI_SUM, comm_);
  return sum;
}

template <std::floating_point T>
DistributedCut DistributedOctree<T>::cut(const CellCutter& cutter,
                                         const CutOptions& options) const {
  require(balance_ != Balance::None, "DistributedOctree: cut() needs a balanced mesh");
  const auto leaves = detail::leavesWithGhosts(*forest_, balance_, local().cells());
  DistributedCut result;
  agreed(comm_, [&] {
    const OctreeCells<T> part(local().domain(), local().deepest(), leaves.cells);
    std::vector<double> volumes;
    for (const auto& [index, level, kind] : local().cells()) {
      const auto grid = local().domain().level(level);
      const Index3 next{index.i + 1, index.j + 1, index.k + 1};
      const auto size = Vec3<double>(grid.cell(next).lower) - Vec3<double>(grid.cell(index).lower);
      volumes.push_back(size.x * size.y * size.z);
    }
    result = detail::ownLeaves(cutter.cut(part, options), leaves.firstOwn, volumes, leaves.numbers);
  });
  return result;
}

template <std::floating_point T>
std::uint32_t DistributedOctree<T>::forestChecksum() const {
  std::uint32_t result = p8est_checksum(forest_.get());  // on rank 0
  MPI_Bcast(&result, 1, MPI_UINT32_T, 0, comm_);
  return result;
}

template class DistributedOctree<float>;
template class DistributedOctree<double>;

}  // namespace cutwater
