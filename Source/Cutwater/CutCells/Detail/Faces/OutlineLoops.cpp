#include <Cutwater/CutCells/Detail/Faces/OutlineLoops.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

namespace cutwater {

namespace {

/// Joins holes to the outline around them.
class HoleJoiner {
 public:
  explicit HoleJoiner(const FaceAxes& axes) : c_(axes.first), d_(axes.second) {}

  /// The first loop is around all others.
  [[nodiscard]] OutlineLoop joined(std::vector<OutlineLoop> loops) const {
    auto outline = std::move(loops.front());
    // From below: what is below a hole's lowest point is joined already.
    std::vector<OutlineLoop> holes(std::make_move_iterator(loops.begin() + 1),
                                   std::make_move_iterator(loops.end()));
    for (auto& hole : holes) {
      const auto lowest =
          std::ranges::min_element(hole, {}, [this](const Vec3<double>& p) { return p[d_]; });
      std::rotate(hole.begin(), lowest, hole.end());
    }
    std::ranges::sort(holes, {}, [this](const OutlineLoop& hole) { return hole.front()[d_]; });
    for (const auto& hole : holes) join(outline, hole);
    return outline;
  }

 private:
  void join(OutlineLoop& outline, const OutlineLoop& hole) const {
    const auto at = outline.begin() + static_cast<std::ptrdiff_t>(seenFrom(outline, hole.front()));
    OutlineLoop way(hole);
    way.push_back(hole.front());
    way.push_back(*at);
    outline.insert(at + 1, way.begin(), way.end());
  }

  /// A corner of the outline below the point that nothing of the outline hides (Eberly,
  /// "Triangulation by ear clipping", 2002).
  [[nodiscard]] std::size_t seenFrom(const OutlineLoop& outline, const Vec3<double>& p) const {
    std::size_t best = 0;
    double height = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const auto next = (i + 1) % outline.size();
      const auto& from = outline[i];
      const auto& to = outline[next];
      if ((from[c_] <= p[c_]) == (to[c_] <= p[c_])) continue;
      const double here = from[d_] + (p[c_] - from[c_]) / (to[c_] - from[c_]) * (to[d_] - from[d_]);
      if (here > p[d_] || here <= height) continue;
      height = here;
      best = from[d_] < to[d_] ? i : next;
    }
    // Corners in the triangle of the point, what is right below it, and that corner may hide it:
    // the one that is least to the side is seen.
    const auto& corner = outline[best];
    const auto slope = [&](const Vec3<double>& q) {
      return std::abs(q[c_] - p[c_]) / (p[d_] - q[d_]);
    };
    double least = slope(corner);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const auto& q = outline[i];
      const bool isOnThatSide = (q[c_] - p[c_]) * (corner[c_] - p[c_]) > 0;
      if (!isOnThatSide || q[d_] >= p[d_] || !(slope(q) < least)) continue;
      // Above the line from the point right below to the corner.
      const double share = (q[c_] - p[c_]) / (corner[c_] - p[c_]);
      if (share > 1 || q[d_] < height + share * (corner[d_] - height)) continue;
      least = slope(q);
      best = i;
    }
    return best;
  }

  int c_;
  int d_;
};

double areaOf(const OutlineLoop& loop, int across) {
  double area = 0;
  for (std::size_t i = 2; i < loop.size(); ++i) {
    area += cross(loop[i - 1] - loop[0], loop[i] - loop[0])[across];
  }
  return area;
}

/// The edges of polygons that are those of one polygon alone.
class RimEdges {
 public:
  struct Edge {
    Vec3<double> from;
    Vec3<double> to;
    bool isSeen = false;
  };

  explicit RimEdges(std::span<const OutlineLoop> polygons) {
    for (const auto& polygon : polygons) {
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const auto& from = polygon[k];
        const auto& to = polygon[(k + 1) % polygon.size()];
        if (from != to) edges_.push_back({from, to});
      }
    }
    std::ranges::stable_sort(edges_, {}, ends);
    for (auto& edge : edges_) {
      if (edge.isSeen) continue;
      const auto [first, last] = those({edge.to, edge.from});
      const auto back = std::find_if(first, last, [](const Edge& e) { return !e.isSeen; });
      if (back != last) edge.isSeen = back->isSeen = true;
    }
    std::erase_if(edges_, [](const Edge& edge) { return edge.isSeen; });
  }

  /// Walks along all of them, with what they bound on the left, as seen against the axis.
  [[nodiscard]] std::vector<OutlineLoop> loops(int across) {
    std::vector<OutlineLoop> result;
    for (auto& first : edges_) {
      if (first.isSeen) continue;
      OutlineLoop loop;
      for (auto* edge = &first; edge != nullptr; edge = next(*edge, across)) {
        edge->isSeen = true;
        loop.push_back(edge->from);
      }
      result.push_back(std::move(loop));
    }
    return result;
  }

 private:
  static auto inOrder(const Vec3<double>& p) { return std::tuple(p.x, p.y, p.z); }
  static std::pair<std::tuple<double, double, double>, std::tuple<double, double, double>> ends(
      const Edge& edge) {
    return {inOrder(edge.from), inOrder(edge.to)};
  }
  [[nodiscard]] std::pair<std::vector<Edge>::iterator, std::vector<Edge>::iterator> those(
      const Edge& like) {
    return {std::ranges::lower_bound(edges_, ends(like), {}, ends),
            std::ranges::upper_bound(edges_, ends(like), {}, ends)};
  }
  /// The edge that follows: where several do, the first one to the left of what was walked, so that
  /// loops that touch in a corner go around one part each.
  [[nodiscard]] Edge* next(const Edge& edge, int across) {
    const auto from = [](const Edge& e) { return inOrder(e.from); };
    const auto first = std::ranges::lower_bound(edges_, inOrder(edge.to), {}, from);
    const auto last = std::ranges::upper_bound(edges_, inOrder(edge.to), {}, from);
    const auto turn = [&](const Edge& e) {
      const auto back = edge.from - edge.to;
      const auto way = e.to - e.from;
      return std::atan2(cross(way, back)[across], dot(way, back));  // clockwise from `back`
    };
    constexpr double kWhole = 7;  // above 2 pi
    double least = 2 * kWhole;
    Edge* best = nullptr;
    for (auto it = first; it != last; ++it) {
      if (it->isSeen) continue;
      const double angle = turn(*it);
      const double clockwise = angle > 0 ? angle : angle + kWhole;
      if (clockwise >= least) continue;
      least = clockwise;
      best = &*it;
    }
    return best;
  }

  std::vector<Edge> edges_;
};

}  // namespace

OutlineLoop joinedLoops(std::vector<OutlineLoop> loops, const FaceAxes& axes) {
  const auto area = [&](const OutlineLoop& loop) { return areaOf(loop, axes.across); };
  std::iter_swap(loops.begin(), std::ranges::max_element(loops, {}, area));
  return HoleJoiner(axes).joined(std::move(loops));
}

OutlineLoop unitedOutline(std::span<const OutlineLoop> polygons, const FaceAxes& axes) {
  auto loops = RimEdges(polygons).loops(axes.across);
  return loops.empty() ? OutlineLoop{} : joinedLoops(std::move(loops), axes);
}

}  // namespace cutwater
