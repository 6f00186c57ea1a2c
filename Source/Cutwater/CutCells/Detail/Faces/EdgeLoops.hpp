#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <span>
#include <vector>

namespace cutwater {

/// Directed edges of polygons, of which opposite ones cancel: what is left are closed loops.
class EdgeLoops {
 public:
  using Loop = std::vector<Vec3<double>>;
  using Edge = std::array<Vec3<double>, 2>;  ///< from the one to the other

  /// Adds the edges of a polygon, in its order or against it.
  void add(std::span<const Vec3<double>> polygon, bool isReversed = false);

  /// What is left, sorted by where it begins.
  [[nodiscard]] std::span<const Edge> rest() {
    cancel();
    return edges_;
  }
  /// The loops, each of which goes through a point once. Where several edges leave a point `b`, to
  /// which `a` leads, the one to the `c` with the least turn(a, b, c) is taken.
  using Turn =
      FunctionRef<double(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c)>;
  [[nodiscard]] std::vector<Loop> loops(Turn turn);
  /// Those in a plane across an axis. Seen against it, each keeps to the part on its left, so that
  /// loops that touch in a corner go around one part each.
  [[nodiscard]] std::vector<Loop> loopsAcross(int axis);

 private:
  void cancel();

  std::vector<Edge> edges_;
};

}  // namespace cutwater
