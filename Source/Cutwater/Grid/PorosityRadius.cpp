#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/VolumeSearch.hpp>
#include <Cutwater/Grid/SolidVolume.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cutwater {

namespace {

/// The porosities computed so far, and on which side of the target they certainly are.
template <std::floating_point T>
class Trials {
 public:
  Trials(double porosity, FunctionRef<Solid<T>(T)> solidOf, const Box<T>& box,
         const VolumeOptions& options)
      : porosity_(porosity), solidOf_(solidOf), box_(box), options_(options) {}

  /// Less or greater than the target, or equivalent if that is undecided.
  std::weak_ordering compare(T radius) {
    return sideOf(tryAt(radius, options_, [this](const Interval<double>& volume) {
      return std::is_neq(sideOf(porosityOf(volume)));
    }));
  }
  /// Computes a porosity to be compared with others.
  void sample(T radius) {
    auto coarse = options_;
    coarse.fraction = std::max(coarse.fraction, 0.01);
    tryAt(radius, coarse, [](const Interval<double>&) { return false; });
  }

  [[nodiscard]] int count() const { return static_cast<int>(seen_.size()); }
  /// Whether no two of them are certainly out of order with their radii.
  [[nodiscard]] bool areOrdered(bool isGrowing) const {
    for (const auto& a : seen_) {
      for (const auto& b : seen_) {
        if (!(a.radius < b.radius)) continue;
        const auto& [less, more] = isGrowing ? std::pair(a, b) : std::pair(b, a);
        if (less.porosity.lower > more.porosity.upper) return false;
      }
    }
    return true;
  }

 private:
  struct Seen {
    T radius;
    Interval<double> porosity;
  };

  Interval<double> tryAt(T radius, const VolumeOptions& options,
                         FunctionRef<bool(const Interval<double>& volume)> isEnough) {
    const auto solid = solidOf_(radius);
    const auto found = detail::VolumeSearch<T>(solid, box_, options).run(isEnough).porosity();
    seen_.push_back({radius, found});
    return found;
  }
  [[nodiscard]] Interval<double> porosityOf(const Interval<double>& volume) const {
    return VolumeBounds{.volume = volume, .boxVolume = detail::volumeOf(box_)}.porosity();
  }
  [[nodiscard]] std::weak_ordering sideOf(const Interval<double>& porosity) const {
    if (porosity.upper < porosity_) return std::weak_ordering::less;
    if (porosity.lower > porosity_) return std::weak_ordering::greater;
    return std::weak_ordering::equivalent;
  }

  double porosity_;
  FunctionRef<Solid<T>(T)> solidOf_;
  Box<T> box_;
  VolumeOptions options_;
  std::vector<Seen> seen_;
};

/// Bisection of a range whose ends are on different sides, as far as sides are decided.
template <std::floating_point T>
class Bisection {
 public:
  Bisection(Trials<T>& trials, std::weak_ordering atLower, const Interval<T>& range, T width)
      : trials_(trials), atLower_(atLower), range_(range), width_(width) {}

  Interval<T> run() {
    while (range_.upper - range_.lower > width_) {
      const T middle = middleOf(range_.lower, range_.upper);
      if (middle == range_.lower || middle == range_.upper) break;
      const auto side = trials_.compare(middle);
      if (std::is_eq(side)) {
        narrow(range_.lower, middle, atLower_);
        narrow(range_.upper, middle, opposite(atLower_));
        break;
      }
      (side == atLower_ ? range_.lower : range_.upper) = middle;
    }
    return range_;
  }

 private:
  static T middleOf(T a, T b) { return T(0.5) * a + T(0.5) * b; }
  static std::weak_ordering opposite(std::weak_ordering side) {
    return std::is_lt(side) ? std::weak_ordering::greater : std::weak_ordering::less;
  }

  /// Moves an end, where porosities are on that side, towards an undecided radius.
  void narrow(T& end, T open, std::weak_ordering side) {
    while (std::abs(open - end) > T(0.5) * width_) {
      const T middle = middleOf(end, open);
      if (middle == end || middle == open) break;
      (trials_.compare(middle) == side ? end : open) = middle;
    }
  }

  Trials<T>& trials_;
  std::weak_ordering atLower_;
  Interval<T> range_;
  T width_;
};

}  // namespace

template <std::floating_point T>
PorosityRadius<T> porosityRadius(double porosity, FunctionRef<Solid<T>(T radius)> solidOf,
                                 const Interval<T>& range, const Box<T>& box,
                                 const PorosityRadiusOptions& options) {
  require(std::isfinite(range.lower) && std::isfinite(range.upper) && range.lower < range.upper,
          "porosityRadius: need a finite range", Named{"lower", range.lower},
          Named{"upper", range.upper});
  require(0 < options.tolerance && options.tolerance < 1, "porosityRadius: need 0 < tolerance < 1",
          Named{"tolerance", options.tolerance});
  require(options.samples >= 0, "porosityRadius: need samples >= 0",
          Named{"samples", options.samples});
  detail::requireVolume(box);
  Trials<T> trials(porosity, solidOf, box, options.volume);
  const auto atLower = trials.compare(range.lower);
  const auto atUpper = trials.compare(range.upper);
  require(std::is_neq(atLower) && std::is_neq(atUpper) && atLower != atUpper,
          "porosityRadius: need a range with certainly more and less than the porosity at its ends",
          Named{"porosity", porosity}, Named{"lower", range.lower}, Named{"upper", range.upper});
  for (int n = 1; n <= options.samples; ++n) {
    const T part = static_cast<T>(n) / static_cast<T>(options.samples + 1);
    trials.sample((1 - part) * range.lower + part * range.upper);
  }
  const T width = static_cast<T>(options.tolerance) * (range.upper - range.lower);
  const auto radius = Bisection<T>(trials, atLower, range, width).run();
  return {radius, trials.areOrdered(std::is_lt(atLower)), trials.count()};
}

template PorosityRadius<float> porosityRadius(double, FunctionRef<Solid<float>(float)>,
                                              const Interval<float>&, const Box<float>&,
                                              const PorosityRadiusOptions&);
template PorosityRadius<double> porosityRadius(double, FunctionRef<Solid<double>(double)>,
                                               const Interval<double>&, const Box<double>&,
                                               const PorosityRadiusOptions&);

}  // namespace cutwater
