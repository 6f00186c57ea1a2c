#include <Cutwater/Repair/Detail/LocalRepair.hpp>
#include <Cutwater/Repair/Detail/NearestPatches.hpp>
#include <Cutwater/Repair/RemoveSelfIntersections.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <algorithm>
#include <utility>

namespace cutwater {
namespace {

SelfIntersections found(const PolygonSoup& soup, std::size_t limit) {
  return findSelfIntersections(DcelMesh<double>(soup), {.limit = limit});
}

}  // namespace

SelfIntersectionRepairReport removeSelfIntersections(PolygonSoup& soup,
                                                     const SelfIntersectionRepairOptions& options) {
  soup.validate();
  require(options.rounds > 0, "removeSelfIntersections: need rounds > 0",
          Named{"rounds", options.rounds});
  const detail::Deadline deadline("removeSelfIntersections", options.seconds);
  SelfIntersectionRepairReport report;
  report.before = report.after = measure(soup);
  report.facesBefore = report.facesAfter = soup.polygonCount();
  // A search that reaches its limit may have left out pairs.
  const std::size_t limit = std::max(options.mostPairs, options.mostPairs + 1);
  const auto before = found(soup, limit);
  if (!before.complete || before.pairs.count > options.mostPairs) {
    throw Error(ErrorKind::Limit, "removeSelfIntersections: more than " +
                                      detail::toText(static_cast<long long>(options.mostPairs)) +
                                      " pairs of faces meet: wrap() the surface instead");
  }
  report.pairsBefore = report.pairsAfter = before.pairs.count;
  if (!before) return report;

  auto mended = detail::withoutSelfIntersections(triangulated(soup), options.rounds, deadline);
  const auto after = found(mended, limit);
  report.seconds = deadline.elapsed();
  if (after.pairs.count >= before.pairs.count) return report;
  report.farthest = detail::takeNearestPatches(mended, soup).greatest;
  report.pairsAfter = after.pairs.count;
  report.facesAfter = mended.polygonCount();
  report.after = measure(mended);
  soup = std::move(mended);
  return report;
}

}  // namespace cutwater
