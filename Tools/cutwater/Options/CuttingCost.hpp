#pragma once

#include <cstddef>
#include <functional>

// What cutting cells takes, known before it is done.
namespace cutwater::tool {

/// Cells that are to be cut, or have been.
struct CutCount {
  double cells = 0;
  double seconds = 0;
};

/// Memory at its peak, in bytes: of the rows of cells that are cut, and of the parts of triangles.
/// `polygons`: whether they are kept, and written.
[[nodiscard]] double bytesToCut(double cells, std::size_t triangles, bool polygons);

/// Time in seconds, from some ten thousand larger cells and from a quarter as many: the triangles
/// take some of it whatever the cells are. Negative, for not known, if so few cells take a moment.
/// @param cutLarger  cuts cells 2^n times as large.
[[nodiscard]] double secondsToCut(double cells, const std::function<CutCount(int)>& cutLarger);

}  // namespace cutwater::tool
