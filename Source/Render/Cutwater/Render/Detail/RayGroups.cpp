#include <Cutwater/Render/Detail/RayGroups.hpp>

#include <algorithm>
#include <vector>

namespace cutwater::detail {

namespace {

constexpr std::size_t kSmallest = 4;  // rays of a group
constexpr int kMostSteps = 64;        // of groups of one size
/// Steps shorter than this part of a group's radius are left to smaller groups.
constexpr double kShortest = 0.5;

/// Rays with a certain distance to one of them.
class RayGroup {
 public:
  explicit RayGroup(std::span<GroupedRay> rays)
      : rays_(rays),
        first_(std::ranges::min_element(rays, {}, &GroupedRay::along)->ray),
        along_(std::ranges::min(rays, {}, &GroupedRay::along).along),
        end_(std::ranges::min(rays, {}, &GroupedRay::end).end) {
    for (const auto& [ray, end, along] : rays) {
      apart_ = std::max(apart_, length(ray->origin - first_->origin));
      diverging_ = std::max(diverging_, length(ray->direction - first_->direction));
    }
  }

  [[nodiscard]] Vec3<double> place() const { return first_->at(along_); }

  /// Advances by what is free about its place; returns whether to go on.
  bool advance(double free, const Camera& camera, double reach) {
    const double radius = apart_ + diverging_ * along_;
    const double step = free - radius;
    if (!(step > std::max(kShortest * radius, reach * camera.pixelSize(along_)))) return false;
    along_ += step;
    return along_ < end_;
  }

  void tellRays() const {
    for (auto& ray : rays_) ray.along = std::max(ray.along, along_);
  }

 private:
  std::span<GroupedRay> rays_;
  const Ray* first_;
  double along_;
  double end_;
  double apart_ = 0;
  double diverging_ = 0;
};

}  // namespace

void advanceTogether(std::span<GroupedRay> rays, const Camera& camera, double reach,
                     FreeRadii freeAbout) {
  std::vector<RayGroup> groups;
  std::vector<std::size_t> moving;
  std::vector<Vec3<double>> places;
  std::vector<double> radii;
  for (auto size = rays.size(); size >= kSmallest; size = (size + 3) / 4) {
    groups.clear();
    moving.clear();
    for (std::size_t i = 0; i < rays.size(); i += size) {
      moving.push_back(groups.size());
      groups.emplace_back(rays.subspan(i, std::min(size, rays.size() - i)));
    }
    for (int step = 0; step < kMostSteps && !moving.empty(); ++step) {
      places.clear();
      for (const auto g : moving) places.push_back(groups[g].place());
      radii.resize(places.size());
      freeAbout(places, radii);
      std::size_t kept = 0;
      for (std::size_t k = 0; k < radii.size(); ++k) {
        if (groups[moving[k]].advance(radii[k], camera, reach)) moving[kept++] = moving[k];
      }
      moving.resize(kept);
    }
    for (const auto& group : groups) group.tellRays();
  }
}

}  // namespace cutwater::detail
