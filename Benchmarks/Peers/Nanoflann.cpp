#include "Peers/Nanoflann.hpp"

#include <nanoflann.hpp>
#include <vector>

namespace cutwater::benchmarks {

namespace {

/// By the names that nanoflann asks for.
struct Points {
  std::span<const Vec3<double>> all;

  // NOLINTBEGIN(readability-identifier-naming)
  [[nodiscard]] std::size_t kdtree_get_point_count() const { return all.size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return (&all[i].x)[axis];
  }
  template <typename Bounds>
  bool kdtree_get_bbox(Bounds&) const {
    return false;
  }
  // NOLINTEND(readability-identifier-naming)
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>,
                                                 Points, 3, std::uint32_t>;

}  // namespace

struct NanoflannTree::Index {
  explicit Index(std::span<const Vec3<double>> all) : points{all}, tree(3, points) {}

  Points points;
  Tree tree;
  std::vector<std::pair<std::uint32_t, double>> found;
};

NanoflannTree::NanoflannTree(std::span<const Vec3<double>> points)
    : index_(std::make_unique<Index>(points)) {}

NanoflannTree::~NanoflannTree() = default;

void NanoflannTree::nearest(const Vec3<double>& p, std::span<std::uint32_t> ids,
                            std::span<double> squares) const {
  index_->tree.knnSearch(&p.x, ids.size(), ids.data(), squares.data());
}

std::size_t NanoflannTree::within(const Vec3<double>& p, double radius) const {
  nanoflann::SearchParams unsorted;
  unsorted.sorted = false;
  return index_->tree.radiusSearch(&p.x, radius * radius, index_->found, unsorted);
}

}  // namespace cutwater::benchmarks
