#include <Cutwater/Surface/Cleaning/Detail/DelaunayFlips.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace cutwater::detail {
namespace {

class DelaunayFlips {
 public:
  DelaunayFlips(const PlanarView& view, int way, std::span<std::array<std::uint32_t, 3>> triangles)
      : view_(view), way_(way), triangles_(triangles) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      for (const auto& edge : edgesOf(t)) {
        triangleAt_[key(edge)] = t;
        open_.push_back(edge);
      }
    }
  }

  void run() {
    while (!open_.empty()) {
      const auto edge = open_.back();
      open_.pop_back();
      flip(edge);
    }
  }

 private:
  struct Edge {
    std::uint32_t from, to;
  };

  [[nodiscard]] static std::uint64_t key(const Edge& edge) {
    return std::uint64_t{edge.from} << 32 | edge.to;
  }

  [[nodiscard]] std::array<Edge, 3> edgesOf(std::uint32_t triangle) const {
    const auto& [a, b, c] = triangles_[triangle];
    return {{{a, b}, {b, c}, {c, a}}};
  }

  /// Flips the edge if it is still there, has a triangle on either side, and should.
  void flip(const Edge& edge) {
    const auto [a, b] = edge;
    const auto one = triangleAt_.find(key({a, b}));
    const auto other = triangleAt_.find(key({b, a}));
    if (one == triangleAt_.end() || other == triangleAt_.end()) return;
    const auto first = one->second;
    const auto second = other->second;
    const auto c = apex(first, edge);
    const auto d = apex(second, {b, a});
    if (!isInCircle(a, b, c, d) || turn(c, d, b) <= 0 || turn(d, c, a) <= 0) return;
    triangleAt_.erase(one);
    triangleAt_.erase(other);
    put(first, {c, d, b});
    put(second, {d, c, a});
  }

  void put(std::uint32_t triangle, const std::array<std::uint32_t, 3>& corners) {
    triangles_[triangle] = corners;
    for (const auto& edge : edgesOf(triangle)) {
      triangleAt_[key(edge)] = triangle;
      open_.push_back(edge);
    }
  }

  /// The third corner.
  [[nodiscard]] std::uint32_t apex(std::uint32_t triangle, const Edge& edge) const {
    const auto& [a, b, c] = triangles_[triangle];
    return a != edge.from && a != edge.to ? a : b != edge.from && b != edge.to ? b : c;
  }

  /// Whether d, on the other side of ab than c, lies in the circle through a, b, c: the angles at c
  /// and d add up to more than pi. The circles' centres are then apart by the sine of that sum over
  /// the product of their sines, in halves of ab: here by more than a share of the larger radius.
  [[nodiscard]] bool isInCircle(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                std::uint32_t d) const {
    const Angle atC = angle(a, c, b);
    const Angle atD = angle(a, d, b);
    constexpr double kShareOfRadius = 0.01;
    constexpr double kRounding = 1e-14;
    return atC.sine * atD.cosine + atC.cosine * atD.sine <
           -kShareOfRadius * std::max(atC.sine * atD.size, atD.sine * atC.size) -
               kRounding * atC.size * atD.size;
  }

  /// Sine and cosine times the lengths of the sides.
  struct Angle {
    double sine, cosine, size;
  };

  [[nodiscard]] Angle angle(std::uint32_t a, std::uint32_t at, std::uint32_t b) const {
    const double ua = view_.u(a) - view_.u(at);
    const double va = view_.v(a) - view_.v(at);
    const double ub = view_.u(b) - view_.u(at);
    const double vb = view_.v(b) - view_.v(at);
    return {std::abs(ua * vb - va * ub), ua * ub + va * vb,
            std::hypot(ua, va) * std::hypot(ub, vb)};
  }

  [[nodiscard]] int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return way_ * view_.turn(a, b, c);
  }

  const PlanarView& view_;
  int way_;
  std::span<std::array<std::uint32_t, 3>> triangles_;
  std::unordered_map<std::uint64_t, std::uint32_t> triangleAt_;  // that the edge is a side of
  std::vector<Edge> open_;                                       // to be looked at
};

}  // namespace

void flipToDelaunay(const PlanarView& view, int way,
                    std::span<std::array<std::uint32_t, 3>> triangles) {
  DelaunayFlips(view, way, triangles).run();
}

}  // namespace cutwater::detail
