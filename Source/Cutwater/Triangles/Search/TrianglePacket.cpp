#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>
#include <Cutwater/Triangles/Search/TrianglePacket.hpp>
#include <Cutwater/Triangles/TriangleDistance.hpp>

#include <cmath>

namespace cutwater {

namespace {

using Corners = std::array<Vec3<double>, 3>;

void set(std::array<TrianglePacket::Lanes, 3>& to, std::size_t lane, const Vec3<double>& v) {
  for (int axis = 0; axis < 3; ++axis) {
    to[static_cast<std::size_t>(axis)][lane] = static_cast<float>(v[axis]);
  }
}

/// Sets the packet's box.
void fitBox(TrianglePacket& packet, std::span<const Corners> triangles) {
  const auto& origin = triangles.front()[0];
  const auto found = detail::fittingAxes(triangles.size(), [&](std::size_t i) {
    const auto& [a, b, c] = triangles[i];
    return Corners{a - origin, b - origin, c - origin};
  });
  if (found) packet.axes = *found;
  Box<double> box;  // relative to the origin, along the axes
  for (const auto& triangle : triangles) {
    for (const auto& corner : triangle) box.extend(detail::along(packet.axes, corner - origin));
  }
  auto center = origin;
  for (int axis = 0; axis < 3; ++axis) {
    center += box.center()[axis] * Vec3<double>(packet.axes[static_cast<std::size_t>(axis)]);
  }
  packet.center = static_cast<Vec3<float>>(center);
  const auto at = detail::along(packet.axes, Vec3<double>(packet.center) - origin);
  const auto half = max(box.upper - at, at - box.lower);
  constexpr double kRounding = 0x1p-49;  // of coordinates up to about 1
  packet.half =
      static_cast<Vec3<float>>((1 + 0x1p-22) * (half + kRounding * Vec3<double>{1, 1, 1}));
}

}  // namespace

std::array<Vec3<double>, 3> TrianglePacket::corners(std::size_t lane) const {
  const auto at = [lane](const std::array<Lanes, 3>& v) -> Vec3<double> {
    return {v[0][lane], v[1][lane], v[2][lane]};
  };
  const Vec3<double> first = Vec3<double>(center) + at(a);
  return {first, first + at(ab), first + at(ac)};
}

TrianglePacket packTriangles(std::span<const Corners> triangles) {
  TrianglePacket packet;
  fitBox(packet, triangles);
  const Vec3<double> center(packet.center);
  double radius = 0;
  for (std::size_t lane = 0; lane < TrianglePacket::kWidth; ++lane) {
    const auto& [a, b, c] = triangles[std::min(lane, triangles.size() - 1)];
    const bool sliver = isSliver(a, b, c);
    set(packet.a, lane, a - center);
    set(packet.ab, lane, b - a);
    set(packet.ac, lane, c - a);
    set(packet.normal, lane, unitNormal(Triangle<double>{a, b, c, sliver}));
    for (const auto& corner : {a, b, c}) radius = std::max(radius, length(corner - center));
  }
  packet.radius = static_cast<float>(radius * (1 + 0x1p-20));
  return packet;
}

template <std::floating_point T>
std::vector<TrianglePacket> packTriangles(std::span<const Vec3<T>> positions,
                                          std::span<const std::array<std::uint32_t, 3>> triangles,
                                          const TriangleTree& tree) {
  constexpr std::size_t kWidth = TrianglePacket::kWidth;
  std::vector<TrianglePacket> packets(tree.slots().size() / kWidth);
  parallelFor(packets.size(), {.grain = 256}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      std::array<Corners, kWidth> corners;
      std::size_t count = 0;
      for (const auto id : tree.leaf(static_cast<std::uint32_t>(n))) {
        if (id == kNone) break;
        corners[count] = cornersOf(positions, triangles[id]);
        for (auto& corner : corners[count]) corner = tree.frame().toFrame(corner);
        ++count;
      }
      packets[n] = packTriangles(std::span(corners).first(count));
    }
  });
  return packets;
}

template std::vector<TrianglePacket> packTriangles(std::span<const Vec3<float>>,
                                                   std::span<const std::array<std::uint32_t, 3>>,
                                                   const TriangleTree&);
template std::vector<TrianglePacket> packTriangles(std::span<const Vec3<double>>,
                                                   std::span<const std::array<std::uint32_t, 3>>,
                                                   const TriangleTree&);

}  // namespace cutwater
