#pragma once

#include <Cutwater/Core/Vec3.hpp>

namespace cutwater::test {

/// Quadruple precision, 113 bits: the oracle for what is computed in twice the precision.
__extension__ using Float128 = __float128;

struct Vec3Float128 {
  Float128 x, y, z;

  static Vec3Float128 difference(const Vec3<double>& a, const Vec3<double>& b) {
    return {Float128(a.x) - b.x, Float128(a.y) - b.y, Float128(a.z) - b.z};
  }
  friend Vec3Float128 cross(const Vec3Float128& a, const Vec3Float128& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  friend Float128 dot(const Vec3Float128& a, const Vec3Float128& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
};

/// By Newton's method from double; libquadmath is not needed. 0 where a double would underflow.
inline Float128 squareRoot(Float128 a) {
  Float128 root = std::sqrt(static_cast<double>(a));
  if (!(root > 0)) return 0;
  for (int i = 0; i < 3; ++i) root = (root + a / root) / 2;
  return root;
}

}  // namespace cutwater::test
