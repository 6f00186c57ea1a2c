#include <Cutwater/Render/Detail/FacetRays.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace cutwater::detail {

namespace {

constexpr double kSlack = 1e-9;  // of a facet's size

/// For each child of a node how far along a ray its box begins, in the frame of the tree, which has
/// no turned nodes. In single precision: boxes are grown by more than what rounding does, and by
/// the distance at which a ray may pass.
class RayKeys {
 public:
  /// With u = 2^-24, distances along the ray are wrong by 4 u of themselves, and differences of
  /// coordinates by 2 u of the two.
  RayKeys(const Vec3<double>& start, const Vec3<double>& direction, double reach)
      : start_(start),
        grown_(static_cast<float>(reach) * (1 + 0x1p-20F) +
               0x1p-20F * (2 + static_cast<float>(maxComponent(abs(start))))) {
    constexpr float kLeast = 1e-20F;
    for (int axis = 0; axis < 3; ++axis) {
      const auto along = static_cast<float>(direction[axis]);
      inverse_[axis] = 1 / (std::abs(along) > kLeast ? along : kLeast);
    }
  }

  void operator()(const BvhNode<16>& node, BvhNode<16>::Lanes& out) const {
    BvhNode<16>::Lanes begin{}, end;
    end.fill(kMostKey);
    const Vec3<float> start(start_ - Vec3<double>(node.center));
    for (int axis = 0; axis < 3; ++axis) {
      const auto& lower = node.lower[static_cast<std::size_t>(axis)];
      const auto& upper = node.upper[static_cast<std::size_t>(axis)];
      // Out of the loop over the lanes, so that compilers vectorise it.
      const float grown = grown_, from = start[axis], inverse = inverse_[axis];
      for (std::size_t k = 0; k < out.size(); ++k) {
        const float one = (lower[k] - grown - from) * inverse;
        const float other = (upper[k] + grown - from) * inverse;
        const float first = one < other ? one : other;
        const float last = one < other ? other : one;
        begin[k] = first > begin[k] ? first : begin[k];
        end[k] = last < end[k] ? last : end[k];
      }
    }
    for (std::size_t k = 0; k < out.size(); ++k) {
      out[k] = begin[k] <= end[k] ? begin[k] : kMostKey;
    }
  }

 private:
  Vec3<double> start_;
  float grown_;
  Vec3<float> inverse_;
};

/// The point of an edge that is nearest to the line of a ray, and how far along the ray that is.
FacetPass passed(const Ray& ray, const Vec3<double>& start, const Vec3<double>& edge) {
  const auto across = [&](const Vec3<double>& v) {
    return v - dot(v, ray.direction) * ray.direction;
  };
  const auto from = across(start - ray.origin);
  const auto side = across(edge);
  const double size = lengthSquared(side);
  const double t = size > 0 ? std::clamp(-dot(from, side) / size, 0.0, 1.0) : 0;
  const auto point = start + t * edge;
  return {dot(point - ray.origin, ray.direction), point, kNone};
}

}  // namespace

/// The hits of one ray that may still count.
class FacetRays::Walk {
 public:
  Walk(const std::vector<Facet>& facets, const Ray& ray, double begin, double end, double samePlace)
      : facets_(facets), ray_(ray), begin_(begin), first_(end), samePlace_(samePlace) {}

  /// Looks at the facets of a leaf. Returns the distance along the ray beyond which no hit counts.
  double operator()(std::span<const std::uint32_t> slots) {
    for (const auto id : slots) {
      if (id == kNone) break;
      const auto along = meets(facets_[id]);
      if (!along || *along > limit()) continue;
      isFound_ = true;
      first_ = std::min(first_, *along);
      if (count_ == hits_.size()) forget();
      if (count_ < hits_.size()) hits_[count_++] = {*along, id};
    }
    return limit();
  }

  [[nodiscard]] std::optional<FacetHit> best() {
    if (!isFound_) return {};
    forget();
    const auto isBetter = [&](const Hit& a, const Hit& b) {
      const auto &one = facets_[a.facet], &other = facets_[b.facet];
      if (faces(one) != faces(other)) return faces(one);
      return one.patch != other.patch ? one.patch < other.patch : a.along < b.along;
    };
    const auto& hit = *std::min_element(hits_.begin(), hits_.begin() + count_, isBetter);
    return FacetHit{first_, facets_[hit.facet].normal, facets_[hit.facet].patch};
  }

 private:
  struct Hit {
    double along;
    std::uint32_t facet;
  };

  [[nodiscard]] double limit() const { return isFound_ ? first_ + samePlace_ : first_; }
  [[nodiscard]] bool faces(const Facet& facet) const {
    return dot(facet.normal, ray_.direction) < 0;
  }

  /// T. Möller and B. Trumbore 1997, "Fast, minimum storage ray/triangle intersection".
  [[nodiscard]] std::optional<double> meets(const Facet& facet) const {
    const auto across = cross(ray_.direction, facet.toLast);
    const double volume = dot(facet.toNext, across);
    if (volume == 0) return {};  // seen edge-on
    const auto from = ray_.origin - facet.corner;
    const double u = dot(from, across) / volume;
    const auto turned = cross(from, facet.toNext);
    const double v = dot(ray_.direction, turned) / volume;
    if (!(u >= -kSlack && v >= -kSlack && u + v <= 1 + kSlack)) return {};
    const double along = dot(facet.toLast, turned) / volume;
    if (!(along >= begin_)) return {};
    return along;
  }

  /// Drops the hits that are too far behind the first.
  void forget() {
    const auto end = std::remove_if(hits_.begin(), hits_.begin() + count_,
                                    [&](const Hit& hit) { return hit.along > limit(); });
    count_ = static_cast<std::size_t>(end - hits_.begin());
  }

  const std::vector<Facet>& facets_;
  const Ray& ray_;
  double begin_;
  double first_;
  double samePlace_;
  bool isFound_ = false;
  std::array<Hit, 16> hits_;
  std::size_t count_ = 0;
};

template <std::floating_point T>
std::optional<FacetRays> FacetRays::of(const SignedDistanceFunction<T>& solid,
                                       const Box<double>& box, int threads) {
  FacetRays rays;
  std::vector<Box<double>> boxes;
  const bool areAll =
      solid.facetsIn({Vec3<T>(box.lower), Vec3<T>(box.upper)}, [&](const SurfaceFacet<T>& facet) {
        std::array<Vec3<double>, 3> corners;
        std::ranges::transform(facet.corners, corners.begin(),
                               [](const Vec3<T>& p) { return Vec3<double>(p); });
        const auto& [a, b, c] = corners;
        auto around = Box<double>{}.extend(a).extend(b).extend(c);
        boxes.push_back(around.grown(2 * kSlack * around.diagonal()));
        rays.facets_.push_back({a, b - a, c - a, Vec3<double>(facet.normal), facet.owner.patch});
        return true;
      });
  if (!areAll || boxes.empty()) return {};
  rays.tree_ = buildBvh<16, 4>(boxes, threads);
  return rays;
}

std::optional<FacetHit> FacetRays::first(const Ray& ray, double begin, double end,
                                         double samePlace) const {
  if (!(begin < end)) return {};
  Walk walk(facets_, ray, begin, end, samePlace);
  visitAlong(ray, begin, end, 0, [&](auto slots) { return walk(slots); });
  return walk.best();
}

std::optional<FacetPass> FacetRays::nearest(const Ray& ray, double begin, double end,
                                            FunctionRef<double(double)> reach) const {
  if (!(begin < end)) return {};
  std::optional<FacetPass> best;
  double least = 1;  // times the reach
  visitAlong(ray, begin, end, reach(end), [&](std::span<const std::uint32_t> slots) {
    for (const auto id : slots) {
      if (id == kNone) break;
      const auto& [corner, toNext, toLast, normal, patch] = facets_[id];
      const std::array edges{std::array{corner, toNext}, std::array{corner, toLast},
                             std::array{corner + toNext, toLast - toNext}};
      for (const auto& [start, along] : edges) {
        const auto pass = passed(ray, start, along);
        if (!(pass.along >= begin && pass.along <= end)) continue;
        const double distance = length(pass.point - ray.at(pass.along)) / reach(pass.along);
        if (!(distance < least)) continue;
        least = distance;
        best = {pass.along, pass.point, patch};
      }
    }
    return end;
  });
  return best;
}

template <typename Visit>
void FacetRays::visitAlong(const Ray& ray, double begin, double end, double reach,
                           Visit visit) const {
  const auto& frame = tree_.frame;
  const auto limit = [&](double along) {
    const double most = std::min(frame.scale * (along - begin), 1e30);
    return static_cast<float>(most) * (1 + 0x1p-20F) + 0x1p-20F;
  };
  tree_.tree().traverse(
      RayKeys(frame.toFrame(ray.at(begin)), ray.direction, frame.scale * reach),
      [&](std::span<const std::uint32_t> slots) { return limit(visit(slots)); }, limit(end));
}

template std::optional<FacetRays> FacetRays::of(const SignedDistanceFunction<float>&,
                                                const Box<double>&, int);
template std::optional<FacetRays> FacetRays::of(const SignedDistanceFunction<double>&,
                                                const Box<double>&, int);

}  // namespace cutwater::detail
