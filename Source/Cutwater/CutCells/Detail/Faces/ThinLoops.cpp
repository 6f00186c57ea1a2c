#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/Detail/Faces/ThinLoops.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

namespace cutwater {

namespace {

using Edge = EdgeLoops::Edge;
using Loop = EdgeLoops::Loop;

/// In sizes of all: the distances that are tried, and areas that are rounding.
constexpr std::array kDistances{0x1p-46, 0x1p-43, 0x1p-40, 0x1p-37, 0x1p-34, 0x1p-31, 0x1p-28};
constexpr double kThin = 0x1p-45;

std::vector<Loop> simpleLoops(EdgeLoops edges) {
  const auto shortest = [](const Vec3<double>&, const Vec3<double>& b, const Vec3<double>& c) {
    return lengthSquared(c - b);
  };
  return edges.loops(shortest);
}

double areaOf(const std::vector<Loop>& loops) {
  double sum = 0;
  for (const auto& loop : loops) {
    for (std::size_t k = 2; k < loop.size(); ++k) {
      sum += 0.5 * length(cross(loop[k - 1] - loop[0], loop[k] - loop[0]));
    }
  }
  return sum;
}

/// The ends of edges, and which of them are close to each other.
class CloseEnds {
 public:
  explicit CloseEnds(std::span<const Edge> edges) {
    for (const auto& edge : edges) points_.insert(points_.end(), edge.begin(), edge.end());
    std::ranges::sort(points_, {}, inOrder);
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  }
  void join(double distance) {
    distance_ = distance;
    sets_.reset(points_.size());
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      for (auto j = i + 1; j < points_.size() && points_[j].x - points_[i].x <= distance; ++j) {
        if (length(points_[j] - points_[i]) <= distance) sets_.unite(i, j);
      }
    }
  }
  /// The number of all ends that are close to this one.
  [[nodiscard]] std::uint32_t of(const Vec3<double>& end) {
    const auto found = std::ranges::lower_bound(points_, inOrder(end), {}, inOrder);
    return sets_.find(static_cast<std::uint32_t>(found - points_.begin()));
  }
  /// The edge's ends, and what is close to it but not to these, from the one to the other.
  [[nodiscard]] Loop along(const Edge& edge) {
    const auto way = edge[1] - edge[0];
    const double size = length(way);
    const auto [low, high] = std::minmax({edge[0].x, edge[1].x});
    std::vector<std::pair<double, Vec3<double>>> between;
    auto p = std::ranges::lower_bound(points_, low - distance_, {}, &Vec3<double>::x);
    for (; p != points_.end() && p->x <= high + distance_; ++p) {
      const double share = dot(*p - edge[0], way) / size;
      const bool isBetween = share > distance_ && share < size - distance_;
      if (isBetween && length(cross(*p - edge[0], way)) <= distance_ * size) {
        between.emplace_back(share, *p);
      }
    }
    std::ranges::sort(between, {},
                      [](const auto& b) { return std::pair(b.first, inOrder(b.second)); });
    Loop result{edge[0]};
    for (const auto& [share, point] : between) result.push_back(point);
    result.push_back(edge[1]);
    return result;
  }

 private:
  static std::tuple<double, double, double> inOrder(const Vec3<double>& p) {
    return {p.x, p.y, p.z};
  }

  std::vector<Vec3<double>> points_;
  detail::DisjointSets sets_;
  double distance_ = 0;
};

/// Divides edges at ends that are close to them; each loop is an edge and the way back.
std::vector<Loop> dividedEdges(EdgeLoops& edges, CloseEnds& ends) {
  std::vector<Loop> loops;
  for (const auto& edge : edges.rest()) {
    auto loop = ends.along(edge);
    if (loop.size() > 2) loops.push_back(std::move(loop));
  }
  for (auto& loop : loops) {
    std::reverse(loop.begin() + 1, loop.end());
    edges.add(loop, true);
  }
  return loops;
}

/// Divides edges, then pairs those of opposite directions whose ends are close; the rest are loops
/// as they come.
std::vector<Loop> pairedLoops(EdgeLoops edges, CloseEnds& ends) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Edge>> unpaired;
  auto loops = dividedEdges(edges, ends);
  const auto divided = static_cast<std::ptrdiff_t>(loops.size());
  for (const auto& edge : edges.rest()) {
    const auto from = ends.of(edge[0]);
    const auto to = ends.of(edge[1]);
    const auto opposite = unpaired.find({to, from});
    if (from == to || opposite == unpaired.end() || opposite->second.empty()) {
      unpaired[{from, to}].push_back(edge);
      continue;
    }
    const auto other = opposite->second.back();
    opposite->second.pop_back();
    Loop loop{edge[0], edge[1]};
    if (other[0] != edge[1]) loop.push_back(other[0]);
    if (other[1] != edge[0]) loop.push_back(other[1]);
    loops.push_back(std::move(loop));
  }
  for (auto loop = loops.begin() + divided; loop != loops.end(); ++loop) edges.add(*loop, true);
  for (auto& loop : simpleLoops(std::move(edges))) loops.push_back(std::move(loop));
  return loops;
}

}  // namespace

std::vector<Loop> thinLoops(EdgeLoops edges) {
  const auto rest = edges.rest();
  if (rest.empty()) return {};
  Box<double> box;
  for (const auto& edge : rest) box.extend(edge[0]);
  const double size = box.diagonal();
  CloseEnds ends(rest);
  auto best = simpleLoops(edges);
  double least = areaOf(best);
  for (const double distance : kDistances) {
    if (least <= kThin * size * size) break;
    ends.join(distance * size);
    auto loops = pairedLoops(edges, ends);
    const double area = areaOf(loops);
    if (area < least) least = area, best = std::move(loops);
  }
  return best;
}

}  // namespace cutwater
