#include <Cutwater/Render/SphereTracer.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cutwater::detail {

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// Of an exact distance; and of a mere bound, which may be less than the distance.
constexpr double kNearEnough = 1.0 / 40;
constexpr double kNearEnoughByBound = 1.0 / 320;
/// Sheets have no crossings to ask about: a ray along one sees it from this much farther with every
/// so many steps, which bounds their number.
constexpr int kStepsOfPatience = 1024;
/// How far from a sheet another may lie to be the same, or a point beyond a cut, in pixels.
constexpr double kSamePlace = 1e-3;
/// Half the diagonal of a square, and a sixth more: of two steps past a point the nearer end is at
/// most 1.16 times as far from it as the ray.
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
      occlusion_(solid, distance_, region, options.occlusionRadius),
      nearEnough_(distance_.isExact() ? kNearEnough : kNearEnoughByBound) {}

/// The rays of one call.
template <std::floating_point T>
class SphereTracer<T>::Packet {
 public:
  Packet(const SphereTracer& tracer, std::span<const PicturePoint> points, double spacing,
         std::span<SurfaceSample> samples)
      : t_(tracer), reach_(kReach * spacing), samples_(samples) {
    for (const auto& point : points) {
      const auto ray = t_.camera_.ray(point.x, point.y);
      const auto range = t_.region_.clip(ray, t_.camera_.nearest());
      const auto index = static_cast<std::uint32_t>(lines_.size());
      lines_.push_back({ray, range, range.begin});
      samples_[index] = {};
      if (!range.empty()) active_.push_back(index);
    }
    points_.resize(active_.size());
    values_.resize(active_.size());
  }

  void run() {
    stopAtCuts();
    if (t_.distance_.isKnown()) {
      startTogether();
      march();
    }
    for (const auto i : active_) meetsBetween(i, lines_[i].along, lines_[i].range.end);
    settle(arrived_, false);
    for (std::uint32_t i = 0; i < lines_.size(); ++i) {
      if (!samples_[i].isHit() && lines_[i].nearest < reach_) passing_.push_back(i);
    }
    settle(passing_, true);
    if (t_.options_.occlusionRadius > 0) lookAround();
  }

 private:
  struct Line {
    Ray ray;
    RayRange range;
    double along;           // nothing is seen up to here
    double nearest = kInf;  // in pixels, of those steps
    double nearestAlong = 0;
  };

  [[nodiscard]] Vec3<T> at(const Vec3<double>& p) const { return Vec3<T>(p); }

  /// Values where the active rays are.
  void evaluate() {
    for (std::size_t k = 0; k < active_.size(); ++k) {
      const auto& line = lines_[active_[k]];
      points_[k] = at(line.ray.at(line.along));
    }
    t_.solid_.signedDistances(std::span(points_).first(active_.size()),
                              std::span(values_).first(active_.size()), {.threads = 1});
  }

  /// Rays that come in through a cut within the solid see its face. What is within rounding of the
  /// surface shows the surface. Beside the rim of the face the surface that was cut away may be
  /// near; it is not seen, and left behind by a step that does not pass what remains.
  void stopAtCuts() {
    if (std::none_of(active_.begin(), active_.end(),
                     [&](auto i) { return lines_[i].range.cut != kNone; })) {
      return;
    }
    evaluate();
    keepActive([&](std::size_t k, Line& line, std::uint32_t i) {
      const auto cut = line.range.cut;
      if (cut == kNone) return true;
      if (!t_.distance_.isInside(values_[k], points_[k])) {
        const double step = t_.nearEnough_ * t_.camera_.pixelSize(line.along);
        const double free = t_.distance_(values_[k], points_[k]);
        if (free <= 0 || free > step) return true;
        const double next = std::min(line.along + step, line.range.end);
        if (meetsBetween(i, line.along, next)) return false;
        line.along = next;
        return true;
      }
      samples_[i].along = static_cast<float>(line.along);
      samples_[i].normal = Vec3<float>(t_.region_.normal(cut));
      samples_[i].surface = SurfaceSample::kCutFace + cut;
      return false;
    });
  }

  /// Steps of all rays alike: at equal distances along, they are all within some radius of the one
  /// that comes in first.
  void startTogether() {
    if (active_.size() < 2) return;
    const auto& first =
        lines_[*std::min_element(active_.begin(), active_.end(), [&](auto a, auto b) {
          return lines_[a].range.begin < lines_[b].range.begin;
        })];
    double end = kInf, apart = 0, diverging = 0;
    for (const auto i : active_) {
      const auto& line = lines_[i];
      end = std::min(end, line.range.end);
      apart = std::max(apart, length(line.ray.origin - first.ray.origin));
      diverging = std::max(diverging, length(line.ray.direction - first.ray.direction));
    }
    double along = first.range.begin;
    for (int step = 0; step < kMostSteps && along < end; ++step) {
      const auto p = at(first.ray.at(along));
      const double radius = apart + diverging * along;
      const double free = t_.distance_(t_.solid_.signedDistance(p), p) - radius;
      if (!(free > 0.5 * radius)) break;
      along += free;
    }
    for (const auto i : active_) lines_[i].along = std::max(lines_[i].along, along);
  }

  void march() {
    const int most = t_.options_.sheets ? 8 * kStepsOfPatience : kMostSteps;
    for (int step = 0; step < most && !active_.empty(); ++step) {
      keepActive(
          [](std::size_t, Line& line, std::uint32_t) { return line.along < line.range.end; });
      evaluate();
      const double patience =
          t_.options_.sheets ? std::max(1.0, static_cast<double>(step) / kStepsOfPatience) : 1;
      keepActive([&](std::size_t k, Line& line, std::uint32_t i) {
        const double free = t_.distance_(values_[k], points_[k]);
        const double pixel = t_.camera_.pixelSize(line.along);
        if (free <= t_.nearEnough_ * patience * pixel) {
          arrived_.push_back(i);
          return false;
        }
        if (free < line.nearest * pixel) {
          line.nearest = free / pixel;
          line.nearestAlong = line.along;
        }
        line.along += free;
        return true;
      });
    }
    if (t_.options_.sheets) active_.clear();
  }

  /// Whether there is a crossing on a part of a ray: the sample is of the first then.
  bool meetsBetween(std::uint32_t i, double from, double to) {
    if (!(from < to)) return false;
    const auto& ray = lines_[i].ray;
    t_.solid_.crossings({at(ray.at(from)), at(ray.at(to))}, [&](const Crossing<T>& crossing) {
      const double along = from + (to - from) * static_cast<double>(crossing.parameter);
      show(i, along, Vec3<double>(crossing.normal), crossing.owner.patch);
      return false;
    });
    return samples_[i].isHit();
  }

  void show(std::uint32_t i, double along, Vec3<double> normal, std::uint32_t patch) {
    const auto& direction = lines_[i].ray.direction;
    const double facing = dot(normal, direction);
    if (facing > 0) normal = -normal;
    if (!(lengthSquared(normal) > 0.5)) normal = -direction;  // none is known
    samples_[i].along = static_cast<float>(along);
    samples_[i].normal = Vec3<float>(normal);
    samples_[i].surface = patch;
  }

  /// Finds out where rays meet the surface, or pass it, from the points of it nearest to them.
  void settle(std::span<const std::uint32_t> which, bool passing) {
    points_.resize(which.size());
    nearest_.resize(which.size());
    for (std::size_t k = 0; k < which.size(); ++k) {
      const auto& line = lines_[which[k]];
      points_[k] = at(line.ray.at(passing ? line.nearestAlong : line.along));
    }
    t_.solid_.closestPoints(points_, nearest_, {.threads = 1});
    for (std::size_t k = 0; k < which.size(); ++k) {
      if (passing) {
        pass(which[k], nearest_[k], points_[k]);
      } else {
        meet(which[k], nearest_[k]);
      }
    }
  }

  void meet(std::uint32_t i, const SurfacePoint<T>& nearest) {
    const auto& line = lines_[i];
    const Vec3<double> normal(nearest.normal);
    // Towards the tangent plane, unless the ray runs along it.
    double along = line.along;
    const double speed = dot(normal, line.ray.direction);
    const double further = dot(normal, Vec3<double>(nearest.point) - line.ray.at(along)) / speed;
    const double most = t_.camera_.pixelSize(along);
    if (std::abs(speed) > 0.02 && std::abs(further) < most) along += further;
    along = std::clamp(along, line.range.begin, line.range.end);
    show(i, along, normal,
         t_.options_.sheets ? sheetAt(nearest, line.ray, along) : nearest.owner.patch);
  }

  /// Of sheets that lie on each other, nearest to the same points but for rounding: the patch of
  /// one that looks at the viewer if there is one, and of such the first.
  [[nodiscard]] std::uint32_t sheetAt(const SurfacePoint<T>& nearest, const Ray& ray,
                                      double along) const {
    const auto foot = nearest.point;
    const T reach = static_cast<T>(kSamePlace * t_.camera_.pixelSize(along));
    const Vec3<T> toViewer = -Vec3<T>(ray.direction);
    bool found = false;
    bool faces = false;
    auto patch = nearest.owner.patch;
    t_.solid_.facetsIn(Box<T>{foot, foot}.grown(reach), [&](const SurfaceFacet<T>& facet) {
      const bool isThere = std::abs(dot(facet.corners[0] - foot, facet.normal)) <= reach;
      const bool looks = dot(facet.normal, toViewer) > 0;
      if (!isThere || (faces && !looks)) return true;
      patch = found && faces == looks ? std::min(patch, facet.owner.patch) : facet.owner.patch;
      found = true;
      faces = looks;
      return true;
    });
    return patch;
  }

  void pass(std::uint32_t i, const SurfacePoint<T>& nearest, const Vec3<T>& p) {
    const auto& line = lines_[i];
    const double gap{length(nearest.point - p)};
    const double pixel = t_.camera_.pixelSize(line.nearestAlong);
    const double removed = t_.region_.clearance(Vec3<double>(nearest.point));
    if (!(gap < reach_ * pixel && removed < kSamePlace * pixel)) return;
    samples_[i].along = static_cast<float>(line.nearestAlong);
    samples_[i].normal = Vec3<float>(normalized(p - nearest.point));
    samples_[i].passed = nearest.owner.patch;
  }

  void lookAround() {
    std::vector<typename Occlusion<T>::Foot> feet;
    std::vector<std::uint32_t> owners;
    for (std::uint32_t i = 0; i < lines_.size(); ++i) {
      const auto& sample = samples_[i];
      if ((!sample.isHit() && sample.passed == kNone) || sample.isCut()) continue;
      feet.push_back(
          {lines_[i].ray.at(static_cast<double>(sample.along)), Vec3<double>(sample.normal)});
      owners.push_back(i);
    }
    const auto open = t_.occlusion_.openness(feet);
    for (std::size_t k = 0; k < open.size(); ++k) samples_[owners[k]].open = open[k];
  }

  /// Asks keep(k, line, index) for the k-th active ray, and has only these stay active.
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
  std::span<SurfaceSample> samples_;
  std::vector<Line> lines_;
  std::vector<std::uint32_t> active_;   // rays under way
  std::vector<std::uint32_t> arrived_;  // those that see something
  std::vector<std::uint32_t> passing_;  // those that nearly do
  std::vector<Vec3<T>> points_;
  std::vector<T> values_;
  std::vector<SurfacePoint<T>> nearest_;
};

template <std::floating_point T>
void SphereTracer<T>::trace(std::span<const PicturePoint> points, double spacing,
                            std::span<SurfaceSample> samples) const {
  Packet(*this, points, spacing, samples).run();
}

template class SphereTracer<float>;
template class SphereTracer<double>;

}  // namespace cutwater::detail
