#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Sdf/SurfacePoint.hpp>

#include <vector>

namespace cutwater::detail {

/// The sides on which facets face each other.
enum class Facing : std::uint8_t {
  Fronts,  ///< with a gap between them
  Backs,   ///< with a wall between them
};

/// A binary tree of facets, with boxes around their corners and around their normals. Finds pairs
/// that face each other without visiting all of them.
template <std::floating_point T>
class FacetTree {
 public:
  using Facet = SurfaceFacet<T>;

  /// Removes all facets, but keeps the memory. Normals of facets must not be zero.
  void clear() { facets_.clear(); }
  void add(const Facet& facet) { facets_.push_back(facet); }
  /// To be called once the last facet has been added.
  void build();
  [[nodiscard]] bool empty() const { return facets_.empty(); }

  /// Whether one of these facets faces, within 60 degrees, one of the others that matters, with the
  /// two at least `least` apart somewhere. Calls `mayMatter(box)` for boxes around others and
  /// `matters(facet)` for those that face one of these, until it returns true.
  template <typename MayMatter, typename Matters>
  [[nodiscard]] bool isFaced(const FacetTree& others, Facing facing, T least,
                             const MayMatter& mayMatter, const Matters& matters) const {
    if (empty() || others.empty()) return false;
    const T side = facing == Facing::Fronts ? T(1) : T(-1);
    return Search<MayMatter, Matters>{*this, others, side, least, mayMatter, matters}.run(0, 0);
  }

 private:
  static constexpr std::size_t kLeaf = 4;
  /// Cosine of the angle between normals of facets that face each other.
  static constexpr T kFacing = T(-0.5);

  struct Node {
    Box<T> corners;
    Box<T> normals;
    std::size_t begin = 0;  // range of its facets
    std::size_t end = 0;
    std::size_t upper = 0;  // its second child (the first one follows it); 0 for a leaf
  };

  /// Recursive traversal of pairs of nodes.
  template <typename MayMatter, typename Matters>
  struct Search {
    const FacetTree& own;
    const FacetTree& others;
    T side;
    T least;
    const MayMatter& mayMatter;
    const Matters& matters;

    [[nodiscard]] bool run(std::size_t mine, std::size_t other) const {
      const auto& a = own.nodes_[mine];
      const auto& b = others.nodes_[other];
      if (!mayFace(a, b, side, least) || !mayMatter(b.corners)) return false;
      if (a.upper == 0 && b.upper == 0) return compare(a, b);
      if (b.upper == 0 || (a.upper != 0 && a.end - a.begin > b.end - b.begin)) {
        return run(mine + 1, other) || run(a.upper, other);
      }
      return run(mine, other + 1) || run(mine, b.upper);
    }
    [[nodiscard]] bool compare(const Node& a, const Node& b) const {
      for (auto i = a.begin; i < a.end; ++i) {
        for (auto k = b.begin; k < b.end; ++k) {
          const auto& facet = others.facets_[k];
          if (face(own.facets_[i], facet, side, least) && matters(facet)) return true;
        }
      }
      return false;
    }
  };

  std::size_t divide(std::size_t begin, std::size_t end);
  /// Certainly true if any of their facets face each other.
  [[nodiscard]] static bool mayFace(const Node& a, const Node& b, T side, T least);
  [[nodiscard]] static bool face(const Facet& a, const Facet& b, T side, T least);

  std::vector<Facet> facets_;
  std::vector<Node> nodes_;
};

extern template class FacetTree<float>;
extern template class FacetTree<double>;

}  // namespace cutwater::detail
