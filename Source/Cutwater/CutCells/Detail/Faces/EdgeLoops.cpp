#include <Cutwater/CutCells/Detail/Faces/EdgeLoops.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

namespace cutwater {

namespace {

auto inOrder(const Vec3<double>& p) {
  return std::tuple(p.x, p.y, p.z);
}

/// From the way back around `b`, clockwise to the way to `c`: a measure of the angle that grows
/// with it, from 0 to 4. So the walk keeps to the part on its left.
double clockwiseTurn(int axis, const Vec3<double>& a, const Vec3<double>& b,
                     const Vec3<double>& c) {
  const double sine = cross(c - b, a - b)[axis];
  const double cosine = dot(a - b, c - b);
  const double share = cosine / (std::abs(sine) + std::abs(cosine));
  if (sine == 0 && cosine >= 0) return 4;  // straight back
  return sine >= 0 ? 1 - share : 3 + share;
}

}  // namespace

void EdgeLoops::add(std::span<const Vec3<double>> polygon, bool isReversed) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto& p = polygon[k];
    const auto& q = polygon[(k + 1) % polygon.size()];
    if (p != q) edges_.push_back(isReversed ? Edge{q, p} : Edge{p, q});
  }
}

/// And sorts the rest by where they begin.
void EdgeLoops::cancel() {
  const auto goesUp = [](const Edge& e) { return inOrder(e[0]) < inOrder(e[1]); };
  const auto key = [&](const Edge& e) {
    return goesUp(e) ? std::pair(inOrder(e[0]), inOrder(e[1]))
                     : std::pair(inOrder(e[1]), inOrder(e[0]));
  };
  std::ranges::stable_sort(edges_, {}, key);
  std::vector<Edge> rest;
  for (std::size_t first = 0; first < edges_.size();) {
    auto last = first;
    std::ptrdiff_t up = 0;
    for (; last < edges_.size() && key(edges_[last]) == key(edges_[first]); ++last) {
      up += goesUp(edges_[last]) ? 1 : -1;
    }
    for (auto i = first; i < last && up != 0; ++i) {
      if (goesUp(edges_[i]) != (up > 0)) continue;
      rest.push_back(edges_[i]);
      up += up > 0 ? -1 : 1;
    }
    first = last;
  }
  edges_ = std::move(rest);
  std::ranges::stable_sort(edges_, {}, [](const Edge& e) { return inOrder(e[0]); });
}

std::vector<EdgeLoops::Loop> EdgeLoops::loops(Turn turn) {
  cancel();
  std::vector<char> isUsed(edges_.size());
  std::vector<std::size_t> path;  // edges, each from where the last one leads
  std::vector<Loop> result;
  const auto key = [](const Edge& e) { return inOrder(e[0]); };
  const auto next = [&](const Edge& from) {
    auto best = edges_.size();
    double least = 0;
    const auto first = std::ranges::lower_bound(edges_, inOrder(from[1]), {}, key);
    for (auto e = first; e != edges_.end() && (*e)[0] == from[1]; ++e) {
      const auto number = static_cast<std::size_t>(e - edges_.begin());
      if (isUsed[number] != 0) continue;
      const double angle = turn(from[0], from[1], (*e)[1]);
      if (best == edges_.size() || angle < least) best = number, least = angle;
    }
    return best;
  };
  for (std::size_t start = 0; start < edges_.size(); ++start) {
    if (isUsed[start] != 0) continue;
    path.assign(1, start);
    isUsed[start] = 1;
    while (!path.empty()) {
      const auto& end = edges_[path.back()];
      const auto closes =
          std::ranges::find_if(path, [&](std::size_t edge) { return edges_[edge][0] == end[1]; });
      if (closes != path.end()) {
        Loop loop;
        for (auto edge = closes; edge != path.end(); ++edge) loop.push_back(edges_[*edge][0]);
        result.push_back(std::move(loop));
        path.erase(closes, path.end());
        continue;
      }
      const auto following = next(end);
      if (following == edges_.size()) break;  // not of edges that are those of polygons
      isUsed[following] = 1;
      path.push_back(following);
    }
  }
  return result;
}

std::vector<EdgeLoops::Loop> EdgeLoops::loopsAcross(int axis) {
  return loops([axis](const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c) {
    return clockwiseTurn(axis, a, b, c);
  });
}

}  // namespace cutwater
