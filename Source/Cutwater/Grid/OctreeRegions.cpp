#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/OctreeRegions.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

/// Calls visit(neighbour) for the neighbours across a cell's faces that are no finer than the cell:
/// of two neighbours, at least one sees the other.
template <std::floating_point T, typename Visit>
void forCoarserNeighbours(const Octree<T>& mesh, const OctreeCell& cell, const Visit& visit) {
  for (int face = 0; face < 6; ++face) {
    const int step = face % 2 == 0 ? -1 : 1;
    auto index = cell.index;
    (face < 2 ? index.i : face < 4 ? index.j : index.k) += step;
    const auto found = mesh.find(index, cell.level);
    if (found && mesh.cells()[*found].level <= cell.level) visit(*found);
  }
}

template <std::floating_point T>
double volumeOf(const Octree<T>& mesh, const OctreeCell& cell) {
  return std::pow(std::ldexp(double{mesh.domain().spacing()}, -cell.level), 3);
}

}  // namespace

template <std::floating_point T>
FluidRegions<T>::FluidRegions(const Octree<T>& mesh) : regionOf_(mesh.cells().size(), kNone) {
  const auto cells = mesh.cells();
  require(cells.size() < kNone, "FluidRegions: need fewer than 2^32 - 1 cells",
          Named{"cells", cells.size()});
  const auto contacts = contactsOf(mesh);
  detail::DisjointSets sets(cells.size());
  for (const auto& [cell, other] : contacts) {
    if (cells[cell].kind == cells[other].kind) sets.unite(cell, other);
  }
  numberRegions(mesh, sets);
  assignCutCells(mesh, contacts);
}

template <std::floating_point T>
auto FluidRegions<T>::contactsOf(const Octree<T>& mesh) -> std::vector<Contact> {
  const auto cells = mesh.cells();
  const auto isFluid = [&](std::size_t n) { return cells[n].kind != BoxClass::Inside; };
  const auto isOutside = [&](std::size_t n) { return cells[n].kind == BoxClass::Outside; };
  std::vector<Contact> contacts;
  for (std::uint32_t n = 0; n < cells.size(); ++n) {
    if (!isFluid(n)) continue;
    forCoarserNeighbours(mesh, cells[n], [&](std::size_t other) {
      if (!isFluid(other) || !(isOutside(n) || isOutside(other))) return;
      // Two cells of one level see each other.
      if (cells[other].level == cells[n].level && other < n) return;
      contacts.push_back({n, static_cast<std::uint32_t>(other)});
    });
  }
  return contacts;
}

template <std::floating_point T>
void FluidRegions<T>::numberRegions(const Octree<T>& mesh, detail::DisjointSets& sets) {
  struct Found {
    FluidRegion<T> region;
    std::uint32_t first;
    int level;  // that of the largest cell
  };
  const auto cells = mesh.cells();
  std::vector<Found> found;
  std::vector<std::uint32_t> numbers(cells.size(), kNone);  // indexed by the set's first cell
  for (std::uint32_t n = 0; n < cells.size(); ++n) {
    if (cells[n].kind != BoxClass::Outside) continue;
    auto& number = numbers[sets.find(n)];
    if (number == kNone) {
      number = static_cast<std::uint32_t>(found.size());
      found.push_back({{}, n, cells[n].level + 1});
    }
    auto& [region, first, level] = found[number];
    ++region.cells;
    region.volume += volumeOf(mesh, cells[n]);
    if (cells[n].level < level) {
      level = cells[n].level;
      region.point = mesh.center(cells[n]);
    }
  }
  std::ranges::stable_sort(found, std::greater<>{}, [](const Found& f) { return f.region.volume; });
  for (std::uint32_t number = 0; number < found.size(); ++number) {
    numbers[found[number].first] = number;
    regions_.push_back(found[number].region);
  }
  for (std::uint32_t n = 0; n < cells.size(); ++n) {
    if (cells[n].kind == BoxClass::Outside) regionOf_[n] = numbers[sets.find(n)];
  }
}

template <std::floating_point T>
void FluidRegions<T>::assignCutCells(const Octree<T>& mesh, std::span<const Contact> contacts) {
  const auto cells = mesh.cells();
  // Regions are numbered by size, so the largest has the least number.
  const auto assign = [&](std::uint32_t n, std::uint32_t from) {
    if (mayBeCut(cells[n].kind)) regionOf_[n] = std::min(regionOf_[n], regionOf_[from]);
  };
  for (const auto& [cell, other] : contacts) {
    assign(cells[cell].kind == BoxClass::Outside ? other : cell,
           cells[cell].kind == BoxClass::Outside ? cell : other);
  }
}

template <std::floating_point T>
std::vector<std::size_t> FluidRegions<T>::unreached(const Octree<T>& mesh,
                                                    const Vec3<T>& point) const {
  const auto at = mesh.find(point);
  require(at.has_value(), "unreached: need a point within the mesh", Named{"point", point});
  const auto region = regionOf_[*at];
  require(region != kNone, "unreached: need a point in the fluid", Named{"point", point});
  std::vector<std::size_t> result;
  for (std::size_t n = 0; n < mesh.cells().size(); ++n) {
    if (mesh.cells()[n].kind != BoxClass::Inside && regionOf_[n] != region) result.push_back(n);
  }
  return result;
}

template <std::floating_point T>
Interval<double> solidVolume(const Octree<T>& mesh) {
  Interval<double> volume{0, 0};
  for (const auto& cell : mesh.cells()) {
    if (cell.kind == BoxClass::Outside) continue;
    const double own = volumeOf(mesh, cell);
    volume.upper += own;
    if (cell.kind == BoxClass::Inside) volume.lower += own;
  }
  return volume;
}

template class FluidRegions<float>;
template class FluidRegions<double>;
template Interval<double> solidVolume(const Octree<float>&);
template Interval<double> solidVolume(const Octree<double>&);

}  // namespace cutwater
