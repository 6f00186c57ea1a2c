#pragma once

#include <Cutwater/Core/Block.hpp>
#include <Cutwater/Mesh/TriangleSurfaceData.hpp>

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

  TriangleSurfaceData<T> data;
  Block block;
  TriangleSurface<T> surface;
};

}  // namespace cutwater::test
