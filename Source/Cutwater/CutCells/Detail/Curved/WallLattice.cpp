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

/// Cubes of a cell along each axis.
constexpr int kPerSide = 2;

TilePlace stepped(TilePlace node, int axis, int step) {
  node[asIndex(axis)] += step;
  return node;
}

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
  constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15;  // Knuth: 2^64 by the golden ratio
  std::uint64_t sum = 0;
  for (const auto n : node) sum = (sum ^ static_cast<std::uint32_t>(n)) * kOdd;
  return sum ^ sum >> 32U;
}

std::size_t WallLattice::Hash::operator()(const Edge& edge) const {
  return 31 * (*this)(edge[0]) + (*this)(edge[1]);
}

WallLattice::WallLattice(const FluidField& field, const GridPlanes& planes,
                         const LeavesAround* leaves)
    : field_(field),
      planes_(planes),
      leaves_(leaves),
      width_(leaves != nullptr ? 1 << leaves->levels : 1) {
  if (leaves == nullptr) return;
  auto sizes = planes.sizes();
  for (auto& n : sizes) n += 2;
  around_ = TileSizes(sizes);
  forTilePlaces(sizes, [&](TilePlace cell) {
    for (auto& n : cell) --n;
    dividedCells_.push_back(leaves->isDivided(cell, 0) ? 1 : 0);
  });
}

bool WallLattice::isDividedCell(const TilePlace& cell, int below) const {
  if (below > 0) return leaves_->isDivided(cell, below);
  return dividedCells_[around_.number({cell[0] + 1, cell[1] + 1, cell[2] + 1})] != 0;
}

TilePlace WallLattice::firstNodeOf(TilePlace cell) const {
  for (auto& n : cell) n *= kPerSide * width_;
  return cell;
}

/// Nodes lie in these, and halfway between them.
double WallLattice::planeAt(int axis, int plane) const {
  return leaves_ != nullptr ? leaves_->plane(axis, plane) : planes_.at(axis, plane);
}

Vec3<double> WallLattice::pointOf(const TilePlace& node) const {
  Vec3<double> point;
  for (int axis = 0; axis < 3; ++axis) {
    const int plane = node[asIndex(axis)] / 2;
    point[axis] = planeAt(axis, plane);
    if (node[asIndex(axis)] % 2 != 0) point[axis] += 0.5 * (planeAt(axis, plane + 1) - point[axis]);
  }
  return point;
}

Vec3<double> WallLattice::shiftOf(const TilePlace& node) const {
  Vec3<double> shift;
  if (leaves_ != nullptr) return shift;  // which have no period
  for (int axis = 0; axis < 3; ++axis) {
    const int n = node[asIndex(axis)];
    if (n % kPerSide == 0) shift[axis] = planes_.shiftAt(axis, n / kPerSide);
  }
  return shift;
}

double WallLattice::valueAt(const TilePlace& node) {
  const auto [known, isNew] = values_.try_emplace(node);
  if (isNew) known->second = field_.value(pointOf(node) - shiftOf(node));
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
  const auto shift = min(shiftOf(from), shiftOf(to));  // along axes on which both are beyond it
  const auto start = pointOf(from) - shift;
  const auto way = pointOf(to) - shift - start;
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
    if (at == 1 || way[axis] == 0) known->second[axis] = pointOf(to)[axis];
  }
  return known->second;
}

bool WallLattice::isDivided(const TilePlace& first, const TilePlace& lengths) const {
  const int width = *std::ranges::max_element(lengths);
  if (leaves_ == nullptr || width == 1) return false;
  // A leaf is as wide as two of its cubes, and its edges and faces have their nodes: so they are
  // divided if cells around them are that are twice as wide as they.
  int below = 0;
  for (int wide = width_; wide > width; wide /= 2) ++below;
  if (below >= leaves_->levels) return false;
  for (unsigned side = 0; side < 8; ++side) {
    auto cell = first;
    bool isBeside = true;
    for (std::size_t a = 0; a < 3; ++a) {
      const bool isLower = (side >> a & 1U) != 0;
      if (isLower) cell[a] -= width;
      isBeside = isBeside && !(isLower && lengths[a] > 0);
      cell[a] = cell[a] < 0 ? -1 : cell[a] / (2 * width);
    }
    if (isBeside && isDividedCell(cell, below)) return true;
  }
  return false;
}

void WallLattice::addEdge(const TilePlace& first, int axis, int width,
                          std::vector<TilePlace>& to) const {
  if (!isDivided(first, stepped({}, axis, width))) {
    to.push_back(first);
    return;
  }
  addEdge(first, axis, width / 2, to);
  addEdge(stepped(first, axis, width / 2), axis, width / 2, to);
}

template <typename Visit>
void WallLattice::forTriangles(int axis, const TilePlace& first, int width,
                               const Visit& visit) const {
  const FaceAxes axes(axis);
  if (isDivided(first, stepped(stepped({}, axes.first, width), axes.second, width))) {
    const int half = width / 2;
    for (const int across : {0, half}) {
      for (const int along : {0, half}) {
        const auto corner = stepped(stepped(first, axes.first, along), axes.second, across);
        forTriangles(axis, corner, half, visit);
      }
    }
    return;
  }
  const auto beside = stepped(first, axes.first, width);
  const auto above = stepped(first, axes.second, width);
  const auto opposite = stepped(beside, axes.second, width);
  std::vector<TilePlace> rim;
  if (leaves_ != nullptr) {
    std::vector<TilePlace> back;
    addEdge(first, axes.first, width, rim);
    addEdge(beside, axes.second, width, rim);
    addEdge(first, axes.second, width, back);
    addEdge(above, axes.first, width, back);
    back.push_back(opposite);
    rim.insert(rim.end(), back.rbegin(), back.rend() - 1);
  }
  if (rim.size() <= 4) {
    visit(std::array{first, beside, opposite});
    visit(std::array{first, opposite, above});
    return;
  }
  const auto middle = stepped(stepped(first, axes.first, width / 2), axes.second, width / 2);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    visit(std::array{middle, rim[i], rim[(i + 1) % rim.size()]});
  }
}

void WallLattice::addOutlines(int axis, const TilePlace& cell, const CurvedFace& face,
                              CutCells::Polygons& to) {
  const FaceAxes axes(axis);
  std::vector<EdgeLoops> ofParts(face.parts.size());
  const auto add = [&](const std::array<TilePlace, 3>& nodes) {
    EdgeLoops::Loop polygon;
    const TilePlace* inFluid = nullptr;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& node = nodes[i];
      const auto& next = nodes[(i + 1) % 3];
      if (isFluid(node)) {
        polygon.push_back(pointOf(node));
        inFluid = &node;
      }
      if (isFluid(node) != isFluid(next)) polygon.push_back(crossing(node, next));
    }
    if (inFluid == nullptr) return;
    ofParts[face.partAt(pointOf(*inFluid))].add(polygon);
  };
  for (int n = 0; n < kPerSide * kPerSide; ++n) {
    auto first = firstNodeOf(cell);
    first[asIndex(axes.first)] += n % kPerSide * width_;
    first[asIndex(axes.second)] += n / kPerSide * width_;
    forTriangles(axis, first, width_, add);
  }
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
  const auto triangles = wallIn(cell);
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

std::vector<WallLattice::Triangle> WallLattice::wallIn(const TilePlace& cell) {
  std::vector<Triangle> triangles;
  forTilePlaces({kPerSide, kPerSide, kPerSide}, [&](const TilePlace& within) {
    auto first = firstNodeOf(cell);
    for (std::size_t a = 0; a < 3; ++a) first[a] += within[a] * width_;
    addCube(first, triangles);
  });
  return triangles;
}

void WallLattice::addCube(const TilePlace& first, std::vector<Triangle>& to) {
  constexpr std::array<std::array<int, 3>, 6> kWays{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  constexpr std::size_t kOfWholeCube = 12;
  std::vector<std::array<TilePlace, 3>> surface;
  if (leaves_ != nullptr) {
    surface.reserve(2 * kOfWholeCube);
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, width_}) {
        forTriangles(axis, stepped(first, axis, side), width_,
                     [&](const std::array<TilePlace, 3>& nodes) { surface.push_back(nodes); });
      }
    }
  }
  if (surface.size() > kOfWholeCube) {
    auto middle = first;
    for (auto& n : middle) n += width_ / 2;
    for (const auto& [a, b, c] : surface) addTetrahedron({middle, a, b, c}, to);
    return;
  }
  int fluid = 0;
  forTilePlaces({2, 2, 2}, [&](TilePlace corner) {
    for (std::size_t a = 0; a < 3; ++a) corner[a] = first[a] + corner[a] * width_;
    fluid += isFluid(corner) ? 1 : 0;
  });
  if (fluid == 0 || fluid == 8) return;
  for (const auto& way : kWays) {
    std::array<TilePlace, 4> nodes{first};
    for (std::size_t i = 0; i < 3; ++i) nodes[i + 1] = stepped(nodes[i], way[i], width_);
    addTetrahedron(nodes, to);
  }
}

void WallLattice::addTetrahedron(const std::array<TilePlace, 4>& nodes, std::vector<Triangle>& to) {
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
    for (const auto& node : some) sum += pointOf(node);
    return sum / static_cast<double>(some.size());
  };
  const auto across = middleOf(fluid) - middleOf(body);
  Vec3<double> normal;
  for (std::size_t i = 1; i + 1 < rim.size(); ++i) {
    normal += cross(rim[i] - rim[0], rim[i + 1] - rim[0]);
  }
  if (dot(normal, across) < 0) std::ranges::reverse(rim);
  for (std::size_t i = 1; i + 1 < rim.size(); ++i) {
    const Triangle triangle{{rim[0], rim[i], rim[i + 1]}, pointOf(fluid.front())};
    const auto& [a, b, c] = triangle.corners;
    if (a != b && b != c && c != a) to.push_back(triangle);
  }
}

}  // namespace cutwater
