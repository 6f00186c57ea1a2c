#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace cutwater {

/// A whole number of up to `Digits` digits of 32 bits, with a sign: for signs of sums of products
/// that double, also as an expansion of doubles, cannot hold because they underflow. Operations are
/// exact; the caller sees to it that sums do not overflow. On the stack, and slow: microseconds.
template <std::size_t Digits>
class WideInteger {
 public:
  WideInteger() = default;
  /// x / 2^-1074, the smallest double that is not zero: a whole number for any finite x.
  static WideInteger inUnitsOfLeast(double x) {
    static_assert(Digits >= 66, "for 2098 bits and the sum of two");
    constexpr int kMantissaBits = 52;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto exponent = bits >> kMantissaBits & 0x7FFU;
    const auto fraction = bits & ((std::uint64_t{1} << kMantissaBits) - 1);
    const auto mantissa = exponent == 0 ? fraction : fraction | std::uint64_t{1} << kMantissaBits;
    const auto shift = exponent == 0 ? 0 : exponent - 1;
    WideInteger result;
    result.isNegative_ = (bits >> 63U) != 0;
    const auto first = static_cast<std::size_t>(shift / kBits);
    const auto within = shift % kBits;
    result.digits_[first] = static_cast<std::uint32_t>(mantissa << within);
    result.digits_[first + 1] = static_cast<std::uint32_t>(mantissa << within >> kBits);
    if (within > 0) {
      result.digits_[first + 2] = static_cast<std::uint32_t>(mantissa >> (2 * kBits - within));
    }
    return result;
  }

  [[nodiscard]] int signOf() const {
    const bool isZero =
        std::ranges::all_of(digits_, [](std::uint32_t digit) { return digit == 0; });
    return isZero ? 0 : isNegative_ ? -1 : 1;
  }

  friend WideInteger operator+(const WideInteger& a, const WideInteger& b) {
    if (a.isNegative_ == b.isNegative_) return combined(a, b, 1);
    return isLess(a, b) ? combined(b, a, -1) : combined(a, b, -1);
  }
  friend WideInteger operator-(const WideInteger& a, const WideInteger& b) { return a + -b; }
  [[nodiscard]] WideInteger operator-() const {
    WideInteger result = *this;
    result.isNegative_ = !isNegative_;
    return result;
  }
  template <std::size_t Others>
  [[nodiscard]] WideInteger<Digits + Others> operator*(const WideInteger<Others>& other) const {
    WideInteger<Digits + Others> result;
    result.isNegative_ = isNegative_ != other.isNegative_;
    for (std::size_t i = 0; i < Digits; ++i) {
      if (digits_[i] == 0) continue;  // nearly all are
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < Others; ++j) {
        carry += std::uint64_t{digits_[i]} * other.digits_[j] + result.digits_[i + j];
        result.digits_[i + j] = static_cast<std::uint32_t>(carry);
        carry >>= kBits;
      }
      result.digits_[i + Others] = static_cast<std::uint32_t>(carry);
    }
    return result;
  }

 private:
  template <std::size_t>
  friend class WideInteger;

  static constexpr std::uint64_t kBits = 32;

  /// Whether `a` is nearer to zero.
  static bool isLess(const WideInteger& a, const WideInteger& b) {
    return std::lexicographical_compare(a.digits_.rbegin(), a.digits_.rend(), b.digits_.rbegin(),
                                        b.digits_.rend());
  }
  /// The digits of `b` added to those of `a`, or for sign -1, where `a` is not less, taken from
  /// them.
  static WideInteger combined(const WideInteger& a, const WideInteger& b, int sign) {
    WideInteger result;
    result.isNegative_ = a.isNegative_;
    std::int64_t carry = 0;
    for (std::size_t i = 0; i < Digits; ++i) {
      carry += std::int64_t{a.digits_[i]} + sign * std::int64_t{b.digits_[i]};
      result.digits_[i] = static_cast<std::uint32_t>(carry);
      carry >>= kBits;  // rounds down: -1 is borrowed
    }
    return result;
  }

  std::array<std::uint32_t, Digits> digits_{};  // the least significant first
  bool isNegative_ = false;
};

}  // namespace cutwater
