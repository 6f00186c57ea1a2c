#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Surface/DcelMesh.hpp>
#include <Cutwater/Surface/Detail/EdgesAtVertex.hpp>
#include <Cutwater/Surface/Detail/Pseudonormals.hpp>
#include <Cutwater/Surface/Triangulation.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace cutwater {
namespace {

/// Up to this many half-edges at a vertex, as most have, comparing all with all is fastest.
constexpr std::size_t kMostComparedPairwise = 16;

void checkArrays(const PolygonSoup& soup) {
  constexpr std::size_t kMost = kNone - 1;
  for (const std::size_t count : {soup.points.size(), soup.corners.size()}) {
    if (count <= kMost) continue;
    throw Error(ErrorKind::Limit, "DcelMesh: more than 2^32 - 2 points or corners (" +
                                      detail::toText(static_cast<long long>(count)) + ")");
  }
  require(soup.offsets.size() == soup.polygonCount() + 1 && soup.offsets.front() == 0 &&
              soup.offsets.back() == soup.corners.size(),
          "DcelMesh: the soup's offsets and corners contradict each other",
          Named{"polygons", soup.polygonCount()}, Named{"offsets", soup.offsets.size()},
          Named{"corners", soup.corners.size()});
}

}  // namespace

template <std::floating_point T>
DcelMesh<T>::DcelMesh(const PolygonSoup& soup)
    : patches_(soup.patches), patchNames_(soup.patchNames) {
  checkArrays(soup);
  positions_.reserve(soup.points.size());
  for (const auto& p : soup.points) {
    positions_.push_back(static_cast<Vec3<T>>(p));
    require(std::isfinite(lengthSquared(Vec3<double>(positions_.back()))),
            "DcelMesh: need finite coordinates with finite squares",
            Named{"point", positions_.size() - 1}, Named{"position", p});
  }
  takeFaces(soup);
  collectOutgoing();
  pairTwins();
  takeTriangles(soup);
  computeNormals();
}

template <std::floating_point T>
void DcelMesh<T>::takeFaces(const PolygonSoup& soup) {
  faceOffsets_.assign(1, 0);
  faceOffsets_.reserve(soup.offsets.size());
  origins_.reserve(soup.corners.size());
  faceOf_.reserve(soup.corners.size());
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    require(soup.offsets[i] < soup.offsets[i + 1] && soup.offsets[i + 1] <= soup.corners.size(),
            "DcelMesh: a polygon without corners", Named{"polygon", i});
    for (const std::uint32_t corner : soup.polygon(i)) {
      require(corner < positions_.size(), "DcelMesh: a corner that is no point",
              Named{"polygon", i}, Named{"corner", corner}, Named{"points", positions_.size()});
      origins_.push_back(VertexId{corner});
      faceOf_.push_back(FaceId{static_cast<std::uint32_t>(i)});
    }
    faceOffsets_.push_back(size32(origins_));
  }
}

template <std::floating_point T>
void DcelMesh<T>::collectOutgoing() {
  outgoingOffsets_.assign(positions_.size() + 1, 0);
  for (const VertexId v : origins_) ++outgoingOffsets_[index(v)];
  detail::countsToOffsets(outgoingOffsets_);
  std::vector<std::uint32_t> nextFree(outgoingOffsets_.begin(), outgoingOffsets_.end());
  outgoing_.resize(origins_.size());
  for (const HalfEdgeId e : halfEdges()) outgoing_[nextFree[index(origin(e))]++] = e;
}

template <std::floating_point T>
void DcelMesh<T>::visitEdges(FunctionRef<void(const Edge&)> visit) const {
  detail::EdgesAtVertex edges(positions_.size());
  for (const VertexId vertex : vertices()) {
    edges.visit(*this, vertex, visit, [](HalfEdgeId) { return true; });
  }
}

template <std::floating_point T>
void DcelMesh<T>::visitEdgesWithoutTwins(FunctionRef<void(const Edge&)> visit) const {
  // All half-edges of an edge have twins or none has.
  const auto hasNone = [this](HalfEdgeId e) { return !hasTwin(e); };
  if (std::ranges::find(twins_, kNoHalfEdge) == twins_.end()) return;
  detail::EdgesAtVertex edges(positions_.size());
  for (const VertexId vertex : vertices()) edges.visit(*this, vertex, visit, hasNone);
}

template <std::floating_point T>
void DcelMesh<T>::pairTwins() {
  twins_.assign(origins_.size(), kNoHalfEdge);
  // An edge belongs to its lower vertex, so threads write to different half-edges.
  const auto pairAtMostVertices = [this](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v) {
      if (outgoing(VertexId{v}).size() <= kMostComparedPairwise) pairTwinsAt(VertexId{v});
    }
  };
  parallelFor(positions_.size(), {.grain = 4096}, pairAtMostVertices);

  const auto pair = [this](const Edge& edge) {
    if (edge.halfEdges.size() != 2) return;
    const HalfEdgeId one = edge.halfEdges[0];
    const HalfEdgeId other = edge.halfEdges[1];
    if (origin(one) == origin(other)) return;
    twins_[index(one)] = other;
    twins_[index(other)] = one;
  };
  std::optional<detail::EdgesAtVertex> edges;
  for (const VertexId vertex : vertices()) {
    if (outgoing(vertex).size() <= kMostComparedPairwise) continue;
    if (!edges) edges.emplace(positions_.size());
    edges->visit(*this, vertex, FunctionRef<void(const Edge&)>(pair),
                 [](HalfEdgeId) { return true; });
  }
}

/// Pairs the half-edges at a vertex that has few, by comparing all with all.
template <std::floating_point T>
void DcelMesh<T>::pairTwinsAt(VertexId vertex) {
  const auto out = outgoing(vertex);
  std::array<VertexId, kMostComparedPairwise> targets;
  std::array<VertexId, kMostComparedPairwise> sources;
  for (std::size_t i = 0; i < out.size(); ++i) {
    targets[i] = target(out[i]);
    sources[i] = origin(prev(out[i]));
  }
  const auto ends = std::span(targets).first(out.size());
  const auto starts = std::span(sources).first(out.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const VertexId end = ends[i];
    if (end <= vertex || std::ranges::count(ends, end) != 1) continue;
    const auto found = std::ranges::find(starts, end);
    if (found == starts.end() || std::find(found + 1, starts.end(), end) != starts.end()) continue;
    const HalfEdgeId back = prev(out[static_cast<std::size_t>(found - starts.begin())]);
    twins_[index(out[i])] = back;
    twins_[index(back)] = out[i];
  }
}

template <std::floating_point T>
void DcelMesh<T>::takeTriangles(const PolygonSoup& soup) {
  auto triangulation = triangulate(soup);
  triangleOffsets_.assign(soup.polygonCount() + 1, 0);
  for (const std::uint32_t face : triangulation.polygons) ++triangleOffsets_[face];
  detail::countsToOffsets(triangleOffsets_);
  triangles_ = std::move(triangulation.triangles);
}

template <std::floating_point T>
void DcelMesh<T>::computeNormals() {
  const auto byTriangle = pseudonormals<T>(positions_, triangles_);
  pseudonormals_ = byTriangle.vertices;
  normals_.reserve(patches_.size());
  std::vector<Vec3<double>> corners;
  for (const FaceId face : faces()) {
    if (triangles(face).size() == 1) {
      normals_.push_back(byTriangle.triangles[triangleOffsets_[index(face)]]);
      continue;
    }
    corners.clear();
    for (const VertexId v : vertices(face)) corners.emplace_back(position(v));
    normals_.push_back(static_cast<Vec3<T>>(polygonArea(corners).normal));
  }
}

template <std::floating_point T>
Box<T> DcelMesh<T>::boundingBox() const {
  Box<T> box;
  for (const VertexId corner : origins_) box.extend(position(corner));
  return box;
}

template <std::floating_point T>
std::array<Vec3<double>, 3> DcelMesh<T>::corners(const TriangleCorners& triangle) const {
  const auto [a, b, c] = triangle;
  return {Vec3<double>(position(a)), Vec3<double>(position(b)), Vec3<double>(position(c))};
}

template <std::floating_point T>
T DcelMesh<T>::area(FaceId face) const {
  double sum = 0;
  for (const auto& triangle : triangles(face)) sum += polygonArea(corners(triangle)).area;
  return static_cast<T>(sum);
}

template <std::floating_point T>
Vec3<T> DcelMesh<T>::centroid(FaceId face) const {
  // Relative to a corner: far from the origin, the mean would lose digits.
  const Vec3<double> base(position(vertices(face).front()));
  double area = 0;
  Vec3<double> moment;
  for (const auto& triangle : triangles(face)) {
    const auto [a, b, c] = corners(triangle);
    const double weight = polygonArea(std::array{a, b, c}).area;
    area += weight;
    moment += weight / 3 * ((a - base) + (b - base) + (c - base));
  }
  if (area > 0) return static_cast<Vec3<T>>(base + moment / area);
  Vec3<double> sum;
  for (const VertexId v : vertices(face)) sum += Vec3<double>(position(v)) - base;
  return static_cast<Vec3<T>>(base + sum / static_cast<double>(vertices(face).size()));
}

template <std::floating_point T>
Vec3<T> DcelMesh<T>::pseudonormal(HalfEdgeId e) const {
  if (!hasTwin(e)) return normal(face(e));
  return Pseudonormals<T>::edge(normal(face(e)), normal(face(twin(e))));
}

template <std::floating_point T>
double DcelMesh<T>::totalArea() const {
  return measure().area;
}

template <std::floating_point T>
double DcelMesh<T>::signedVolume() const {
  return measure().volume;
}

template <std::floating_point T>
SurfaceMeasure DcelMesh<T>::measure() const {
  return measureTriangles(triangles_.size(), Vec3<double>(boundingBox().center()),
                          [this](std::size_t i) { return corners(triangles_[i]); });
}

template class DcelMesh<float>;
template class DcelMesh<double>;

}  // namespace cutwater
