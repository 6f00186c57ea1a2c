#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Mesh/PolygonGeometry.hpp>
#include <Cutwater/Mesh/SoundnessCheck.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

namespace cutwater {

namespace {

/// Where to probe: half of the places evenly spread over the list of triangles, so that small parts
/// count as much as large ones, half over the area. Within a triangle they follow M. Roberts' R2
/// sequence (2018, "The unreasonable effectiveness of quasirandom sequences").
template <std::floating_point T>
class Places {
 public:
  struct Place {
    std::uint32_t triangle;
    double b;  // barycentric weights of the second and the third corner
    double c;
  };

  Places(const TriangleSurface<T>& surface, std::size_t count) : count_(count) {
    double sum = 0;
    for (std::uint32_t id = 0; id < surface.triangles.size(); ++id) {
      const auto [a, b, c] = surface.corners(id);
      areas_.push_back(sum += length(cross(b - a, c - a)));
    }
  }

  [[nodiscard]] Place operator[](std::size_t i) const {
    constexpr double kPlastic = 1.3247179572447460;  // of x^3 = x + 1
    const std::size_t pair = i / 2;
    const auto share = [&](double step) {
      const double whole = 0.5 + static_cast<double>(pair) / step;
      return whole - std::floor(whole);
    };
    double b = share(kPlastic);
    double c = share(kPlastic * kPlastic);
    if (b + c > 1) b = 1 - b, c = 1 - c;
    // Off the edges: what is just beside them may be beyond the next triangle.
    constexpr double kInward = 0.125;
    return {triangle(i), b + kInward * (1.0 / 3 - b), c + kInward * (1.0 / 3 - c)};
  }

 private:
  [[nodiscard]] std::uint32_t triangle(std::size_t i) const {
    const std::size_t all = areas_.size();
    if (i % 2 == 0) return static_cast<std::uint32_t>(i * all / count_);
    const double area = (static_cast<double>(i) / static_cast<double>(count_)) * areas_.back();
    const auto found = std::ranges::upper_bound(areas_, area) - areas_.begin();
    return static_cast<std::uint32_t>(std::min(static_cast<std::size_t>(found), all - 1));
  }

  std::size_t count_;
  std::vector<double> areas_;  // twice that of all triangles up to this one
};

}  // namespace

template <std::floating_point T>
SoundnessProbes probeSoundness(const TriangleSurface<T>& surface, TrianglesAlong along,
                               std::size_t count, std::span<const std::uint32_t> always) {
  const Places<T> places(surface, count);
  std::atomic<std::size_t> probes{0};
  std::atomic<std::size_t> unsound{0};
  const auto probe = [&](const typename Places<T>::Place& place) {
    const auto corners = surface.corners(place.triangle);
    const auto normal = polygonArea(corners).normal;
    if (normal == Vec3<double>{}) return;
    const auto& [a, b, c] = corners;
    const auto point = a + place.b * (b - a) + place.c * (c - a);
    const Vec3<double> step = 0x1p-40 * (length(point) + double{surface.size}) * normal;
    const auto before = locate(surface, point + step, along);
    const auto behind = locate(surface, point - step, along);
    ++probes;
    const bool sound = before.winding == 0 && behind.winding == 1;
    if (!sound || before.onSurface || behind.onSurface) ++unsound;
  };
  parallelFor(count + always.size(), {.grain = 16, .progress = {}},
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                  constexpr double kThird = 1.0 / 3;
                  probe(i < count ? places[i]
                                  : typename Places<T>::Place{always[i - count], kThird, kThird});
                }
              });
  return {.probes = probes, .unsound = unsound};
}

template <std::floating_point T>
SignReport checkSigns(const TriangleSurface<T>& surface, const TriangleSurfaceData<T>& data,
                      TrianglesAlong along, const MeshSDFOptions& options) {
  SignReport report;
  const auto& orientation = data.orientation();
  report.unbalancedEdges = data.unbalancedEdges();
  report.shells = orientation.shells();
  report.turnedFaces = orientation.turnedFaces;
  report.turnedShells = orientation.turnedShells;
  report.unorientable = orientation.unorientable;
  if (report.isClosed()) {
    const auto found = probeSoundness(surface, along, options.probes, orientation.firstFaces);
    report.probes = found.probes;
    report.unsound = found.unsound;
  }
  report.scheme = options.signs != SignScheme::Automatic ? options.signs
                  : report.isSound()                     ? SignScheme::NearestFeature
                                                         : SignScheme::WindingNumber;
  return report;
}

#define CUTWATER_INSTANTIATE(T)                                                                   \
  template SignReport checkSigns(const TriangleSurface<T>&, const TriangleSurfaceData<T>&,        \
                                 TrianglesAlong, const MeshSDFOptions&);                          \
  template SoundnessProbes probeSoundness(const TriangleSurface<T>&, TrianglesAlong, std::size_t, \
                                          std::span<const std::uint32_t>);
CUTWATER_INSTANTIATE(float)
CUTWATER_INSTANTIATE(double)
#undef CUTWATER_INSTANTIATE

}  // namespace cutwater
