#include <Cutwater/Repair/Detail/Crossings.hpp>
#include <Cutwater/Repair/Detail/RimFilling.hpp>
#include <Cutwater/Repair/FillHoles.hpp>
#include <Cutwater/Surface/Cleaning/Detail/PlaneFrame.hpp>
#include <Cutwater/Surface/Cleaning/Detail/SoupEdits.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace cutwater {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;
using Loop = std::vector<std::uint32_t>;

Edge edgeBetween(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

/// Fills rims one after the other.
class HoleFiller {
 public:
  HoleFiller(const PolygonSoup& soup, const HoleOptions& options)
      : soup_(soup), options_(options), deadline_("fillHoles", options.seconds) {}

  /// The soup with its holes filled.
  PolygonSoup run(HoleReport& report) {
    const auto open = detail::openEdgesOf(soup_);
    for (const auto& edge : open) beside_[{edge.lower, edge.upper}] = edge.triangle;
    const auto rims = detail::loopsAround(open);
    findEdgesBetween(rims);
    PolygonSoup result = soup_;
    for (const auto& rim : rims) {
      const double width = widthOf(rim);
      auto& found = fill(rim, width, result, report);
      found.add(soup_.points[rim.front()]);
      if (&found == &report.filled) report.widestFilled = std::max(report.widestFilled, width);
    }
    report.seconds = deadline_.elapsed();
    return result;
  }

 private:
  /// Fills a rim, and returns the findings of the report that it belongs to.
  Findings<Vec3<double>>& fill(const Loop& rim, double width, PolygonSoup& result,
                               HoleReport& report) {
    if (rim.size() > options_.mostEdges) return report.tooLong;
    if (width > options_.widest) return report.tooWide;
    if (deadline_.isOver()) return report.late;
    const auto triangles = trianglesIn(rim);
    if (!triangles) return report.late;
    if (triangles->empty() || !areNew(*triangles, rim)) return report.unfillable;
    const auto patch =
        options_.patch.empty() ? patchAlong(rim) : detail::patchNamed(result, options_.patch);
    for (const auto& triangle : *triangles) {
      result.addPolygon(triangle, patch);
      for (std::size_t k = 0; k < 3; ++k) {
        edges_.insert(edgeBetween(triangle[k], triangle[(k + 1) % 3]));
      }
    }
    return report.filled;
  }

  /// The triangles that fill a rim; nothing if the time is up.
  [[nodiscard]] std::optional<std::vector<std::array<std::uint32_t, 3>>> trianglesIn(
      const Loop& rim) const {
    std::vector<Vec3<double>> points;
    std::vector<Vec3<double>> third;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      points.push_back(soup_.points[rim[i]]);
      third.push_back(soup_.points[cornerBeside(rim[i], rim[(i + 1) % rim.size()])]);
    }
    std::vector<std::array<std::uint32_t, 3>> triangles;
    try {
      triangles = detail::fillRim(points, third, deadline_);
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::Limit) return {};
      if (error.kind() != ErrorKind::Topology) throw;  // CGAL gave up: unfillable
    }
    for (auto& triangle : triangles) {
      for (auto& corner : triangle) corner = rim[corner];
    }
    return triangles;
  }

  /// A further corner of the face that has this open edge.
  [[nodiscard]] std::uint32_t cornerBeside(std::uint32_t a, std::uint32_t b) const {
    const auto polygon = soup_.polygon(beside_.at(edgeBetween(a, b)));
    const auto at = std::ranges::find_if(polygon, [&](auto c) { return c != a && c != b; });
    return at == polygon.end() ? a : *at;
  }

  /// Whether no edge of the triangles within the rim belongs to the surface or to another filling.
  [[nodiscard]] bool areNew(std::span<const std::array<std::uint32_t, 3>> triangles,
                            const Loop& rim) const {
    std::set<Edge> around;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      around.insert(edgeBetween(rim[i], rim[(i + 1) % rim.size()]));
    }
    for (const auto& t : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto edge = edgeBetween(t[k], t[(k + 1) % 3]);
        if (edges_.contains(edge) && !around.contains(edge)) return false;
      }
    }
    return true;
  }

  /// Finds the surface's edges with both ends on rims.
  void findEdgesBetween(std::span<const Loop> rims) {
    std::vector<bool> isOnRim(soup_.points.size());
    for (const auto& rim : rims) {
      for (const auto point : rim) isOnRim[point] = true;
    }
    for (std::size_t i = 0; i < soup_.polygonCount(); ++i) {
      const auto polygon = soup_.polygon(i);
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const auto a = polygon[k];
        const auto b = polygon[(k + 1) % polygon.size()];
        if (isOnRim[a] && isOnRim[b]) edges_.insert(edgeBetween(a, b));
      }
    }
  }

  [[nodiscard]] double widthOf(const Loop& rim) const {
    Box<double> box;
    for (const auto point : rim) box.extend(soup_.points[point]);
    return box.diagonal();
  }

  [[nodiscard]] std::uint32_t patchAlong(const Loop& rim) const {
    std::map<std::uint32_t, std::size_t> faces;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      ++faces[soup_.patches[beside_.at(edgeBetween(rim[i], rim[(i + 1) % rim.size()]))]];
    }
    return std::ranges::max_element(faces, {}, [](const auto& entry) { return entry.second; })
        ->first;
  }

  const PolygonSoup& soup_;
  const HoleOptions& options_;
  detail::Deadline deadline_;
  std::map<Edge, std::uint32_t> beside_;  // the first polygon at each open edge
  std::set<Edge> edges_;
};

}  // namespace

HoleReport fillHoles(PolygonSoup& soup, const HoleOptions& options) {
  soup.validate();
  require(options.widest > 0, "fillHoles: need widest > 0", Named{"widest", options.widest});
  HoleReport report;
  report.before = report.after = measure(soup);
  PolygonSoup filled = HoleFiller(soup, options).run(report);
  report.facesAdded = filled.polygonCount() - soup.polygonCount();
  if (report.facesAdded == 0) return report;
  report.areaAdded = detail::areaFrom(filled, soup.polygonCount());
  report.crossings = detail::crossingsOfLast(filled, report.facesAdded);
  report.after = measure(filled);
  soup = std::move(filled);
  return report;
}

}  // namespace cutwater
