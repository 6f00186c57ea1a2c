#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/BeamGraph.hpp>

#include <algorithm>
#include <map>

namespace cutwater {

namespace {

void check(const UnitCell& cell, const Repeats<double>& cells) {
  double beams = static_cast<double>(cell.struts().size());
  for (int axis = 0; axis < 3; ++axis) {
    const auto count = cells.count[static_cast<std::size_t>(axis)];
    const double size = cells.period[axis];
    require(count > 0, "beamsOf: need cells along each axis", Named{"axis", axis});
    require(size > 0 && std::isfinite(size), "beamsOf: need sizes that are positive and finite",
            Named{"axis", axis}, Named{"size", size});
    beams *= 1.0 + count;
  }
  if (beams > 0x1p31) throw Error(ErrorKind::Limit, "beamsOf: need at most 2^31 beams");
}

/// Nodes of the endless lattice: each kind, in units of the period, stands in all cells.
class NodeTable {
 public:
  NodeTable(const Vec3<double>& period, std::vector<Vec3<double>>& nodes)
      : period_(period), nodes_(nodes) {}

  /// Index of the node at this end of a strut of the cell at `place`.
  std::uint32_t nodeAt(const Vec3<double>& end, const Vec3<double>& place) {
    Vec3<double> cell;
    for (int axis = 0; axis < 3; ++axis) cell[axis] = std::floor(end[axis] + UnitCell::kSame);
    const auto inCell = end - cell;
    const auto kind = std::ranges::find_if(kinds_, [&](const Vec3<double>& other) {
      return maxComponent(abs(other - inCell)) <= UnitCell::kSame;
    });
    const auto index = kind - kinds_.begin();
    if (kind == kinds_.end()) kinds_.push_back(inCell);
    const auto there = cell + place;
    const Key key{index, std::lround(there.x), std::lround(there.y), std::lround(there.z)};
    const auto [entry, isNew] = known_.try_emplace(key, static_cast<std::uint32_t>(nodes_.size()));
    if (isNew) {
      const auto at = kinds_[static_cast<std::size_t>(index)] + there;
      nodes_.push_back({at.x * period_.x, at.y * period_.y, at.z * period_.z});
    }
    return entry->second;
  }

 private:
  using Key = std::array<std::int64_t, 4>;

  Vec3<double> period_;
  std::vector<Vec3<double>>& nodes_;
  std::vector<Vec3<double>> kinds_;
  std::map<Key, std::uint32_t> known_;
};

}  // namespace

BeamGraph beamsOf(const UnitCell& cell, const Repeats<double>& cells, double radius) {
  check(cell, cells);
  BeamGraph graph;
  NodeTable table(cells.period, graph.nodes);
  const auto& count = cells.count;
  // Struts with middles in lower faces are those in the upper faces of the cells before.
  for (std::uint32_t z = 0; z <= count[2]; ++z) {
    for (std::uint32_t y = 0; y <= count[1]; ++y) {
      for (std::uint32_t x = 0; x <= count[0]; ++x) {
        const Vec3<double> place{1.0 * x, 1.0 * y, 1.0 * z};
        for (const auto& strut : cell.struts()) {
          const auto middle = strut.middle() + place;
          if (middle.x > count[0] + UnitCell::kSame || middle.y > count[1] + UnitCell::kSame ||
              middle.z > count[2] + UnitCell::kSame) {
            continue;
          }
          const auto a = table.nodeAt(strut.a, place);
          const auto b = table.nodeAt(strut.b, place);
          graph.beams.push_back({{a, b}, {radius, radius}});
        }
      }
    }
  }
  return graph;
}

}  // namespace cutwater
