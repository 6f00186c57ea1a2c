#include <Cutwater/CutCells/Detail/Surface/SidePairs.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>

#include <algorithm>
#include <array>

namespace cutwater {

namespace {

std::array<DoubleDouble, 3> components(const DoubleDouble3& v) {
  return {v.x, v.y, v.z};
}

/// The sign of a component of a cross product.
int crossComponent(const DoubleDouble3& u, const DoubleDouble3& v, std::size_t axis) {
  const auto i = (axis + 1) % 3;
  const auto j = (axis + 2) % 3;
  return determinantSign(components(u)[i], components(u)[j], components(v)[i], components(v)[j]);
}

/// The order of angles around a direction, from that of `start` on, turning right-handed.
class AngularOrder {
 public:
  AngularOrder(const DoubleDouble3& direction, const DoubleDouble3& start)
      : direction_(direction), start_(start) {}

  [[nodiscard]] bool isBefore(const DoubleDouble3& a, const DoubleDouble3& b) const {
    const int quarterA = quarter(a);
    const int quarterB = quarter(b);
    if (quarterA != quarterB) return quarterA < quarterB;
    return quarterA % 2 == 1 && determinantSign({direction_, a, b}) > 0;
  }

 private:
  /// 0: at the start; 1: up to half a turn from it; 2: half a turn; 3: more.
  [[nodiscard]] int quarter(const DoubleDouble3& way) const {
    const int side = determinantSign({direction_, start_, way});
    if (side != 0) return side > 0 ? 1 : 3;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int turn = crossComponent(direction_, start_, axis);
      if (turn != 0) return crossComponent(direction_, way, axis) == -turn ? 2 : 0;
    }
    return 0;
  }

  DoubleDouble3 direction_;
  DoubleDouble3 start_;
};

/// Whether a triangle whose third corner is there has no angle around the edge.
bool isAlong(const DoubleDouble3& direction, const DoubleDouble3& way) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (crossComponent(direction, way, axis) != 0) return false;
  }
  return true;
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> pairedAround(const DoubleDouble3& direction,
                                                                  std::vector<SideAtEdge> sides) {
  const auto first = std::ranges::find_if(
      sides, [&](const SideAtEdge& side) { return !isAlong(direction, side.way); });
  if (first != sides.end()) {
    const AngularOrder order(direction, first->way);
    std::ranges::stable_sort(sides, [&](const SideAtEdge& a, const SideAtEdge& b) {
      return order.isBefore(a.way, b.way);
    });
    for (std::size_t i = 1; i + 1 < sides.size(); ++i) {
      const bool areEqual = !order.isBefore(sides[i].way, sides[i + 1].way);
      if (areEqual && sides[i].isForward == sides[i - 1].isForward) {
        std::swap(sides[i], sides[i + 1]);
      }
    }
  }
  // The fluid begins behind a triangle that runs forward. Twice around: the first wedge may have
  // begun before the start.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  std::vector<std::uint32_t> open;
  std::vector<char> isPaired(sides.size());
  for (std::size_t n = 0; n < 2 * sides.size(); ++n) {
    const auto i = n % sides.size();
    if (isPaired[i] != 0) continue;
    if (sides[i].isForward) {
      if (n < sides.size()) open.push_back(static_cast<std::uint32_t>(i));
    } else if (!open.empty()) {
      pairs.emplace_back(sides[open.back()].side, sides[i].side);
      isPaired[open.back()] = isPaired[i] = 1;
      open.pop_back();
    }
  }
  return pairs;
}

}  // namespace cutwater
