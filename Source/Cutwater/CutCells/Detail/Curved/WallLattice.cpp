#include <Cutwater/Core/Detail/MixedBits.hpp>
#include <Cutwater/CutCells/Detail/Curved/WallLattice.hpp>
#include <Cutwater/CutCells/Detail/Faces/EdgeLoops.hpp>
#include <Cutwater/CutCells/Detail/Faces/JoinedLoops.hpp>
#include <Cutwater/CutCells/Detail/Rows/PieceRows.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace cutwater {

namespace {

/// Leaves out corners within an edge of the face: the faces around it have no others there than
/// ends of the wall.
EdgeLoops::Loop withoutNodesOfEdges(const EdgeLoops::Loop& loop, const Box<double>& face,
                                    int across) {
  EdgeLoops::Loop kept;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto& before = loop[(i + loop.size() - 1) % loop.size()];
    const auto& after = loop[(i + 1) % loop.size()];
    const auto isWithinEdge = [&](int axis) {
      const double at = loop[i][axis];
      return axis != across && (at == face.lower[axis] || at == face.upper[axis]) &&
             before[axis] == at && after[axis] == at;
    };
    if (!isWithinEdge(0) && !isWithinEdge(1) && !isWithinEdge(2)) kept.push_back(loop[i]);
  }
  return kept;
}

}  // namespace

std::size_t WallLattice::Hash::operator()(const TilePlace& node) const {
  std::uint64_t hash = 0;
  for (const auto n : node) hash = detail::mixed(hash ^ static_cast<std::uint32_t>(n));
  return hash;
}

std::size_t WallLattice::Hash::operator()(const Edge& edge) const {
  return 31 * (*this)(edge[0]) + (*this)(edge[1]);
}

double WallLattice::valueAt(const TilePlace& node) {
  const auto [known, isNew] = values_.try_emplace(node);
  if (isNew) known->second = field_.value(lattice_.pointOf(node) - lattice_.shiftOf(node));
  return known->second;
}

/// Where the wall passes through an edge, by some steps of the Illinois method (Dowell and Jarratt
/// 1971).
const Vec3<double>& WallLattice::crossing(TilePlace from, TilePlace to) {
  constexpr int kSteps = 12;
  constexpr double kNear = 1e-8;  // of the edge
  const auto isAfter = [](const TilePlace& a, const TilePlace& b) {
    return std::tie(a[2], a[1], a[0]) > std::tie(b[2], b[1], b[0]);
  };
  if (isAfter(from, to)) std::swap(from, to);
  const auto [known, isNew] = crossings_.try_emplace({from, to});
  if (!isNew) return known->second;
  const auto shift =
      min(lattice_.shiftOf(from), lattice_.shiftOf(to));  // along axes on which both are beyond it
  const auto start = lattice_.pointOf(from) - shift;
  const auto way = lattice_.pointOf(to) - shift - start;
  double low = 0;
  double high = 1;
  double lowValue = valueAt(from);
  double highValue = valueAt(to);
  double at = 0;
  int lastSide = 0;
  for (int step = 0; step < kSteps; ++step) {
    at = low + (high - low) * (lowValue / (lowValue - highValue));
    const double value = field_.value(start + at * way);
    if (std::abs(value) <= kNear * length(way) || !(at > low && at < high)) break;
    const int side = (value > 0) == (lowValue > 0) ? 1 : -1;
    if (side == lastSide) (side > 0 ? highValue : lowValue) *= 0.5;
    (side > 0 ? low : high) = at;
    (side > 0 ? lowValue : highValue) = value;
    lastSide = side;
  }
  known->second = start + at * way + shift;
  // In the planes that both ends lie in, and at an end to the bit.
  for (int axis = 0; axis < 3; ++axis) {
    if (at == 1 || way[axis] == 0) known->second[axis] = lattice_.pointOf(to)[axis];
  }
  return known->second;
}

void WallLattice::addOutlines(int axis, const TilePlace& cell, const CurvedFace& face,
                              CutCells::Polygons& to) {
  const FaceAxes axes(axis);
  std::vector<EdgeLoops> ofParts(face.parts.size());
  const auto add = [&](const CellLattice::Triangle& nodes) {
    EdgeLoops::Loop polygon;
    const TilePlace* inFluid = nullptr;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& node = nodes[i];
      const auto& next = nodes[(i + 1) % 3];
      if (isFluid(node)) {
        polygon.push_back(lattice_.pointOf(node));
        inFluid = &node;
      }
      if (isFluid(node) != isFluid(next)) polygon.push_back(crossing(node, next));
    }
    if (inFluid == nullptr) return;
    ofParts[face.partAt(lattice_.pointOf(*inFluid))].add(polygon);
  };
  lattice_.forTriangles(axis, cell, add);
  Box<double> box;
  for (int a = 0; a < 3; ++a) {
    const int plane = cell[asIndex(a)];
    box.lower[a] = planes_.at(a, plane);
    box.upper[a] = planes_.at(a, a == axis ? plane : plane + 1);  // the face may be the last one
  }
  for (auto& edges : ofParts) {
    auto loops = edges.loopsAcross(axis);
    for (auto& loop : loops) loop = withoutNodesOfEdges(loop, box, axis);
    std::erase_if(loops, [](const EdgeLoops::Loop& loop) { return loop.size() < 3; });
    to.add(joinedLoops(axes, std::move(loops)));
  }
}

void WallLattice::addWalls(const TilePlace& cell,
                           FunctionRef<std::uint32_t(const Vec3<double>& point)> pieceAt,
                           const CellPieces& pieces, TilePolygons& to) {
  struct OfWall {
    std::pair<std::uint32_t, std::uint32_t> wall;  // piece and patch
    const Triangle* triangle;
  };
  std::vector<Triangle> triangles;
  lattice_.forTetrahedra(
      cell, [&](const CellLattice::Tetrahedron& nodes) { addTetrahedron(nodes, triangles); });
  std::vector<OfWall> found;
  for (const auto& triangle : triangles) {
    const auto piece = pieceAt(triangle.inFluid);
    const auto walls = wallsOf(pieces, piece);
    if (walls.empty()) continue;
    const auto& [a, b, c] = triangle.corners;
    const auto patch = walls.size() > 1 ? field_.owner((a + b + c) / 3.0).patch : 0;
    const auto same = std::ranges::find(walls, patch, &PieceWall::patch);
    const auto& wall = same != walls.end() ? *same : walls.front();
    found.push_back({{piece, wall.patch}, &triangle});
  }
  std::ranges::stable_sort(found, {}, &OfWall::wall);
  for (const auto& [wall, triangle] : found) {
    to.walls.add(triangle->corners);
    to.wallOf.push_back(wall);
    to.fragmentOf.push_back(kNone);
  }
}

void WallLattice::addTetrahedron(const CellLattice::Tetrahedron& nodes, std::vector<Triangle>& to) {
  const auto isHere = [&](const TilePlace& node) { return isFluid(node); };
  const auto count = std::ranges::count_if(nodes, isHere);
  if (count == 0 || count == 4) return;
  std::vector<TilePlace> fluid;
  std::vector<TilePlace> body;
  for (const auto& node : nodes) (isFluid(node) ? fluid : body).push_back(node);
  // Around the wall, in an order along which one end of the edge changes at a time.
  std::vector<Vec3<double>> rim;
  if (fluid.size() == 2) {
    rim = {crossing(fluid[0], body[0]), crossing(fluid[0], body[1]), crossing(fluid[1], body[1]),
           crossing(fluid[1], body[0])};
  } else {
    for (const auto& f : fluid) {
      for (const auto& b : body) rim.push_back(crossing(f, b));
    }
  }
  // Points may coincide in nodes; the nodes tell which way is into the fluid.
  const auto middleOf = [&](const std::vector<TilePlace>& some) {
    Vec3<double> sum;
    for (const auto& node : some) sum += lattice_.pointOf(node);
    return sum / static_cast<double>(some.size());
  };
  const auto across = middleOf(fluid) - middleOf(body);
  Vec3<double> normal;
  for (std::size_t i = 1; i + 1 < rim.size(); ++i) {
    normal += cross(rim[i] - rim[0], rim[i + 1] - rim[0]);
  }
  if (dot(normal, across) < 0) std::ranges::reverse(rim);
  for (std::size_t i = 1; i + 1 < rim.size(); ++i) {
    const Triangle triangle{{rim[0], rim[i], rim[i + 1]}, lattice_.pointOf(fluid.front())};
    const auto& [a, b, c] = triangle.corners;
    if (a != b && b != c && c != a) to.push_back(triangle);
  }
}

}  // namespace cutwater
