#include <Cutwater/CutCells/Detail/Curved/CellLattice.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceAxes.hpp>

#include <algorithm>

namespace cutwater {

namespace {

/// Cubes of a cell along each axis.
constexpr int kPerSide = 2;

TilePlace stepped(TilePlace node, int axis, int step) {
  node[asIndex(axis)] += step;
  return node;
}

}  // namespace

void CellLattice::forTriangles(int axis, const TilePlace& cell,
                               FunctionRef<void(const Triangle&)> visit) const {
  const FaceAxes axes(axis);
  for (int n = 0; n < kPerSide * kPerSide; ++n) {
    auto first = firstNodeOf(cell);
    first[asIndex(axes.first)] += n % kPerSide * width_;
    first[asIndex(axes.second)] += n / kPerSide * width_;
    divide(axis, first, width_, visit);
  }
}

void CellLattice::forTetrahedra(const TilePlace& cell,
                                FunctionRef<void(const Tetrahedron&)> visit) const {
  forTilePlaces({kPerSide, kPerSide, kPerSide}, [&](const TilePlace& within) {
    auto first = firstNodeOf(cell);
    for (std::size_t a = 0; a < 3; ++a) first[a] += within[a] * width_;
    divide(first, visit);
  });
}

Vec3<double> CellLattice::pointOf(const TilePlace& node) const {
  Vec3<double> point;
  for (int axis = 0; axis < 3; ++axis) {
    const int plane = node[asIndex(axis)] / 2;
    point[axis] = planeAt(axis, plane);
    if (node[asIndex(axis)] % 2 != 0) point[axis] += 0.5 * (planeAt(axis, plane + 1) - point[axis]);
  }
  return point;
}

Vec3<double> CellLattice::shiftOf(const TilePlace& node) const {
  Vec3<double> shift;
  if (leaves_ != nullptr) return shift;  // which have no period
  for (int axis = 0; axis < 3; ++axis) {
    const int n = node[asIndex(axis)];
    if (n % kPerSide == 0) shift[axis] = planes_.shiftAt(axis, n / kPerSide);
  }
  return shift;
}

TilePlace CellLattice::firstNodeOf(TilePlace cell) const {
  for (auto& n : cell) n *= kPerSide * width_;
  return cell;
}

/// Nodes lie in these, and halfway between them.
double CellLattice::planeAt(int axis, int plane) const {
  return leaves_ != nullptr ? leaves_->plane(axis, plane) : planes_.at(axis, plane);
}

bool CellLattice::isDivided(const TilePlace& first, const TilePlace& lengths) const {
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
    if (isBeside && leaves_->isDivided(cell, below)) return true;
  }
  return false;
}

void CellLattice::addEdge(const TilePlace& first, int axis, int width,
                          std::vector<TilePlace>& to) const {
  if (!isDivided(first, stepped({}, axis, width))) {
    to.push_back(first);
    return;
  }
  addEdge(first, axis, width / 2, to);
  addEdge(stepped(first, axis, width / 2), axis, width / 2, to);
}

std::vector<TilePlace> CellLattice::rimOf(int axis, const TilePlace& first, int width) const {
  const FaceAxes axes(axis);
  const auto beside = stepped(first, axes.first, width);
  const auto above = stepped(first, axes.second, width);
  std::vector<TilePlace> rim;
  std::vector<TilePlace> back;
  addEdge(first, axes.first, width, rim);
  addEdge(beside, axes.second, width, rim);
  addEdge(first, axes.second, width, back);
  addEdge(above, axes.first, width, back);
  back.push_back(stepped(above, axes.first, width));
  rim.insert(rim.end(), back.rbegin(), back.rend() - 1);
  return rim;
}

void CellLattice::divide(int axis, const TilePlace& first, int width,
                         FunctionRef<void(const Triangle&)> visit) const {
  const FaceAxes axes(axis);
  const auto at = [&](int along, int across) {
    return stepped(stepped(first, axes.first, along), axes.second, across);
  };
  const int half = width / 2;
  if (isDivided(first, stepped(stepped({}, axes.first, width), axes.second, width))) {
    for (const int across : {0, half}) {
      for (const int along : {0, half}) divide(axis, at(along, across), half, visit);
    }
    return;
  }
  const auto rim = leaves_ != nullptr ? rimOf(axis, first, width) : std::vector<TilePlace>();
  if (rim.size() <= 4) {
    visit({first, at(width, 0), at(width, width)});
    visit({first, at(width, width), at(0, width)});
    return;
  }
  for (std::size_t i = 0; i < rim.size(); ++i) {
    visit({at(half, half), rim[i], rim[(i + 1) % rim.size()]});
  }
}

void CellLattice::divide(const TilePlace& first,
                         FunctionRef<void(const Tetrahedron&)> visit) const {
  constexpr std::array<std::array<int, 3>, 6> kWays{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  constexpr std::size_t kOfWholeCube = 12;
  std::vector<Triangle> surface;
  if (leaves_ != nullptr) {
    surface.reserve(2 * kOfWholeCube);
    const auto add = [&](const Triangle& triangle) { surface.push_back(triangle); };
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, width_}) divide(axis, stepped(first, axis, side), width_, add);
    }
  }
  if (surface.size() > kOfWholeCube) {
    auto middle = first;
    for (auto& n : middle) n += width_ / 2;
    for (const auto& [a, b, c] : surface) visit({middle, a, b, c});
    return;
  }
  for (const auto& way : kWays) {
    Tetrahedron nodes{first};
    for (std::size_t i = 0; i < 3; ++i) nodes[i + 1] = stepped(nodes[i], way[i], width_);
    visit(nodes);
  }
}

}  // namespace cutwater
