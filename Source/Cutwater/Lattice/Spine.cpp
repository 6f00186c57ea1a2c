#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/Spine.hpp>

#include <algorithm>

namespace cutwater {

namespace {

double norm(const Vec3<double>& v) {
  return std::sqrt(lengthSquared(v));  // Spine::length() hides that of vectors
}

/// The mirror image of a vector in the plane across `normal`; itself if that is zero.
Vec3<double> reflected(const Vec3<double>& v, const Vec3<double>& normal) {
  const double squared = lengthSquared(normal);
  return squared > 0 ? v - (2 * dot(normal, v) / squared) * normal : v;
}

/// The part of v across `tangent`, as a unit vector.
Vec3<double> across(const Vec3<double>& tangent, const Vec3<double>& v) {
  return normalized(v - dot(tangent, v) * tangent);
}

Vec3<double> axisMostAcross(const Vec3<double>& tangent) {
  const auto size = abs(tangent);
  if (size.x <= size.y && size.x <= size.z) return {1, 0, 0};
  return size.y <= size.z ? Vec3<double>{0, 1, 0} : Vec3<double>{0, 0, 1};
}

}  // namespace

Vec3<double> Spine::Span::point(double t) const {
  const double b = t / chord;
  const double a = 1 - b;
  return a * begin + b * end +
         (chord * chord / 6) * ((a * a * a - a) * bendAtBegin + (b * b * b - b) * bendAtEnd);
}

Vec3<double> Spine::Span::derivative(double t) const {
  const double b = t / chord;
  const double a = 1 - b;
  return (end - begin) / chord +
         (chord / 6) * ((1 - 3 * a * a) * bendAtBegin + (3 * b * b - 1) * bendAtEnd);
}

double Spine::Span::arc(double from, double to) const {
  const double half = 0.5 * (to - from);
  const double middle = 0.5 * (to + from);
  const double offset = std::sqrt(0.6) * half;  // Gauss-Legendre quadrature with three points
  const auto speed = [&](double t) { return norm(derivative(t)); };
  return half / 9 * (5 * speed(middle - offset) + 8 * speed(middle) + 5 * speed(middle + offset));
}

Spine::Spine(std::span<const Vec3<double>> points, const Vec3<double>& side) {
  require(points.size() > 1, "Spine: need two points", Named{"points", points.size()});
  for (std::size_t i = 0; i < points.size(); ++i) {
    require(isFinite(points[i]), "Spine: need points that are finite", Named{"index", i},
            Named{"point", points[i]});
    if (i == 0) continue;
    const double chord = norm(points[i] - points[i - 1]);
    require(isFinite(Vec3<double>{chord, 1 / chord, 0}),
            "Spine: need points that differ from the next", Named{"index", i - 1},
            Named{"point", points[i]});
    spans_.push_back({points[i - 1], points[i], {}, {}, chord});
  }
  bend();
  sample(side);
}

void Spine::bend() {
  // The second derivatives at inner points solve a tridiagonal system: eliminated from the first
  // onwards (Thomas's algorithm), then filled in from the last.
  std::vector<double> diagonal;
  std::vector<Vec3<double>> right;
  for (std::size_t i = 1; i < spans_.size(); ++i) {
    const auto& before = spans_[i - 1];
    const auto& after = spans_[i];
    const auto slope = [](const Span& span) { return (span.end - span.begin) / span.chord; };
    const double factor = i == 1 ? 0 : before.chord / diagonal.back();
    diagonal.push_back(2 * (before.chord + after.chord) - factor * before.chord);
    const auto carried = i == 1 ? Vec3<double>{} : factor * right.back();
    right.push_back(6.0 * (slope(after) - slope(before)) - carried);
  }
  for (std::size_t i = spans_.size(); i-- > 1;) {
    const auto bend = (right[i - 1] - spans_[i].chord * spans_[i].bendAtEnd) / diagonal[i - 1];
    spans_[i].bendAtBegin = bend;
    spans_[i - 1].bendAtEnd = bend;
  }
}

void Spine::sample(const Vec3<double>& side) {
  constexpr std::uint32_t kSteps = 32;
  SpineFrame frame;
  frame.point = spans_.front().begin;
  frame.tangent = normalized(spans_.front().derivative(0));
  frame.normal =
      across(frame.tangent, side == Vec3<double>{} ? axisMostAcross(frame.tangent) : side);
  require(lengthSquared(frame.normal) > 0.5, "Spine: need a side that is not along the curve",
          Named{"side", side});
  frame.binormal = cross(frame.tangent, frame.normal);
  samples_.push_back({0, 0, 0, frame});
  for (std::uint32_t i = 0; i < spans_.size(); ++i) {
    const auto& span = spans_[i];
    for (std::uint32_t step = 0; step < kSteps; ++step) {
      const double from = span.chord * step / kSteps;
      const double to = span.chord * (step + 1) / kSteps;
      const double arc = span.arc(from, to);
      const auto before = samples_.back();
      frame = moved(before.frame, span, to);
      // Between samples, an acceptable curve turns by much less than a right angle.
      require(arc > 0 && dot(frame.tangent, before.frame.tangent) > 0,
              "Spine: need a curve that does not turn on the spot", Named{"at", frame.point});
      const bool isLast = step + 1 == kSteps && i + 1 < spans_.size();
      samples_.push_back({isLast ? i + 1 : i, isLast ? 0 : to, before.arc + arc, frame});
    }
  }
}

SpineFrame Spine::moved(const SpineFrame& frame, const Span& span, double t) const {
  SpineFrame there;
  there.point = span.point(t);
  there.tangent = normalized(span.derivative(t));
  const auto way = there.point - frame.point;
  const auto turn = there.tangent - reflected(frame.tangent, way);
  there.normal = across(there.tangent, reflected(reflected(frame.normal, way), turn));
  there.binormal = cross(there.tangent, there.normal);
  return there;
}

SpineFrame Spine::frameAt(double arc) const {
  const auto next = std::ranges::upper_bound(samples_, arc, {}, &Sample::arc);
  if (next == samples_.begin() || next == samples_.end()) {
    const auto& end = next == samples_.begin() ? samples_.front() : samples_.back();
    auto frame = end.frame;
    frame.point += (arc - end.arc) * frame.tangent;
    return frame;
  }
  const auto& sample = *(next - 1);
  const auto& span = spans_[sample.span];
  // Newton's method; within a sample's reach, the speed hardly changes.
  double t = sample.t;
  for (int step = 0; step < 4; ++step) {
    const double missing = arc - sample.arc - span.arc(sample.t, t);
    t += missing / norm(span.derivative(t));
  }
  return moved(sample.frame, span, std::min(t, span.chord));
}

}  // namespace cutwater
