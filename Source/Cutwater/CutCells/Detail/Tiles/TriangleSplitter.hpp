#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/CutCells/Detail/Surface/MovedPredicates.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>

#include <utility>

namespace cutwater {

/// What an edge of a fragment lies on: an edge of its triangle, from corner `number` to the next
/// one, or a plane of the grid.
struct FragmentEdge {
  int axis = -1;  ///< of the plane; -1: an edge of the triangle
  int number = 0;

  [[nodiscard]] bool isPlane() const { return axis >= 0; }
  bool operator==(const FragmentEdge&) const = default;
};

/// The part of a triangle in one cell: a convex polygon, oriented as the triangle.
///
/// Point i lies where edges i - 1 and i meet: at a corner of the triangle, on one of its edges and
/// a plane, or on two planes.
struct Fragment {
  /// A triangle has three edges, and a cell six faces.
  static constexpr int kMost = 9;

  std::array<std::int32_t, 3> cell{};
  int size = 0;
  std::array<Vec3<double>, kMost> points;
  std::array<FragmentEdge, kMost> edges;  ///< from point i to the next
};

/// Divides triangles among the cells of a grid.
///
/// Which cells a triangle has a part in, and in what planes and edges these parts end, are those of
/// the moved surface (see MovedPredicates.hpp), exactly. Points are computed in double from the
/// whole triangle and the planes that they lie on, so that all cells compute the same bits, and
/// triangles that share an edge do, too. They lie in the cell, to the bit.
class TriangleSplitter {
 public:
  /// Views the planes.
  explicit TriangleSplitter(const GridPlanes& planes) : planes_(planes) {}

  /// Calls visit(fragment) for each part in a cell; parts beyond the grid's planes are left out.
  ///
  /// `vertices` are three different numbers. Triangles that share an edge give its ends the same
  /// ones.
  void split(const std::array<MovedVertex, 3>& triangle,
             const std::array<std::uint32_t, 3>& vertices,
             FunctionRef<void(const Fragment&)> visit);

 private:
  using PointCells = std::array<std::int32_t, 3>;
  /// A polygon on the way to fragments. Its points are in these cells along each axis; along an
  /// axis of a plane through a point, in the one that holds the polygon.
  struct Part {
    Fragment polygon;
    std::array<PointCells, Fragment::kMost> rows;

    void add(const Vec3<double>& point, const FragmentEdge& edge, const PointCells& in) {
      const auto i = static_cast<std::size_t>(polygon.size++);
      polygon.points[i] = point;
      polygon.edges[i] = edge;
      rows[i] = in;
    }
  };

  [[nodiscard]] int rowOf(const MovedVertex& corner, int axis) const;
  /// Whether a coordinate is between the planes of a row, and in neither.
  [[nodiscard]] bool isBetweenPlanes(int axis, int row, double x) const;
  void visitWhole(FunctionRef<void(const Fragment&)> visit);
  void divide(Part& part, int axis, FunctionRef<void(const Fragment&)> visit);
  void take(Part& part, int axis, int row, FunctionRef<void(const Fragment&)> visit);
  void cut(const Part& whole, int axis, int plane, Part& below, Part& above) const;
  [[nodiscard]] Vec3<double> onEdge(int edge, const FragmentEdge& plane, PointCells& rows) const;
  [[nodiscard]] Vec3<double> onLine(const FragmentEdge& first, const FragmentEdge& second,
                                    bool goesUp, PointCells& rows) const;
  [[nodiscard]] int rowOnLine(const Vec3<double>& point, int axis, double slope,
                              bool facesUp) const;
  [[nodiscard]] std::pair<Vec3<double>, Vec3<double>> trace(int axis, int number,
                                                            const Vec3<double>& shift) const;
  [[nodiscard]] Vec3<double> crossing(int edge, const PlaneAcross& plane,
                                      const Vec3<double>& shift = {}) const;
  [[nodiscard]] Vec3<double> withinCell(Vec3<double> point, const PointCells& rows, int axis,
                                        int second) const;

  const GridPlanes& planes_;
  // Of the triangle:
  std::array<MovedVertex, 3> triangle_;
  std::array<std::uint32_t, 3> vertices_{};
  Vec3<double> normal_;  // its components' sizes, as computed
  double size_ = 0;      // at least the sum of the coordinates of any two corners
  std::array<PointCells, 3> cornerRows_{};
  Part whole_;
  /// What is cut off along each axis, and two rests that take turns.
  struct Workspace {
    Part below;
    std::array<Part, 2> rests;
  };
  std::array<Workspace, 3> work_;
};

}  // namespace cutwater
