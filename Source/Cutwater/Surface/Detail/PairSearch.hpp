#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Surface/Detail/CrowdSplits.hpp>
#include <Cutwater/Surface/Detail/LeafBoxes.hpp>
#include <Cutwater/Surface/Detail/PairTest.hpp>
#include <Cutwater/Triangles/Search/TriangleTree.hpp>

#include <atomic>

namespace cutwater {

/// Receives the pairs of triangles that meet.
struct PairVisitor {
  /// Only pairs whose lower triangle is at most this one are wanted; may fall during the search.
  const std::atomic<std::uint32_t>& lastWanted;
  /// Takes a pair, the lower first, and returns whether to continue.
  FunctionRef<bool(std::uint32_t first, std::uint32_t second)> take;

  [[nodiscard]] bool wants(std::uint32_t first) const {
    return first <= lastWanted.load(std::memory_order_relaxed);
  }
};

/// The search for pairs of triangles that meet, divided into tasks that threads may run in any
/// order. Every pair is found by exactly one of them. Where few triangles have changed, see
/// PairTest, the others look for these alone.
///
/// Leaves of a tree are compared with the leaves around them. Those that have very many around them
/// are crowded: comparing their triangles would take the square of their number. Pairs of triangles
/// from crowded leaves are left to split().
class PairSearch {
 public:
  /// Of the tree, only the grouping of triangles is used. Both must outlive this object.
  PairSearch(const PairTest& pairs, const TriangleTree& tree, int threads);

  [[nodiscard]] std::size_t tasks() const { return ranges() + crowds_.size(); }
  /// Tasks from this one on are those of crowds. Those before find all pairs with a triangle that
  /// is in no crowded leaf.
  [[nodiscard]] std::size_t ranges() const { return surroundings_.size(); }
  [[nodiscard]] bool isCrowded(std::uint32_t leaf) const { return isCrowded_[leaf] != 0; }
  /// Returns false if the visitor ended it.
  bool run(std::size_t task, const PairVisitor& visitor) const;

 private:
  static constexpr std::size_t kLeavesPerRange = 32;

  using SlotBoxes = std::array<Box<double>, LeafBoxes::kWidth>;

  /// The leaves around those of a range.
  struct Surroundings {
    std::vector<std::uint32_t> leaves;
    std::array<std::uint32_t, kLeavesPerRange> ends{};  ///< per leaf of the range
  };

  [[nodiscard]] std::span<const std::uint32_t> slots(std::uint32_t leaf) const {
    return tree_.leaf(leaf);
  }
  void fitLeaves(std::size_t range);
  void lookAround(std::size_t range);
  /// Fits boxes to the nodes of the tree, whose own may be turned, from those of the leaves that
  /// `counts`.
  template <typename Counts>
  [[nodiscard]] std::vector<LeafBoxes> fittedNodes(Counts&& counts) const;
  /// Appends the leaves whose box meets that of the given one, if that has not changed only those
  /// that have; false if there are too many.
  [[nodiscard]] bool addAround(std::uint32_t leaf, std::vector<std::uint32_t>& leaves) const;
  void gatherCrowds();
  [[nodiscard]] bool hasChanged(const Crowd& crowd) const;
  // These return false if the visitor ended the search.
  bool decideWithin(std::uint32_t leaf, const SlotBoxes& boxes, const PairVisitor& visitor) const;
  bool decideBetween(std::uint32_t leaf, const SlotBoxes& boxes, std::uint32_t other,
                     const PairVisitor& visitor) const;
  bool decideCrowd(const Crowd& crowd, const PairVisitor& visitor) const;
  /// Every pair by itself.
  bool decideEach(const Crowd& crowd, const PairVisitor& visitor) const;
  /// The pairs of one triangle with those of `others` that have a bit in `lanes`.
  bool decide(std::uint32_t t, std::span<const std::uint32_t> others, std::uint32_t lanes,
              const PairVisitor& visitor) const;

  const PairTest& pairs_;
  const TriangleTree& tree_;
  std::vector<LeafBoxes> boxes_;            ///< per leaf
  std::vector<std::uint8_t> isChanged_;     ///< per leaf: whether it has a triangle that has
  std::vector<LeafBoxes> childBoxes_;       ///< per node
  std::vector<LeafBoxes> changedBoxes_;     ///< per node, of leaves that have changed; none if all
  std::vector<Surroundings> surroundings_;  ///< per range
  std::vector<std::uint8_t> isCrowded_;     ///< per leaf
  std::vector<Crowd> crowds_;
};

}  // namespace cutwater
