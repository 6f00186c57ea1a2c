#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

// SignedDistanceFunction::describe().

namespace cutwater {

namespace {

using detail::toText;

std::string nameOf(Quality quality) {
  return quality == Quality::Exact        ? "exact"
         : quality == Quality::LowerBound ? "lower bound"
                                          : "sign only";
}

template <std::floating_point T>
std::string textOf(const Vec3<T>& v) {
  return "(" + toText(double{v.x}) + ", " + toText(double{v.y}) + ", " + toText(double{v.z}) + ")";
}
template <std::floating_point T>
std::string textOf(const Box<T>& box) {
  if (box == Box<T>::everywhere()) return "anywhere";
  if (box.empty()) return "nowhere";
  return "in " + textOf(box.lower) + " .. " + textOf(box.upper);
}

template <std::floating_point T>
std::string textOf(const RigidTransform<T>& placement) {
  if (placement.isIdentity()) return "";
  const std::string turned = placement.isRotated() ? "turned" : "";
  if (placement.offset() == Vec3<T>{}) return ", " + turned;
  return ", moved by " + textOf(placement.offset()) + (turned.empty() ? "" : " and " + turned);
}

template <std::floating_point T>
std::string textOf(const Guarantee<T>& promise) {
  std::string text = promise.inside == promise.outside ? nameOf(promise.outside)
                                                       : "outside " + nameOf(promise.outside) +
                                                             ", inside " + nameOf(promise.inside);
  if (promise.lipschitz) {
    text += ", Lipschitz " + toText(double{*promise.lipschitz});
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
    text += indent + "  and " + toText(static_cast<long long>(count - kMostOperands)) + " more\n";
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
