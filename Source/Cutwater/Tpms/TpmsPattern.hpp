#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace cutwater {

/// The two channels into which a triply periodic surface F = 0 divides space.
enum class TpmsChannel : std::uint8_t {
  A,  ///< F > 0
  B,  ///< F < 0
};

namespace detail {
enum class TpmsKind : std::uint8_t;
struct PatternConstants;
}  // namespace detail

/// A level function and its gradient.
template <std::floating_point T>
struct TpmsSample {
  T value;
  Vec3<T> gradient;  ///< per radian: times 2 pi / u for a cell of size u
};

/// A pattern F(x, y, z) whose zero set is, nearly, a triply periodic minimal surface (TPMS),
/// without a size of its own: a trigonometric polynomial in coordinates in cells.
///
///     gyroid            sin x cos y + sin y cos z + sin z cos x       with x, y, z in radians
///
/// Coordinates are in cells, so the cubic cell is [0, 1]^3 and the period is 1 along each axis;
/// derivatives per radian are smaller than those per cell by a factor of 2 pi. The constants below,
/// which were proven by branch and bound, hold for F as written here.
class TpmsPattern {
 public:
  // c and s are cosines and sines, c2 and s2 those of twice the angle;
  // T = s2x cy sz + s2y cz sx + s2z cx sy, C = c2x c2y + c2y c2z + c2z c2x.
  static TpmsPattern gyroid();        ///< sx cy + sy cz + sz cx
  static TpmsPattern schwarzP();      ///< cx + cy + cz
  static TpmsPattern schwarzD();      ///< cx cy cz - sx sy sz
  static TpmsPattern schwarzD4();     ///< sx sy sz + sx cy cz + cx sy cz + cx cy sz: D, moved
  static TpmsPattern lidinoid();      ///< T/2 - C/2 + 0.15
  static TpmsPattern splitP();        ///< 1.1 T - 0.2 C - 0.4 (c2x + c2y + c2z)
  static TpmsPattern neovius();       ///< 3 (cx + cy + cz) + 4 cx cy cz
  static TpmsPattern iwp();           ///< 2 (cx cy + cy cz + cz cx) - (c2x + c2y + c2z): Schoen
  static TpmsPattern frd();           ///< 4 cx cy cz - C: Schoen's F-RD
  static TpmsPattern fischerKochS();  ///< c2x sy cz + cx c2y sz + sx cy c2z
  static std::vector<TpmsPattern> all();

  /// "gyroid", "Schwarz P" and so on.
  [[nodiscard]] std::string name() const;

  /// F at a point, given in cells. Far from the origin, only the rounding of the coordinates
  /// matters.
  template <std::floating_point T>
  [[nodiscard]] T value(const Vec3<T>& inCells) const;
  template <std::floating_point T>
  [[nodiscard]] TpmsSample<T> sample(const Vec3<T>& inCells) const;

  /// An upper bound of |grad F|, per radian.
  [[nodiscard]] double lipschitz() const;
  /// An upper bound of |dF/dx|, |dF/dy| and |dF/dz|, per radian.
  [[nodiscard]] double slopeAlongAxis() const;
  /// An upper bound of the spectral norm of the matrix of second derivatives, per radian squared.
  [[nodiscard]] double curvature() const;
  /// An upper bound of the third derivative in any three directions, per radian cubed.
  [[nodiscard]] double thirdDerivative() const;
  /// Encloses F.
  [[nodiscard]] Interval<double> range() const;
  /// A lower bound of |grad F| on the surface F = 0, per radian.
  [[nodiscard]] double leastSlope() const;
  /// The mean of |grad F| over the surface F = 0, per radian: a wall |F| <= h is about
  /// 2 h / meanSlope() thick.
  [[nodiscard]] double meanSlope() const;
  /// The level h above which channel A, F > h (or B, F < -h), falls apart into separate pieces.
  [[nodiscard]] double pinch(TpmsChannel channel) const;
  /// The radius of the largest ball in the channel that the surface F = 0 bounds, in units of the
  /// cubic cell; rounded down.
  [[nodiscard]] double inscribedRadius(TpmsChannel channel) const;

  [[nodiscard]] detail::TpmsKind kind() const { return kind_; }
  bool operator==(const TpmsPattern&) const = default;

 private:
  explicit TpmsPattern(detail::TpmsKind kind) : kind_(kind) {}
  [[nodiscard]] const detail::PatternConstants& constants() const;

  detail::TpmsKind kind_;
};

}  // namespace cutwater
