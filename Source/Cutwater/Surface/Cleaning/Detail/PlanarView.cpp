#include <Cutwater/Surface/Cleaning/Detail/PlanarView.hpp>

#include <algorithm>

namespace cutwater::detail {

bool PlanarView::isWithin(std::uint32_t p, std::uint32_t a, std::uint32_t b) const {
  return std::min(u(a), u(b)) <= u(p) && u(p) <= std::max(u(a), u(b)) &&
         std::min(v(a), v(b)) <= v(p) && v(p) <= std::max(v(a), v(b));
}

bool PlanarView::boxesMeet(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                           std::uint32_t d) const {
  return std::max(u(a), u(b)) >= std::min(u(c), u(d)) &&
         std::max(u(c), u(d)) >= std::min(u(a), u(b)) &&
         std::max(v(a), v(b)) >= std::min(v(c), v(d)) &&
         std::max(v(c), v(d)) >= std::min(v(a), v(b));
}

bool PlanarView::meet(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
  if (!boxesMeet(a, b, c, d)) return false;
  if (b == c || b == d) std::swap(a, b);
  if (a == d) std::swap(c, d);
  if (a == c) {  // the two overlap along a line, or do not meet
    return b == d || (turn(a, b, d) == 0 && (isWithin(b, a, d) || isWithin(d, a, b)));
  }
  const int sideC = turn(a, b, c);
  const int sideD = turn(a, b, d);
  const int sideA = turn(c, d, a);
  const int sideB = turn(c, d, b);
  if (sideC * sideD < 0 && sideA * sideB < 0) return true;
  return (sideC == 0 && isWithin(c, a, b)) || (sideD == 0 && isWithin(d, a, b)) ||
         (sideA == 0 && isWithin(a, c, d)) || (sideB == 0 && isWithin(b, c, d));
}

bool PlanarView::isAround(std::span<const std::uint32_t> loop, std::uint32_t point) const {
  bool around = false;  // the parity of crossings of the ray towards larger u
  std::uint32_t a = loop.back();
  for (const auto b : loop) {
    if ((v(a) > v(point)) != (v(b) > v(point))) {
      const int side = turn(a, b, point);
      if (v(b) > v(a) ? side > 0 : side < 0) around = !around;
    }
    a = b;
  }
  return around;
}

int PlanarView::orientation(std::span<const std::uint32_t> loop) const {
  const std::size_t n = loop.size();
  const std::size_t i = lastOf(loop);
  return turn(loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n]);
}

std::size_t PlanarView::lastOf(std::span<const std::uint32_t> loop) const {
  const auto last =
      std::ranges::max_element(loop, {}, [this](std::uint32_t i) { return std::pair(u(i), v(i)); });
  return static_cast<std::size_t>(last - loop.begin());
}

}  // namespace cutwater::detail
