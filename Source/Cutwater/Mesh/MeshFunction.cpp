#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/Detail/BoxAnswers.hpp>
#include <Cutwater/Mesh/Detail/DcelIndex.hpp>
#include <Cutwater/Mesh/Detail/MeshIndex.hpp>
#include <Cutwater/Mesh/Detail/SegmentAnswers.hpp>
#include <Cutwater/Mesh/MeshFunction.hpp>
#include <Cutwater/Text/Numbers.hpp>

namespace cutwater {

template <std::floating_point T, typename Index>
std::size_t MeshFunction<T, Index>::triangleCount() const {
  return index_->surface().triangles.size();
}

template <std::floating_point T, typename Index>
std::array<Vec3<T>, 3> MeshFunction<T, Index>::triangle(std::uint32_t id) const {
  require(id < triangleCount(), "triangle: no such triangle", Named{"id", id});
  return index_->triangle(id);
}

template <std::floating_point T, typename Index>
Box<T> MeshFunction<T, Index>::surfaceBox() const {
  return index_->surfaceBox();
}

template <std::floating_point T, typename Index>
const SignReport& MeshFunction<T, Index>::signReport() const {
  return index_->signs();
}

template <std::floating_point T, typename Index>
T MeshFunction<T, Index>::localSignedDistance(const Vec3<T>& point) const {
  return PointAnswers<T, Index>(*index_).signedDistance(point);
}

template <std::floating_point T, typename Index>
T MeshFunction<T, Index>::localSignedDistanceWithin(const Vec3<T>& point,
                                                    const Interval<T>& wanted) const {
  return PointAnswers<T, Index>(*index_).signedDistanceWithin(point, wanted);
}

template <std::floating_point T, typename Index>
void MeshFunction<T, Index>::localSignedDistances(std::span<const Vec3<T>> points,
                                                  std::span<T> distances) const {
  PointAnswers<T, Index>(*index_).signedDistances(points, distances);
}

template <std::floating_point T, typename Index>
bool MeshFunction<T, Index>::localSignedDistancesWithin(std::span<const Vec3<T>> points, T limit,
                                                        std::span<T> distances) const {
  return PointAnswers<T, Index>(*index_).signedDistancesWithin(points, limit, distances);
}

template <std::floating_point T, typename Index>
Vec3<T> MeshFunction<T, Index>::localGradient(const Vec3<T>& point) const {
  return PointAnswers<T, Index>(*index_).gradient(point);
}

template <std::floating_point T, typename Index>
SurfacePoint<T> MeshFunction<T, Index>::localClosestPoint(const Vec3<T>& point) const {
  return PointAnswers<T, Index>(*index_).closestPoint(point);
}

template <std::floating_point T, typename Index>
void MeshFunction<T, Index>::localClosestPoints(std::span<const Vec3<T>> points,
                                                std::span<SurfacePoint<T>> results) const {
  PointAnswers<T, Index>(*index_).closestPoints(points, results);
}

template <std::floating_point T, typename Index>
SurfaceOwner MeshFunction<T, Index>::localOwner(const Vec3<T>& point) const {
  return PointAnswers<T, Index>(*index_).closestPoint(point).owner;
}

template <std::floating_point T, typename Index>
CrossingCount MeshFunction<T, Index>::localCrossings(const Segment<T>& segment,
                                                     CrossingVisitor<T> visit) const {
  return SegmentAnswers<T, Index>(*index_).crossings(segment, visit);
}

template <std::floating_point T, typename Index>
void MeshFunction<T, Index>::localFirstHits(std::span<const Segment<T>> segments,
                                            std::span<FirstHit<T>> hits) const {
  const SegmentAnswers<T, Index> answers(*index_);
  for (std::size_t i = 0; i < segments.size(); ++i) hits[i] = answers.firstHit(segments[i]);
}

template <std::floating_point T, typename Index>
Interval<T> MeshFunction<T, Index>::localBounds(const OrientedBox<T>& box,
                                                BoxHint* /*hint*/) const {
  return BoxAnswers<T, Index>(*index_).bounds(box);
}

template <std::floating_point T, typename Index>
auto MeshFunction<T, Index>::defaultClass() const {
  return [this](const OrientedBox<T>& box, BoxHint* hint) {
    return SignedDistanceFunction<T>::localClassify(box, hint);
  };
}

template <std::floating_point T, typename Index>
BoxClass MeshFunction<T, Index>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  return BoxAnswers<T, Index>(*index_).classOf(box, hint, defaultClass());
}

template <std::floating_point T, typename Index>
void MeshFunction<T, Index>::localClasses(std::span<const OrientedBox<T>> boxes,
                                          std::span<BoxClass> classes,
                                          std::span<BoxHint> hints) const {
  BoxAnswers<T, Index>(*index_).classesOf(boxes, classes, hints, defaultClass());
}

template <std::floating_point T, typename Index>
bool MeshFunction<T, Index>::localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const {
  return BoxAnswers<T, Index>(*index_).facetsIn(box, visit) ||
         SignedDistanceFunction<T>::localFacetsIn(box, visit);
}

template <std::floating_point T, typename Index>
Guarantee<T> MeshFunction<T, Index>::localGuarantee() const {
  return PointAnswers<T, Index>(*index_).guarantee();
}

template <std::floating_point T, typename Index>
std::optional<T> MeshFunction<T, Index>::localLipschitzIn(const OrientedBox<T>& box) const {
  const bool isSteady = BoxAnswers<T, Index>(*index_).isSteady(box.bounds());
  return isSteady ? std::optional(T(1)) : std::nullopt;
}

template <std::floating_point T, typename Index>
Box<T> MeshFunction<T, Index>::localBoundingBox() const {
  return index_->solidBox();
}

template <std::floating_point T, typename Index>
Box<T> MeshFunction<T, Index>::localClearanceBox() const {
  return index_->signJumps() ? Box<T>::everywhere()
                             : index_->solidBox();  // no triangle is beyond it
}

template <std::floating_point T, typename Index>
std::vector<std::string> MeshFunction<T, Index>::localPatchNames() const {
  return index_->patchNames();
}

template <std::floating_point T, typename Index>
std::string MeshFunction<T, Index>::localName() const {
  return "Mesh of " + text::counted(triangleCount(), "triangle", "triangles");
}

template class MeshFunction<float, MeshIndex<float>>;
template class MeshFunction<double, MeshIndex<double>>;
template class MeshFunction<float, DcelIndex<float>>;
template class MeshFunction<double, DcelIndex<double>>;

}  // namespace cutwater
