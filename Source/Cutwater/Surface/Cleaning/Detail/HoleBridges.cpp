#include <Cutwater/Surface/Cleaning/Detail/HoleBridges.hpp>

#include <algorithm>
#include <functional>
#include <unordered_set>
#include <utility>

namespace cutwater::detail {
namespace {

class Bridging {
 public:
  Bridging(const PlanarView& view, const Loop& boundary, std::vector<Loop> holes)
      : view_(view), way_(view.orientation(boundary)), ring_(boundary), holes_(std::move(holes)) {
    inRing_.insert(ring_.begin(), ring_.end());
    // The hole that reaches farthest comes first: all that it sees beyond is already joined.
    const auto reach = [&](const Loop& hole) {
      const auto last = hole[view.lastOf(hole)];
      return std::pair(view.u(last), view.v(last));
    };
    std::ranges::sort(holes_, [&](const Loop& a, const Loop& b) { return reach(a) > reach(b); });
  }

  Loop run() {
    for (; joined_ < holes_.size(); ++joined_) {
      const Loop& hole = holes_[joined_];
      const bool isJoined = touches(hole) ? joinAtCorner(hole) : joinByBridge(hole);
      if (!isJoined) return {};
    }
    return std::move(ring_);
  }

 private:
  [[nodiscard]] bool touches(const Loop& hole) const {
    return std::ranges::any_of(hole,
                               [&](std::uint32_t corner) { return inRing_.contains(corner); });
  }

  /// Where the hole touches a corner of the ring, inserts the hole there. Returns false if they
  /// share more than one corner.
  bool joinAtCorner(const Loop& hole) {
    std::vector<std::pair<std::size_t, std::size_t>> shared;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const auto start = std::ranges::find(hole, ring_[i]);
      if (start == hole.end()) continue;
      if (!shared.empty() && ring_[i] != ring_[shared.front().first]) return false;
      shared.emplace_back(i, start - hole.begin());
    }
    for (const auto& [place, start] : shared) {
      if (!isInside(ring_, place, hole[(start + 1) % hole.size()])) continue;
      insert(hole, start + 1, hole.size(), place);
      return true;
    }
    return false;
  }

  bool joinByBridge(const Loop& hole) {
    const std::size_t start = view_.lastOf(hole);
    const std::size_t place = placeFor(hole, start);
    if (place == ring_.size()) return false;
    const auto end = ring_[place];
    insert(hole, start, hole.size() + 1, place);
    const auto after = place + hole.size() + 2;
    ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(after), end);
    return true;
  }

  /// The nearest place in the ring that is visible from the hole's corner; the ring's size if there
  /// is none.
  [[nodiscard]] std::size_t placeFor(const Loop& hole, std::size_t start) const {
    const auto from = hole[start];
    std::vector<std::pair<double, std::size_t>> places;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const double du = view_.u(ring_[i]) - view_.u(from);
      const double dv = view_.v(ring_[i]) - view_.v(from);
      if (ring_[i] != from) places.emplace_back(du * du + dv * dv, i);
    }
    std::ranges::make_heap(places, std::greater{});
    while (!places.empty()) {
      std::ranges::pop_heap(places, std::greater{});
      const auto place = places.back().second;
      places.pop_back();
      if (isInside(ring_, place, from) && isInside(hole, start, ring_[place]) &&
          isFree(from, ring_[place])) {
        return place;
      }
    }
    return ring_.size();
  }

  /// Whether the segment from the loop's corner to the point starts on the region's side (O'Rourke,
  /// "Computational geometry in C", 1998, InCone).
  [[nodiscard]] bool isInside(const Loop& loop, std::size_t corner, std::uint32_t to) const {
    const std::size_t n = loop.size();
    const auto at = loop[corner];
    const auto before = loop[(corner + n - 1) % n];
    const auto after = loop[(corner + 1) % n];
    if (before == after) return true;  // the end of a bridge
    if (turn(before, at, after) >= 0) return turn(at, to, before) > 0 && turn(to, at, after) > 0;
    return !(turn(at, to, after) >= 0 && turn(to, at, before) >= 0);
  }

  [[nodiscard]] int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return way_ * view_.turn(a, b, c);
  }

  [[nodiscard]] bool isFree(std::uint32_t from, std::uint32_t to) const {
    const auto meets = [&](const Loop& loop) {
      std::uint32_t a = loop.back();
      for (const auto b : loop) {
        if (view_.meet(from, to, a, b)) return true;
        a = b;
      }
      return false;
    };
    if (meets(ring_)) return false;
    return std::none_of(holes_.begin() + static_cast<std::ptrdiff_t>(joined_), holes_.end(), meets);
  }

  /// Inserts `count` corners of the hole into the ring, after the given place.
  void insert(const Loop& hole, std::size_t start, std::size_t count, std::size_t place) {
    Loop detour;
    for (std::size_t k = 0; k < count; ++k) detour.push_back(hole[(start + k) % hole.size()]);
    ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(place) + 1, detour.begin(),
                 detour.end());
    inRing_.insert(detour.begin(), detour.end());
  }

  const PlanarView& view_;
  int way_;
  Loop ring_;
  std::unordered_set<std::uint32_t> inRing_;
  std::vector<Loop> holes_;
  std::size_t joined_ = 0;
};

}  // namespace

Loop joinHoles(const PlanarView& view, const Loop& boundary, std::vector<Loop> holes) {
  return Bridging(view, boundary, std::move(holes)).run();
}

}  // namespace cutwater::detail
