#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Cleaning/Detail/PlacesText.hpp>
#include <Cutwater/Surface/Cleaning/Openings.hpp>
#include <Cutwater/Text/ReportLine.hpp>

namespace cutwater {

std::string OpeningReport::text() const {
  using text::reportLine;
  const auto number = [](std::size_t n) { return detail::toText(static_cast<long long>(n)); };
  const auto at = [](const Findings<Vec3<double>>& found) {
    return found ? "; at" + detail::placesText(found) : std::string();
  };
  std::string result;
  result += reportLine("openings closed", number(closed.count) + at(closed));
  result += reportLine("rim edges", number(rimEdges));
  if (left) result += reportLine("rims left open", number(left.count) + at(left));
  if (pointsMoved > 0) {
    result += reportLine("points moved onto the plane",
                         number(pointsMoved) + ", farthest " + detail::shortText(farthestMove));
  }
  if (facesRemoved > 0) result += reportLine("faces removed", number(facesRemoved));
  const std::string change = detail::changeText(before, after);
  return result + reportLine("faces added", number(facesAdded) + ", of area " +
                                                detail::shortText(areaAdded) + change);
}

}  // namespace cutwater
