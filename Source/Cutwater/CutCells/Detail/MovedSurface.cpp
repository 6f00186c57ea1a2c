#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/Detail/MovedSurface.hpp>
#include <Cutwater/CutCells/Detail/SidePairs.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace cutwater {

namespace {

using Corners = MovedSurface::Corners;

/// Rounding leaves a component of a normal, a sum of unit vectors times angles, below this.
constexpr double kZero = 1e-12;

/// Side i of triangle t is number 3 t + i, from corner i to the next.
std::uint32_t startOf(std::span<const Corners> triangles, std::uint32_t side) {
  return triangles[side / 3][side % 3];
}
std::uint32_t endOf(std::span<const Corners> triangles, std::uint32_t side) {
  return triangles[side / 3][(side % 3 + 1) % 3];
}
std::uint32_t oppositeOf(std::span<const Corners> triangles, std::uint32_t side) {
  return triangles[side / 3][(side % 3 + 2) % 3];
}

DoubleDouble3 exactWay(const Vec3<double>& from, const Vec3<double>& to) {
  return {exactDifference(to.x, from.x), exactDifference(to.y, from.y),
          exactDifference(to.z, from.z)};
}

/// Where a triangle that lies across the axis faces along it: 1 or -1; else 0.
int facing(const std::array<Vec3<double>, 3>& t, int axis) {
  const double at = t[0][axis];
  if (t[1][axis] != at || t[2][axis] != at) return 0;
  return crossSign(t[0], t[1], t[0], t[2], axis);
}

}  // namespace

MovedSurface::MovedSurface(std::span<const Vec3<double>> positions,
                           std::span<const Corners> triangles)
    : corners_(triangles.begin(), triangles.end()), meshTriangles_(triangles.size()) {
  vertices_.reserve(positions.size());
  for (const auto& p : positions) vertices_.push_back({.position = p});
  numberEdges();
  moveVertices();
}

void MovedSurface::numberEdges() {
  std::vector<std::uint32_t> order(3 * corners_.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto ends = [&](std::uint32_t side) {
    return std::minmax({startOf(corners_, side), endOf(corners_, side)});
  };
  std::ranges::sort(order, {}, [&](std::uint32_t side) { return std::pair(ends(side), side); });
  edges_.resize(corners_.size());
  const auto number = [&](std::uint32_t one, std::uint32_t other) {
    edges_[one / 3][one % 3] = edges_[other / 3][other % 3] = edgeCount_++;
  };
  for (std::size_t first = 0; first < order.size();) {
    const auto [p, q] = ends(order[first]);
    const auto isForward = [&, from = p](std::uint32_t side) {
      return startOf(corners_, side) == from;
    };
    auto last = first + 1;
    while (last < order.size() && ends(order[last]) == std::pair(p, q)) ++last;
    const auto sides = std::span(order).subspan(first, last - first);
    if (2 * static_cast<std::size_t>(std::ranges::count_if(sides, isForward)) != sides.size()) {
      throw Error(ErrorKind::Topology, "cut cells: the surface is not closed");
    }
    if (sides.size() == 2) {
      number(sides[0], sides[1]);
    } else {
      std::vector<SideAtEdge> around;
      const auto& origin = vertices_[p].position;
      for (const auto side : sides) {
        const auto& far = vertices_[oppositeOf(corners_, side)].position;
        around.push_back({side, isForward(side), exactWay(origin, far)});
      }
      for (const auto& [one, other] :
           pairedAround(exactWay(origin, vertices_[q].position), std::move(around))) {
        number(one, other);
      }
    }
    first = last;
  }
}

/// Gives walls at saddles their own copies of vertices.
class MovedSurface::SaddleSplit {
 public:
  explicit SaddleSplit(MovedSurface& surface)
      : surface_(surface), vertexCount_(static_cast<std::uint32_t>(surface.vertices_.size())) {}

  /// Takes the vertices at which walls across an axis face both ways, and the axes.
  void run(std::span<const Saddle> saddles) {
    findPartners();
    for (const auto& [vertex, axis] : saddles) cornersAt_[vertex];
    for (std::uint32_t side = 0; side < partner_.size(); ++side) {
      const auto found = cornersAt_.find(startOf(surface_.corners_, side));
      if (found != cornersAt_.end()) found->second.push_back(side);
    }
    for (const auto& saddle : saddles) decide(saddle);
    for (const auto& [corner, flips] : flips_) moveCorner(corner, flips);
    closeEdges();
    closeCopies();
  }

 private:
  using Two = std::pair<std::uint32_t, std::uint32_t>;
  /// A side from one copy of a vertex to another that has no partner yet.
  struct OpenSide {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::uint32_t side = 0;
    DoubleDouble3 way;  ///< to the third corner of its triangle
  };

  void findPartners() {
    std::vector<std::uint32_t> seen(surface_.edgeCount_, kNone);
    partner_.resize(3 * surface_.meshTriangles_);
    for (std::uint32_t side = 0; side < partner_.size(); ++side) {
      auto& other = seen[edgeOf(side)];
      if (other == kNone) {
        other = side;
      } else {
        partner_[side] = other;
        partner_[other] = side;
      }
    }
  }

  /// Lets each wall across the axis, and what adjoins it at the vertex, have the vertex on the side
  /// to which the wall faces.
  void decide(const Saddle& saddle) {
    std::map<std::uint32_t, int> wanted;  // by corner; 0: by walls that face both ways
    for (const auto corner : cornersAt_[saddle.vertex]) {
      const int side = wallFacing(corner / 3, saddle.axis);
      if (side == 0) continue;
      wanted[corner] = side;
      for (const bool isNext : {false, true}) spread(corner, saddle.axis, side, isNext, wanted);
    }
    for (const auto& [corner, side] : wanted) {
      const auto& shift = surface_.vertices_[saddle.vertex].shift;
      if (side != 0 && side != shift[static_cast<std::size_t>(saddle.axis)]) {
        flips_[corner] |= 1U << static_cast<unsigned>(saddle.axis);
      }
    }
  }
  /// From a wall one way round the vertex: to the next triangle, and those that lie in one plane
  /// across another axis with it, up to an edge along the axis. Copies there lie on the edge; at
  /// others, the gap between them would fold the wall that adjoins over itself.
  void spread(std::uint32_t corner, int axis, int side, bool isNext,
              std::map<std::uint32_t, int>& wanted) {
    auto last = corner;
    for (auto next = around(last, isNext); wallFacing(next / 3, axis) == 0;
         next = around(next, isNext)) {
      if (last != corner && !isOneWall(last / 3, next / 3)) return;
      if (isAlong(isNext ? before(last) : last, axis)) return;
      const auto [known, isNew] = wanted.emplace(next, side);
      if (!isNew && known->second != side) known->second = 0;
      last = next;
    }
  }
  [[nodiscard]] bool isAlong(std::uint32_t side, int axis) const {
    const auto& all = surface_.corners_;
    auto way = surface_.vertices_[endOf(all, side)].position -
               surface_.vertices_[startOf(all, side)].position;
    way[axis] = 0;
    return way == Vec3<double>{};
  }
  /// The corner of the next triangle around a vertex.
  [[nodiscard]] std::uint32_t around(std::uint32_t corner, bool isNext) const {
    // The side that begins at the corner has a partner that ends there; the one before it has one
    // that begins there.
    if (isNext) return partner_[before(corner)];
    return after(partner_[corner]);
  }
  [[nodiscard]] static std::uint32_t after(std::uint32_t side) {
    return side % 3 == 2 ? side - 2 : side + 1;
  }
  [[nodiscard]] static std::uint32_t before(std::uint32_t side) {
    return side % 3 == 0 ? side + 2 : side - 1;
  }
  [[nodiscard]] bool isOneWall(std::uint32_t a, std::uint32_t b) const {
    for (int axis = 0; axis < 3; ++axis) {
      const int side = wallFacing(a, axis);
      if (side != 0) return side == wallFacing(b, axis);
    }
    return false;
  }
  [[nodiscard]] int wallFacing(std::uint32_t triangle, int axis) const {
    return facing(surface_.positionsOf(triangle), axis);
  }

  void moveCorner(std::uint32_t corner, unsigned flips) {
    auto& vertex = surface_.corners_[corner / 3][corner % 3];
    const auto next = static_cast<std::uint32_t>(surface_.vertices_.size());
    const auto [known, isNew] = numbers_.emplace(std::pair(vertex, flips), next);
    if (isNew) {
      auto copy = surface_.vertices_[vertex];
      for (unsigned axis = 0; axis < 3; ++axis) {
        if ((flips >> axis & 1U) != 0)
          copy.shift[axis] = static_cast<std::int8_t>(-copy.shift[axis]);
      }
      surface_.vertices_.push_back(copy);
      copied_.push_back(vertex);
    }
    vertex = known->second;
  }

  [[nodiscard]] std::uint32_t meshVertex(std::uint32_t number) const {
    return number < vertexCount_ ? number : copied_[number - vertexCount_];
  }
  [[nodiscard]] std::uint32_t& edgeOf(std::uint32_t side) {
    return surface_.edges_[side / 3][side % 3];
  }
  void pair(std::uint32_t one, std::uint32_t other) {
    edgeOf(one) = edgeOf(other) = surface_.edgeCount_++;
  }
  /// Adds a triangle; returns the number of its first side.
  std::uint32_t addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto side = static_cast<std::uint32_t>(3 * surface_.corners_.size());
    surface_.corners_.push_back({a, b, c});
    surface_.edges_.push_back({kNone, kNone, kNone});
    return side;
  }

  /// Fills the gaps between two triangles of the mesh that no longer share both ends of an edge.
  void closeEdges() {
    for (std::uint32_t one = 0; one < partner_.size(); ++one) {
      const auto other = partner_[one];
      if (other < one) continue;
      const auto& all = surface_.corners_;
      const auto [v1, w1] = std::pair(startOf(all, one), endOf(all, one));
      const auto [w2, v2] = std::pair(startOf(all, other), endOf(all, other));
      if (v1 == v2 && w1 == w2) continue;
      closeEdge({one, other}, {v1, w1}, {v2, w2});
    }
  }
  void closeEdge(const Two& sides, const Two& first, const Two& second) {
    const auto [v1, w1] = first;
    const auto [v2, w2] = second;
    const auto away = exactWay(surface_.vertices_[v1].position, surface_.vertices_[w1].position);
    const auto back = exactWay(surface_.vertices_[w1].position, surface_.vertices_[v1].position);
    if (v1 == v2) {
      const auto side = addTriangle(w1, v1, w2);
      pair(sides.first, side);
      pair(sides.second, side + 1);
      open_.push_back({w2, w1, side + 2, back});
      return;
    }
    const auto side = addTriangle(w1, v1, v2);
    pair(sides.first, side);
    open_.push_back({v1, v2, side + 1, away});
    if (w1 == w2) {
      pair(sides.second, side + 2);
      return;
    }
    const auto next = addTriangle(w1, v2, w2);
    pair(side + 2, next);
    pair(sides.second, next + 1);
    open_.push_back({w2, w1, next + 2, back});
  }

  /// Closes what is left open at each vertex, a loop from copy to copy.
  void closeCopies() {
    const auto count = open_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const auto [from, to, side, way] = open_[i];
      const auto vertex = meshVertex(from);
      if (from == vertex || to == vertex) continue;
      const auto added = addTriangle(to, from, vertex);
      pair(side, added);
      open_.push_back({from, vertex, added + 1, {}});
      open_.push_back({vertex, to, added + 2, {}});
      open_[i].side = kNone;
    }
    std::erase_if(open_, [](const OpenSide& s) { return s.side == kNone; });
    const auto ends = [](const OpenSide& s) { return std::minmax(s.from, s.to); };
    const auto key = [&](const OpenSide& s) {
      const auto [low, high] = ends(s);
      return std::tuple(low, high, s.side);
    };
    std::ranges::sort(open_, {}, key);
    for (std::size_t first = 0; first < open_.size();) {
      auto last = first + 1;
      while (last < open_.size() && Two(ends(open_[last])) == Two(ends(open_[first]))) ++last;
      pairOpen(std::span(open_).subspan(first, last - first));
      first = last;
    }
  }
  void pairOpen(std::span<const OpenSide> open) {
    const auto [low, high] = std::minmax(open[0].from, open[0].to);
    std::array<double, 3> direction{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      direction[axis] = surface_.vertices_[high].shift[axis] - surface_.vertices_[low].shift[axis];
    }
    std::vector<SideAtEdge> around;
    for (const auto& s : open) around.push_back({s.side, s.from == low, s.way});
    for (const auto& [one, other] :
         pairedAround({direction[0], direction[1], direction[2]}, std::move(around))) {
      pair(one, other);
    }
  }

  MovedSurface& surface_;
  std::uint32_t vertexCount_;
  std::vector<std::uint32_t> partner_;                             // per side of the mesh
  std::map<std::uint32_t, std::vector<std::uint32_t>> cornersAt_;  // of saddles
  std::map<std::uint32_t, unsigned> flips_;  // per corner that gets a copy: a bit per axis
  std::map<std::pair<std::uint32_t, unsigned>, std::uint32_t> numbers_;  // by vertex and flips
  std::vector<std::uint32_t> copied_;  // the vertices of the mesh that copies are of
  std::vector<OpenSide> open_;
};

void MovedSurface::moveVertices() {
  // Bit 0: a triangle across the axis faces down; bit 1: one faces up.
  std::vector<std::array<std::uint8_t, 3>> faces(vertices_.size());
  std::vector<Vec3<double>> normals(vertices_.size());
  for (std::uint32_t id = 0; id < meshTriangles_; ++id) {
    const auto& corners = corners_[id];
    const auto t = positionsOf(id);
    const auto area = cross(t[1] - t[0], t[2] - t[0]);
    const double size = length(area);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto u = t[(i + 1) % 3] - t[i];
      const auto v = t[(i + 2) % 3] - t[i];
      if (size > 0) normals[corners[i]] += (std::atan2(size, dot(u, v)) / size) * area;
    }
    for (int axis = 0; axis < 3; ++axis) {
      const int side = facing(t, axis);
      if (side == 0) continue;
      for (const auto v : corners) faces[v][static_cast<std::size_t>(axis)] |= side > 0 ? 2 : 1;
    }
  }
  std::vector<Saddle> saddles;
  for (std::uint32_t v = 0; v < faces.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto face = faces[v][static_cast<std::size_t>(axis)];
      const bool goesUp = face == 1 || face == 2 ? face == 2 : normals[v][axis] >= -kZero;
      vertices_[v].shift[static_cast<std::size_t>(axis)] = goesUp ? 1 : -1;
      if (face == 3) saddles.push_back({v, axis});
    }
  }
  if (!saddles.empty()) SaddleSplit(*this).run(saddles);
}

int MovedSurface::windingAt(const Vec3<double>& node) const {
  int winding = 0;
  for (std::uint32_t id = 0; id < triangleCount(); ++id) {
    winding += riseBelowNode(triangle(id), node);
  }
  return winding;
}

}  // namespace cutwater
