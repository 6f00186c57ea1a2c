#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <array>
#include <charconv>

// SignedDistanceFunction::describe().

namespace cutwater {

namespace {

std::string nameOf(Quality quality) {
  return quality == Quality::Exact        ? "exact"
         : quality == Quality::LowerBound ? "lower bound"
                                          : "sign only";
}

/// To six digits: the slight growth of boxes by rounding is not worth reading.
std::string textOf(double value) {
  std::array<char, 32> buffer{};
  const auto end = buffer.data() + buffer.size();
  return {buffer.data(),
          std::to_chars(buffer.data(), end, value, std::chars_format::general, 6).ptr};
}

template <std::floating_point T>
std::string textOf(const Vec3<T>& v) {
  std::string text = "(";  // g++ 12 warns about sums that begin with it
  text += textOf(double{v.x}) + ", " + textOf(double{v.y}) + ", " + textOf(double{v.z}) + ")";
  return text;
}
template <std::floating_point T>
std::string textOf(const Box<T>& box) {
  if (box == Box<T>::everywhere()) return "anywhere";
  if (box.empty()) return "nowhere";
  return "in " + textOf(box.lower) + " .. " + textOf(box.upper);
}

template <std::floating_point T>
std::string textOf(const RigidTransform<T>& placement) {
  const bool isMoved = placement.offset() != Vec3<T>{};
  std::string text;
  if (isMoved) text += ", moved by " + textOf(placement.offset());
  if (placement.isRotated()) text += isMoved ? " and turned" : ", turned";
  return text;
}

template <std::floating_point T>
std::string textOf(const Guarantee<T>& promise) {
  std::string text = promise.inside == promise.outside ? nameOf(promise.outside)
                                                       : "outside " + nameOf(promise.outside) +
                                                             ", inside " + nameOf(promise.inside);
  if (promise.lipschitz) {
    text += ", Lipschitz " + textOf(double{*promise.lipschitz});
  } else {
    text += ", no Lipschitz constant";
  }
  if (!promise.continuous) text += ", not continuous";
  if (promise.domain != Box<T>::everywhere()) text += ", valid " + textOf(promise.domain);
  return text;
}

}  // namespace

template <std::floating_point T>
void SignedDistanceFunction<T>::describe(std::string& text, int depth) const {
  constexpr std::size_t kMostOperands = 16;
  const std::string indent(2 * static_cast<std::size_t>(depth), ' ');
  text += indent + localName() + textOf(placement_) + ": " + textOf(guarantee()) + "; " +
          textOf(boundingBox()) + "\n";
  std::size_t count = 0;
  forEachOperand([&](const SignedDistanceFunction& operand) {
    if (count++ < kMostOperands) operand.describe(text, depth + 1);
  });
  if (count > kMostOperands) {
    text += indent + "  and " + detail::toText(static_cast<long long>(count - kMostOperands)) +
            " more\n";
  }
}

template <std::floating_point T>
std::string SignedDistanceFunction<T>::describe() const {
  std::string text;
  describe(text, 0);
  return text;
}

template void SignedDistanceFunction<float>::describe(std::string&, int) const;
template void SignedDistanceFunction<double>::describe(std::string&, int) const;
template std::string SignedDistanceFunction<float>::describe() const;
template std::string SignedDistanceFunction<double>::describe() const;

}  // namespace cutwater
