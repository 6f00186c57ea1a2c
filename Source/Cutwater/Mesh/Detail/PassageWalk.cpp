#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/Mesh/Detail/PassageWalk.hpp>

#include <algorithm>

namespace cutwater {

namespace {

bool isBefore(const Passage& a, const Passage& b) {
  return a.parameter < b.parameter || (a.parameter == b.parameter && a.triangle < b.triangle);
}

/// The ratio of the ends' heights above the plane, in twice the precision, as differences of
/// heights are small for segments that graze it.
double parameterOf(const Segment<double>& segment, const std::array<Vec3<double>, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const auto normal = cross(DoubleDouble3::difference(b, a), DoubleDouble3::difference(c, a));
  const auto start = dot(normal, DoubleDouble3::difference(segment.start, a));
  const auto end = dot(normal, DoubleDouble3::difference(segment.end, a));
  const auto whole = start - end;
  // Crossed although it lies in the plane: by perturbation alone, anywhere in the triangle.
  if (whole == DoubleDouble(0)) return 0;
  return std::clamp(static_cast<double>(start / whole), 0.0, 1.0);
}

}  // namespace

template <std::floating_point T>
Passage PassageWalk<T>::next() {
  if (at_ == count_) {
    if (isComplete_) return {};
    if (count_ > 0) last_ = batch_[count_ - 1];
    fetch();
  }
  return at_ < count_ ? batch_[at_++] : Passage{};
}

template <std::floating_point T>
void PassageWalk<T>::fetch() {
  count_ = 0;
  at_ = 0;
  visitPassages<T>(surface_, segment_, along_, [&](std::uint32_t id, int direction) {
    const double parameter = parameterOf(segment_, surface_.corners(id));
    return insert({.parameter = parameter, .triangle = id, .direction = direction});
  });
  isComplete_ = count_ < most_;
  most_ = kBatch;
}

/// Keeps the first passages not yet returned; returns the parameter up to which more are wanted.
template <std::floating_point T>
double PassageWalk<T>::insert(const Passage& passage) {
  const auto wanted = [&] { return count_ < most_ ? 1 : batch_[most_ - 1].parameter; };
  if (!isBefore(last_, passage)) return wanted();
  if (count_ == most_) {
    if (!isBefore(passage, batch_[most_ - 1])) return wanted();
    --count_;
  }
  const auto end = batch_.begin() + static_cast<std::ptrdiff_t>(count_);
  const auto place = std::upper_bound(batch_.begin(), end, passage, isBefore);
  std::move_backward(place, end, end + 1);
  *place = passage;
  ++count_;
  return wanted();
}

template class PassageWalk<float>;
template class PassageWalk<double>;

}  // namespace cutwater
