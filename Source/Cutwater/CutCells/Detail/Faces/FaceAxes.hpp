#pragma once

#include <Cutwater/CutCells/Detail/Tiles/TileNumbers.hpp>

namespace cutwater {

/// The axes of a face: across it, and the others in cyclic order.
struct FaceAxes {
  explicit FaceAxes(int axis) : across(axis), first((axis + 1) % 3), second((axis + 2) % 3) {}
  int across;
  int first;
  int second;
};

/// The edges of a face, as ofStretch() numbers them: the axis along which each runs, and where it
/// begins.
struct FaceEdge {
  int axis = 0;
  TilePlace place{};
};
[[nodiscard]] inline FaceEdge edgeOfFace(int axis, const TilePlace& face, int side) {
  const FaceAxes axes(axis);
  FaceEdge edge{side < 2 ? axes.first : axes.second, face};
  const int other = side < 2 ? axes.second : axes.first;
  edge.place[static_cast<std::size_t>(other)] += side % 2;
  return edge;
}

}  // namespace cutwater
