#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Surface/Cleaning/Detail/DelaunayFlips.hpp>
#include <Cutwater/Surface/Cleaning/Detail/HoleBridges.hpp>
#include <Cutwater/Surface/Cleaning/Detail/PlanarRegions.hpp>
#include <Cutwater/Surface/Cleaning/Detail/PlanarView.hpp>
#include <Cutwater/Surface/Detail/EarClipping.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace cutwater::detail {
namespace {

Loop joined(std::span<const Loop> loops) {
  Loop result;
  for (const auto& loop : loops) result.insert(result.end(), loop.begin(), loop.end());
  return result;
}

class RegionFiller {
 public:
  RegionFiller(std::span<const Vec3<double>> positions, std::span<const Loop> loops, int axis)
      : positions_(normalizedPositions(positions, joined(loops))),
        view_(positions_, axis),
        loops_(loops),
        around_(loops.size()) {
    result_.left.assign(loops.size(), false);
    result_.parents.assign(loops.size(), kNone);
    result_.isHole.assign(loops.size(), false);
  }

  PlanarFilling run() {
    findMeetings();
    nest();
    std::vector<std::vector<Loop>> holes(loops_.size());
    for (const auto i : outermostFirst()) {
      const auto parent = result_.parents[i];
      if (parent == kNone || result_.left[i]) continue;
      result_.isHole[i] = !result_.isHole[parent] && orientation(i) != orientation(parent);
      if (result_.isHole[i]) holes[parent].push_back(loops_[i]);
    }
    for (std::uint32_t i = 0; i < loops_.size(); ++i) {
      if (!result_.isHole[i] && !result_.left[i]) fill(i, std::move(holes[i]));
    }
    leaveHoles();
    return std::move(result_);
  }

 private:
  struct Edge {
    std::uint32_t from, to, loop;
  };

  /// Finds loops that meet themselves or others in more than a corner.
  void findMeetings() {
    std::vector<Edge> edges;
    std::vector<Box<double>> boxes;
    for (std::uint32_t loop = 0; loop < loops_.size(); ++loop) {
      std::uint32_t from = loops_[loop].back();
      for (const auto to : loops_[loop]) {
        edges.push_back({from, to, loop});
        boxes.push_back(Box<double>{}.extend(flat(from)).extend(flat(to)));
        from = to;
      }
    }
    if (edges.empty()) return;
    const auto arrays = buildBvh<16, 4>(boxes);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      arrays.tree().overlapping(
          OrientedBox<double>::of(boxes[i]), [&](std::span<const std::uint32_t> slots) {
            for (const auto k : slots) {
              if (k == kNone || k <= i || !boxes[k].overlaps(boxes[i])) continue;
              if (!view_.meet(edges[i].from, edges[i].to, edges[k].from, edges[k].to)) continue;
              result_.left[edges[i].loop] = result_.left[edges[k].loop] = true;
            }
            return true;
          });
    }
  }

  [[nodiscard]] Vec3<double> flat(std::uint32_t point) const {
    return {view_.u(point), view_.v(point), 0};
  }

  /// Finds which loops enclose which. A loop inside one that is left open is left open, too.
  void nest() {
    std::vector<Box<double>> boxes(loops_.size());
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      for (const auto point : loops_[i]) boxes[i].extend(flat(point));
    }
    for (std::uint32_t i = 0; i < loops_.size(); ++i) {
      for (std::uint32_t k = 0; k < loops_.size(); ++k) {
        if (k == i || !boxes[k].contains(boxes[i].lower) || !boxes[k].contains(boxes[i].upper)) {
          continue;
        }
        const auto point = std::ranges::find_if(loops_[i], [&](std::uint32_t p) {
          return std::ranges::find(loops_[k], p) == loops_[k].end();
        });
        if (point != loops_[i].end() && view_.isAround(loops_[k], *point)) around_[i].push_back(k);
      }
    }
    const auto met = result_.left;
    for (std::uint32_t i = 0; i < loops_.size(); ++i) {
      for (const auto k : around_[i]) result_.left[i] = result_.left[i] || met[k];
      // The smallest of those around it is the one that most others enclose.
      const auto parent = std::ranges::max_element(
          around_[i], {}, [&](std::uint32_t k) { return around_[k].size(); });
      if (parent != around_[i].end()) result_.parents[i] = *parent;
    }
  }

  [[nodiscard]] std::vector<std::uint32_t> outermostFirst() const {
    std::vector<std::uint32_t> order(loops_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return around_[i].size(); });
    return order;
  }

  [[nodiscard]] int orientation(std::uint32_t loop) const {
    return view_.orientation(loops_[loop]);
  }

  void fill(std::uint32_t boundary, std::vector<Loop> holes) {
    const Loop ring = joinHoles(view_, loops_[boundary], std::move(holes));
    result_.left[boundary] = ring.empty();
    if (ring.empty()) return;
    std::vector<Vec3<double>> corners;
    for (const auto point : ring) corners.push_back(view_.position(point));
    Vec3<double> up;
    up[view_.axis()] = orientation(boundary);
    std::vector<PlaceTriangle> triangles;
    clipEars(corners, up, triangles);
    const std::size_t first = result_.triangles.size();
    for (const auto& [a, b, c] : triangles) {
      result_.triangles.push_back({ring[a], ring[b], ring[c]});
    }
    flipToDelaunay(view_, orientation(boundary), std::span(result_.triangles).subspan(first));
  }

  /// Holes are left open where the loop around them is.
  void leaveHoles() {
    for (std::uint32_t i = 0; i < loops_.size(); ++i) {
      if (result_.isHole[i]) result_.left[i] = result_.left[result_.parents[i]];
    }
  }

  std::vector<Vec3<double>> positions_;
  PlanarView view_;
  std::span<const Loop> loops_;
  std::vector<std::vector<std::uint32_t>> around_;  // for each loop: those that enclose it
  PlanarFilling result_;
};

}  // namespace

PlanarFilling fillLoops(std::span<const Vec3<double>> positions, std::span<const Loop> loops,
                        int axis) {
  return RegionFiller(positions, loops, axis).run();
}

}  // namespace cutwater::detail
