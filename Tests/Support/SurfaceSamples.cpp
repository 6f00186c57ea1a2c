#include "Support/SurfaceSamples.hpp"

#include <algorithm>
#include <random>

namespace cutwater::test {

namespace {

/// The end of the segment's last halving: a point at which the sign just changed.
template <typename Inside>
Vec3<double> bisected(const Inside& inside, Vec3<double> a, Vec3<double> b) {
  const bool start = inside(a);
  for (int i = 0; i < 60; ++i) {
    const Vec3<double> middle = 0.5 * a + 0.5 * b;
    if (middle == a || middle == b) break;
    (inside(middle) == start ? a : b) = middle;
  }
  return b;
}

}  // namespace

template <std::floating_point T>
bool SurfaceSamples<T>::isInside(const Vec3<double>& p) const {
  return f_.signedDistance(Vec3<T>(p)) < 0;
}

template <std::floating_point T>
SurfaceSamples<T>::SurfaceSamples(const SignedDistanceFunction<T>& f, double extent, int lines,
                                  unsigned seed)
    : f_(f), spacing_(2 * extent / lines) {
  constexpr int kSteps = 160;
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> jitter(0.3, 0.7);
  const auto inside = [this](const Vec3<double>& p) { return isInside(p); };
  for (int axis = 0; axis < 3; ++axis) {
    for (int line = 0; line < lines * lines; ++line) {
      Vec3<double> p;
      p[(axis + 1) % 3] = -extent + (line % lines + jitter(engine)) * spacing_;
      p[(axis + 2) % 3] = -extent + (line / lines + jitter(engine)) * spacing_;
      p[axis] = -extent;
      bool before = isInside(p);
      for (int step = 1; step <= kSteps; ++step) {
        Vec3<double> q = p;
        q[axis] = -extent + 2 * extent * step / kSteps;
        const bool now = isInside(q);
        if (now != before) points_.push_back(bisected(inside, p, q));
        p = q;
        before = now;
      }
    }
  }
}

template <std::floating_point T>
auto SurfaceSamples<T>::nearest(const Vec3<double>& p) const -> Nearest {
  std::size_t best = 0;
  double bestSquared = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double squared = lengthSquared(points_[i] - p);
    if (squared < bestSquared) best = i, bestSquared = squared;
  }
  return {best, std::sqrt(bestSquared)};
}

template <std::floating_point T>
double SurfaceSamples<T>::firstChange(const Vec3<double>& p, const Vec3<double>& direction,
                                      double reach) const {
  constexpr int kSteps = 24;
  const bool start = isInside(p);
  for (int i = 1; i <= kSteps; ++i) {
    const Vec3<double> q = p + (reach * i / kSteps) * direction;
    if (isInside(q) == start) continue;
    const auto inside = [this](const Vec3<double>& x) { return isInside(x); };
    return length(bisected(inside, p + (reach * (i - 1) / kSteps) * direction, q) - p);
  }
  return std::numeric_limits<double>::infinity();
}

template <std::floating_point T>
double SurfaceSamples<T>::polishedFrom(const Vec3<double>& p, const Vec3<double>& sample,
                                       double enough) const {
  std::mt19937 engine(7);
  std::normal_distribution<double> normal;
  double best = length(sample - p);
  if (best == 0) return 0;
  Vec3<double> direction = (sample - p) / best;
  double spread = std::min(1.0, 2 * spacing_ / best);
  for (int failures = 0; spread > 1e-7 && best > enough;) {
    const Vec3<double> tilt{normal(engine), normal(engine), normal(engine)};
    const Vec3<double> other = normalized(direction + spread * tilt);
    const double distance = firstChange(p, other, best);
    if (distance < best) {
      // Growing again follows the narrow valley along an edge.
      best = distance, direction = other, failures = 0;
      spread = std::min(1.0, 1.5 * spread);
    } else if (++failures == 48) {
      spread *= 0.5, failures = 0;
    }
  }
  return best;
}

template <std::floating_point T>
double SurfaceSamples<T>::polishedDistance(const Vec3<double>& p, double enough) const {
  // The nearest sample may lie in the wrong valley: start from several, some way apart.
  constexpr int kStarts = 40;
  const double reach = nearest(p).distance + 3 * spacing_;
  std::vector<Vec3<double>> starts;
  double best = std::numeric_limits<double>::infinity();
  for (int start = 0; start < kStarts && best > enough; ++start) {
    const Vec3<double>* next = nullptr;
    for (const auto& sample : points_) {
      if (length(sample - p) > (next != nullptr ? length(*next - p) : reach)) continue;
      const bool isApart = std::all_of(starts.begin(), starts.end(), [&](const auto& other) {
        return length(sample - other) > 0.4 * spacing_;
      });
      if (isApart) next = &sample;
    }
    if (next == nullptr) break;
    starts.push_back(*next);
    best = std::min(best, polishedFrom(p, *next, enough));
  }
  return best;
}

template <std::floating_point T>
bool SurfaceSamples<T>::anyIn(const Box<double>& box) const {
  return std::any_of(points_.begin(), points_.end(),
                     [&](const auto& p) { return box.contains(p); });
}

template class SurfaceSamples<float>;
template class SurfaceSamples<double>;

}  // namespace cutwater::test
