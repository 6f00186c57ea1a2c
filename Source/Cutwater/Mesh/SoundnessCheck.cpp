#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Mesh/PolygonGeometry.hpp>
#include <Cutwater/Mesh/SoundnessCheck.hpp>

#include <atomic>
#include <cmath>
#include <vector>

namespace cutwater {

namespace {

/// A place on the surface.
struct Place {
  std::uint32_t triangle = 0;
  Vec3<double> weights{1.0 / 3, 1.0 / 3, 1.0 / 3};
};

/// Evenly over the area: at equal steps of the area summed up in the order of triangles; within a
/// triangle by the multiples of powers of the plastic number (M. Roberts 2018, "The unreasonable
/// effectiveness of quasirandom sequences").
template <std::floating_point T>
std::vector<Place> spreadPlaces(const TriangleSurface<T>& surface, std::size_t count) {
  constexpr double kPlastic = 1.3247179572447460;  // of x^3 = x + 1
  const auto areaOf = [&](std::uint32_t id) {
    const auto [a, b, c] = surface.corners(id);
    return length(cross(b - a, c - a));
  };
  double whole = 0;
  for (std::uint32_t id = 0; id < surface.triangles.size(); ++id) whole += areaOf(id);
  std::vector<Place> places;
  double upToHere = 0;
  for (std::uint32_t id = 0; id < surface.triangles.size(); ++id) {
    upToHere += areaOf(id);
    while (places.size() < count && (static_cast<double>(places.size()) + 0.5) * whole <
                                        static_cast<double>(count) * upToHere) {
      const auto i = static_cast<double>(places.size() + 1);
      double u = i / kPlastic - std::floor(i / kPlastic);
      double v = i / (kPlastic * kPlastic) - std::floor(i / (kPlastic * kPlastic));
      if (u + v > 1) u = 1 - u, v = 1 - v;
      places.push_back({id, {1 - u - v, u, v}});
    }
  }
  return places;
}

}  // namespace

template <std::floating_point T>
SoundnessProbes probeSoundness(const TriangleSurface<T>& surface, TrianglesAlong along,
                               std::size_t count, std::span<const std::uint32_t> always) {
  auto places = spreadPlaces(surface, count);
  for (const auto id : always) places.push_back({.triangle = id});
  std::atomic<std::size_t> probes{0};
  std::atomic<std::size_t> unsound{0};
  const auto probe = [&](const Place& place) {
    const auto corners = surface.corners(place.triangle);
    const auto normal = polygonArea(corners).normal;
    if (normal == Vec3<double>{}) return;
    const auto& w = place.weights;
    const auto on = w.x * corners[0] + w.y * corners[1] + w.z * corners[2];
    const Vec3<double> step = 0x1p-40 * (length(on) + double{surface.size}) * normal;
    const auto before = locate(surface, on + step, along);
    const auto behind = locate(surface, on - step, along);
    ++probes;
    const bool sound = before.winding == 0 && behind.winding == 1;
    if (!sound || before.onSurface || behind.onSurface) ++unsound;
  };
  parallelFor(places.size(), {.grain = 16, .progress = {}},
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) probe(places[i]);
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
