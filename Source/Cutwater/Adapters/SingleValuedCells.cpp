#include <Cutwater/Adapters/Detail/SingleValuedParts.hpp>
#include <Cutwater/Adapters/SingleValuedCells.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

namespace cutwater {

namespace {

using Parts = SingleValuedParts;

/// Calls visit(cell, class) for the cells of a box within the grid, along lines.
template <typename Visit>
void forClasses(const CutCells& cells, const IndexBox& box, const Visit& visit) {
  const auto grid = cells.grid.indices();
  const auto key = [](const Index3& cell) { return std::tuple(cell.k, cell.j, cell.i); };
  const auto own = std::span(cells.cells.index).first(cells.cellCount);
  const auto from = [](std::int32_t at, std::int32_t lowest) {
    return static_cast<std::uint64_t>(std::int64_t{at} - lowest);
  };
  for (auto k = box.lo.k; k <= box.hi.k; ++k) {
    for (auto j = box.lo.j; j <= box.hi.j; ++j) {
      auto row = std::ranges::lower_bound(own, key({box.lo.i, j, k}), {}, key);
      auto number = (from(k, grid.lo.k) * grid.length(1) + from(j, grid.lo.j)) * grid.length(0) +
                    from(box.lo.i, grid.lo.i);
      auto run = std::ranges::upper_bound(cells.bodyRuns, number, {},
                                          [](const auto& body) { return body[1]; });
      for (auto i = box.lo.i; i <= box.hi.i; ++i, ++number) {
        const Index3 cell{i, j, k};
        while (run != cells.bodyRuns.end() && (*run)[1] <= number) ++run;
        if (row != own.end() && *row == cell) {
          ++row;
          visit(cell, FluidClass::Cut);
        } else {
          const bool isBody = run != cells.bodyRuns.end() && (*run)[0] <= number;
          visit(cell, isBody ? FluidClass::Body : FluidClass::Fluid);
        }
      }
    }
  }
}

IndexBox grown(IndexBox box, int axis, std::int32_t below, std::int32_t above) {
  along(box.lo, axis) -= below;
  along(box.hi, axis) += above;
  return box;
}

IndexBox common(const IndexBox& a, const IndexBox& b) {
  IndexBox result;
  for (int axis = 0; axis < 3; ++axis) {
    along(result.lo, axis) = std::max(along(a.lo, axis), along(b.lo, axis));
    along(result.hi, axis) = std::min(along(a.hi, axis), along(b.hi, axis));
  }
  return result;
}

Index3 nearestIn(const IndexBox& box, Index3 index) {
  for (int axis = 0; axis < 3; ++axis) {
    along(index, axis) = std::clamp(along(index, axis), along(box.lo, axis), along(box.hi, axis));
  }
  return index;
}

/// The value of an index in a view of a box.
template <typename Value>
Value& valueAt(const GridView<Value>& view, const IndexBox& box, const Index3& index) {
  const auto from = [](std::int32_t at, std::int32_t lowest) {
    return static_cast<std::size_t>(std::int64_t{at} - lowest);
  };
  return view.at(from(index.i, box.lo.i), from(index.j, box.lo.j), from(index.k, box.lo.k));
}

/// Fills a box: what lies between cells that are all fluid, or all body, is not looked up.
template <typename T>
class Filling {
 public:
  Filling(const Parts& parts, const IndexBox& box, const SingleValuedFields<T>& out)
      : parts_(parts), box_(box), out_(out), around_(box) {
    for (int axis = 0; axis < parts_.dimensions(); ++axis) around_ = grown(around_, axis, 1, 1);
    kinds_.resize(around_.count());
    forClasses(parts.merged().cells, common(around_, parts.box()),
               [&](const Index3& cell, FluidClass kind) { kindAt(cell) = kind; });
    // Cells beyond are as those in the first layer.
    auto layer = parts.box();
    for (int axis = 0; axis < parts_.dimensions(); ++axis) layer = grown(layer, axis, 1, 1);
    const auto known = common(around_, layer);
    forEachIndex(known, [&](const Index3& cell) {
      if (!parts.box().contains(cell)) kindAt(cell) = parts.kindOf(cell);
    });
    forEachIndex(around_, [&](const Index3& cell) {
      if (layer.contains(cell)) return;
      const auto nearest = nearestIn(layer, cell);
      kindAt(cell) =
          !parts.isPeriodic() && known.contains(nearest) ? kindAt(nearest) : parts.kindOf(cell);
    });
  }

  void run() {
    forEachIndex(box_, [&](const Index3& cell) { fillCell(cell); });
    auto nodes = box_;
    for (int axis = 0; axis < parts_.dimensions(); ++axis) {
      nodes = grown(nodes, axis, 0, 1);
      const auto faces = grown(box_, axis, 0, 1);
      forEachIndex(faces, [&](const Index3& cell) { fillFace(faces, cell, axis); });
    }
    for (int axis = 0; axis < parts_.dimensions(); ++axis) {
      const auto edges = grown(nodes, axis, 0, -1);
      forEachIndex(edges, [&](const Index3& cell) { fillEdge(edges, cell, axis); });
    }
    forEachIndex(nodes, [&](const Index3& node) {
      const auto all = kindAround(node, extentOf(0));
      valueAt(out_.levelSet, nodes, node) =
          static_cast<T>(all == FluidClass::Fluid  ? -1
                         : all == FluidClass::Body ? 1
                                                   : parts_.levelSetAt(node));
    });
  }

 private:
  [[nodiscard]] FluidClass& kindAt(const Index3& cell) {
    return valueAt(GridView<FluidClass>::contiguous(kinds_.data(), around_), around_, cell);
  }
  /// In a plane, everything extends along z.
  [[nodiscard]] unsigned extentOf(unsigned axes) const {
    constexpr unsigned kAlongZ = 4;
    return parts_.dimensions() == 3 ? axes : axes | kAlongZ;
  }
  /// That of all cells that meet in a face, an edge or a node; Cut if they differ.
  [[nodiscard]] FluidClass kindAround(const Index3& at, unsigned extent) {
    const auto first = kindAt(at);
    for (unsigned corner = 1; corner < 8; ++corner) {
      if ((corner & extent) != 0) continue;
      auto cell = at;
      for (int axis = 0; axis < 3; ++axis) {
        along(cell, axis) -= static_cast<std::int32_t>(corner >> static_cast<unsigned>(axis) & 1U);
      }
      if (kindAt(cell) != first) return FluidClass::Cut;
    }
    return first;
  }

  void setVector(const std::array<GridView<T>, 3>& views, const Index3& cell,
                 const Vec3<double>& value) {
    for (int a = 0; a < parts_.dimensions(); ++a) {
      valueAt(views[asIndex(a)], box_, cell) = static_cast<T>(value[a]);
    }
  }

  void fillCell(const Index3& cell) {
    const auto kind = kindAt(cell);
    valueAt(out_.kind, box_, cell) = kind;
    if (kind == FluidClass::Cut) return fillCut(cell);
    valueAt(out_.volumeFraction, box_, cell) = static_cast<T>(kind == FluidClass::Fluid ? 1 : 0);
    valueAt(out_.wallArea, box_, cell) = 0;
    setVector(out_.centroid, cell, {});
    setVector(out_.wallCentroid, cell, {-1, -1, -1});
    setVector(out_.wallNormal, cell, {});
  }

  static Vec3<double> withinCell(const Vec3<double>& offset) {
    const auto clamped = [](double x) { return std::clamp(x, -0.5, 0.5); };
    return {clamped(offset.x), clamped(offset.y), clamped(offset.z)};
  }

  void fillCut(const Index3& cell) {
    const auto part = parts_.partOf(cell, Parts::kCell);
    const auto wall = parts_.wallOf(cell);
    valueAt(out_.volumeFraction, box_, cell) = static_cast<T>(part.share);
    setVector(out_.centroid, cell, withinCell(part.centroid));
    setVector(out_.wallCentroid, cell, withinCell(wall.centroid));
    // Of the open parts as they are rounded, so that they close.
    Vec3<double> vector;
    for (int axis = 0; axis < parts_.dimensions(); ++axis) {
      const auto& [low, high] = wall.open[asIndex(axis)];
      vector[axis] =
          static_cast<double>(static_cast<T>(low)) - static_cast<double>(static_cast<T>(high));
    }
    if (vector == Vec3<double>{}) vector = wall.vector;
    const auto face = faceAreas();
    const Vec3<double> area{vector.x * face.x, vector.y * face.y, vector.z * face.z};
    const auto normal = area / length(area);
    const Vec3<double> section{normal.x * face.x, normal.y * face.y, normal.z * face.z};
    valueAt(out_.wallArea, box_, cell) = static_cast<T>(length(area) / length(section));
    setVector(out_.wallNormal, cell, normal);
  }

  /// Of the box's first cell: areas of faces across each axis, over that of the largest.
  [[nodiscard]] Vec3<double> faceAreas() const {
    const auto& cells = parts_.merged().cells;
    Vec3<double> area;
    for (int axis = 0; axis < 3; ++axis) area[axis] = cells.faceArea(parts_.box().lo, axis);
    return area / std::max({area.x, area.y, area.z});
  }

  void fillFace(const IndexBox& faces, const Index3& cell, int axis) {
    const auto all = kindAround(cell, Parts::kCell & ~(1U << static_cast<unsigned>(axis)));
    const auto part = all == FluidClass::Fluid  ? Parts::Part{.share = 1}
                      : all == FluidClass::Body ? Parts::Part{}
                                                : parts_.partOfFace(cell, axis);
    const auto centroid = withinCell(part.centroid);
    valueAt(out_.aperture[asIndex(axis)], faces, cell) = static_cast<T>(part.share);
    const auto& views = out_.faceCentroid[asIndex(axis)];
    valueAt(views[0], faces, cell) = static_cast<T>(centroid[axis == 0 ? 1 : 0]);
    if (parts_.dimensions() < 3) return;
    valueAt(views[1], faces, cell) = static_cast<T>(centroid[axis == 2 ? 1 : 2]);
  }

  void fillEdge(const IndexBox& edges, const Index3& cell, int axis) {
    const auto extent = extentOf(1U << static_cast<unsigned>(axis));
    const auto all = kindAround(cell, extent);
    const auto part = all == FluidClass::Fluid  ? Parts::Part{.share = 1}
                      : all == FluidClass::Body ? Parts::Part{}
                                                : parts_.partOf(cell, extent);
    const double centroid = std::clamp(part.centroid[axis], -0.5, 0.5);
    valueAt(out_.edgeCentroid[asIndex(axis)], edges, cell) =
        static_cast<T>(part.share == 1   ? 1
                       : part.share == 0 ? -1
                                         : centroid);
  }

  const Parts& parts_;
  IndexBox box_;
  const SingleValuedFields<T>& out_;
  IndexBox around_;
  std::vector<FluidClass> kinds_;
};

std::shared_ptr<const Parts> finest(const CutCells& cells, const SingleValuedOptions& options) {
  require(options.isPlane || cells.arcPolygons.count() == cells.arcs.area.size(),
          "SingleValuedCells: need cells that were cut with polygons");
  const auto box = cells.grid.indices();
  for (int axis = 0; axis < 3; ++axis) {
    const auto period = cells.grid.period[asIndex(axis)];
    require(period == 0 || static_cast<std::size_t>(period) == box.length(axis),
            "SingleValuedCells: need all cells of a period", Named{"axis", axis});
  }
  return std::make_shared<const Parts>(merged(cells, {.smallest = options.smallest}),
                                       options.isPlane ? EdgeOpenings() : EdgeOpenings(cells),
                                       options);
}

}  // namespace

// Cells that are all fluid and all body are never side by side, so those of a line are alike if
// none is cut.
FluidClass classOf(const CutCells& cells, const IndexBox& box) {
  const auto key = [](const Index3& cell) { return std::tuple(cell.k, cell.j, cell.i); };
  const auto own = std::span(cells.cells.index).first(cells.cellCount);
  const auto first = cells.classOf(box.lo);
  for (auto k = box.lo.k; k <= box.hi.k; ++k) {
    for (auto j = box.lo.j; j <= box.hi.j; ++j) {
      const auto row = std::ranges::lower_bound(own, key({box.lo.i, j, k}), {}, key);
      const bool isAnyCut = row != own.end() && key(*row) <= key({box.hi.i, j, k});
      if (isAnyCut || cells.classOf({box.lo.i, j, k}) != first) return FluidClass::Cut;
    }
  }
  return first;
}

SingleValuedCells::SingleValuedCells(const CutCells& cells, const SingleValuedOptions& options)
    : parts_(finest(cells, options)) {}

SingleValuedCells::SingleValuedCells(std::shared_ptr<const SingleValuedParts> parts)
    : parts_(std::move(parts)) {}

bool SingleValuedCells::canCoarsen() const {
  const auto& box = parts_->box();
  for (int axis = 0; axis < parts_->dimensions(); ++axis) {
    if (along(box.lo, axis) % 2 != 0 || box.length(axis) % 2 != 0) return false;
  }
  return true;
}

SingleValuedCells SingleValuedCells::coarser() const {
  const auto& options = parts_->options();
  const auto coarse = coarsened(cells(), {2, 2, options.isPlane ? 1 : 2});
  return SingleValuedCells(std::make_shared<const Parts>(
      merged(coarse, {.smallest = options.smallest}), parts_->coarseEdges(coarse), options));
}

const CutCells& SingleValuedCells::cells() const {
  return parts_->merged().cells;
}

const std::vector<LostPiece>& SingleValuedCells::lost() const {
  return parts_->merged().lost;
}

double SingleValuedCells::newWallShare() const {
  const auto& parts = cells().wallParts;
  const auto covered = cells().patchNames.size() - 1;
  std::size_t walls = 0;
  std::size_t isNew = 0;
  for (std::size_t first = 0, last = 0; first < parts.piece.size(); first = last) {
    bool isAllNew = true;
    for (; last < parts.piece.size() && parts.piece[last] == parts.piece[first]; ++last) {
      isAllNew = isAllNew && parts.patch[last] == covered;
    }
    ++walls;
    isNew += isAllNew ? 1 : 0;
  }
  return walls > 0 ? static_cast<double>(isNew) / static_cast<double>(walls) : 0;
}

template <std::floating_point T>
void SingleValuedCells::fill(const IndexBox& box, const SingleValuedFields<T>& fields) const {
  Filling<T>(*parts_, box, fields).run();
}

template void SingleValuedCells::fill(const IndexBox&, const SingleValuedFields<float>&) const;
template void SingleValuedCells::fill(const IndexBox&, const SingleValuedFields<double>&) const;

}  // namespace cutwater
