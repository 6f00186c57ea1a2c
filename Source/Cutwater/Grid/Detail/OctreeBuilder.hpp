#pragma once

#include <Cutwater/Grid/Detail/CellTagger.hpp>
#include <Cutwater/Grid/Detail/OctreeBalance.hpp>

namespace cutwater::detail {

/// @throws Error if the domain has no level as deep as this.
template <std::floating_point T>
void requireLevel(const OctreeDomain<T>& domain, int deepest);

/// @throws Error(Limit) for more cells than `most`. `level`: the finest that is counted.
void requireCells(double cells, int level, std::size_t most);

/// Codes of the roots, in order.
template <std::floating_point T>
[[nodiscard]] OctreeCodes rootCodes(const OctreeDomain<T>& domain);

/// Finds the leaves of an octree mesh.
template <std::floating_point T>
class OctreeBuilder {
 public:
  /// All must outlive it.
  OctreeBuilder(const CellTagger<T>& tagger, const OctreeDomain<T>& domain,
                const OctreeOptions& options)
      : tagger_(tagger), domain_(domain), options_(options) {}

  /// Returns the leaves in the order of their codes, none finer than level `deepest`.
  [[nodiscard]] std::vector<OctreeCell> run(int deepest);

 private:
  /// Cells of a level in order, with their tags.
  struct Cells {
    OctreeCodes codes;
    std::vector<CellTag> tags;
  };
  struct Leaf {
    MortonCode place;  // code of its first cell on the finest level
    OctreeCell cell;
  };

  /// Divides the cells that the rules alone ask for, level by level.
  void divide();
  /// `parents`: hints, one for every eight cells, or none. Returns the hints for the cells'
  /// children.
  std::vector<BoxHint> tagCells(int level, Cells& cells, std::span<const BoxHint> parents,
                                const Progress& progress) const;
  [[nodiscard]] Progress progressOf(int level) const;
  /// The leaves if no more cells are divided than those known so far, and `more`.
  void requireFew(std::size_t more, int level) const;

  /// All cells of a level, divided or not.
  [[nodiscard]] Cells cellsOf(int level) const;
  void collect(std::vector<Leaf>& leaves, int level, const Cells& cells) const;

  const CellTagger<T>& tagger_;
  const OctreeDomain<T>& domain_;
  const OctreeOptions& options_;
  int deepest_ = 0;
  std::vector<Cells> found_;          // by the rules
  std::vector<OctreeCodes> divided_;  // cells of each level
};

extern template void requireLevel(const OctreeDomain<float>&, int);
extern template void requireLevel(const OctreeDomain<double>&, int);
extern template OctreeCodes rootCodes(const OctreeDomain<float>&);
extern template OctreeCodes rootCodes(const OctreeDomain<double>&);
extern template class OctreeBuilder<float>;
extern template class OctreeBuilder<double>;

}  // namespace cutwater::detail
