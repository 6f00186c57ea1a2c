#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Mesh/PolygonGeometry.hpp>
#include <Cutwater/Mesh/SoundnessCheck.hpp>

#include <algorithm>
#include <atomic>
#include <vector>

namespace cutwater {

template <std::floating_point T>
SoundnessProbes probeSoundness(const TriangleSurface<T>& surface, TrianglesAlong along,
                               std::size_t count, std::span<const std::uint32_t> always) {
  const std::size_t all = surface.triangles.size();
  const std::size_t spread = std::min(count, all);
  std::atomic<std::size_t> probes{0};
  std::atomic<std::size_t> unsound{0};
  const auto probe = [&](std::uint32_t id) {
    const auto corners = surface.corners(id);
    const auto normal = polygonArea(corners).normal;
    if (normal == Vec3<double>{}) return;
    const auto middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    const Vec3<double> step = 0x1p-40 * (length(middle) + double{surface.size}) * normal;
    const auto before = locate(surface, middle + step, along);
    const auto behind = locate(surface, middle - step, along);
    ++probes;
    const bool sound = before.winding == 0 && behind.winding == 1;
    if (!sound || before.onSurface || behind.onSurface) ++unsound;
  };
  parallelFor(
      spread + always.size(), {.grain = 16, .progress = {}},
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          probe(i < spread ? static_cast<std::uint32_t>(i * all / spread) : always[i - spread]);
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
