// Includes p8est.h.
#pragma once

#include <Cutwater/Grid/Detail/CellTagger.hpp>
#include <Cutwater/P4est/DistributedOctree.hpp>

#include <p8est.h>

namespace cutwater::detail {

/// Builds p4est's forest, and gives its quadrants' meaning as cells.
template <std::floating_point T>
class ForestBuilder {
 public:
  /// All must outlive it.
  ForestBuilder(const CellTagger<T>& tagger, const OctreeDomain<T>& domain,
                const DistributedOctreeOptions& options)
      : tagger_(tagger), domain_(domain), options_(options) {}

  /// Returns the forest, refined, balanced and partitioned. Collective.
  /// @throws Error, the same on all ranks, if the tagger throws on one.
  [[nodiscard]] std::shared_ptr<p8est> run(MPI_Comm comm, int deepest);
  /// Returns this rank's cells, with their kinds, and drops the data kept for each quadrant.
  [[nodiscard]] std::vector<OctreeCell> takeCells();

 private:
  /// Data of a quadrant while the forest is built; moves with it from rank to rank.
  struct Data {
    BoxHint hint;
    CellTag tag;
    bool isTagged = false;
  };
  struct Quadrants;  // of one level

  static Data& dataOf(p8est_quadrant_t& quadrant) {
    return *static_cast<Data*>(quadrant.p.user_data);
  }
  // Callbacks for p4est.
  static void begin(p8est_t* forest, p4est_topidx_t tree, p8est_quadrant_t* quadrant);
  static void divide(p8est_t* forest, p4est_topidx_t tree, int parentCount,
                     p8est_quadrant_t** parents, int childCount, p8est_quadrant_t** children);
  static int isRefined(p8est_t* forest, p4est_topidx_t tree, p8est_quadrant_t* quadrant);
  static int weightUntilTagged(p8est_t* forest, p4est_topidx_t tree, p8est_quadrant_t* quadrant);
  static int finalWeight(p8est_t* forest, p4est_topidx_t tree, p8est_quadrant_t* quadrant);

  template <typename Visit>
  void forQuadrants(const Visit& visit) const;
  /// Tags this rank's quadrants that have no tag yet.
  void tagNew(int deepest);
  void tagQuadrants(int level, Quadrants& quadrants);
  void balance();
  /// @throws Error, on all ranks, if this level would make more cells than the options allow.
  void requireFew(int level) const;

  const CellTagger<T>& tagger_;
  const OctreeDomain<T>& domain_;
  const DistributedOctreeOptions& options_;
  std::shared_ptr<p8est> forest_;
};

extern template class ForestBuilder<float>;
extern template class ForestBuilder<double>;

}  // namespace cutwater::detail
