#include <embree3/rtcore.h>
#include <limits>
#include <stdexcept>
#include <tbb/global_control.h>

#include "Peers/PseudonormalSign.hpp"

namespace cutwater::benchmarks {

namespace {

/// Embree's tree is in float. Its user measures the triangles that it offers in double, and keeps
/// the radius of the search a little larger than the best distance so far: then the tree's rounding
/// loses no triangle, and the result is as exact as double gets.
class Embree final : public Peer {
 public:
  Embree(const PolygonSoup& triangles, int threads);
  ~Embree() override {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  void signedDistances(std::span<const Vec3<double>> points,
                       std::span<double> distances) const override {
    for (std::size_t i = 0; i < points.size(); ++i) distances[i] = signedDistance(points[i]);
  }

 private:
  struct Search {
    const Corners* corners;
    Vec3<double> p;
    double margin;
    double distanceSquared = std::numeric_limits<double>::infinity();
    ClosestPoint closest = {};
    unsigned triangle = 0;
  };

  static bool visit(RTCPointQueryFunctionArguments* args);
  [[nodiscard]] double signedDistance(const Vec3<double>& p) const;
  void setGeometry(const PolygonSoup& triangles);

  RTCDevice device_;
  RTCScene scene_;
  double size_ = 0;  // of the largest coordinate
  std::vector<Corners> corners_;
  PseudonormalSign sign_;
};

Embree::Embree(const PolygonSoup& triangles, int threads)
    : device_(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())),
      scene_(rtcNewScene(device_)),
      corners_(cornersOf(triangles)),
      sign_(triangles) {
  for (const auto& p : triangles.points) size_ = std::max(size_, maxComponent(abs(p)));
  setGeometry(triangles);
  rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
  rtcCommitScene(scene_);
  if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw std::runtime_error("Embree: no scene");
}

void Embree::setGeometry(const PolygonSoup& triangles) {
  const auto geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                             RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                             triangles.points.size()));
  for (const auto& p : triangles.points) {
    for (int axis = 0; axis < 3; ++axis) *points++ = static_cast<float>(p[axis]);
  }
  auto* indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), triangles.polygonCount()));
  std::copy(triangles.corners.begin(), triangles.corners.end(), indices);
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
}

bool Embree::visit(RTCPointQueryFunctionArguments* args) {
  auto& search = *static_cast<Search*>(args->userPtr);
  const auto closest = closestPoint(search.p, search.corners[args->primID]);
  const double distanceSquared = lengthSquared(closest.offset);
  if (!(distanceSquared < search.distanceSquared)) return false;
  search.distanceSquared = distanceSquared;
  search.closest = closest;
  search.triangle = args->primID;
  args->query->radius = static_cast<float>(std::sqrt(distanceSquared) + search.margin);
  return true;
}

double Embree::signedDistance(const Vec3<double>& p) const {
  constexpr double kFloatEps = std::numeric_limits<float>::epsilon();
  Search search{
      .corners = corners_.data(), .p = p, .margin = 4 * kFloatEps * (size_ + maxComponent(abs(p)))};
  RTCPointQuery query{};
  query.x = static_cast<float>(p.x);
  query.y = static_cast<float>(p.y);
  query.z = static_cast<float>(p.z);
  query.radius = std::numeric_limits<float>::infinity();
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(scene_, &query, &context, visit, &search);
  return sign_.signedDistance(search.triangle, search.closest);
}

}  // namespace

std::unique_ptr<Peer> buildEmbree(const PolygonSoup& triangles, int threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  return std::make_unique<Embree>(triangles, threads);
}

}  // namespace cutwater::benchmarks
