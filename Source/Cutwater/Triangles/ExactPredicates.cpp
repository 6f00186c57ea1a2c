#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>
#include <Cutwater/Triangles/WideInteger.hpp>

#include <cmath>
#include <cstddef>

namespace cutwater {

double coarse(double x) {
  constexpr double kRounder = 0x1.8p-288;  // adding it leaves bits of 2^-340 and above
  return std::abs(x) >= 0x1p-287 ? x : (x + kRounder) - kRounder;
}

namespace {

int sign(double value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// A number as a sum of doubles without common bits, smallest first, none of them zero (Shewchuk
/// 1997, section 2). It has at most `Capacity` parts; sums and products are exact.
template <std::size_t Capacity>
class Expansion {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double operator[](std::size_t i) const { return parts_[i]; }
  /// The largest part exceeds all others together.
  [[nodiscard]] int signOf() const { return size_ == 0 ? 0 : sign(parts_[size_ - 1]); }
  void push(double part) {
    if (part != 0) parts_[size_++] = part;
  }
  [[nodiscard]] Expansion operator-() const {
    Expansion result;
    for (std::size_t i = 0; i < size_; ++i) result.push(-parts_[i]);
    return result;
  }

 private:
  std::array<double, Capacity> parts_{};  // unused ones are never read
  std::size_t size_ = 0;
};

Expansion<2> expansion(DoubleDouble value) {
  Expansion<2> result;
  result.push(value.low);
  result.push(value.high);
  return result;
}

/// Shewchuk's fast-expansion-sum: merges by size, then carries upwards.
template <std::size_t A, std::size_t B>
Expansion<A + B> operator+(const Expansion<A>& a, const Expansion<B>& b) {
  Expansion<A + B> result;
  double carry = 0;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() || j < b.size()) {
    const bool takeA = j == b.size() || (i < a.size() && std::abs(a[i]) < std::abs(b[j]));
    const DoubleDouble sum = DoubleDouble::sum(carry, takeA ? a[i++] : b[j++]);
    result.push(sum.low);
    carry = sum.high;
  }
  result.push(carry);
  return result;
}

template <std::size_t A, std::size_t B>
Expansion<A + B> operator-(const Expansion<A>& a, const Expansion<B>& b) {
  return a + -b;
}

/// Shewchuk's scale-expansion.
template <std::size_t A>
Expansion<2 * A> operator*(const Expansion<A>& a, double factor) {
  Expansion<2 * A> result;
  double carry = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const DoubleDouble product = DoubleDouble::product(a[i], factor);
    const DoubleDouble low = DoubleDouble::sum(carry, product.low);
    const DoubleDouble high = DoubleDouble::sum(product.high, low.high);
    result.push(low.low);
    result.push(high.low);
    carry = high.high;
  }
  result.push(carry);
  return result;
}

/// Multiplies by an expansion of two parts, such as a difference.
template <std::size_t A>
Expansion<4 * A> operator*(const Expansion<A>& a, const Expansion<2>& b) {
  Expansion<4 * A> result;
  if (b.size() == 0) return result;
  const auto first = a * b[0];
  if (b.size() == 1) {
    for (std::size_t i = 0; i < first.size(); ++i) result.push(first[i]);
    return result;
  }
  return first + a * b[1];
}

/// a - b. The filters may use it, and expansions where coarse() drops nothing.
DoubleDouble difference(double a, double b) {
  return DoubleDouble::difference(coarse(a), coarse(b));
}

DoubleDouble3 difference(const Vec3<double>& a, const Vec3<double>& b) {
  return {difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)};
}

template <typename... Numbers>
bool isEachCoarse(Numbers... x) {
  return ((coarse(x) == x) && ...);
}

bool isCoarse(const Vec3<double>& v) {
  return isEachCoarse(v.x, v.y, v.z);
}

Expansion<2> expansionOf(double a, double b) {
  return expansion(DoubleDouble::difference(a, b));
}

WideInteger<66> wideOf(double a, double b) {
  return WideInteger<66>::inUnitsOfLeast(a) - WideInteger<66>::inUnitsOfLeast(b);
}

// The same formulas for expansions and wide integers. `of`: the exact difference of two numbers.

template <typename Number>
auto determinant(const Number& a, const Number& b, const Number& c, const Number& d) {
  return a * d - b * c;
}

template <typename Number>
int determinantSignOf(const std::array<Number, 3>& u, const std::array<Number, 3>& v,
                      const std::array<Number, 3>& w) {
  const auto x = determinant(u[1], u[2], v[1], v[2]) * w[0];
  const auto y = determinant(u[2], u[0], v[2], v[0]) * w[1];
  const auto z = determinant(u[0], u[1], v[0], v[1]) * w[2];
  return (x + y + z).signOf();
}

template <typename Difference>
int orientationBy(const Difference& of, const Vec3<double>& a, const Vec3<double>& b,
                  const Vec3<double>& c, const Vec3<double>& p) {
  const auto from = [&](const Vec3<double>& q) {
    return std::array{of(q.x, a.x), of(q.y, a.y), of(q.z, a.z)};
  };
  return determinantSignOf(from(b), from(c), from(p));
}

/// Below this the filters defer to exact arithmetic. It is far above what coarse() drops from a
/// product of three numbers up to 2^60, and far below any determinant of consequence.
constexpr double kTiny = 0x1p-200;

}  // namespace

int orientation(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c,
                const Vec3<double>& p) {
  const Vec3<double> u = b - a;
  const Vec3<double> v = c - a;
  const Vec3<double> w = p - a;
  const double xy = u.x * v.y;
  const double yx = u.y * v.x;
  const double yz = u.y * v.z;
  const double zy = u.z * v.y;
  const double zx = u.z * v.x;
  const double xz = u.x * v.z;
  const double value = (yz - zy) * w.x + (zx - xz) * w.y + (xy - yx) * w.z;
  // Shewchuk's bound is (7 + 56 u) u times the sum of sizes, u = 2^-53.
  const double sizes = (std::abs(yz) + std::abs(zy)) * std::abs(w.x) +
                       (std::abs(zx) + std::abs(xz)) * std::abs(w.y) +
                       (std::abs(xy) + std::abs(yx)) * std::abs(w.z);
  if (std::abs(value) > 8 * 0x1p-53 * sizes + kTiny) return sign(value);
  if (p == a || p == b || p == c) return 0;  // often: grids, and vertices of many triangles

  const DoubleDouble3 exactU = difference(b, a);
  const DoubleDouble3 exactV = difference(c, a);
  const DoubleDouble3 exactW = difference(p, a);
  // Each operation is within 2^-100 of its terms, and there are five of them on every path.
  const double finer = static_cast<double>(dot(cross(exactU, exactV), exactW));
  if (std::abs(finer) > 0x1p-96 * sizes + kTiny) return sign(finer);
  if (isCoarse(a) && isCoarse(b) && isCoarse(c) && isCoarse(p)) {
    return orientationBy(expansionOf, a, b, c, p);
  }
  return orientationBy(wideOf, a, b, c, p);
}

int crossSign(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c,
              const Vec3<double>& d, int axis) {
  const int i = (axis + 1) % 3;
  const int j = (axis + 2) % 3;
  const double left = (b[i] - a[i]) * (d[j] - c[j]);
  const double right = (b[j] - a[j]) * (d[i] - c[i]);
  const double value = left - right;
  // Three roundings on each path: two differences and a product, then the last difference.
  if (std::abs(value) > 4 * 0x1p-53 * (std::abs(left) + std::abs(right)) + kTiny) {
    return sign(value);
  }
  const auto by = [&](const auto& of) {
    return determinant(of(b[i], a[i]), of(b[j], a[j]), of(d[i], c[i]), of(d[j], c[j])).signOf();
  };
  const bool areCoarse =
      isEachCoarse(a[i], a[j], b[i], b[j]) && isEachCoarse(c[i], c[j], d[i], d[j]);
  return areCoarse ? by(expansionOf) : by(wideOf);
}

namespace {

/// The sign of the first nonzero component. It determines how a value with this gradient changes
/// when the point moves by (e, e^2, e^3).
template <typename Component>
int firstSign(Component&& component) {
  for (int axis = 0; axis < 3; ++axis) {
    if (const int s = component(axis); s != 0) return s;
  }
  return 0;
}

/// The side of the edge from `a` to `b` on which the perturbed line passes; 0 only if they are
/// parallel.
int sideOfEdge(const Segment<double>& line, const Vec3<double>& a, const Vec3<double>& b) {
  if (const int s = orientation(line.start, line.end, a, b); s != 0) return s;
  return firstSign([&](int axis) { return crossSign(line.start, line.end, a, b, axis); });
}

}  // namespace

int sideOf(const Vec3<double>& point, const std::array<Vec3<double>, 3>& triangle) {
  const auto& a = triangle[0];
  const auto& b = triangle[1];
  const auto& c = triangle[2];
  if (const int s = orientation(a, b, c, point); s != 0) return s;
  return firstSign([&](int axis) { return crossSign(a, b, a, c, axis); });
}

int passage(const Segment<double>& segment, const std::array<Vec3<double>, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const int start = sideOf(segment.start, triangle);
  const int end = sideOf(segment.end, triangle);
  if (start == end) return 0;
  // A triangle seen edge-on has no inside; an edge parallel to the segment belongs to such a
  // triangle.
  const int first = sideOfEdge(segment, a, b);
  if (first == 0 || first != sideOfEdge(segment, b, c) || first != sideOfEdge(segment, c, a)) {
    return 0;
  }
  return end;
}

bool isOnTriangle(const Vec3<double>& point, const std::array<Vec3<double>, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  if (orientation(a, b, c, point) != 0) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const int turn = crossSign(a, b, a, c, axis);
    if (turn == 0) continue;
    if (point == a || point == b || point == c) return true;
    return crossSign(a, b, a, point, axis) != -turn && crossSign(b, c, b, point, axis) != -turn &&
           crossSign(c, a, c, point, axis) != -turn;
  }
  return false;
}

DoubleDouble exactDifference(double a, double b) {
  return difference(a, b);
}

int determinantSign(const std::array<DoubleDouble3, 3>& rows) {
  const auto of = [](const DoubleDouble3& v) {
    return std::array{expansion(v.x), expansion(v.y), expansion(v.z)};
  };
  return determinantSignOf(of(rows[0]), of(rows[1]), of(rows[2]));
}

int determinantSign(DoubleDouble a, DoubleDouble b, DoubleDouble c, DoubleDouble d) {
  return determinant(expansion(a), expansion(b), expansion(c), expansion(d)).signOf();
}

}  // namespace cutwater
