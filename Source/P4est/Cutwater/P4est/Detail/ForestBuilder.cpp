#include <Cutwater/Grid/Detail/OctreeBuilder.hpp>
#include <Cutwater/P4est/Agreement.hpp>
#include <Cutwater/P4est/Detail/ForestBuilder.hpp>
#include <Cutwater/P4est/Detail/GhostLeaves.hpp>

#include <p8est_bits.h>
#include <p8est_extended.h>

namespace cutwater::detail {

namespace {

/// The cost of a cell that is yet to be tagged, relative to one that is only stored.
constexpr int kWeightUntilTagged = 16;

/// p4est logs to stdout, unless the program has configured it otherwise. Messages before it aborts
/// (as when out of memory) still go there.
void silenceUnlessInitialised() {
  if (sc_package_id < 0 && p4est_package_id < 0) {
    sc_set_log_defaults(nullptr, nullptr, SC_LP_ERROR);
  }
}

void destroy(p8est_t* forest) {
  auto* connectivity = forest->connectivity;
  p8est_destroy(forest);
  p8est_connectivity_destroy(connectivity);
}

}  // namespace

template <std::floating_point T>
struct ForestBuilder<T>::Quadrants {
  std::vector<p8est_quadrant_t*> list;
  std::vector<MortonCode> codes;
};

template <std::floating_point T>
std::shared_ptr<p8est> ForestBuilder<T>::run(MPI_Comm comm, int deepest) {
  silenceUnlessInitialised();
  const auto& n = domain_.roots();
  auto* roots = p8est_connectivity_new_brick(n.i, n.j, n.k, 0, 0, 0);
  forest_ = {p8est_new_ext(comm, roots, 0, 0, 1, sizeof(Data), begin, this), destroy};
  for (int level = 0;; ++level) {
    agreed(comm, [&] { tagNew(deepest); });
    if (level == deepest) break;
    requireFew(level + 1);
    const auto count = forest_->global_num_quadrants;
    p8est_refine_ext(forest_.get(), 0, deepest, isRefined, begin, divide);
    if (forest_->global_num_quadrants == count) break;
    p8est_partition(forest_.get(), 0, weightUntilTagged);
  }
  balance();
  requireCells(static_cast<double>(forest_->global_num_quadrants), deepest, options_.maxCells);
  agreed(comm, [&] { tagNew(deepest); });
  p8est_partition(forest_.get(), 0, finalWeight);
  return forest_;
}

template <std::floating_point T>
void ForestBuilder<T>::requireFew(int level) const {
  std::uint64_t divided = 0;
  forQuadrants([&](p8est_quadrant_t& quadrant, const Index3& /*root*/) {
    divided += dataOf(quadrant).tag.isRefined ? 1 : 0;
  });
  MPI_Allreduce(MPI_IN_PLACE, &divided, 1, MPI_UINT64_T, MPI_SUM, forest_->mpicomm);
  const auto now = static_cast<double>(forest_->global_num_quadrants);
  requireCells(now + 7 * static_cast<double>(divided), level, options_.maxCells);
}

template <std::floating_point T>
void ForestBuilder<T>::balance() {
  if (options_.balance == Balance::None) return;
  const auto across = options_.balance == Balance::Face   ? P8EST_CONNECT_FACE
                      : options_.balance == Balance::Edge ? P8EST_CONNECT_EDGE
                                                          : P8EST_CONNECT_CORNER;
  p8est_balance_ext(forest_.get(), across, begin, divide);
}

template <std::floating_point T>
void ForestBuilder<T>::begin(p8est_t* /*forest*/, p4est_topidx_t /*tree*/,
                             p8est_quadrant_t* quadrant) {
  dataOf(*quadrant) = {};
}

template <std::floating_point T>
void ForestBuilder<T>::divide(p8est_t* /*forest*/, p4est_topidx_t /*tree*/, int /*parentCount*/,
                              p8est_quadrant_t** parents, int childCount,
                              p8est_quadrant_t** children) {
  for (int n = 0; n < childCount; ++n) {
    dataOf(*children[n]) = {.hint = dataOf(*parents[0]).hint, .tag = {}};
  }
}

template <std::floating_point T>
int ForestBuilder<T>::isRefined(p8est_t* /*forest*/, p4est_topidx_t /*tree*/,
                                p8est_quadrant_t* quadrant) {
  return dataOf(*quadrant).tag.isRefined ? 1 : 0;
}

template <std::floating_point T>
int ForestBuilder<T>::weightUntilTagged(p8est_t* /*forest*/, p4est_topidx_t /*tree*/,
                                        p8est_quadrant_t* quadrant) {
  return dataOf(*quadrant).isTagged ? 1 : kWeightUntilTagged;
}

template <std::floating_point T>
int ForestBuilder<T>::finalWeight(p8est_t* forest, p4est_topidx_t /*tree*/,
                                  p8est_quadrant_t* quadrant) {
  const auto& builder = *static_cast<const ForestBuilder*>(forest->user_pointer);
  return mayBeCut(dataOf(*quadrant).tag.kind) ? builder.options_.cutWeight : 1;
}

template <std::floating_point T>
template <typename Visit>
void ForestBuilder<T>::forQuadrants(const Visit& visit) const {
  for (auto tree = forest_->first_local_tree; tree <= forest_->last_local_tree; ++tree) {
    const auto root = rootOf(*forest_, tree);
    auto& quadrants = p8est_tree_array_index(forest_->trees, tree)->quadrants;
    for (std::size_t n = 0; n < quadrants.elem_count; ++n) {
      visit(*p8est_quadrant_array_index(&quadrants, n), root);
    }
  }
}

template <std::floating_point T>
void ForestBuilder<T>::tagNew(int deepest) {
  std::vector<Quadrants> found(static_cast<std::size_t>(deepest) + 1);
  forQuadrants([&](p8est_quadrant_t& quadrant, const Index3& root) {
    if (dataOf(quadrant).isTagged) return;
    auto& [list, codes] = found[static_cast<unsigned char>(quadrant.level)];
    list.push_back(&quadrant);
    codes.push_back(mortonCode(indexIn(root, quadrant)));
  });
  for (int level = 0; level <= deepest; ++level)
    tagQuadrants(level, found[static_cast<std::size_t>(level)]);
}

template <std::floating_point T>
void ForestBuilder<T>::tagQuadrants(int level, Quadrants& quadrants) {
  std::vector<CellTag> tags(quadrants.list.size());
  const auto data = [&](std::size_t n) -> Data& { return dataOf(*quadrants.list[n]); };
  const auto before = [&](std::size_t first, std::span<BoxHint> hints) {
    for (std::size_t i = 0; i < hints.size(); ++i) hints[i] = data(first + i).hint;
  };
  const auto after = [&](std::size_t first, std::span<const BoxHint> hints) {
    for (std::size_t i = 0; i < hints.size(); ++i) data(first + i).hint = hints[i];
  };
  tagger_.tag({.level = level,
               .grid = domain_.level(level),
               .codes = quadrants.codes,
               .hintsBefore = before,
               .hintsAfter = after},
              tags, {.threads = options_.threads});
  for (std::size_t n = 0; n < tags.size(); ++n) {
    data(n).tag = tags[n];
    data(n).isTagged = true;
  }
}

template <std::floating_point T>
std::vector<OctreeCell> ForestBuilder<T>::takeCells() {
  std::vector<OctreeCell> cells;
  cells.reserve(static_cast<std::size_t>(forest_->local_num_quadrants));
  forQuadrants([&](p8est_quadrant_t& quadrant, const Index3& root) {
    cells.push_back({indexIn(root, quadrant), static_cast<std::uint8_t>(quadrant.level),
                     dataOf(quadrant).tag.kind});
  });
  p8est_reset_data(forest_.get(), 0, nullptr, nullptr);
  return cells;
}

template class ForestBuilder<float>;
template class ForestBuilder<double>;

}  // namespace cutwater::detail
