#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Detail/CsvRows.hpp>
#include <Cutwater/Io/Tables.hpp>
#include <Cutwater/Text/Output.hpp>
#include <Cutwater/Text/Words.hpp>

#include <cmath>

namespace cutwater {

namespace {

using detail::CsvRows;

constexpr std::array<std::string_view, 3> kCapNames{"butt", "hemisphere", "sphere"};

BeamCap capOf(const CsvRows& rows, std::size_t field) {
  for (std::size_t cap = 0; cap < kCapNames.size(); ++cap) {
    if (text::equalIgnoringCase(rows.text(field), kCapNames[cap])) {
      return static_cast<BeamCap>(cap);
    }
  }
  rows.fail("expected butt, hemisphere or sphere, found " + text::inQuotes(rows.text(field)));
}

/// Fills a graph line by line.
class Lines {
 public:
  Lines(CsvRows& rows, double scale) : rows_(rows), scale_(scale) {}

  BeamGraph read() {
    while (rows_.next()) {
      const auto kind = rows_.text(0);
      if (text::equalIgnoringCase(kind, "node")) {
        addNode();
      } else if (text::equalIgnoringCase(kind, "beam")) {
        addBeam();
      } else if (text::equalIgnoringCase(kind, "ball")) {
        addBall();
      } else {
        rows_.fail("expected node, beam or ball, found " + text::inQuotes(kind));
      }
    }
    if (graph_.beams.empty() && graph_.balls.empty()) rows_.fail("the file ends without a beam");
    return std::move(graph_);
  }

 private:
  void addNode() {
    rows_.requireFields(4);
    requireRoom(graph_.nodes.size());
    graph_.nodes.push_back(scale_ * rows_.point(1));
    if (!isFinite(graph_.nodes.back())) rows_.fail("the scale is too large");
  }
  void addBeam() {
    const bool isFrustum = rows_.fields() == 7;
    if (!isFrustum) rows_.requireFields(5);
    requireRoom(graph_.beams.size());
    BeamGraph::Beam beam{{node(1), node(2)}, {radius(3), radius(4)}};
    if (!(beam.radii[0] > 0 || beam.radii[1] > 0)) rows_.fail("need a radius above 0");
    if (isFrustum) {
      beam.body = BeamBody::Frustum;
      beam.caps = {capOf(rows_, 5), capOf(rows_, 6)};
      if (graph_.nodes[beam.nodes[0]] == graph_.nodes[beam.nodes[1]]) {
        rows_.fail("a frustum needs nodes in two places");
      }
    }
    graph_.beams.push_back(beam);
  }
  void addBall() {
    rows_.requireFields(3);
    requireRoom(graph_.balls.size());
    graph_.balls.push_back({node(1), radius(2)});
    if (!(graph_.balls.back().radius > 0)) rows_.fail("need a radius above 0");
  }

  [[nodiscard]] std::uint32_t node(std::size_t field) const {
    return rows_.index(field, graph_.nodes.size(), "node");
  }
  [[nodiscard]] double radius(std::size_t field) const {
    const double result = scale_ * rows_.number(field);
    if (result < 0) rows_.fail("need radii that are not negative");
    if (!std::isfinite(result)) rows_.fail("the scale is too large");
    return result;
  }
  void requireRoom(std::size_t count) const {
    if (count >= kNone - 1) rows_.failLimit("more than 2^32 - 2 lines of a kind");
  }

  CsvRows& rows_;
  double scale_;
  BeamGraph graph_;
};

/// Refuses what readBeams() would refuse.
void check(const BeamGraph& graph) {
  const auto isRadius = [](double r) { return 0 <= r && std::isfinite(r); };
  const auto isNode = [&](std::uint32_t node) { return node < graph.nodes.size(); };
  require(!graph.beams.empty() || !graph.balls.empty(), "writeBeams: need a beam");
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    require(isFinite(graph.nodes[i]), "writeBeams: need finite coordinates", Named{"node", i});
  }
  for (std::size_t i = 0; i < graph.beams.size(); ++i) {
    const auto& [nodes, radii, body, caps] = graph.beams[i];
    require(isNode(nodes[0]) && isNode(nodes[1]), "writeBeams: need nodes that exist",
            Named{"beam", i});
    require(isRadius(radii[0]) && isRadius(radii[1]) && radii[0] + radii[1] > 0,
            "writeBeams: need radii that are finite, not negative, and not both 0",
            Named{"beam", i});
    require(body != BeamBody::Frustum || graph.nodes[nodes[0]] != graph.nodes[nodes[1]],
            "writeBeams: a frustum needs nodes in two places", Named{"beam", i});
  }
  for (std::size_t i = 0; i < graph.balls.size(); ++i) {
    const auto& [node, radius] = graph.balls[i];
    require(isNode(node) && isRadius(radius) && radius > 0,
            "writeBeams: need a node that there is, and a finite radius above 0", Named{"ball", i});
  }
}

}  // namespace

BeamGraph readBeams(const std::filesystem::path& path, const ReadTableOptions& options) {
  require(options.scale > 0 && std::isfinite(options.scale), "readBeams: need 0 < scale < infinity",
          Named{"scale", options.scale});
  CsvRows rows(path, options.maxBytes);
  return Lines(rows, options.scale).read();
}

void writeBeams(const std::filesystem::path& path, const BeamGraph& graph) {
  check(graph);
  OutputFile file(path);
  text::Output out(file);
  for (const auto& p : graph.nodes) out << "node," << p.x << ',' << p.y << ',' << p.z << '\n';
  for (const auto& [nodes, radii, body, caps] : graph.beams) {
    out << "beam," << std::uint64_t{nodes[0]} << ',' << std::uint64_t{nodes[1]} << ',' << radii[0]
        << ',' << radii[1];
    if (body == BeamBody::Frustum) {
      for (const auto cap : caps) out << ',' << kCapNames[static_cast<std::size_t>(cap)];
    }
    out << '\n';
  }
  for (const auto& [node, radius] : graph.balls) {
    out << "ball," << std::uint64_t{node} << ',' << radius << '\n';
  }
  out.flush();
  file.commit();
}

}  // namespace cutwater
