#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/Detail/CellMirrors.hpp>
#include <Cutwater/Lattice/UnitCell.hpp>

#include <algorithm>

namespace cutwater {

namespace {

constexpr auto kFolds = {CellFold::None, CellFold::Octant, CellFold::SortXY, CellFold::Sort,
                         CellFold::Fcc};

std::uint32_t bitOf(CellFold fold) {
  return 1U << static_cast<unsigned>(fold);
}

double difference(const CellStrut& s, const CellStrut& t) {
  return std::max(maxComponent(abs(s.a - t.a)), maxComponent(abs(s.b - t.b)));
}

/// The copy whose midpoint lies in the cell.
CellStrut inCell(const CellStrut& strut) {
  const auto middle = strut.middle();
  Vec3<double> cell;
  for (int axis = 0; axis < 3; ++axis) cell[axis] = std::floor(middle[axis] + UnitCell::kSame);
  return {strut.a - cell, strut.b - cell};
}

std::vector<CellStrut> joined(std::span<const Vec3<double>> nodes,
                              std::span<const std::array<std::uint32_t, 2>> struts) {
  std::vector<CellStrut> found;
  for (const auto& [a, b] : struts) {
    require(std::max(a, b) < nodes.size(), "UnitCell: a strut needs nodes that exist",
            Named{"strut", found.size()}, Named{"node", std::max(a, b)},
            Named{"nodes", nodes.size()});
    found.push_back({nodes[a], nodes[b]});
  }
  return found;
}

}  // namespace

UnitCell::UnitCell(std::string name, std::span<const CellStrut> struts) : name_(std::move(name)) {
  require(!struts.empty(), "UnitCell: need a strut");
  for (const auto& strut : struts) add(strut);
  findMirrors();
}

UnitCell::UnitCell(std::string name, std::span<const Vec3<double>> nodes,
                   std::span<const std::array<std::uint32_t, 2>> struts)
    : UnitCell(std::move(name), joined(nodes, struts)) {}

void UnitCell::add(const CellStrut& strut) {
  constexpr double kShortest = 1e-6;
  constexpr double kFarthest = 1.5;  // from the middle of the cube
  for (const auto& end : {strut.a, strut.b}) {
    const bool isNear = maxComponent(abs(end - Vec3<double>{0.5, 0.5, 0.5})) <= kFarthest;
    require(isFinite(end) && isNear, "UnitCell: need ends of struts in [-1, 2]^3",
            Named{"end", end});
  }
  require(length(strut.b - strut.a) > kShortest, "UnitCell: need a strut with some length",
          Named{"a", strut.a}, Named{"b", strut.b});
  if (!contains(strut, kSame)) struts_.push_back(inCell(strut));
}

bool UnitCell::contains(const CellStrut& strut, double tolerance) const {
  const auto wanted = inCell(strut);
  const CellStrut reversed{wanted.b, wanted.a};
  return std::ranges::any_of(struts_, [&](const CellStrut& other) {
    return std::min(difference(wanted, other), difference(reversed, other)) <= tolerance;
  });
}

void UnitCell::findMirrors() {
  for (const auto fold : kFolds) {
    const bool hasAll = std::ranges::all_of(detail::wallsOf(fold), [&](const auto& wall) {
      return std::ranges::all_of(struts_, [&](const CellStrut& strut) {
        return contains({wall.image(strut.a), wall.image(strut.b)}, detail::kRounding);
      });
    });
    if (hasAll) folds_ |= bitOf(fold);
  }
}

bool UnitCell::has(CellFold fold) const {
  return (folds_ & bitOf(fold)) != 0;
}

CellFold UnitCell::foldAt(const Vec3<double>& size) const {
  // Mirrors that are not perpendicular to an axis need equal sizes along the axes that they
  // exchange.
  const bool isSquare = size.x == size.y;
  const bool isCube = isSquare && size.y == size.z;
  if (isCube && has(CellFold::Sort)) return CellFold::Sort;
  if (isCube && has(CellFold::Fcc)) return CellFold::Fcc;
  if (isSquare && has(CellFold::SortXY)) return CellFold::SortXY;
  return has(CellFold::Octant) ? CellFold::Octant : CellFold::None;
}

std::vector<CellStrut> UnitCell::closedStruts() const {
  std::vector<CellStrut> found;
  for (const auto& strut : struts_) {
    const auto middle = strut.middle();
    // Struts in the lower faces are in the upper ones, too.
    for (int i = 0; i < 8; ++i) {
      const Vec3<double> place{1.0 * (i & 1), 1.0 * (i >> 1 & 1), 1.0 * (i >> 2 & 1)};
      if (maxComponent(middle + place) <= 1 + kSame) {
        found.push_back({strut.a + place, strut.b + place});
      }
    }
  }
  return found;
}

double UnitCell::lengthPerCell() const {
  double sum = 0;
  for (const auto& [a, b] : struts_) sum += length(b - a);
  return sum;
}

}  // namespace cutwater
