#include <Cutwater/CutCells/Detail/Surface/SaddleSplit.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace cutwater {

namespace {

class SaddleSplit {
 public:
  explicit SaddleSplit(MovedTriangles& triangles)
      : all_(triangles), vertexCount_(static_cast<std::uint32_t>(triangles.vertices.size())) {}

  /// Takes the vertices at which walls across an axis face both ways, and the axes.
  std::vector<std::uint32_t> run(std::span<const Saddle> saddles) {
    findPartners();
    for (const auto& [vertex, axis] : saddles) cornersAt_[vertex];
    for (std::uint32_t side = 0; side < partner_.size(); ++side) {
      const auto found = cornersAt_.find(all_.startOf(side));
      if (found != cornersAt_.end()) found->second.push_back(side);
    }
    for (const auto& saddle : saddles) decide(saddle);
    for (const auto& [corner, flips] : flips_) moveCorner(corner, flips);
    closeEdges();
    closeCopies();
    return overlapping();
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
    std::vector<std::uint32_t> seen(all_.edgeCount, kNone);
    partner_.resize(3 * all_.meshTriangles);
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
      const auto& shift = all_.vertices[saddle.vertex].shift;
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
    auto way =
        all_.vertices[all_.endOf(side)].position - all_.vertices[all_.startOf(side)].position;
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
    return all_.facing(triangle, axis);
  }

  /// The triangles at vertices whose fans of triangles have different copies.
  [[nodiscard]] std::vector<std::uint32_t> overlapping() const {
    std::vector<std::uint32_t> found;
    for (const auto& [vertex, corners] : cornersAt_) {
      const auto fan = fanFrom(corners.front());
      std::set<std::uint32_t> copies;
      std::set<std::uint32_t> others;
      for (const auto corner : corners) {
        (fan.contains(corner) ? copies : others).insert(all_.startOf(corner));
      }
      if (others.empty() || (copies == others && copies.size() == 1)) continue;
      for (const auto corner : corners) found.push_back(corner / 3);
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }
  /// The corners at a vertex that are connected with this one across edges.
  [[nodiscard]] std::set<std::uint32_t> fanFrom(std::uint32_t corner) const {
    std::set<std::uint32_t> fan;
    while (fan.insert(corner).second) corner = around(corner, true);
    return fan;
  }

  void moveCorner(std::uint32_t corner, unsigned flips) {
    auto& vertex = all_.corners[corner / 3][corner % 3];
    const auto next = static_cast<std::uint32_t>(all_.vertices.size());
    const auto [known, isNew] = numbers_.emplace(std::pair(vertex, flips), next);
    if (isNew) {
      auto copy = all_.vertices[vertex];
      for (unsigned axis = 0; axis < 3; ++axis) {
        if ((flips >> axis & 1U) != 0)
          copy.shift[axis] = static_cast<std::int8_t>(-copy.shift[axis]);
      }
      all_.vertices.push_back(copy);
      copied_.push_back(vertex);
    }
    vertex = known->second;
  }

  [[nodiscard]] std::uint32_t meshVertex(std::uint32_t number) const {
    return number < vertexCount_ ? number : copied_[number - vertexCount_];
  }
  [[nodiscard]] std::uint32_t& edgeOf(std::uint32_t side) { return all_.edges[side / 3][side % 3]; }
  /// Adds a triangle; returns the number of its first side.
  std::uint32_t addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto side = static_cast<std::uint32_t>(3 * all_.corners.size());
    all_.corners.push_back({a, b, c});
    all_.edges.push_back({kNone, kNone, kNone});
    return side;
  }

  /// Fills the gaps between two triangles of the mesh that no longer share both ends of an edge.
  void closeEdges() {
    for (std::uint32_t one = 0; one < partner_.size(); ++one) {
      const auto other = partner_[one];
      if (other < one) continue;
      const auto [v1, w1] = std::pair(all_.startOf(one), all_.endOf(one));
      const auto [w2, v2] = std::pair(all_.startOf(other), all_.endOf(other));
      if (v1 == v2 && w1 == w2) continue;
      closeEdge({one, other}, {v1, w1}, {v2, w2});
    }
  }
  void closeEdge(const Two& sides, const Two& first, const Two& second) {
    const auto [v1, w1] = first;
    const auto [v2, w2] = second;
    const auto away = all_.wayBetween(v1, w1);
    const auto back = all_.wayBetween(w1, v1);
    if (v1 == v2) {
      const auto side = addTriangle(w1, v1, w2);
      all_.pair(sides.first, side);
      all_.pair(sides.second, side + 1);
      open_.push_back({w2, w1, side + 2, back});
      return;
    }
    const auto side = addTriangle(w1, v1, v2);
    all_.pair(sides.first, side);
    open_.push_back({v1, v2, side + 1, away});
    if (w1 == w2) {
      all_.pair(sides.second, side + 2);
      return;
    }
    const auto next = addTriangle(w1, v2, w2);
    all_.pair(side + 2, next);
    all_.pair(sides.second, next + 1);
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
      all_.pair(side, added);
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
      direction[axis] = all_.vertices[high].shift[axis] - all_.vertices[low].shift[axis];
    }
    std::vector<SideAtEdge> around;
    for (const auto& s : open) around.push_back({s.side, s.from == low, s.way});
    for (const auto& [one, other] :
         pairedAround({direction[0], direction[1], direction[2]}, std::move(around))) {
      all_.pair(one, other);
    }
  }

  MovedTriangles& all_;
  std::uint32_t vertexCount_;
  std::vector<std::uint32_t> partner_;                             // per side of the mesh
  std::map<std::uint32_t, std::vector<std::uint32_t>> cornersAt_;  // of saddles
  std::map<std::uint32_t, unsigned> flips_;  // per corner that gets a copy: a bit per axis
  std::map<std::pair<std::uint32_t, unsigned>, std::uint32_t> numbers_;  // by vertex and flips
  std::vector<std::uint32_t> copied_;  // the vertices of the mesh that copies are of
  std::vector<OpenSide> open_;
};

}  // namespace

std::vector<std::uint32_t> splitSaddles(MovedTriangles& triangles,
                                        std::span<const Saddle> saddles) {
  return SaddleSplit(triangles).run(saddles);
}

}  // namespace cutwater
