#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Detail/PolygonEdges.hpp>
#include <Cutwater/Shapes/Polygon.hpp>

#include <algorithm>

namespace cutwater {

namespace {

using detail::PlanarEdge;

/// The place of an edge in the loops.
struct Place {
  std::size_t loop;
  std::size_t corner;  // where the edge starts
};

template <std::floating_point T>
std::vector<Vec2<T>> checkedLoop(const std::vector<Vec2<T>>& corners, std::size_t number) {
  std::vector<Vec2<T>> loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    require(isFinite(corners[i]), "Polygon: need finite coordinates", Named{"loop", number},
            Named{"corner", i}, Named{"x", corners[i].x}, Named{"y", corners[i].y});
    if (loop.empty() || corners[i] != loop.back()) loop.push_back(corners[i]);
  }
  while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
  require(loop.size() >= 3, "Polygon: need three different corners at least", Named{"loop", number},
          Named{"corners", loop.size()});
  return loop;
}

/// Orientation of the loop, found at its lowest corner, the leftmost if there are several; 1:
/// counterclockwise.
template <std::floating_point T>
int turn(const std::vector<Vec2<T>>& loop) {
  const auto lowest = std::ranges::min_element(loop, [](const Vec2<T>& a, const Vec2<T>& b) {
    return a.y < b.y || (a.y == b.y && a.x < b.x);
  });
  const auto i = static_cast<std::size_t>(lowest - loop.begin());
  const auto n = loop.size();
  return PlanarEdge<T>(loop[(i + n - 1) % n], loop[i]).side(loop[(i + 1) % n]);
}

template <std::floating_point T>
class LoopCheck {
 public:
  explicit LoopCheck(const std::vector<std::vector<Vec2<T>>>& loops)
      : loops_(loops), tree_(edges()) {}

  void requireApart() const {
    const auto& all = tree_.primitives();
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      tree_.overlapping(all[i].boundingBox(), [&](std::uint32_t j) {
        if (j > i) requireApart(i, j);
        return true;
      });
    }
  }

  /// The number of loops that surround this one.
  [[nodiscard]] std::size_t depth(std::size_t loop) const {
    return detail::crossingsToTheRight<T>(tree_, loops_[loop].front(), farthest_,
                                          [&](std::uint32_t i) { return places_[i].loop != loop; });
  }

 private:
  std::vector<PlanarEdge<T>> edges() {
    std::vector<PlanarEdge<T>> all;
    for (std::size_t loop = 0; loop < loops_.size(); ++loop) {
      const auto& corners = loops_[loop];
      for (std::size_t i = 0; i < corners.size(); ++i) {
        all.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
        places_.push_back({loop, i});
        farthest_ = std::max(farthest_, corners[i].x);
      }
    }
    return all;
  }

  void requireApart(std::uint32_t i, std::uint32_t j) const {
    const auto& a = tree_.primitives()[i];
    const auto& b = tree_.primitives()[j];
    if (a.end() == b.start() && areNeighbours(i, j)) return requireNoFold(a, b, i, j);
    if (b.end() == a.start() && areNeighbours(j, i)) return requireNoFold(b, a, i, j);
    const bool areApart =
        a.side(b.start()) * a.side(b.end()) > 0 || b.side(a.start()) * b.side(a.end()) > 0;
    // If they lie on one line, they overlap, because their boxes do.
    require(areApart, "Polygon: edges cross or touch", Named{"loop", places_[i].loop},
            Named{"edge", places_[i].corner}, Named{"other loop", places_[j].loop},
            Named{"other edge", places_[j].corner});
  }
  void requireNoFold(const PlanarEdge<T>& a, const PlanarEdge<T>& b, std::uint32_t i,
                     std::uint32_t j) const {
    const bool isFold = a.side(b.end()) == 0 && dot(a.outward(), b.outward()) < 0;
    require(!isFold, "Polygon: an edge folds back on the one before it",
            Named{"loop", places_[i].loop}, Named{"edge", places_[i].corner},
            Named{"other edge", places_[j].corner});
  }
  /// Whether edge j follows edge i.
  [[nodiscard]] bool areNeighbours(std::uint32_t i, std::uint32_t j) const {
    const auto& a = places_[i];
    const auto& b = places_[j];
    return a.loop == b.loop && (a.corner + 1) % loops_[a.loop].size() == b.corner;
  }

  const std::vector<std::vector<Vec2<T>>>& loops_;
  std::vector<Place> places_;  // of the edges
  T farthest_ = std::numeric_limits<T>::lowest();
  LinearBVH<T, PlanarEdge<T>> tree_;
};

}  // namespace

template <std::floating_point T>
Polygon<T>::Polygon(const Loop& outline, const std::vector<Loop>& others) {
  loops_.push_back(checkedLoop(outline, 0));
  for (const auto& loop : others) loops_.push_back(checkedLoop(loop, loops_.size()));
  const LoopCheck<T> check(loops_);
  check.requireApart();
  std::vector<bool> runsBackwards;
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    const bool isOutline = check.depth(i) % 2 == 0;
    runsBackwards.push_back((turn(loops_[i]) > 0) != isOutline);
  }
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    if (runsBackwards[i]) std::ranges::reverse(loops_[i]);
  }
}

template <std::floating_point T>
T Polygon<T>::area() const {
  double twice = 0;
  for (const auto& loop : loops_) {
    const auto from = [&](std::size_t i) {
      return Vec2<double>{double{loop[i].x} - double{loop[0].x},
                          double{loop[i].y} - double{loop[0].y}};
    };
    for (std::size_t i = 2; i < loop.size(); ++i) twice += cross(from(i - 1), from(i));
  }
  return static_cast<T>(0.5 * twice);
}

template class Polygon<float>;
template class Polygon<double>;

}  // namespace cutwater
