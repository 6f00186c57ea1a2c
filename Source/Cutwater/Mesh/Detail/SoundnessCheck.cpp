#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Mesh/Detail/SoundnessCheck.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>
#include <Cutwater/Triangles/TriangleIntersection.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <vector>

namespace cutwater {

namespace {

/// Places to probe: half are spread evenly over the list of triangles, so that small parts count as
/// much as large ones, and half over the area.
template <std::floating_point T>
class Places {
 public:
  struct Place {
    std::uint32_t triangle;
    double b = 1.0 / 3;  // barycentric weights of the second and the third corner
    double c = 1.0 / 3;
  };

  explicit Places(const TriangleSurface<T>& surface) {
    double sum = 0;
    for (std::uint32_t id = 0; id < surface.triangles.size(); ++id) {
      const auto [a, b, c] = surface.corners(id);
      areas_.push_back(sum += length(cross(b - a, c - a)));
    }
  }

  [[nodiscard]] Place operator[](std::size_t i) const {
    auto [share, b, c] = evenlySpread(i / 2);
    if (b + c > 1) b = 1 - b, c = 1 - c;
    // Away from the edges: a point just beside one may be beyond the next triangle.
    constexpr double kInward = 0.125;
    return {i % 2 == 0 ? byCount(share) : byArea(share), b + kInward * (1.0 / 3 - b),
            c + kInward * (1.0 / 3 - c)};
  }

 private:
  [[nodiscard]] std::uint32_t byCount(double share) const {
    return atMost(static_cast<std::size_t>(share * static_cast<double>(areas_.size())));
  }
  [[nodiscard]] std::uint32_t byArea(double share) const {
    const auto found = std::ranges::upper_bound(areas_, share * areas_.back()) - areas_.begin();
    return atMost(static_cast<std::size_t>(found));
  }
  [[nodiscard]] std::uint32_t atMost(std::size_t triangle) const {
    return static_cast<std::uint32_t>(std::min(triangle, areas_.size() - 1));  // shares round to 1
  }

  std::vector<double> areas_;  // twice the total area of the triangles up to this one
};

}  // namespace

Vec3<double> evenlySpread(std::size_t i) {
  constexpr double kRoot = 1.2207440846057596;  // of x^4 = x + 1
  const auto n = static_cast<double>(i);
  const auto share = [](double number) { return number - std::floor(number); };
  return {share(0.5 + n / kRoot), share(0.5 + n / (kRoot * kRoot)),
          share(0.5 + n / (kRoot * kRoot * kRoot))};
}

std::size_t runProbes(std::size_t count, std::size_t triangles, TrianglesAlong along,
                      FunctionRef<void(std::size_t, TrianglesAlong)> probe) {
  constexpr std::size_t kRound = 64;
  const std::size_t most = 1'000'000 + 8 * triangles;
  std::atomic<std::size_t> shown{0};
  const auto metered = [&](const Segment<double>& segment, TriangleVisitor visit) {
    std::size_t here = 0;
    along(segment, [&](std::span<const std::uint32_t> ids) {
      here += ids.size();
      return visit(ids);
    });
    shown += here;
  };
  std::size_t done = 0;
  while (done < count && shown <= most) {
    const std::size_t round = std::min(kRound, count - done);
    parallelFor(round, {.grain = 4, .progress = {}}, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) probe(done + i, metered);
    });
    done += round;
  }
  return done;
}

namespace {

/// Whether the solid is just behind the place, and nothing just in front; empty on a triangle
/// without area.
template <std::floating_point T>
std::optional<bool> isSoundAt(const TriangleSurface<T>& surface,
                              const typename Places<T>::Place& at, TrianglesAlong along) {
  const auto corners = surface.corners(at.triangle);
  const auto normal = polygonArea(corners).normal;
  if (normal == Vec3<double>{}) return {};
  const auto& [a, b, c] = corners;
  const auto point = a + at.b * (b - a) + at.c * (c - a);
  const Vec3<double> step = 0x1p-40 * (length(point) + double{surface.size}) * normal;
  const auto before = locate(surface, point + step, along);
  const auto behind = locate(surface, point - step, along);
  return before.winding == 0 && behind.winding == 1 && !before.onSurface && !behind.onSurface;
}

/// Examines place(i) for i = 0, 1, ...; `tried` receives how many: see runProbes().
template <std::floating_point T, typename PlaceOf>
SoundnessProbes examine(const TriangleSurface<T>& surface, TrianglesAlong along, std::size_t count,
                        PlaceOf&& placeOf, std::size_t& tried) {
  std::atomic<std::size_t> probes{0};
  std::atomic<std::size_t> unsound{0};
  tried =
      runProbes(count, surface.triangles.size(), along, [&](std::size_t i, TrianglesAlong metered) {
        const auto sound = isSoundAt<T>(surface, placeOf(i), metered);
        if (!sound) return;
        ++probes;
        if (!*sound) ++unsound;
      });
  return {.probes = probes, .unsound = unsound};
}

/// The largest triangle of each part of the surface that is connected across edges of two
/// triangles which nothing else touches along the edge. `touchedEdges`: see SurfaceContacts.
template <std::floating_point T>
std::vector<std::uint32_t> largestOfParts(const TriangleSurface<T>& surface, std::size_t shells,
                                          std::span<const std::uint8_t> touchedEdges) {
  const auto count = static_cast<std::uint32_t>(surface.triangles.size());
  const auto isInner = [](const auto& across) { return std::ranges::count(across, kNone) == 0; };
  const auto isFree = [](std::uint8_t touched) { return touched == 0; };
  const bool isOnePart = shells == 1 && std::ranges::all_of(surface.neighbours, isInner) &&
                         std::ranges::all_of(touchedEdges, isFree);
  detail::DisjointSets parts(isOnePart ? 0 : count);
  for (std::uint32_t t = 0; t < count && !isOnePart; ++t) {
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const auto across = surface.neighbours[t][edge];
      const bool isTouched = SurfaceContacts::isTouched(touchedEdges[t], edge);
      if (across != kNone && !isTouched) parts.unite(t, across);
    }
  }
  std::vector<std::uint32_t> largest(isOnePart ? 1 : count, kNone);
  std::vector<double> areas(largest.size(), -1);
  for (std::uint32_t t = 0; t < count; ++t) {
    const auto part = isOnePart ? 0 : parts.find(t);
    const auto [a, b, c] = surface.corners(t);
    const double area = lengthSquared(cross(b - a, c - a));
    if (area > areas[part]) areas[part] = area, largest[part] = t;
  }
  std::erase(largest, kNone);
  return largest;
}

/// See SignReport.
template <std::floating_point T>
std::size_t countTouchingEdges(const TriangleSurface<T>& surface,
                               std::span<const std::uint8_t> touchedEdges) {
  const auto isFace = [&](std::uint32_t t) {
    const auto [a, b, c] = surface.corners(t);
    return hasArea({Vec3<double>(a), Vec3<double>(b), Vec3<double>(c)});
  };
  std::size_t count = 0;
  for (std::uint32_t t = 0; t < touchedEdges.size(); ++t) {
    if (touchedEdges[t] == 0 || !isFace(t)) continue;
    for (std::size_t edge = 0; edge < 3; ++edge) {
      if (!SurfaceContacts::isTouchedInPart(touchedEdges[t], edge)) continue;
      const auto across = surface.neighbours[t][edge];
      if (across == kNone || isFace(across)) ++count;
    }
  }
  return count;
}

/// Examines one place on each part of a surface without overlaps: what is true there is true all
/// over the part. For within a triangle, there is no other; and beside an edge between two, as long
/// as nothing else touches all along it, is a place where there are no more than these two. Faces
/// without area divide parts at T-junctions, but bound nothing. Where there are too many places to
/// examine, nothing is proven.
template <std::floating_point T>
void prove(const TriangleSurface<T>& surface, TrianglesAlong along,
           std::span<const std::uint8_t> touchedEdges, SignReport& report) {
  const auto parts = largestOfParts(surface, report.shells, touchedEdges);
  std::size_t tried = 0;
  const auto placeOf = [&](std::size_t i) { return typename Places<T>::Place{parts[i]}; };
  const auto found = examine<T>(surface, along, parts.size(), placeOf, tried);
  report.probes = found.probes;
  report.isProven = tried == parts.size() && found.unsound == 0;
}

}  // namespace

template <std::floating_point T>
SoundnessProbes probeSoundness(const TriangleSurface<T>& surface, TrianglesAlong along,
                               std::size_t count, std::span<const std::uint32_t> always) {
  using Place = typename Places<T>::Place;
  const Places<T> places(surface);
  const std::size_t shells = std::min(count, always.size());
  // Alternates shells and places, then takes the remaining places.
  const auto placeOf = [&](std::size_t i) {
    if (i >= 2 * shells) return places[i - shells];
    return i % 2 == 0 ? Place{always[i / 2 * always.size() / shells]} : places[i / 2];
  };
  std::size_t tried = 0;
  return examine<T>(surface, along, count + shells, placeOf, tried);
}

template <std::floating_point T>
SignReport checkSigns(const TriangleSurface<T>& surface, const TriangleSurfaceArrays<T>& data,
                      TrianglesAlong along, const MeshSDFOptions& options,
                      FunctionRef<SurfaceContacts()> findContacts) {
  SignReport report;
  const auto& orientation = data.orientation();
  report.unbalancedEdges = data.openEdges().size();
  report.shells = orientation.shells();
  report.turnedFaces = orientation.turnedFaces;
  report.turnedShells = orientation.turnedShells();
  report.unorientable = orientation.unorientable;
  if (!report.isClosed()) return report;
  if (options.findSelfIntersections) {
    const auto contacts = findContacts();
    report.selfIntersections = contacts.overlaps;
    if (contacts.overlaps == 0 && report.unorientable == 0) {
      report.touchingEdges = countTouchingEdges(surface, contacts.touchedEdges);
      prove(surface, along, contacts.touchedEdges, report);
    }
  }
  if (report.isProven) return report;
  const auto found = probeSoundness(surface, along, options.probes, orientation.firstFaces);
  report.probes = found.probes;
  report.unsound = found.unsound;
  return report;
}

#define CUTWATER_INSTANTIATE(T)                                                                   \
  template SignReport checkSigns(const TriangleSurface<T>&, const TriangleSurfaceArrays<T>&,      \
                                 TrianglesAlong, const MeshSDFOptions&,                           \
                                 FunctionRef<SurfaceContacts()>);                                 \
  template SoundnessProbes probeSoundness(const TriangleSurface<T>&, TrianglesAlong, std::size_t, \
                                          std::span<const std::uint32_t>);
CUTWATER_INSTANTIATE(float)
CUTWATER_INSTANTIATE(double)
#undef CUTWATER_INSTANTIATE

}  // namespace cutwater
