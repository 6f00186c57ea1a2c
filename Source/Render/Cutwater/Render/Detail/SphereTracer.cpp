#include <Cutwater/Render/Detail/RayGroups.hpp>
#include <Cutwater/Render/Detail/SphereTracer.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cutwater::detail {

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// Thresholds, in pixels, for an exact distance and for a bound, which may be less than the
/// distance.
constexpr double kNearEnough = 1.0 / 40;
constexpr double kNearEnoughByBound = 1.0 / 320;
/// In drafts a ray within half a pixel of the surface goes on to the tangent plane at once, unless
/// that takes it further than a pixel.
constexpr double kNearEnoughInDrafts = 0.5;
/// So far they step at most if they cannot: as long as they are within half a pixel, anything that
/// they pass is thinner than that.
constexpr double kLongestInDrafts = 1;
/// For sheets crossings() is of no use. Instead, the threshold for a ray along one grows every this
/// many steps, which bounds their number.
constexpr int kStepsOfPatience = 1024;
/// The largest allowance for rounding, in pixels: more would be visible.
constexpr double kBlur = 0.25;
/// Half the diagonal of a square, and a sixth more: when a ray steps past a point, the nearer end
/// of the step is at most 1.16 times as far from it as the ray.
constexpr double kReach = 0.5 * 1.42 * 1.17;

}  // namespace

template <std::floating_point T>
SphereTracer<T>::SphereTracer(const SignedDistanceFunction<T>& solid, const KeptRegion& region,
                              const Camera& camera, const TraceOptions& options)
    : solid_(solid),
      region_(region),
      camera_(camera),
      options_(options),
      distance_(solid.guarantee(), region.box(), options.sheets),
      occlusion_(solid, distance_, region,
                 {.radius = options.occlusionRadius, .hasFacets = options.facets != nullptr}),
      facets_(distance_.isExact() ? options.facets : nullptr),
      sighting_(solid, region, camera, options.sheets),
      nearEnough_(distance_.isExact() ? kNearEnough : kNearEnoughByBound) {}

/// The rays of one call.
template <std::floating_point T>
class SphereTracer<T>::Packet {
 public:
  Packet(const SphereTracer& tracer, std::span<const PicturePoint> points, const RaySpread& spread,
         std::span<const SurfaceSample> others)
      : t_(tracer),
        reach_(kReach * spread.spacing),
        group_(spread.group),
        others_(others),
        samples_(points.size()) {
    for (const auto& point : points) {
      const auto ray = t_.camera_.ray(point.x, point.y);
      const auto range = t_.region_.clip(ray, t_.camera_.nearest());
      const auto index = static_cast<std::uint32_t>(lines_.size());
      const auto& other = others_[index];
      const double end =
          other.isHit() ? std::min(range.end, other.along + samePlace(other)) : range.end;
      lines_.push_back({ray, range, end, range.begin});
      if (range.begin < end && !other.isCut()) active_.push_back(index);
    }
    points_.resize(active_.size());
    values_.resize(active_.size());
  }

  void run() {
    stopAtCuts();
    if (t_.facets_ != nullptr) {
      meetFacets();
      passFacets();
      return;
    }
    if (t_.distance_.isKnown()) {
      startTogether();
      march();
    }
    for (const auto i : active_) meetsBetween(i, lines_[i].along, lines_[i].end);
    sampleArrived();
    for (std::uint32_t i = 0; i < lines_.size(); ++i) {
      if (lines_[i].nearest < reach_ && !groupSees(i)) passing_.push_back(i);
    }
    samplePassing();
  }

  /// Replaces what others see by what is in front of it.
  void addTo(std::span<SurfaceSample> samples) const {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      auto sample = samples_[i];
      if (sample.isHit() && !sample.isCut()) sample.surface = t_.patchOf(sample.surface);
      if (sample.passed != kNone) sample.passed = t_.patchOf(sample.passed);
      if (isInFront(sample, samples[i])) samples[i] = sample;
    }
  }

 private:
  struct Line {
    Ray ray;
    RayRange range;
    double end;             // of the part before what others see
    double along;           // nothing visible up to here
    double nearest = kInf;  // least distance so far, in pixels
    double nearestAlong = 0;
    // Of a ray within half a pixel of the surface that did not go on to its tangent plane:
    bool isBeside = false;
    double speed = 0;  // towards the surface, per length of the ray
    double free = 0;   // at the place before, and the step from there; no step: not yet
    double step = 0;
  };

  [[nodiscard]] Vec3<T> at(const Vec3<double>& p) const { return Vec3<T>(p); }
  /// Lengths along a ray that make no difference, where it sees something.
  [[nodiscard]] double samePlace(const SurfaceSample& seen) const {
    return Sighting<T>::kSamePlace * t_.camera_.pixelSize(seen.along);
  }
  /// Of surfaces in the same place, the first patch is seen.
  [[nodiscard]] bool isInFront(const SurfaceSample& sample, const SurfaceSample& other) const {
    if (!sample.isHit()) return sample.passed != kNone && !other.isHit() && other.passed == kNone;
    if (!other.isHit() || sample.isCut()) return true;
    const double behind = sample.along - other.along;
    if (std::abs(behind) <= samePlace(other)) return sample.surface < other.surface;
    return behind < 0;
  }
  /// Whether any ray of the i-th one's group sees something. If so, it does not matter what others
  /// pass.
  [[nodiscard]] bool groupSees(std::size_t i) const {
    const auto first = i / group_ * group_;
    const auto end = std::min(first + group_, samples_.size());
    for (auto k = first; k < end; ++k) {
      if (samples_[k].isHit() || others_[k].isHit()) return true;
    }
    return false;
  }
  /// Evaluates the solid at the current points of the active rays.
  void evaluate() {
    points_.resize(active_.size());
    for (std::size_t k = 0; k < active_.size(); ++k) {
      const auto& line = lines_[active_[k]];
      points_[k] = at(line.ray.at(line.along));
    }
    t_.solid_.signedDistances(std::span(points_).first(active_.size()),
                              std::span(values_).first(active_.size()), {.threads = 1});
  }

  /// Rays that enter through a cut inside the solid see its face; within round-off of the surface
  /// they see the surface. Beside the rim of the face the surface that was cut away may be near; it
  /// is not visible, and a step that does not pass the remaining surface leaves it behind.
  void stopAtCuts() {
    if (std::none_of(active_.begin(), active_.end(),
                     [&](auto i) { return lines_[i].range.cut != kNone; })) {
      return;
    }
    evaluate();
    keepActive([&](std::size_t k, Line& line, std::uint32_t i) {
      if (line.range.cut == kNone) return true;
      const double pixel = t_.camera_.pixelSize(line.along);
      const double step = t_.nearEnough_ * pixel;
      if (!t_.distance_.isInside(values_[k], points_[k], kBlur * pixel)) {
        const double free = t_.distance_(values_[k], points_[k], kBlur * pixel);
        if (free <= 0 || free > step) return true;
        const double next = std::min(line.along + step, line.end);
        if (meetsBetween(i, line.along, next)) return false;
        line.along = next;
        return true;
      }
      if (!touchesCut(i, step)) samples_[i] = t_.sighting_.atCut(line.range);
      return false;
    });
  }

  /// Where only signs are known, they show whether the surface is within round-off of a cut: if so,
  /// they change one step before it. The sample is then of the surface.
  bool touchesCut(std::uint32_t i, double step) {
    const auto& line = lines_[i];
    const double before = line.along - step;
    return !t_.distance_.isKnown() && t_.solid_.signedDistance(at(line.ray.at(before))) >= 0 &&
           meetsBetween(i, before, line.along + step);
  }

  void meetFacets() {
    keepActive([&](std::size_t, Line& line, std::uint32_t i) {
      const double same = Sighting<T>::kSamePlace * t_.camera_.pixelSize(line.along);
      const auto hit = t_.facets_->first(line.ray, line.along, line.end, same);
      if (hit) samples_[i] = Sighting<T>::atFacet(line.ray, *hit);
      return !hit;
    });
  }

  /// What is left of the rays meets no facet.
  void passFacets() {
    const auto reach = [&](double along) { return reach_ * t_.camera_.pixelSize(along); };
    for (const auto i : active_) {
      if (groupSees(i)) continue;
      const auto& line = lines_[i];
      const auto pass = t_.facets_->nearest(line.ray, line.along, line.end, reach);
      if (pass) samples_[i] = t_.sighting_.passing(line.ray, *pass, reach_);
    }
  }

  /// Advances rays as far as their neighbours' distances tell that they may be.
  void startTogether() {
    std::vector<GroupedRay> rays;
    for (const auto i : active_) {
      rays.push_back({&lines_[i].ray, lines_[i].end, lines_[i].along});
    }
    advanceTogether(rays, t_.camera_, reach_,
                    [&](std::span<const Vec3<double>> places, std::span<double> free) {
                      for (std::size_t k = 0; k < places.size(); ++k) points_[k] = at(places[k]);
                      const auto values = std::span(values_).first(places.size());
                      t_.solid_.signedDistances(std::span(points_).first(places.size()), values,
                                                {.threads = 1});
                      for (std::size_t k = 0; k < places.size(); ++k) {
                        free[k] = t_.distance_(values[k], points_[k], kInf);
                      }
                    });
    for (std::size_t k = 0; k < rays.size(); ++k) lines_[active_[k]].along = rays[k].along;
  }

  void march() {
    const int most = t_.options_.sheets ? 8 * kStepsOfPatience : kMostSteps;
    for (int step = 0; step < most && !active_.empty(); ++step) {
      keepActive([](auto, Line& line, auto) { return line.along < line.end; });
      evaluate();
      const double patience =
          t_.options_.sheets ? std::max(1.0, static_cast<double>(step) / kStepsOfPatience) : 1;
      keepActive([&](std::size_t k, Line& line, std::uint32_t i) {
        const double pixel = t_.camera_.pixelSize(line.along);
        const double free = t_.distance_(values_[k], points_[k], kBlur * pixel);
        if (free <= t_.nearEnough_ * patience * pixel) {
          arrived_.push_back(i);
          return false;
        }
        if (free < line.nearest * pixel) {
          line.nearest = free / pixel;
          line.nearestAlong = line.along;
        }
        line.along += t_.options_.isDraft ? stepInDraft(line, free, pixel, i) : free;
        return true;
      });
      if (!near_.empty()) landNearby();
    }
    if (t_.options_.sheets) active_.clear();
  }

  /// How far a ray goes on in a draft. One that runs along the surface, nearer than half a pixel,
  /// goes on to where it meets the surface if that is flat, or by a pixel if that is less.
  double stepInDraft(Line& line, double free, double pixel, std::uint32_t i) {
    if (free > kNearEnoughInDrafts * pixel) {
      line.isBeside = false;
      return free;
    }
    if (!line.isBeside) {
      near_.push_back(i);
      return free;
    }
    if (line.step > 0) line.speed = (line.free - free) / line.step;
    const double longest = pixel * kLongestInDrafts;
    line.free = free;
    line.step = std::max(free, free < line.speed * longest ? free / line.speed : longest);
    return line.step;
  }

  /// Ends those rays near the surface that meet its tangent plane within a pixel.
  void landNearby() {
    sampleByNearest(near_, &Line::along, [&](Line& line, const SurfacePoint<T>& nearest) {
      const Vec3<double> away = line.ray.at(line.along) - Vec3<double>(nearest.point);
      line.speed = -dot(Vec3<double>(nearest.normal), line.ray.direction);
      line.step = 0;
      line.isBeside = !(length(away) <= line.speed * t_.camera_.pixelSize(line.along));
      if (line.isBeside) return SurfaceSample{};
      return t_.sighting_.near(line.ray, line.range, line.along, nearest);
    });
    near_.clear();
    keepActive([&](auto, auto&, auto i) { return !samples_[i].isHit(); });
  }

  /// Whether there is a crossing on a part of a ray; the sample is then of the first one.
  bool meetsBetween(std::uint32_t i, double from, double to) {
    if (!(from < to)) return false;
    const auto& ray = lines_[i].ray;
    t_.solid_.crossings({at(ray.at(from)), at(ray.at(to))}, [&](const Crossing<T>& crossing) {
      const double along = from + (to - from) * static_cast<double>(crossing.parameter);
      samples_[i] = t_.sighting_.atCrossing(ray, along, crossing);
      return false;
    });
    return samples_[i].isHit();
  }

  /// Where rays meet the surface.
  void sampleArrived() {
    sampleByNearest(arrived_, &Line::along, [&](Line& line, const SurfacePoint<T>& nearest) {
      return t_.sighting_.near(line.ray, line.range, line.along, nearest);
    });
  }

  /// Where rays pass the surface.
  void samplePassing() {
    sampleByNearest(passing_, &Line::nearestAlong, [&](Line& line, const SurfacePoint<T>& nearest) {
      return t_.sighting_.passing(
          line.ray, {line.nearestAlong, Vec3<double>(nearest.point), nearest.owner.patch}, reach_);
    });
  }

  /// Calls sampleOf(line, closest surface point to the ray's point at `along`) for rays, and keeps
  /// the samples.
  template <typename SampleOf>
  void sampleByNearest(std::span<const std::uint32_t> rays, double Line::*along,
                       const SampleOf& sampleOf) {
    points_.resize(rays.size());
    nearest_.resize(rays.size());
    for (std::size_t k = 0; k < rays.size(); ++k) {
      const auto& line = lines_[rays[k]];
      points_[k] = at(line.ray.at(line.*along));
    }
    t_.solid_.closestPoints(points_, nearest_, {.threads = 1});
    for (std::size_t k = 0; k < rays.size(); ++k) {
      samples_[rays[k]] = sampleOf(lines_[rays[k]], nearest_[k]);
    }
  }

  /// Calls keep(k, line, index) for the k-th active ray, and keeps only those active for which it
  /// returns true.
  template <typename Keep>
  void keepActive(Keep keep) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < active_.size(); ++k) {
      const auto i = active_[k];
      if (keep(k, lines_[i], i)) active_[kept++] = i;
    }
    active_.resize(kept);
  }

  const SphereTracer& t_;
  double reach_;  // in pixels
  std::size_t group_;
  std::span<const SurfaceSample> others_;  // what rays see of other parts
  std::vector<SurfaceSample> samples_;     // of this one; patches by its own numbers
  std::vector<Line> lines_;
  std::vector<std::uint32_t> active_;   // rays still marching
  std::vector<std::uint32_t> near_;     // those that may have arrived, in a draft
  std::vector<std::uint32_t> arrived_;  // those that see something
  std::vector<std::uint32_t> passing_;  // those that nearly do
  std::vector<Vec3<T>> points_;
  std::vector<T> values_;
  std::vector<SurfacePoint<T>> nearest_;
};

template <std::floating_point T>
void SphereTracer<T>::trace(std::span<const PicturePoint> points, const RaySpread& spread,
                            std::span<SurfaceSample> samples) const {
  Packet packet(*this, points, spread, samples);
  packet.run();
  packet.addTo(samples);
}

template <std::floating_point T>
void SphereTracer<T>::light(std::span<const PicturePoint> points,
                            std::span<SurfaceSample> samples) const {
  std::vector<typename Occlusion<T>::Foot> feet;
  std::vector<std::size_t> owners;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto& sample = samples[i];
    if ((!sample.isHit() && sample.passed == kNone) || sample.isCut()) continue;
    feet.push_back(
        {camera_.ray(points[i].x, points[i].y).at(sample.along), Vec3<double>(sample.normal)});
    owners.push_back(i);
  }
  const auto open = occlusion_.openness(feet);
  for (std::size_t k = 0; k < open.size(); ++k) samples[owners[k]].open = open[k];
}

template class SphereTracer<float>;
template class SphereTracer<double>;

}  // namespace cutwater::detail
