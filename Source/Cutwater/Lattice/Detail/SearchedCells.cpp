#include <Cutwater/Lattice/Detail/SearchedCells.hpp>

#include <map>

namespace cutwater::detail {

namespace {

/// The number of cells along each axis that have a copy of the strut; 0: endless.
std::array<std::uint32_t, 3> copiesOf(const CellStrut& strut,
                                      const std::array<std::uint32_t, 3>& cells) {
  auto count = cells;
  const auto middle = strut.middle();
  for (int axis = 0; axis < 3; ++axis) {
    auto& along = count[static_cast<std::size_t>(axis)];
    if (along > 0 && middle[axis] <= UnitCell::kSame) ++along;
  }
  return count;
}

}  // namespace

template <std::floating_point T>
SearchedCells<T>::SearchedCells(const UnitCell& cell, const Repeats<T>& cells) {
  const Vec3<double> period(cells.period);
  std::map<std::array<std::uint32_t, 3>, std::vector<std::uint32_t>> byCount;
  for (std::uint32_t i = 0; i < cell.struts().size(); ++i) {
    byCount[copiesOf(cell.struts()[i], cells.count)].push_back(i);
  }
  for (const auto& [count, members] : byCount) {
    Box<T> box;
    std::vector<Strut> struts;
    for (const auto i : members) {
      const auto& strut = cell.struts()[i];
      const auto a = times(strut.a, period);
      const auto b = times(strut.b, period);
      box.extend(Vec3<T>(a)).extend(Vec3<T>(b));
      struts.push_back({StrutAxis<T>(a, b), Vec3<T>(times(strut.middle(), period)), i});
    }
    groups_.push_back({Copies<T>({cells.period, count}, box), std::move(struts)});
  }
}

template <std::floating_point T>
SkeletonPoint<T> SearchedCells<T>::nearest(const Vec3<T>& p) const {
  SkeletonPoint<T> best;
  T least = std::numeric_limits<T>::infinity();
  // Cells that are nearer by rounding alone do not count.
  const auto isNear = [&](T gapSquared) {
    return gapSquared < least * (1 - 8 * std::numeric_limits<T>::epsilon());
  };
  for (const auto& group : groups_) {
    const auto& copies = group.copies;
    copies.outwards(p, copies.ofNearest(), isNear, [&](const Vec3<T>& cell) {
      const auto local = copies.seenFrom(cell, p);
      for (const auto& strut : group.struts) {
        const auto away = strut.axis.awayFrom(local);
        const T squared = lengthSquared(away);
        if (!(squared < least)) continue;
        least = squared;
        best.away = away;
        best.strut = strut.strut;
        best.middle = copies.placeOf(cell) + strut.middle;
      }
    });
  }
  best.distance = std::sqrt(least);
  return best;
}

template <std::floating_point T>
Box<T> SearchedCells<T>::box() const {
  Box<T> all;
  for (const auto& group : groups_) all.extend(group.copies.boxOfAll());
  return all;
}

template class SearchedCells<float>;
template class SearchedCells<double>;

}  // namespace cutwater::detail
