#pragma once

#include <Cutwater/Grid/Octree.hpp>

#include <vector>

namespace cutwater {

/// How large an Octree will be, before it is built: see estimate().
class OctreeEstimate {
 public:
  /// `nodes`: cells of each level, also those that are divided, as the rules alone ask for.
  /// `balance[n]`: how many times as many a balanced mesh has, n levels above its finest; the last
  /// is also that of levels further above. `seconds`: of building a mesh of all these levels.
  /// `counted[n]`: cells of the mesh if no rule goes beyond level n, where they have been counted.
  OctreeEstimate(std::vector<double> nodes, std::vector<double> balance, double seconds,
                 std::vector<double> counted = {});

  /// The finest level that the rules reach.
  [[nodiscard]] int deepest() const { return static_cast<int>(nodes_.size()) - 1; }
  /// Number of cells.
  [[nodiscard]] double cells() const { return cells(deepest()); }
  /// The same if no rule went beyond this level.
  [[nodiscard]] double cells(int finest) const;
  /// Number of cells of a level that the rules divide; 0 on the finest.
  [[nodiscard]] double divided(int level) const;
  /// The finest level, for all rules, at which there are no more cells than this. -1 if the roots
  /// are more.
  [[nodiscard]] int finestWithin(double cells) const;

  /// The most memory that building takes at a time, with the mesh itself, in bytes.
  [[nodiscard]] double bytes() const { return cells() * kBytesPerCell; }
  /// Wall time of building the mesh, with the number of threads that the estimate was made with.
  [[nodiscard]] double seconds() const { return seconds_; }

  /// Of memory at the peak of building, in bytes, as measured: see Docs/amr.md.
  static constexpr double kBytesPerCell = 50;

 private:
  [[nodiscard]] double cellsByFactors(int finest) const;

  std::vector<double> nodes_;
  std::vector<double> balance_;
  double seconds_;
  std::vector<double> counted_;
};

/// Estimates the size of Octree(solid, domain, refinement, options) in about a second. The coarse
/// levels are divided in full, until one has some ten thousand cells; of each level below, the
/// rules are applied to an even sample of a few thousand cells, which tells how many of all are
/// divided. A surface has about four times as many cells on each level, a band eight times.
/// What balancing adds is taken from small parts of the mesh, of its four finest levels.
///
/// A mesh of coarse levels alone is counted exactly. Otherwise numbers of cells were within 13 % on
/// the surfaces of Docs/amr.md for rules on cells that are cut, on bands and on curvature; where
/// rules refine few cells, such as those on edges and gaps, samples miss up to a third.
/// @throws Error as Octree, but for `maxCells`, which is ignored.
template <std::floating_point T>
[[nodiscard]] OctreeEstimate estimate(const SignedDistanceFunction<T>& solid,
                                      const OctreeDomain<T>& domain,
                                      const Refinement<T>& refinement,
                                      const OctreeOptions& options = {});

extern template OctreeEstimate estimate(const SignedDistanceFunction<float>&,
                                        const OctreeDomain<float>&, const Refinement<float>&,
                                        const OctreeOptions&);
extern template OctreeEstimate estimate(const SignedDistanceFunction<double>&,
                                        const OctreeDomain<double>&, const Refinement<double>&,
                                        const OctreeOptions&);

}  // namespace cutwater
