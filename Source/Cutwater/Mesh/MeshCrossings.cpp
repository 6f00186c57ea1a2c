#include <Cutwater/Mesh/MeshCrossings.hpp>

#include <algorithm>

namespace cutwater {

namespace {

template <std::floating_point T>
class CrossingWalk {
 public:
  CrossingWalk(const MeshField<T>& field, const Segment<T>& segment, CrossingVisitor<T> visit)
      : field_(field),
        segment_(segment),
        visit_(visit),
        passages_(field.surface, {Vec3<double>(segment.start), Vec3<double>(segment.end)},
                  field.along),
        solid_(field.isInside(segment.start)) {}

  CrossingCount run() {
    if (field_.isClosed) {
      countWinding();
    } else {
      watchSigns();
    }
    return count_;
  }

 private:
  /// Signs are evaluated this far from passages; passages closer to each other are not
  /// distinguished.
  static constexpr double kGap = 0x1p-36;
  static constexpr int kHalvings = 8;

  // Each returns whether to continue.

  bool report(double parameter, const Vec3<T>& normal, const SurfaceOwner& owner) {
    solid_ = !solid_;
    ++count_.found;
    const T t = static_cast<T>(parameter);
    return visit_({.parameter = t,
                   .point = segment_.at(t) / field_.surface.scale,
                   .normal = normal,
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
  bool reportEnd(double parameter) {
    const auto& p = parameter == 0 ? segment_.start : segment_.end;
    const auto hit = field_.surface.surfacePoint(p, field_.nearest(p));
    return report(parameter, hit.normal, hit.owner);
  }

  /// Reports a crossing of a sheet that closes a hole. It has no triangle; its normal is along the
  /// segment.
  bool reportJump(double parameter) {
    const auto direction = normalized(segment_.end - segment_.start);
    const auto p = segment_.at(static_cast<T>(parameter));
    return report(parameter, solid_ ? direction : -direction,
                  field_.surface.owner(field_.nearest(p).triangle));
  }

  void countWinding() {
    int winding = locate(field_.surface, Vec3<double>(segment_.start), field_.along).winding;
    if ((winding >= 1) != solid_ && !reportEnd(0)) return;
    for (auto p = passages_.next(); p.triangle != kNone; p = passages_.next()) {
      winding -= p.direction;
      if ((winding >= 1) != solid_ && !reportPassage(p)) return;
    }
    if (field_.isInside(segment_.end) != solid_) reportEnd(1);
  }

  [[nodiscard]] bool isInside(double parameter) const {
    return field_.isInside(parameter < 1 ? segment_.at(static_cast<T>(parameter)) : segment_.end);
  }

  void watchSigns() {
    double done = 0;
    for (auto next = passages_.next(); next.triangle != kNone;) {
      const Passage first = next;
      double last = first.parameter;
      for (next = passages_.next(); next.triangle != kNone && next.parameter < last + 2 * kGap;
           next = passages_.next()) {
        last = next.parameter;
      }
      const double before = first.parameter - kGap;
      if (before > done && !searchJumps(done, before)) return;
      done = std::min(last + kGap, 1.0);
      if (isInside(done) != solid_ && !reportPassage(first)) return;
    }
    if (done < 1) searchJumps(done, 1);
  }

  bool searchJumps(double from, double to, int halvings = kHalvings) {
    return searchJumps(from, to, isInside(to), halvings);
  }

  /// Searches from a place with the present sign to one where the sign is `solidThere`.
  bool searchJumps(double from, double to, bool solidThere, int halvings) {
    if (solid_ == solidThere) {
      const auto piece = Box<double>{}
                             .extend(Vec3<double>(segment_.at(static_cast<T>(from))))
                             .extend(Vec3<double>(segment_.at(static_cast<T>(to))));
      if (field_.isJumpFree(piece)) return true;
      if (halvings == 0) {
        ++count_.unresolved;
        return true;
      }
    } else if (halvings == 0) {
      return reportJump(bisected(from, to));
    }
    const double middle = 0.5 * (from + to);
    return searchJumps(from, middle, halvings - 1) &&
           searchJumps(middle, to, solidThere, halvings - 1);
  }

  [[nodiscard]] double bisected(double from, double to) const {
    for (;;) {
      const double middle = 0.5 * (from + to);
      // Tested in T's precision, so that the loop terminates.
      if (!(static_cast<T>(from) < static_cast<T>(middle) &&
            static_cast<T>(middle) < static_cast<T>(to))) {
        return to;
      }
      (isInside(middle) == solid_ ? from : to) = middle;
    }
  }

  const MeshField<T>& field_;
  Segment<T> segment_;
  CrossingVisitor<T> visit_;
  PassageWalk<T> passages_;
  bool solid_;
  CrossingCount count_;
};

}  // namespace

template <std::floating_point T>
CrossingCount meshCrossings(const MeshField<T>& field, const Segment<T>& segment,
                            CrossingVisitor<T> visit) {
  return CrossingWalk<T>(field, segment, visit).run();
}

template CrossingCount meshCrossings(const MeshField<float>&, const Segment<float>&,
                                     CrossingVisitor<float>);
template CrossingCount meshCrossings(const MeshField<double>&, const Segment<double>&,
                                     CrossingVisitor<double>);

}  // namespace cutwater
