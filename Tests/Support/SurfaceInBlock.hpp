#pragma once

#include <Cutwater/Core/Block.hpp>
#include <Cutwater/Mesh/Detail/TriangleSurfaceArrays.hpp>
#include <Cutwater/Triangles/Search/TriangleSearch.hpp>

namespace cutwater::test {

/// A soup as a TriangleSurface, and what that is a view of.
template <std::floating_point T>
struct SurfaceInBlock {
  explicit SurfaceInBlock(const PolygonSoup& soup) : data(DcelMesh<T>(soup)) {
    BlockWriter writer;
    const auto sections = data.addTo(writer);
    block = writer.finish();
    surface = sections.view(block);
  }

  TriangleSurfaceArrays<T> data;
  Block block;
  TriangleSurface<T> surface;
};

/// With its tree, and what the search for the nearest triangle reads.
template <std::floating_point T>
struct SearchableInBlock : SurfaceInBlock<T> {
  using SurfaceInBlock<T>::surface;

  explicit SearchableInBlock(const PolygonSoup& soup)
      : SurfaceInBlock<T>(soup),
        arrays(buildTriangleTree(surface.positions, surface.triangles)),
        packets(packTriangles(surface.positions, surface.triangles, arrays.tree())),
        hulls(buildHulls(surface.positions, surface.triangles, arrays.tree())),
        search(arrays.tree(), packets, hulls.hulls, hulls.ofNode) {}

  TriangleTreeArrays arrays;
  std::vector<TrianglePacket> packets;
  HullArrays hulls;
  TriangleSearch search;
};

}  // namespace cutwater::test
