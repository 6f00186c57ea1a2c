// Private: not installed, for it includes p8est.h.
#pragma once

#include <Cutwater/P4est/DistributedOctree.hpp>

#include <p8est.h>

namespace cutwater::detail {

/// Makes p4est's forest, and knows what its quadrants are.
template <std::floating_point T>
class ForestBuilder {
 public:
  /// All must outlive it.
  ForestBuilder(const CellJudge<T>& judge, const OctreeDomain<T>& domain,
                const DistributedOctreeOptions& options)
      : judge_(judge), domain_(domain), options_(options) {}

  /// Divided, balanced and shared out. Collective.
  /// @throws Error, the same on all ranks, if the judge does on one.
  [[nodiscard]] std::shared_ptr<p8est> run(MPI_Comm comm, int deepest);
  /// This rank's, with their kinds. Then drops what was kept for each quadrant.
  [[nodiscard]] std::vector<OctreeCell> takeCells();

 private:
  /// Kept for each quadrant while the forest is made; goes with it from rank to rank.
  struct Data {
    BoxHint hint;
    CellVerdict verdict;
    bool isJudged = false;
  };
  struct Quadrants;  // of one level

  static Data& dataOf(p8est_quadrant_t& quadrant) {
    return *static_cast<Data*>(quadrant.p.user_data);
  }
  // What p4est calls.
  static void begin(p8est_t* forest, p4est_topidx_t tree, p8est_quadrant_t* quadrant);
  static void divide(p8est_t* forest, p4est_topidx_t tree, int parentCount,
                     p8est_quadrant_t** parents, int childCount, p8est_quadrant_t** children);
  static int isRefined(p8est_t* forest, p4est_topidx_t tree, p8est_quadrant_t* quadrant);
  static int weightToJudge(p8est_t* forest, p4est_topidx_t tree, p8est_quadrant_t* quadrant);
  static int finalWeight(p8est_t* forest, p4est_topidx_t tree, p8est_quadrant_t* quadrant);

  template <typename Visit>
  void forQuadrants(const Visit& visit) const;
  [[nodiscard]] Index3 rootOf(p4est_topidx_t tree) const;
  /// Judges those of this rank that have not been judged.
  void judgeNew(int deepest);
  void judge(int level, Quadrants& quadrants);
  void balance();

  const CellJudge<T>& judge_;
  const OctreeDomain<T>& domain_;
  const DistributedOctreeOptions& options_;
  std::shared_ptr<p8est> forest_;
};

extern template class ForestBuilder<float>;
extern template class ForestBuilder<double>;

}  // namespace cutwater::detail
