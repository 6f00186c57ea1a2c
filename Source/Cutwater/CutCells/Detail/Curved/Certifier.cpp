#include <Cutwater/CutCells/Detail/Curved/Certifier.hpp>
#include <Cutwater/CutCells/Detail/Curved/PieceProof.hpp>

#include <algorithm>

namespace cutwater {

namespace {

Box<double> moved(const Box<double>& box, const Vec3<double>& shift) {
  return {box.lower - shift, box.upper - shift};
}

}  // namespace

/// From where cells are cut.
Vec3<double> Certifier::shiftOf(const Box<double>& box) const {
  return {period_.shiftTo(0, box.lower.x), period_.shiftTo(1, box.lower.y),
          period_.shiftTo(2, box.lower.z)};
}

/// An axis along which the box reaches beyond where cells are cut; -1 if there is none.
int Certifier::axisBeyond(const Box<double>& box) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (box.upper[axis] - period_.shiftTo(axis, box.lower[axis]) > period_.endOf(axis)) return axis;
  }
  return -1;
}

bool Certifier::mayBeCut(const Box<double>& box, Around& around) const {
  if (axisBeyond(box) >= 0) return true;
  if (const auto shift = shiftOf(box); shift != around.shift) around = {shift, {}};
  return field_.mayBeCut(moved(box, around.shift), around.hint);
}

Interval<double> Certifier::shareOf(const Box<double>& box, double width, std::size_t boxes) const {
  const int axis = axisBeyond(box);
  if (axis < 0) return field_.shareOf(moved(box, shiftOf(box)), width, boxes);
  // In halves, of single precision as all planes may be.
  auto low = box;
  auto high = box;
  low.upper[axis] = high.lower[axis] = double{static_cast<float>(box.center()[axis])};
  const double share = (low.upper[axis] - box.lower[axis]) / (box.upper[axis] - box.lower[axis]);
  const auto below = shareOf(low, width, boxes);
  const auto above = shareOf(high, width, boxes);
  constexpr double kRounding = 1e-15;
  return {std::max(0.0, share * below.lower + (1 - share) * above.lower - kRounding),
          std::min(1.0, share * below.upper + (1 - share) * above.upper + kRounding)};
}

std::optional<Interval<double>> Certifier::doubtAt(const Box<double>& box) const {
  constexpr std::size_t kBoxes = 1000;  // most cells beside the surface need some dozens
  constexpr double kWhole = 1e-12;      // rounding of a sum of volumes
  const auto share = shareOf(box, 0, std::min(kBoxes, options_.boxes));
  const double width = share.upper - share.lower;
  if (width <= kWhole) return {};
  return width > options_.width ? shareOf(box) : share;
}

bool Certifier::arePieces(const Box<double>& box, std::size_t count) const {
  if (axisBeyond(box) >= 0) return false;
  return PieceProof(field_, moved(box, shiftOf(box)), options_).has(count);
}

}  // namespace cutwater
