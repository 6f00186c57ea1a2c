#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/Detail/CellLayer.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cutwater::detail {

namespace {

/// Of the way to a wall: walls that are so near to each other are the sides of a sheet.
constexpr double kSheet = 1e-9;

PlanePoint operator-(const PlanePoint& a, const PlanePoint& b) {
  return {a[0] - b[0], a[1] - b[1]};
}
PlanePoint between(const PlanePoint& a, const PlanePoint& b) {
  return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
}
double product(const PlanePoint& a, const PlanePoint& b) {
  return a[0] * b[0] + a[1] * b[1];
}
double crossProduct(const PlanePoint& a, const PlanePoint& b) {
  return a[0] * b[1] - a[1] * b[0];
}

std::int32_t& along(Index3& index, int axis) {
  return axis == 0 ? index.i : axis == 1 ? index.j : index.k;
}
std::int32_t along(const Index3& index, int axis) {
  return axis == 0 ? index.i : axis == 1 ? index.j : index.k;
}

void requireAxis(int axis) {
  require(axis >= 0 && axis <= 2, "renderCells: need an axis 0, 1 or 2", Named{"axis", axis});
}

void requirePolygons(const CellRows& rows) {
  require(rows.pieceCount() == 0 || !rows.firstWallPolygon().empty(),
          "renderCells: need cells that were cut with their polygons");
}

Vec3<double> areaVector(std::span<const Vec3<double>> polygon) {
  Vec3<double> area;
  for (std::size_t n = 2; n < polygon.size(); ++n) {
    area += 0.5 * cross(polygon[n - 1] - polygon[0], polygon[n] - polygon[0]);
  }
  return area;
}

Vec3<double> meanOf(std::span<const Vec3<double>> polygon) {
  Vec3<double> sum;
  for (const auto& p : polygon) sum += p;
  return sum / static_cast<double>(polygon.size());
}

/// Where a line from p by `way` passes through a convex polygon: the share of the way.
std::optional<double> passage(const Vec3<double>& p, const Vec3<double>& way,
                              std::span<const Vec3<double>> polygon, const Vec3<double>& normal) {
  const double slope = dot(way, normal);
  if (slope == 0) return {};
  const double share = dot(polygon[0] - p, normal) / slope;
  const auto at = p + share * way;
  for (std::size_t n = 0; n < polygon.size(); ++n) {
    const auto& a = polygon[n];
    const auto& b = polygon[(n + 1) % polygon.size()];
    if (dot(cross(b - a, at - a), normal) < 0) return {};
  }
  return share;
}

/// The same for a segment.
std::optional<double> passage(const PlanePoint& p, const PlanePoint& way,
                              const WallSegment& segment) {
  const auto edge = segment.to - segment.from;
  const double slope = crossProduct(way, edge);
  if (slope == 0) return {};
  const auto start = segment.from - p;
  const double onEdge = crossProduct(start, way) / slope;
  if (onEdge < 0 || onEdge > 1) return {};
  return crossProduct(start, edge) / slope;
}

}  // namespace

CellSide SectionedCell::at(const PlanePoint& p) const {
  if (segments.empty()) return side;
  // Towards the segment that is met least at a slant, if nothing comes before it.
  const WallSegment* target = segments.data();
  double steepest = -1;
  for (const auto& segment : segments) {
    const auto way = between(segment.from, segment.to) - p;
    const double size = std::sqrt(product(way, way) * product(segment.normal, segment.normal));
    const double steepness = size > 0 ? std::abs(product(way, segment.normal)) / size : 0;
    if (steepness <= steepest) continue;
    steepest = steepness;
    target = &segment;
  }
  const auto way = between(target->from, target->to) - p;
  double first = 1;
  for (const auto& segment : segments) {
    const auto share = passage(p, way, segment);
    if (!share || *share < 0 || *share >= first + kSheet) continue;
    // The sides of a baffle are at one place: the one that faces the point is met.
    const bool isFacing = product(way, segment.normal) < 0;
    if (*share > first - kSheet && !isFacing) continue;
    first = std::min(first, *share);
    target = &segment;
  }
  return {product(way, target->normal) < 0, target->piece};
}

CellLayer::CellLayer(const CutCells& cells, int axis, std::int32_t index)
    : rows_(cells),
      grid_(&cells),
      axis_(axis),
      index_(index),
      right_(axis == 0 ? 1 : 0),
      up_(axis == 2 ? 1 : 2) {
  requireAxis(axis);
  const auto box = cells.grid.indices();
  require(index >= along(box.lo, axis) && index <= along(box.hi, axis),
          "renderCells: need a layer of the cells", Named{"layer", index},
          Named{"first", along(box.lo, axis)}, Named{"last", along(box.hi, axis)});
  requirePolygons(rows_);
  const auto& planes = cells.grid.planes[static_cast<std::size_t>(axis)];
  const auto n = static_cast<std::size_t>(std::int64_t{index} - along(box.lo, axis) + 1);
  middle_ = 0.5 * (planes[n] + planes[n + 1]);
  window_ = {inPlane(cells.boxOf(box.lo).lower), inPlane(cells.boxOf(box.hi).upper)};
  for (std::uint32_t row = 0; row < cells.cellCount; ++row) {
    if (along(cells.cells.index[row], axis) == index) addSection(row);
  }
}

template <std::floating_point T>
CellLayer::CellLayer(const CutLeaves& leaves, const OctreeCells<T>& mesh, int axis, double at)
    : rows_(leaves), axis_(axis), right_(axis == 0 ? 1 : 0), up_(axis == 2 ? 1 : 2), middle_(at) {
  requireAxis(axis);
  require(leaves.classes.size() == mesh.cells().size(),
          "renderCells: need the octree whose leaves were cut",
          Named{"leaves", leaves.classes.size()}, Named{"cells", mesh.cells().size()});
  requirePolygons(rows_);
  Box<double> around;
  for (std::uint32_t leaf = 0; leaf < leaves.classes.size(); ++leaf) {
    const auto bounds = mesh.box(mesh.cells()[leaf]);
    const Box<double> box{Vec3<double>(bounds.lower), Vec3<double>(bounds.upper)};
    if (!(box.lower[axis] <= at && at < box.upper[axis])) continue;
    const auto row = leaves.rowOf(leaf);
    leaves_.push_back(
        {{inPlane(box.lower), inPlane(box.upper)}, row, leaves.classes[leaf] == FluidClass::Fluid});
    around.extend(box.lower);
    around.extend(box.upper);
    if (row != CutLeaves::kNoRow) addSection(row);
  }
  require(!leaves_.empty(), "renderCells: need leaves in the plane", Named{"axis", axis},
          Named{"at", at});
  window_ = {inPlane(around.lower), inPlane(around.upper)};
}
template CellLayer::CellLayer(const CutLeaves&, const OctreeCells<float>&, int, double);
template CellLayer::CellLayer(const CutLeaves&, const OctreeCells<double>&, int, double);

void CellLayer::eachCell(FunctionRef<void(const ShownCell&)> use) const {
  for (const auto& leaf : leaves_) use(leaf);
  if (grid_ == nullptr) return;
  auto box = grid_->grid.indices();
  along(box.lo, axis_) = along(box.hi, axis_) = index_;
  forEachIndex(box, [&](const Index3& cell) {
    const auto bounds = grid_->boxOf(cell);
    use({{inPlane(bounds.lower), inPlane(bounds.upper)},
         grid_->rowOf(cell),
         grid_->classOf(cell) == FluidClass::Fluid});
  });
}

SliceWindow<double> CellLayer::rectangle(std::uint32_t row) const {
  const auto box = rows_.boxOf(row);
  return {inPlane(box.lower), inPlane(box.upper)};
}

const SectionedCell& CellLayer::section(std::uint32_t row) const {
  return *std::ranges::lower_bound(sections_, row, {}, &SectionedCell::row);
}

void CellLayer::addSection(std::uint32_t row) {
  SectionedCell cell{.row = row, .segments = {}, .side = {}};
  const auto parts = rows_.wallParts();
  const auto firstPolygon = rows_.firstWallPolygon();
  for (auto piece = rows_.firstPiece(row); piece < rows_.firstPiece(row + 1); ++piece) {
    const auto [first, last] = std::equal_range(parts.begin(), parts.end(), piece);
    const auto from = static_cast<std::size_t>(first - parts.begin());
    const auto to = static_cast<std::size_t>(last - parts.begin());
    for (auto n = firstPolygon[from]; n < firstPolygon[to]; ++n) {
      addSegment(rows_.wallPolygons().of(n), piece, cell);
    }
  }
  if (cell.segments.empty()) cell.side = sideOf(cell);
  sections_.push_back(std::move(cell));
}

/// Corners in the plane count as above it, so that neighbours agree.
void CellLayer::addSegment(std::span<const Vec3<double>> polygon, std::uint32_t piece,
                           SectionedCell& to) {
  std::array<PlanePoint, 2> ends{};
  std::size_t count = 0;
  for (std::size_t n = 0; n < polygon.size() && count < 2; ++n) {
    const auto& a = polygon[n];
    const auto& b = polygon[(n + 1) % polygon.size()];
    const double above = a[axis_] - middle_;
    const double next = b[axis_] - middle_;
    if ((above >= 0) == (next >= 0)) continue;
    ends[count++] = inPlane(a + above / (above - next) * (b - a));
  }
  if (count != 2 || ends[0] == ends[1]) return;
  const auto normal = areaVector(polygon);
  if (normal[right_] == 0 && normal[up_] == 0) return;
  to.segments.push_back({ends[0], ends[1], inPlane(normal), piece});
}

/// Of a cell whose wall does not meet the plane: from the middle of its part of it towards the
/// wall.
CellSide CellLayer::sideOf(const SectionedCell& cell) const {
  const auto first = rows_.firstPiece(cell.row);
  const auto last = rows_.firstPiece(cell.row + std::size_t{1});
  const auto parts = rows_.wallParts();
  const auto firstPolygon = rows_.firstWallPolygon();
  const auto from = std::ranges::lower_bound(parts, first) - parts.begin();
  const auto to = std::ranges::lower_bound(parts, last) - parts.begin();
  auto center = rows_.boxOf(cell.row).center();
  center[axis_] = middle_;
  std::optional<Vec3<double>> way;
  CellSide found{.isFluid = first < last, .piece = first < last ? first : CutCells::kNoRow};
  double nearest = std::numeric_limits<double>::infinity();
  for (auto part = from; part < to; ++part) {
    const auto p = static_cast<std::size_t>(part);
    for (auto n = firstPolygon[p]; n < firstPolygon[p + 1]; ++n) {
      const auto polygon = rows_.wallPolygons().of(n);
      const auto normal = areaVector(polygon);
      if (!(dot(normal, normal) > 0)) continue;
      if (!way) way = meanOf(polygon) - center;
      const auto share = passage(center, *way, polygon, normal);
      if (!share || *share < 0 || *share >= nearest + kSheet) continue;
      const bool isFacing = dot(*way, normal) < 0;
      if (*share > nearest - kSheet && !isFacing) continue;
      nearest = std::min(nearest, *share);
      found = {isFacing, parts[p]};
    }
  }
  return found;
}

}  // namespace cutwater::detail
