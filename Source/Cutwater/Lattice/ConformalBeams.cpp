#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/ConformalBeams.hpp>
#include <Cutwater/Lattice/Detail/StrutCopies.hpp>

#include <algorithm>

namespace cutwater {

namespace {

/// Maps struts and adds them to a graph.
class StrutMapper {
 public:
  StrutMapper(const HexahedralCells& cells, const Thickness<double>& thickness,
              const StrutOptions& options)
      : cells_(cells), thickness_(thickness), parts_(options.subdivisions), places_(parts_ + 1) {}

  std::uint32_t addNode(const Vec3<double>& inCells) { return addNode(placeAt(inCells)); }

  void addStrut(const detail::StrutCopy& strut) {
    for (std::uint32_t i = 0; i <= parts_; ++i) {
      const double t = static_cast<double>(i) / parts_;
      places_[i] = placeAt((1 - t) * strut.a + t * strut.b);
    }
    places_.front() = placeOf(strut.nodes[0]);
    places_.back() = placeOf(strut.nodes[1]);
    if (isOneBeam()) {
      addBeam(strut.nodes, places_.front().radius, places_.back().radius);
      return;
    }
    auto from = strut.nodes[0];
    for (std::uint32_t i = 1; i <= parts_; ++i) {
      const auto to = i == parts_ ? strut.nodes[1] : addNode(places_[i]);
      addBeam({from, to}, places_[i - 1].radius, places_[i].radius);
      from = to;
    }
  }

  BeamGraph take() { return std::move(graph_); }

 private:
  struct Place {
    Vec3<double> point;
    double radius = 0;
  };

  [[nodiscard]] Place placeAt(const Vec3<double>& inCells) const {
    const auto point = cells_.at(inCells);
    return {point, thickness_.at(point, inCells)};
  }
  [[nodiscard]] Place placeOf(std::uint32_t node) const {
    return {graph_.nodes[node], radii_.at(node)};
  }
  std::uint32_t addNode(const Place& place) {
    graph_.nodes.push_back(place.point);
    radii_.push_back(place.radius);
    return static_cast<std::uint32_t>(graph_.nodes.size() - 1);
  }
  void addBeam(const std::array<std::uint32_t, 2>& nodes, double atA, double atB) {
    graph_.beams.push_back({nodes, {atA, atB}});
  }
  /// Whether all places are, at least nearly, those of a beam from the first to the last.
  [[nodiscard]] bool isOneBeam() const {
    constexpr double kSame = 1e-9;  // of the beam's length
    const auto& [a, atA] = places_.front();
    const auto& [b, atB] = places_.back();
    const double allowed = kSame * length(b - a);
    for (std::uint32_t i = 1; i < parts_; ++i) {
      const double t = static_cast<double>(i) / parts_;
      const auto& [point, radius] = places_[i];
      if (length(point - ((1 - t) * a + t * b)) > allowed) return false;
      if (std::abs(radius - ((1 - t) * atA + t * atB)) > allowed) return false;
    }
    return true;
  }

  const HexahedralCells& cells_;
  const Thickness<double>& thickness_;
  std::uint32_t parts_;
  std::vector<Place> places_;  // along the strut that is being added
  BeamGraph graph_;
  std::vector<double> radii_;  // at nodes
};

}  // namespace

BeamGraph beamsOf(const UnitCell& cell, const HexahedralCells& cells,
                  const Thickness<double>& thickness, const StrutOptions& options) {
  require(options.subdivisions > 0, "beamsOf: need a subdivision");
  const detail::CellCounts counts{cells.count(), cells.closed()};
  detail::requireFewStruts("beamsOf", cell, counts, options.subdivisions);
  StrutMapper mapper(cells, thickness, options);
  detail::forEachStrut(
      cell, counts, [&](const Vec3<double>& inCells) { return mapper.addNode(inCells); },
      [&](const detail::StrutCopy& strut) { mapper.addStrut(strut); });
  return mapper.take();
}

}  // namespace cutwater
