#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/FunctionRef.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cutwater {

/// What is certain about the signs of a surface that is open, in each cell of a coarse grid around
/// it: so that most points need no sum over the caps of its holes, see CappedWinding.
///
/// A view of an array: a byte for each cell. The grid follows from the surface's box and its number
/// of triangles. Points and boxes are in the surface's scaled units.
class SignCells {
 public:
  /// What a byte says.
  class Cell {
   public:
    static constexpr int kMostRings = 7;

    constexpr Cell() = default;
    constexpr explicit Cell(std::uint8_t byte) : bits_(byte) {}
    /// `side`: see side(). Least winding numbers other than -2 to 4 are forgotten.
    constexpr Cell(int side, std::optional<int> leastInside, int rings) {
      const int least = leastInside && -3 < *leastInside && *leastInside < 5 ? *leastInside + 3 : 0;
      bits_ = static_cast<unsigned>(side + 1) | static_cast<unsigned>(least) << 2U |
              static_cast<unsigned>(rings) << 5U;
    }

    /// 1: all of it is outside; -1: inside; 0: it may hold triangles, or more is not known.
    [[nodiscard]] constexpr int side() const { return static_cast<int>(bits_ & 3U) - 1; }
    /// The least winding number of the surface and its caps at points of the cell that are inside,
    /// if it is certainly the same for all; then it holds no cap.
    [[nodiscard]] constexpr std::optional<int> leastInside() const {
      const auto code = static_cast<int>(bits_ >> 2U & 7U);
      return code == 0 ? std::nullopt : std::optional(code - 3);
    }
    /// So many rings of cells, the cell itself being the first, hold no cap; kMostRings or more.
    [[nodiscard]] constexpr int rings() const { return static_cast<int>(bits_ >> 5U); }
    [[nodiscard]] constexpr std::uint8_t byte() const { return static_cast<std::uint8_t>(bits_); }

   private:
    unsigned bits_ = 1;  // nothing is known
  };

  SignCells() = default;
  /// Of a surface with this box and so many triangles; `bytes` has size() elements, or none if
  /// nothing is known.
  SignCells(const Box<double>& surface, std::size_t triangles, std::span<const std::uint8_t> bytes);

  /// How many cells there are.
  [[nodiscard]] std::size_t size() const;
  /// Encloses the points of all cells from `first` to `last`, with room for the rounding of at().
  [[nodiscard]] Box<double> box(const std::array<std::int32_t, 3>& first,
                                const std::array<std::int32_t, 3>& last) const;
  [[nodiscard]] const std::array<std::int32_t, 3>& counts() const { return counts_; }
  [[nodiscard]] std::size_t numberOf(const std::array<std::int32_t, 3>& cell) const;

  /// The cell at a point; one about which nothing is known outside the grid.
  [[nodiscard]] Cell at(const Vec3<double>& p) const;
  /// Whether there is certainly no cap within a distance of a point.
  [[nodiscard]] bool isFarFromCaps(const Vec3<double>& p, double distance) const;
  /// See Cell::leastInside(), for all cells that meet a box; none if these are many.
  [[nodiscard]] std::optional<int> leastInside(const Box<double>& box) const;

 private:
  /// Along an axis, in cells from the first one's lower side.
  [[nodiscard]] double placeOf(const Vec3<double>& p, int axis) const {
    return (p[axis] - origin_[axis]) * perLength_;
  }
  [[nodiscard]] std::optional<std::array<std::int32_t, 3>> cellAt(const Vec3<double>& p) const;

  Vec3<double> origin_;
  double width_ = 1;
  double perLength_ = 1;
  std::array<std::int32_t, 3> counts_{};
  std::span<const std::uint8_t> bytes_;
};

/// What findSignCells() asks.
struct SignQueries {
  FunctionRef<bool(const Box<double>&)> mayHoldTriangle;
  FunctionRef<bool(const Box<double>&)> mayHoldCap;
  FunctionRef<std::optional<int>(const Box<double>&)> leastInside;  ///< see CappedWinding
  FunctionRef<int(const Vec3<double>&)> winding;                    ///< of surface and caps
};

/// The array of a SignCells.
[[nodiscard]] std::vector<std::uint8_t> findSignCells(const SignCells& grid,
                                                      const SignQueries& queries);

}  // namespace cutwater
