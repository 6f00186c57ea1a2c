#include <Cutwater/Mesh/Detail/MeshCrossings.hpp>

#include <algorithm>

namespace cutwater {

namespace {

template <std::floating_point T>
class CrossingWalk {
 public:
  CrossingWalk(const MeshField<T>& field, const MeshSegment<T>& segment, CrossingVisitor<T> visit)
      : field_(field),
        ends_(segment.ends),
        segment_(segment.searched),
        visit_(visit),
        passages_(field.surface, segment.searched, field.along, segment.atOnce),
        solid_(field.isInside(segment.ends.start)) {}

  CrossingCount run() {
    const bool isComplete = field_.isClosed             ? countWinding()
                            : field_.winding != nullptr ? followWinding()
                                                        : watchSigns();
    if (isComplete && field_.isInside(ends_.end) != solid_) reportEnd(1);
    return count_;
  }

 private:
  static constexpr int kHalvings = 8;
  static constexpr double kFinest = 0x1p-60;  // parameters nearer to each other are one

  // Each returns whether to continue.

  /// A normal of 0 is replaced by the segment's direction.
  bool report(double parameter, const Vec3<T>& normal, const SurfaceOwner& owner) {
    solid_ = !solid_;
    ++count_.found;
    const auto along = solid_ ? -direction() : direction();
    return visit_({.parameter = static_cast<T>(parameter),
                   .point = pointAt(parameter) / field_.surface.scale,
                   .normal = lengthSquared(normal) > 0 ? normal : along,
                   .entering = solid_,
                   .owner = owner});
  }

  bool reportPassage(const Passage& passage) {
    // The normal points out of the solid, even where the face is turned the other way.
    const bool entering = !solid_;
    const auto normal = unitNormal(field_.surface.triangle(passage.triangle));
    return report(passage.parameter, entering == (passage.direction < 0) ? normal : -normal,
                  field_.surface.owner(passage.triangle));
  }

  /// Reports an end of the segment that lies on the surface, and on its inner side by perturbation.
  /// By pseudonormals, the part searched may also end where the sign is not that of a far end.
  bool reportEnd(double parameter) {
    const auto p = pointAt(parameter);
    const auto nearest = field_.nearest(p);
    if (nearest.distanceSquared > nearest.error * nearest.error) return reportJump(parameter);
    const auto hit = field_.surface.surfacePoint(p, nearest);
    return report(parameter, hit.normal, hit.owner);
  }

  /// Reports a crossing of a sheet that closes a hole. It has no triangle; its normal is along the
  /// segment.
  bool reportJump(double parameter) {
    const auto nearest = field_.nearest(pointAt(parameter));
    return report(parameter, {}, field_.surface.owner(nearest.triangle));
  }

  bool countWinding() {
    int winding = locate(field_.surface, segment_.start, field_.along).winding;
    if ((winding >= 1) != solid_ && !reportEnd(0)) return false;
    for (auto p = passages_.next(); p.triangle != kNone; p = passages_.next()) {
      winding -= p.direction;
      if ((winding >= 1) != solid_ && !reportPassage(p)) return false;
    }
    return true;
  }

  /// The winding number is followed along the segment. It is smooth except where it changes by one
  /// at each passage; these are counted, so it does not matter to which side of a triangle a point
  /// is rounded.
  bool followWinding() {
    winding_ = field_.winding->closedWinding(field_.surface, field_.along, segment_.start);
    if (isInside(0) != solid_ && !reportEnd(0)) return false;
    double done = 0;
    for (auto p = passages_.next(); p.triangle != kNone; p = passages_.next()) {
      if (!searchJumps(done, p.parameter)) return false;
      done = p.parameter;
      winding_ -= p.direction;
      if (isInside(done) != solid_ && !reportPassage(p)) return false;
    }
    return searchJumps(done, 1);
  }

  /// Signs are evaluated beside passages; those closer to each other are not distinguished.
  bool watchSigns() {
    const double gap = this->gap();
    if (isInside(0) != solid_ && !reportEnd(0)) return false;
    double done = 0;
    for (auto next = passages_.next(); next.triangle != kNone;) {
      const Passage first = next;
      double last = first.parameter;
      int merged = 1;
      for (next = passages_.next(); next.triangle != kNone && next.parameter < last + 2 * gap;
           next = passages_.next()) {
        last = next.parameter;
        ++merged;
      }
      if (!searchJumps(done, first.parameter - gap)) return false;
      done = std::min(last + gap, 1.0);
      const bool isCrossed = isInside(done) != solid_;
      if (merged > 1 || !isCrossed) ++count_.unresolved;
      if (isCrossed && !reportPassage(first)) return false;
    }
    return searchJumps(done, 1);
  }

  /// The parameter's change over which points are certain not to be rounded to the same side.
  [[nodiscard]] double gap() const {
    const double rounding = 4 * double{std::numeric_limits<T>::epsilon()} *
                            (length(segment_.start) + length(segment_.end));
    return std::max(0x1p-36, rounding / length(segment_.end - segment_.start));
  }

  /// At this parameter of the present stretch between passages.
  [[nodiscard]] bool isInside(double parameter) const {
    if (field_.winding == nullptr) return field_.isInside(pointAt(parameter));
    return field_.winding->isInside([this](const Vec3<double>& p) { return closedWinding(p); },
                                    segment_.at(parameter));
  }

  /// Of surface and caps at a point of the present stretch, within rounding.
  [[nodiscard]] int closedWinding(const Vec3<double>& p) const {
    const int here = field_.winding->closedWinding(field_.surface, field_.along, p);
    const int counted = winding_ - field_.winding->capsPassed(segment_, p);
    if (here == counted) return here;
    // The point was rounded to the other side of a triangle, or else of a cap along the segment.
    const auto nearest = field_.nearest(static_cast<Vec3<T>>(p));
    return nearest.distanceSquared <= nearest.error * nearest.error ? counted : here;
  }

  [[nodiscard]] Vec3<T> pointAt(double parameter) const {
    return static_cast<Vec3<T>>(segment_.at(parameter));
  }

  [[nodiscard]] Vec3<T> direction() const {
    auto along = segment_.end - segment_.start;
    if (along == Vec3<double>{}) along = Vec3<double>(ends_.end) - Vec3<double>(ends_.start);
    return static_cast<Vec3<T>>(normalized(along / maxComponent(abs(along))));
  }

  /// Whether the sign certainly does not change between these parameters.
  [[nodiscard]] bool isJumpFree(double from, double to) const {
    // Where the sign by pseudonormals flips away from an open surface is not known.
    if (field_.winding == nullptr) return false;
    const auto piece = Box<double>{}.extend(segment_.at(from)).extend(segment_.at(to));
    // Its points are rounded.
    const double rounding = 0x1p-50 * maxComponent(max(abs(piece.lower), abs(piece.upper)));
    return field_.winding->isDecided([this](const Vec3<double>& p) { return closedWinding(p); },
                                     segment_.at(0.5 * (from + to)), piece.grown(rounding));
  }

  bool searchJumps(double from, double to) {
    return from >= to || searchJumps(from, to, isInside(to), kHalvings);
  }

  /// Searches from a place with the present sign to one where the sign is `solidThere`.
  bool searchJumps(double from, double to, bool solidThere, int halvings) {
    if (solid_ == solidThere) {
      if (isJumpFree(from, to)) return true;
      if (halvings == 0) {
        ++count_.unresolved;
        return true;
      }
    } else if (halvings == 0) {
      return reportJump(bisected(from, to));
    }
    const double middle = 0.5 * (from + to);
    return searchJumps(from, middle, isInside(middle), halvings - 1) &&
           searchJumps(middle, to, solidThere, halvings - 1);
  }

  [[nodiscard]] double bisected(double from, double to) const {
    while (to - from > kFinest) {
      const double middle = 0.5 * (from + to);
      // Tested in T's precision, so that the loop terminates.
      if (!(static_cast<T>(from) < static_cast<T>(middle) &&
            static_cast<T>(middle) < static_cast<T>(to))) {
        break;
      }
      (isInside(middle) == solid_ ? from : to) = middle;
    }
    return to;
  }

  const MeshField<T>& field_;
  Segment<T> ends_;
  Segment<double> segment_;
  CrossingVisitor<T> visit_;
  PassageWalk<T> passages_;
  bool solid_;
  int winding_ = 0;  // of the surface and its caps at the start, less passages through the surface
  CrossingCount count_;
};

}  // namespace

template <std::floating_point T>
CrossingCount meshCrossings(const MeshField<T>& field, const MeshSegment<T>& segment,
                            CrossingVisitor<T> visit) {
  return CrossingWalk<T>(field, segment, visit).run();
}

template CrossingCount meshCrossings(const MeshField<float>&, const MeshSegment<float>&,
                                     CrossingVisitor<float>);
template CrossingCount meshCrossings(const MeshField<double>&, const MeshSegment<double>&,
                                     CrossingVisitor<double>);

}  // namespace cutwater
