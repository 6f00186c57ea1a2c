#include <Cutwater/Surface/Detail/HoleCaps.hpp>
#include <Cutwater/Surface/Detail/RimLoops.hpp>

namespace cutwater {

namespace {

/// Triangulates the polygon of a chain and the edge from its end back to its beginning.
void capChain(std::span<const std::uint32_t> chain, HoleCaps& caps) {
  if (chain.size() < 3) return;
  const std::size_t middle = chain.size() / 2;
  caps.triangles.push_back({chain.front(), chain[middle], chain.back()});
  capChain(chain.first(middle + 1), caps);
  capChain(chain.subspan(middle), caps);
}

}  // namespace

template <std::floating_point T>
HoleCaps capHoles(std::span<const Vec3<T>> positions, std::span<const OpenEdge> edges) {
  HoleCaps caps;
  detail::RimLoops walk(edges);
  for (const auto vertex : walk.vertices()) caps.positions.emplace_back(positions[vertex]);
  walk.run([&](std::span<const std::uint32_t> loop) { capChain(loop, caps); });
  return caps;
}

template HoleCaps capHoles(std::span<const Vec3<float>>, std::span<const OpenEdge>);
template HoleCaps capHoles(std::span<const Vec3<double>>, std::span<const OpenEdge>);

}  // namespace cutwater
