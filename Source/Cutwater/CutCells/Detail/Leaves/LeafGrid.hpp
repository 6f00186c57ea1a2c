#pragma once

#include <Cutwater/CutCells/Detail/Surface/CutSurface.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>

#include <array>
#include <limits>
#include <vector>

namespace cutwater {

/// The leaves of an octree: what planes they lie between, and which lies where. A leaf's number is
/// its index in OctreeCells::cells().
class LeafGrid {
 public:
  static constexpr std::uint32_t kNoLeaf = std::numeric_limits<std::uint32_t>::max();

  /// Views the mesh's cells. Planes are those of the finest level: the same on all others, to the
  /// bit.
  /// @throws Error(Argument) unless they are finite and ascend; Error(Limit) for 2^32 - 1 leaves or
  /// more.
  template <std::floating_point T>
  LeafGrid(const OctreeCells<T>& mesh, const CutFrame& frame);

  [[nodiscard]] int deepest() const { return deepest_; }
  [[nodiscard]] std::span<const OctreeCell> leaves() const { return leaves_; }
  /// The cells of a level, from 0, along an axis.
  [[nodiscard]] std::int32_t cells(int level, int axis) const {
    return roots_[asIndex(axis)] << level;
  }
  /// The plane below a cell of a level, in the coordinates of the world or in the frame.
  [[nodiscard]] double plane(int level, int axis, std::int32_t cell) const {
    return planes_[asIndex(axis)][numberOf(level, cell)];
  }
  [[nodiscard]] double planeInFrame(int level, int axis, std::int32_t cell) const {
    return framed_[asIndex(axis)][numberOf(level, cell)];
  }
  [[nodiscard]] Box<double> boxOf(std::uint32_t leaf) const { return boxBetween(planes_, leaf); }
  [[nodiscard]] Box<double> boxInFrame(std::uint32_t leaf) const {
    return boxBetween(framed_, leaf);
  }
  /// The area of its faces across an axis, and its volume.
  [[nodiscard]] double faceArea(std::uint32_t leaf, int axis) const;
  [[nodiscard]] double volume(std::uint32_t leaf) const;

  /// The leaf that a cell is in, or the first of those in it; kNoLeaf if there is none. It is soon
  /// found if it is not far from `near`, a leaf.
  [[nodiscard]] std::uint32_t at(const Index3& cell, int level, std::uint32_t near = 0) const;
  /// The leaves [first, last) that begin in a cube of 2^bits cells along each axis, whose indices
  /// are multiples of that.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> within(const Index3& first, int level,
                                                               int bits) const;

  /// What is across a face.
  enum class Across : std::uint8_t { Nothing, Coarser, Same, Finer };
  /// Across a face of a leaf: the leaf there; the first one, if they are finer.
  [[nodiscard]] std::pair<Across, std::uint32_t> across(std::uint32_t leaf, int axis,
                                                        bool isHigh) const;
  /// The finer leaves across, in order.
  [[nodiscard]] std::vector<std::uint32_t> finerAcross(std::uint32_t leaf, int axis,
                                                       bool isHigh) const;

 private:
  [[nodiscard]] std::size_t numberOf(int level, std::int32_t cell) const {
    return static_cast<std::size_t>(cell) << (deepest_ - level);
  }
  [[nodiscard]] Box<double> boxBetween(const std::array<std::vector<double>, 3>& planes,
                                       std::uint32_t leaf) const;
  [[nodiscard]] std::size_t firstAfter(std::uint64_t place, std::size_t near) const;
  void addTouching(const Index3& cell, int level, int axis, bool isHigh,
                   std::vector<std::uint32_t>& found, std::uint32_t near) const;

  int deepest_;
  std::array<std::int32_t, 3> roots_;
  std::span<const OctreeCell> leaves_;
  std::vector<std::uint64_t>
      places_;  // Morton codes of the leaves' first cells, on the finest level
  std::array<std::vector<double>, 3> planes_;
  std::array<std::vector<double>, 3> framed_;
};

extern template LeafGrid::LeafGrid(const OctreeCells<float>&, const CutFrame&);
extern template LeafGrid::LeafGrid(const OctreeCells<double>&, const CutFrame&);

}  // namespace cutwater
