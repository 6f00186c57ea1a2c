// The text of the reports of repairs.
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Repair/FillHoles.hpp>
#include <Cutwater/Repair/RemoveSelfIntersections.hpp>
#include <Cutwater/Repair/Wrap.hpp>
#include <Cutwater/Surface/Cleaning/Detail/PlacesText.hpp>
#include <Cutwater/Text/ReportLine.hpp>

namespace cutwater {
namespace {

using detail::shortText;
using text::reportLine;

std::string number(std::size_t n) {
  return detail::toText(static_cast<long long>(n));
}

std::string placesLine(const char* name, const Findings<Vec3<double>>& found) {
  return found ? reportLine(name, number(found.count) + "; at" + detail::placesText(found))
               : std::string();
}

std::string facesLine(std::size_t before, std::size_t after, const std::string& change) {
  return reportLine("faces", number(before) + " -> " + number(after) + change);
}

}  // namespace

std::string HoleReport::text() const {
  std::string result =
      filled ? placesLine("holes filled", filled) : reportLine("holes filled", "0");
  result += placesLine("left open: too many edges", tooLong);
  result += placesLine("left open: too wide", tooWide);
  result += placesLine("left open: no filling would do", unfillable);
  result += placesLine("left open: the time was up", late);
  if (!filled) return result;
  result += reportLine("widest hole filled", shortText(widestFilled));
  result += reportLine("faces added", number(facesAdded) + ", of area " + shortText(areaAdded) +
                                          detail::changeText(before, after));
  if (crossings > 0) result += reportLine("pairs with new faces that meet", number(crossings));
  return result;
}

std::string SelfIntersectionRepairReport::text() const {
  std::string result =
      reportLine("pairs of faces that meet", number(pairsBefore) + " -> " + number(pairsAfter));
  if (pairsAfter == pairsBefore) return result;
  result += facesLine(facesBefore, facesAfter, detail::changeText(before, after));
  return result + reportLine("farthest from the surface before", shortText(farthest));
}

std::string WrapReport::text() const {
  return facesLine(facesBefore, facesAfter, detail::changeText(before, after)) +
         reportLine("offset", shortText(offset)) +
         reportLine("distance from the surface", shortText(nearest) + " to " + shortText(farthest));
}

}  // namespace cutwater
