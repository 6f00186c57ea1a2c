#include <Cutwater/Polyhedra/Detail/DividedCells.hpp>
#include <Cutwater/Polyhedra/Detail/EditedMesh.hpp>
#include <Cutwater/Polyhedra/Detail/FaceQuality.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace cutwater {

namespace {

using Edge = std::array<std::uint32_t, 2>;

/// Loops seen from outside of a cell, and the faces that they are of, or parts of.
struct Part {
  std::vector<CornerLoop> loops;
  std::vector<std::uint32_t> faces;
};

/// The edges of loops that have none in the opposite direction.
std::vector<Edge> openEdges(const std::vector<CornerLoop>& loops) {
  std::map<Edge, int> sums;
  for (const auto& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto a = loop[k];
      const auto b = loop[(k + 1) % loop.size()];
      if (a < b) ++sums[{a, b}];
      if (a > b) --sums[{b, a}];
    }
  }
  std::vector<Edge> open;
  for (const auto& [edge, sum] : sums) {
    if (sum == 1) open.push_back(edge);
    if (sum == -1) open.push_back({edge[1], edge[0]});
    if (std::abs(sum) > 1) return {};  // no loop closes that
  }
  return open;
}

/// The loop that closes others, if one without a corner twice does.
std::optional<CornerLoop> closingLoop(const std::vector<CornerLoop>& loops) {
  auto open = openEdges(loops);
  if (open.size() < 3) return std::nullopt;
  CornerLoop loop{open.front()[1]};
  while (!open.empty()) {  // against the direction of the open edges
    const auto next =
        std::ranges::find(open, loop.back(), [](const Edge& edge) { return edge[1]; });
    if (next == open.end()) return std::nullopt;
    loop.push_back((*next)[0]);
    *next = open.back();
    open.pop_back();
  }
  if (loop.back() != loop.front()) return std::nullopt;
  loop.pop_back();
  if (hasRepeatedCorner(loop)) return std::nullopt;
  return loop;
}

/// Divides one cell of a mesh by a plane.
class CellDivision {
 public:
  CellDivision(EditedMesh& mesh, std::uint32_t cell) : mesh_(mesh), cell_(cell) {
    for (const auto number : mesh.facesOf(cell)) {
      const auto& face = mesh.face(number);
      auto loop = face.loop;
      if (face.cell != cell) std::ranges::reverse(loop);
      whole_.loops.push_back(std::move(loop));
      whole_.faces.push_back(number);
    }
    points_ = &mesh.points();
    moments_ = cellMoments(whole_.loops, pointAt());
  }

  /// Divides it by the plane of a wall, or of a face seen from behind: that which leaves the fewest
  /// of these in both parts, if they are fewer than now. Returns the part behind the plane.
  std::optional<std::uint32_t> divide() {
    const auto inverted = invertedOf(whole_, moments_);
    auto fewest = inverted.size();
    std::optional<std::size_t> best;
    for (std::size_t face = 0; face < whole_.faces.size() && fewest > 0; ++face) {
      const bool isInner = mesh_.face(whole_.faces[face]).other != EditedMesh::kNone;
      if (isInner && std::ranges::count(inverted, face) == 0) continue;
      const auto left = invertedIfDividedBy(face);
      if (!left || *left >= fewest) continue;
      fewest = *left;
      best = face;
    }
    if (!best) return std::nullopt;
    static_cast<void>(invertedIfDividedBy(*best));
    return commit();
  }

 private:
  /// The corners of loops, the new ones as well.
  struct PointAt {
    const CellDivision& of;
    const Vec3<double>& operator()(std::uint32_t n) const {
      const auto& points = *of.points_;
      return n < points.size() ? points[n] : of.extra_[n - points.size()];
    }
  };
  [[nodiscard]] PointAt pointAt() const { return {*this}; }
  /// Faces that the center sees from behind.
  [[nodiscard]] std::vector<std::size_t> invertedOf(const Part& part,
                                                    const CellMoments& moments) const {
    std::vector<std::size_t> found;
    for (std::size_t n = 0; n < part.loops.size(); ++n) {
      const auto face = faceMoments(part.loops[n], pointAt());
      if (!(dot(face.area, face.center - moments.center) > 0)) found.push_back(n);
    }
    return found;
  }

  /// Finds the parts that a face's plane makes of the cell. The number of faces seen from behind in
  /// them; none, if it does not make two that are closed and have enough faces.
  std::optional<std::size_t> invertedIfDividedBy(std::size_t face) {
    constexpr double kLeast = 1e-4;  // of the cell's volume
    extra_.clear();
    onEdges_.clear();
    findSides(face);
    if (!findParts(face)) return std::nullopt;
    const auto cap = closingLoop(front_.loops);
    if (!cap) return std::nullopt;
    front_.loops.push_back(*cap);
    behind_.loops.emplace_back(cap->rbegin(), cap->rend());
    if (std::min(front_.loops.size(), behind_.loops.size()) < kFewestFaces) return std::nullopt;
    if (!openEdges(front_.loops).empty() || !openEdges(behind_.loops).empty()) return std::nullopt;
    const auto front = cellMoments(front_.loops, pointAt());
    const auto behind = cellMoments(behind_.loops, pointAt());
    if (!(std::min(front.volume, behind.volume) > kLeast * moments_.volume)) return std::nullopt;
    shareInFront_ = front.volume / (front.volume + behind.volume);
    return invertedOf(front_, front).size() + invertedOf(behind_, behind).size();
  }

  /// On which side of a face's plane the corners lie: 1 in front of it, where its cell is, -1
  /// behind it, 0 near it. Its own are on it.
  void findSides(std::size_t face) {
    constexpr double kNear = 1e-3;  // of the cell's width
    const auto at = pointAt();
    const auto plane = faceMoments(whole_.loops[face], at);
    const auto normal = plane.area / length(plane.area);
    const double near = kNear * std::cbrt(moments_.volume);
    height_.clear();
    for (const auto& loop : whole_.loops) {
      for (const auto corner : loop) {
        const double height = -dot(normal, at(corner) - plane.center);
        height_[corner] = std::abs(height) < near ? 0 : height;
      }
    }
    for (const auto corner : whole_.loops[face]) height_[corner] = 0;
  }

  /// A loop with the points in which edges cross the plane.
  [[nodiscard]] CornerLoop crossed(const CornerLoop& loop) {
    CornerLoop result;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto a = loop[k];
      const auto b = loop[(k + 1) % loop.size()];
      result.push_back(a);
      if (!(height_[a] * height_[b] < 0)) continue;
      const Edge edge{std::min(a, b), std::max(a, b)};
      const auto [known, isNew] = onEdges_.try_emplace(edge);
      if (isNew) {
        const auto at = pointAt();
        const double from = height_[edge[0]];
        const double share = from / (from - height_[edge[1]]);
        known->second = static_cast<std::uint32_t>(points_->size() + extra_.size());
        const auto point = at(edge[0]) + share * (at(edge[1]) - at(edge[0]));
        extra_.push_back(point);
        height_[known->second] = 0;
      }
      result.push_back(known->second);
    }
    return result;
  }

  bool findParts(std::size_t plane) {
    front_ = behind_ = {};
    const auto add = [](Part& part, CornerLoop loop, std::uint32_t face) {
      part.loops.push_back(std::move(loop));
      part.faces.push_back(face);
    };
    const auto at = pointAt();
    const auto normal = faceMoments(whole_.loops[plane], at).area;
    for (std::size_t n = 0; n < whole_.loops.size(); ++n) {
      const auto loop = crossed(whole_.loops[n]);
      const auto number = whole_.faces[n];
      const auto has = [&](int sign) {
        return std::ranges::any_of(loop, [&](auto corner) { return height_[corner] * sign > 0; });
      };
      if (has(1) && has(-1)) {
        auto two = halvesOf(loop);
        if (!two) return false;
        add(front_, std::move(two->first), number);
        add(behind_, std::move(two->second), number);
      } else if (has(1) || (!has(-1) && dot(faceMoments(loop, at).area, normal) > 0)) {
        add(front_, loop, number);
      } else {
        add(behind_, loop, number);
      }
    }
    return true;
  }

  /// What of a loop is in front of the plane, and behind it, if that is one stretch each. Edges in
  /// the plane go with the front, as those of the face that gave it.
  [[nodiscard]] std::optional<std::pair<CornerLoop, CornerLoop>> halvesOf(const CornerLoop& loop) {
    const auto n = loop.size();
    const auto isBehind = [&](std::size_t k) { return height_[loop[k % n]] < 0; };
    std::optional<std::size_t> start;  // of those behind
    for (std::size_t k = 0; k < n; ++k) {
      if (!isBehind(k) || isBehind(k + n - 1)) continue;
      if (start) return std::nullopt;
      start = k;
    }
    if (!start) return std::nullopt;
    std::size_t end = *start;
    while (isBehind(end)) ++end;
    std::pair<CornerLoop, CornerLoop> halves;
    for (auto k = *start + n - 1; k <= end + n; ++k) halves.second.push_back(loop[k % n]);
    for (auto k = end; k < *start + n; ++k) halves.first.push_back(loop[k % n]);
    if (halves.first.size() < 3 || halves.second.size() < 3) return std::nullopt;
    if (halves.second.front() == halves.second.back()) return std::nullopt;
    return halves;
  }

  std::uint32_t commit() {
    for (const auto& point : extra_) mesh_.addPoint(point);
    for (const auto& [edge, point] : onEdges_) mesh_.divideEdge(cell_, edge[0], edge[1], point);
    const double volume = mesh_.mesh().cells.volume[cell_];
    const auto behind = mesh_.addCellLike(cell_, (1 - shareInFront_) * volume);
    mesh_.setVolume(cell_, shareInFront_ * volume);
    const auto oriented = [&](const EditedMesh::Face& face, CornerLoop loop) {
      if (face.cell != cell_) std::ranges::reverse(loop);
      return loop;
    };
    for (std::size_t n = 0; n < behind_.faces.size(); ++n) {
      const auto number = behind_.faces[n];
      auto face = mesh_.face(number);
      const auto inFront = std::ranges::find(front_.faces, number);
      if (inFront == front_.faces.end()) {
        mesh_.move(number, cell_, behind);
        continue;
      }
      const auto place = static_cast<std::size_t>(inFront - front_.faces.begin());
      mesh_.setLoop(number, oriented(face, front_.loops[place]));
      face.loop = oriented(face, behind_.loops[n]);
      (face.cell == cell_ ? face.cell : face.other) = behind;
      mesh_.addFace(std::move(face));
    }
    mesh_.addFace({.loop = front_.loops.back(), .cell = cell_, .other = behind});
    return behind;
  }

  EditedMesh& mesh_;
  std::uint32_t cell_;
  const std::vector<Vec3<double>>* points_;
  std::vector<Vec3<double>> extra_;  // numbered after the mesh's points
  std::map<Edge, std::uint32_t> onEdges_;
  std::map<std::uint32_t, double> height_;  // of corners, before the plane
  Part whole_;
  Part front_;
  Part behind_;
  CellMoments moments_;
  double shareInFront_ = 0;  // of the volume
};

/// Divides a cell, and its parts, as long as that helps.
void divide(EditedMesh& mesh, std::uint32_t cell) {
  std::vector<std::uint32_t> pending{cell};
  while (!pending.empty()) {
    const auto next = pending.back();
    pending.pop_back();
    if (const auto behind = CellDivision(mesh, next).divide()) {
      pending.insert(pending.end(), {next, *behind});
    }
  }
}

}  // namespace

FluidMesh withDividedCells(FluidMesh mesh) {
  std::vector<std::uint32_t> inverted;
  {
    const FaceQuality quality(mesh);
    for (std::size_t face = 0; face < mesh.faces.count(); ++face) {
      const auto owner = mesh.faces.owner[face];
      if (!(quality.pyramid(face, owner) > 0)) inverted.push_back(owner);
      if (face >= mesh.faces.neighbour.size()) continue;
      const auto neighbour = mesh.faces.neighbour[face];
      if (!(quality.pyramid(face, neighbour) > 0)) inverted.push_back(neighbour);
    }
  }
  if (inverted.empty()) return mesh;
  std::ranges::sort(inverted);
  inverted.erase(std::unique(inverted.begin(), inverted.end()), inverted.end());
  EditedMesh edited(std::move(mesh));
  for (const auto cell : inverted) divide(edited, cell);
  return std::move(edited).take();
}

}  // namespace cutwater
