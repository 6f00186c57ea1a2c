#pragma once

#include <Cutwater/Surface/MeshRanges.hpp>

#include <span>
#include <utility>
#include <vector>

namespace cutwater::detail {

/// Converts counts per bin into offsets; there must be one extra bin at the end.
inline void countsToOffsets(std::vector<std::uint32_t>& counts) {
  std::uint32_t sum = 0;
  for (auto& count : counts) sum += std::exchange(count, sum);
}

/// The half-edges at one vertex, grouped into edges by their other end. Takes linear time: each
/// other end points to its edge through an array over all vertices, which is reset afterwards.
class EdgesAtVertex {
 public:
  explicit EdgesAtVertex(std::size_t vertexCount) : edgeTo_(vertexCount, kNone) {}

  /// Visits the edges to higher vertices, among the half-edges for which `wanted` returns true.
  template <typename Mesh, typename Visit, typename Wanted>
  void visit(const Mesh& mesh, VertexId vertex, Visit visit, Wanted wanted) {
    for (const HalfEdgeId out : mesh.outgoing(vertex)) {
      const HalfEdgeId in = mesh.prev(out);
      if (mesh.target(out) > vertex && wanted(out)) add(mesh.target(out), out);
      if (mesh.origin(in) > vertex && wanted(in)) add(mesh.origin(in), in);
    }
    if (uses_.empty()) return;
    flush([&](VertexId otherEnd, std::span<const HalfEdgeId> uses) {
      visit({vertex, otherEnd, uses});
    });
  }

 private:
  struct Use {
    std::uint32_t edge;
    HalfEdgeId halfEdge;
  };

  void add(VertexId otherEnd, HalfEdgeId e) {
    auto& edge = edgeTo_[index(otherEnd)];
    if (edge == kNone) {
      edge = static_cast<std::uint32_t>(otherEnds_.size());
      otherEnds_.push_back(otherEnd);
    }
    uses_.push_back({edge, e});
  }

  /// Calls visit(other end, half-edges) for each edge, and clears the edges.
  template <typename Visit>
  void flush(Visit visit) {
    offsets_.assign(otherEnds_.size() + 1, 0);
    for (const auto& use : uses_) ++offsets_[use.edge];
    countsToOffsets(offsets_);
    sorted_.resize(uses_.size());
    for (const auto& use : uses_) sorted_[offsets_[use.edge]++] = use.halfEdge;
    std::uint32_t begin = 0;  // filling has moved every offset to the end of its edge
    for (std::size_t i = 0; i < otherEnds_.size(); ++i) {
      visit(otherEnds_[i],
            std::span<const HalfEdgeId>(sorted_).subspan(begin, offsets_[i] - begin));
      begin = offsets_[i];
    }
    for (const VertexId end : otherEnds_) edgeTo_[index(end)] = kNone;
    otherEnds_.clear();
    uses_.clear();
  }

  std::vector<std::uint32_t> edgeTo_;
  std::vector<VertexId> otherEnds_;
  std::vector<Use> uses_;
  std::vector<std::uint32_t> offsets_;
  std::vector<HalfEdgeId> sorted_;
};

}  // namespace cutwater::detail
