#include <Cutwater/CutCells/Detail/Curved/CertainParts.hpp>

#include <utility>

namespace cutwater {

CertainParts::Part CertainParts::classOf(const Place& at) const {
  const auto size = (1.0 / static_cast<double>(side_)) * box_.size();
  Box<double> part;
  for (int axis = 0; axis < 3; ++axis) {
    const auto n = at[place(axis)];
    const auto planeAt = [&](std::size_t i) {
      return i == side_ ? box_.upper[axis] : box_.lower[axis] + static_cast<double>(i) * size[axis];
    };
    part.lower[axis] = planeAt(n);
    part.upper[axis] = isFlat_[place(axis)] ? box_.lower[axis] : planeAt(n + 1);
  }
  BoxHint hint;
  if (field_.mayBeCut(part, hint)) return Part::Open;
  return field_.value(part.center()) > 0 ? Part::Fluid : Part::Body;
}

void CertainParts::halve() {
  const auto before = std::move(parts_);
  Place sidesBefore{};
  for (std::size_t a = 0; a < 3; ++a) sidesBefore[a] = sideAlong(a);
  side_ *= 2;
  parts_.assign(sideAlong(0) * sideAlong(1) * sideAlong(2), Part::Open);
  open_ = 0;
  forEach([&](std::uint32_t number, const Place& at) {
    const auto in = (at[2] / 2 * sidesBefore[1] + at[1] / 2) * sidesBefore[0] + at[0] / 2;
    auto& part = parts_[number];
    part = before[in] == Part::Open ? classOf(at) : before[in];
    open_ += part == Part::Open ? 1 : 0;
  });
}

}  // namespace cutwater
