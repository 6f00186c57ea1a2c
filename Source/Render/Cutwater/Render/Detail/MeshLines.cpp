#include <Cutwater/Render/Detail/MeshLines.hpp>

#include <algorithm>

namespace cutwater::detail {

namespace {

using Point = std::array<double, 2>;

template <std::floating_point T>
class Lines {
 public:
  Lines(const SlicePlane<T>& plane, const SliceWindow<T>& window, const PlotArea& area)
      : plane_(plane), normal_(cross(plane.right, plane.up)), window_(window), area_(area) {}

  /// Adds the cell's faces towards lower coordinates, and those upper ones whose axis has its bit
  /// set: the cells beyond add the others.
  void add(const Box<T>& cell, unsigned upperFaces) {
    unsigned above = 0;
    for (int i = 0; i < 8; ++i) {
      corners_[static_cast<std::size_t>(i)] = cell.corner(i);
      heights_[static_cast<std::size_t>(i)] = dot(normal_, cell.corner(i) - plane_.origin);
      above |= (heights_[static_cast<std::size_t>(i)] >= 0 ? 1U : 0U) << i;
    }
    if (above == 0 || above == 0xffU) return;
    for (unsigned axis = 0; axis < 3; ++axis) {
      addFace(axis, 0);
      if ((upperFaces >> axis & 1U) != 0) addFace(axis, 1U << axis);
    }
  }
  [[nodiscard]] std::vector<Stroke> take() { return std::move(strokes_); }

 private:
  void addFace(unsigned axis, unsigned side) {
    const unsigned u = 1U << (axis + 1) % 3;
    const unsigned v = 1U << (axis + 2) % 3;
    const std::array<unsigned, 4> around{side, side | u, side | u | v, side | v};
    std::array<Point, 4> ends;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto a = around[i];
      const auto b = around[(i + 1) % 4];
      if ((heights_[a] >= 0) == (heights_[b] >= 0)) continue;
      const T part = heights_[a] / (heights_[a] - heights_[b]);
      ends[count++] = onPlot(corners_[a] + part * (corners_[b] - corners_[a]));
    }
    if (count != 2) return;
    const auto line = clipped({ends[0][0], ends[0][1], ends[1][0], ends[1][1]}, area_);
    if (line) strokes_.push_back(*line);
  }
  [[nodiscard]] Point onPlot(const Vec3<T>& p) const {
    const auto along = [](T x, T first, T last) {
      return static_cast<double>(x - first) / static_cast<double>(last - first);
    };
    const auto q = p - plane_.origin;
    return {
        area_.x0 + area_.width * along(dot(q, plane_.right), window_.lower[0], window_.upper[0]),
        area_.y0 +
            area_.height * (1 - along(dot(q, plane_.up), window_.lower[1], window_.upper[1]))};
  }

  const SlicePlane<T>& plane_;
  Vec3<T> normal_;
  const SliceWindow<T>& window_;
  const PlotArea& area_;
  std::array<Vec3<T>, 8> corners_;
  std::array<T, 8> heights_;
  std::vector<Stroke> strokes_;
};

}  // namespace

template <std::floating_point T>
std::vector<Stroke> meshLines(const Octree<T>& mesh, const SlicePlane<T>& plane,
                              const SliceWindow<T>& window, const PlotArea& area) {
  Lines<T> lines(plane, window, area);
  for (const auto& cell : mesh.cells()) {
    const auto last = mesh.domain().indices(cell.level).hi;
    const unsigned atEnd = (cell.index.i == last.i ? 1U : 0U) | (cell.index.j == last.j ? 2U : 0U) |
                           (cell.index.k == last.k ? 4U : 0U);
    lines.add(mesh.box(cell), atEnd);
  }
  return lines.take();
}

template std::vector<Stroke> meshLines(const Octree<float>&, const SlicePlane<float>&,
                                       const SliceWindow<float>&, const PlotArea&);
template std::vector<Stroke> meshLines(const Octree<double>&, const SlicePlane<double>&,
                                       const SliceWindow<double>&, const PlotArea&);

}  // namespace cutwater::detail
