#include <Cutwater/Polyhedra/Detail/CellDivision.hpp>
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
    volume_ = cellMoments(whole_.loops, pointAt()).volume;
  }

  /// See divideCell().
  std::optional<std::uint32_t> divideBy(const DividingPlane& plane) {
    if (!findDivision(plane)) return std::nullopt;
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

  bool findDivision(const DividingPlane& plane) {
    constexpr double kLeast = 1e-4;  // of the cell's volume
    normal_ = plane.normal / length(plane.normal);
    findSides(plane);
    if (!findParts()) return false;
    const auto cap = closingLoop(front_.loops);
    if (!cap) return false;
    front_.loops.push_back(*cap);
    behind_.loops.emplace_back(cap->rbegin(), cap->rend());
    if (std::min(front_.loops.size(), behind_.loops.size()) < kFewestFaces) return false;
    if (!openEdges(front_.loops).empty() || !openEdges(behind_.loops).empty()) return false;
    const double front = cellMoments(front_.loops, pointAt()).volume;
    const double behind = cellMoments(behind_.loops, pointAt()).volume;
    shareInFront_ = front / (front + behind);
    return std::min(front, behind) > kLeast * volume_;
  }

  void findSides(const DividingPlane& plane) {
    const auto at = pointAt();
    const double near = plane.near * std::cbrt(volume_);
    for (const auto& loop : whole_.loops) corners_.insert(corners_.end(), loop.begin(), loop.end());
    std::ranges::sort(corners_);
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    for (const auto corner : corners_) {
      const double height = -dot(normal_, at(corner) - plane.point);
      heights_.push_back(std::abs(height) < near ? 0 : height);
    }
    for (const auto corner : plane.corners) {
      const auto place = placeOf(corner);
      if (place < corners_.size() && corners_[place] == corner) heights_[place] = 0;
    }
  }
  [[nodiscard]] std::size_t placeOf(std::uint32_t corner) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(corners_, corner) - corners_.begin());
  }
  /// How far a corner lies before the plane; 0, if near it, as new ones do.
  [[nodiscard]] double heightOf(std::uint32_t corner) const {
    return corner < points_->size() ? heights_[placeOf(corner)] : 0;
  }

  /// A loop with the points in which edges cross the plane.
  [[nodiscard]] CornerLoop crossed(const CornerLoop& loop) {
    CornerLoop result;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto a = loop[k];
      const auto b = loop[(k + 1) % loop.size()];
      result.push_back(a);
      if (!(heightOf(a) * heightOf(b) < 0)) continue;
      const Edge edge{std::min(a, b), std::max(a, b)};
      const auto [known, isNew] = onEdges_.try_emplace(edge);
      if (isNew) {
        const auto at = pointAt();
        const double from = heightOf(edge[0]);
        const double share = from / (from - heightOf(edge[1]));
        known->second = static_cast<std::uint32_t>(points_->size() + extra_.size());
        const auto point = at(edge[0]) + share * (at(edge[1]) - at(edge[0]));
        extra_.push_back(point);
      }
      result.push_back(known->second);
    }
    return result;
  }

  bool findParts() {
    const auto add = [](Part& part, CornerLoop loop, std::uint32_t face) {
      part.loops.push_back(std::move(loop));
      part.faces.push_back(face);
    };
    for (std::size_t n = 0; n < whole_.loops.size(); ++n) {
      const auto loop = crossed(whole_.loops[n]);
      const auto number = whole_.faces[n];
      const auto has = [&](int sign) {
        return std::ranges::any_of(loop, [&](auto corner) { return heightOf(corner) * sign > 0; });
      };
      if (has(1) && has(-1)) {
        auto two = halvesOf(loop);
        if (!two) return false;
        add(front_, std::move(two->first), number);
        add(behind_, std::move(two->second), number);
      } else if (auto two = has(1) || has(-1) ? partInPlane(loop, has(1)) : std::nullopt) {
        add(has(1) ? behind_ : front_, std::move(two->first), number);
        add(has(1) ? front_ : behind_, std::move(two->second), number);
      } else if (has(1) || (!has(-1) && looksAlong(loop))) {
        add(front_, loop, number);
      } else {
        add(behind_, loop, number);
      }
    }
    return true;
  }
  [[nodiscard]] bool looksAlong(const CornerLoop& loop) const {
    return dot(faceMoments(loop, pointAt()).area, normal_) > 0;
  }

  /// What a loop on one side of the plane has in it, if that bounds the other side, and the rest.
  [[nodiscard]] std::optional<std::pair<CornerLoop, CornerLoop>> partInPlane(const CornerLoop& loop,
                                                                             bool isFront) {
    constexpr double kLeast = 1e-3;  // of the square of the cell's width
    const auto n = loop.size();
    const auto isInPlane = [&](std::size_t k) { return heightOf(loop[k % n]) == 0; };
    const auto stretch = onlyStretch(n, isInPlane);
    if (!stretch) return std::nullopt;
    const auto [start, end] = *stretch;
    std::pair<CornerLoop, CornerLoop> parts;
    for (auto k = start; k < end; ++k) parts.first.push_back(loop[k % n]);
    for (auto k = end - 1; k <= start + n; ++k) parts.second.push_back(loop[k % n]);
    if (parts.first.size() < 3 || parts.second.size() < 3) return std::nullopt;
    const double area = dot(faceMoments(parts.first, pointAt()).area, normal_);
    const double width = std::cbrt(volume_);
    if (!((isFront ? -area : area) > kLeast * width * width)) return std::nullopt;
    return parts;
  }

  /// What of a loop is in front of the plane, and behind it, if that is one stretch each. Edges in
  /// the plane go with the front, as those of the face that gave it.
  [[nodiscard]] std::optional<std::pair<CornerLoop, CornerLoop>> halvesOf(const CornerLoop& loop) {
    const auto n = loop.size();
    const auto isBehind = [&](std::size_t k) { return heightOf(loop[k % n]) < 0; };
    const auto stretch = onlyStretch(n, isBehind);
    if (!stretch) return std::nullopt;
    const auto [start, end] = *stretch;
    std::pair<CornerLoop, CornerLoop> halves;
    for (auto k = start + n - 1; k <= end + n; ++k) halves.second.push_back(loop[k % n]);
    for (auto k = end; k < start + n; ++k) halves.first.push_back(loop[k % n]);
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
  std::vector<std::uint32_t> corners_;  // of the cell, ascending
  std::vector<double> heights_;         // of each, see heightOf()
  Vec3<double> normal_;
  Part whole_;
  Part front_;
  Part behind_;
  double volume_ = 0;        // of the polyhedron
  double shareInFront_ = 0;  // of the volume
};

}  // namespace

std::optional<std::uint32_t> divideCell(EditedMesh& mesh, std::uint32_t cell,
                                        const DividingPlane& plane) {
  return CellDivision(mesh, cell).divideBy(plane);
}

}  // namespace cutwater
