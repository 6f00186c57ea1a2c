#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Surface/Detail/PairTest.hpp>
#include <Cutwater/Triangles/TriangleIntersection.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace cutwater {

namespace {

constexpr std::uint8_t kHasArea = 1U << 6U;  // in Views::bits

/// What a triangle fills at a vertex, as seen along an axis: from one of its other corners
/// counterclockwise to the other.
struct Angle {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
};

/// Whether each angle ends where the next one begins, and the last one where the first does. Sorts
/// them.
bool areOneRing(std::span<Angle> angles) {
  std::sort(angles.begin(), angles.end(),
            [](const Angle& a, const Angle& b) { return a.from < b.from; });
  std::size_t at = 0;
  for (std::size_t step = 1; step <= angles.size(); ++step) {
    const auto next =
        std::lower_bound(angles.begin(), angles.end(), angles[at].to,
                         [](const Angle& a, std::uint32_t corner) { return a.from < corner; });
    if (next == angles.end() || next->from != angles[at].to) return false;
    at = static_cast<std::size_t>(next - angles.begin());
    if ((at == 0) != (step == angles.size())) return false;
  }
  return true;
}

}  // namespace

PairTest::PairTest(std::span<const Vec3<double>> positions, std::span<const Corners> triangles,
                   int threads, Changed changed, double clearance)
    : positions_(positions),
      triangles_(triangles),
      changed_(changed),
      clearance_(clearance),
      views_(triangles.size()),
      isFlat_(positions.size()) {
  const ParallelOptions inRanges{.threads = threads, .grain = 4096, .progress = {}};
  parallelFor(triangles.size(), inRanges, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) views_[t] = viewsOf(triangles[t]);
  });
  const Stars at = stars();
  const std::span<const std::uint32_t> list(at.list);
  parallelFor(positions.size(), inRanges, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v) {
      const auto star = list.subspan(at.begins[v], at.begins[v + 1] - at.begins[v]);
      const bool isAsked = std::ranges::any_of(star, [&](auto t) { return isChanged(t); });
      isFlat_[v] = isAsked && liesFlat(v, star) ? 1 : 0;
    }
  });
}

Box<double> PairTest::box(std::uint32_t t) const {
  const auto& [a, b, c] = triangles_[t];
  const auto own = Box<double>{}.extend(positions_[a]).extend(positions_[b]).extend(positions_[c]);
  return clearance_ > 0 ? own.grown(clearance_) : own;
}

bool PairTest::meet(std::uint32_t a, std::uint32_t b) const {
  if (!isChanged(a) && !isChanged(b)) return false;
  const auto& first = triangles_[a];
  const auto& second = triangles_[b];
  const auto& [p, q, r] = second;
  bool isJoined = false;
  for (const auto v : first) {
    if (v != p && v != q && v != r) continue;
    if (isFlat_[v] != 0) return false;
    isJoined = true;
  }
  if (clearance_ > 0 && !isJoined) {
    const auto at = [&](const Corners& t) {
      return std::array{positions_[t[0]], positions_[t[1]], positions_[t[2]]};
    };
    return !areFartherApart(at(first), at(second), clearance_);
  }
  return intersect(positions_, first, second);
}

PairTest::Stars PairTest::stars() const {
  Stars at;
  at.begins.assign(positions_.size() + 1, 0);
  for (const auto& triangle : triangles_) {
    for (const auto v : triangle) ++at.begins[v];
  }
  std::uint32_t end = 0;
  for (auto& begin : at.begins) begin = end += begin;  // the ends
  at.list.resize(3 * triangles_.size());
  for (auto t = static_cast<std::uint32_t>(triangles_.size()); t-- > 0;) {
    for (const auto v : triangles_[t]) at.list[--at.begins[v]] = t;
  }
  return at;
}

PairTest::Views PairTest::viewsOf(const Corners& triangle) const {
  const std::array p{positions_[triangle[0]], positions_[triangle[1]], positions_[triangle[2]]};
  const Vec3<double> u = p[1] - p[0];
  const Vec3<double> v = p[2] - p[0];
  Views views;
  for (int axis = 0; axis < 3; ++axis) {
    const int i = (axis + 1) % 3;
    const int j = (axis + 2) % 3;
    const double left = u[i] * v[j];
    const double right = u[j] * v[i];
    // Far above rounding and underflow, see crossSign(). What is closer is rare, and left to it.
    const double doubt = 0x1p-48 * (std::abs(left) + std::abs(right)) + 0x1p-190;
    if (std::abs(left - right) <= doubt) continue;
    const bool isClockwise = left < right;
    views.bits = static_cast<std::uint8_t>(views.bits | (isClockwise ? 8U : 1U) << axis);
    unsigned passes = 0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const double from = p[(corner + (isClockwise ? 2 : 1)) % 3][j];
      const double to = p[(corner + (isClockwise ? 1 : 2)) % 3][j];
      const double here = p[corner][j];
      passes |= static_cast<unsigned>((from < here) & (to >= here)) << corner;
    }
    views.passes[static_cast<std::size_t>(axis)] = static_cast<std::uint8_t>(passes);
  }
  if (views.bits != 0 || cutwater::hasArea(p)) views.bits |= kHasArea;
  return views;
}

bool PairTest::liesFlat(std::uint32_t vertex, std::span<const std::uint32_t> star) const {
  if (star.size() < 3) return false;
  unsigned common = kHasArea - 1U;
  for (const auto t : star) common &= views_[t].bits;
  if (common == 0) return false;
  const int view = std::countr_zero(common);
  // Seen along that axis, each triangle fills an angle of less than half a turn at the vertex. If
  // they make one ring, every direction is in as many of them as the view's first axis is: in one.
  constexpr std::size_t kUsual = 16;  // without allocating
  std::array<Angle, kUsual> few;
  std::vector<Angle> many(star.size() > kUsual ? star.size() : 0);
  const auto angles = many.empty() ? std::span(few).first(star.size()) : std::span(many);
  unsigned turns = 0;  // angles that contain that axis
  for (std::size_t k = 0; k < star.size(); ++k) {
    const auto& t = triangles_[star[k]];
    const std::size_t own = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
    angles[k] = {t[(own + 1) % 3], t[(own + 2) % 3]};
    if (view >= 3) std::swap(angles[k].from, angles[k].to);
    turns += views_[star[k]].passes[static_cast<std::size_t>(view % 3)] >> own & 1U;
  }
  return turns == 1 && areOneRing(angles);
}

}  // namespace cutwater
