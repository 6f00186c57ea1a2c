#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/BeamGraph.hpp>

#include <algorithm>

namespace cutwater {

namespace {

/// Box of balls about the nodes. It encloses the beam between them, even if that is stored in
/// single precision.
Box<double> boxOf(const Vec3<double>& a, const Vec3<double>& b,
                  const std::array<double, 2>& radii) {
  constexpr double kRounding = 0x1p-22;
  const double radius = std::max(radii[0], radii[1]);
  const auto box = Box<double>().extend(a).extend(b).grown(radius);
  return box.grown(kRounding * (maxComponent(max(abs(box.lower), abs(box.upper))) + radius));
}

std::vector<Box<double>> boxesOf(const BeamGraph& graph) {
  const auto node = [&](std::uint32_t index) {
    require(index < graph.nodes.size(), "beamsWithin: need nodes that exist", Named{"node", index},
            Named{"nodes", graph.nodes.size()});
    return graph.nodes[index];
  };
  std::vector<Box<double>> boxes;
  boxes.reserve(graph.beams.size() + graph.balls.size());
  for (const auto& beam : graph.beams) {
    boxes.push_back(boxOf(node(beam.nodes[0]), node(beam.nodes[1]), beam.radii));
  }
  for (const auto& ball : graph.balls) {
    boxes.push_back(boxOf(node(ball.node), node(ball.node), {ball.radius, ball.radius}));
  }
  return boxes;
}

/// A graph with some of the beams of another one.
class Selection {
 public:
  explicit Selection(const BeamGraph& graph) : from_(graph), known_(graph.nodes.size(), kNone) {}

  void add(BeamGraph::Beam beam) {
    for (auto& node : beam.nodes) node = nodeOf(node);
    graph_.beams.push_back(beam);
  }
  void add(BeamGraph::Ball ball) {
    ball.node = nodeOf(ball.node);
    graph_.balls.push_back(ball);
  }
  BeamGraph take() { return std::move(graph_); }

 private:
  std::uint32_t nodeOf(std::uint32_t node) {
    auto& index = known_[node];
    if (index == kNone) {
      index = static_cast<std::uint32_t>(graph_.nodes.size());
      graph_.nodes.push_back(from_.nodes[node]);
    }
    return index;
  }

  const BeamGraph& from_;
  std::vector<std::uint32_t> known_;
  BeamGraph graph_;
};

}  // namespace

BeamGraph beamsWithin(const BeamGraph& graph, const Solid<double>& solid,
                      const ParallelOptions& options) {
  const auto boxes = boxesOf(graph);
  std::vector<BoxClass> classes(boxes.size());
  solid.classify(boxes, classes, {}, options);
  Selection selection(graph);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (classes[i] == BoxClass::Outside) continue;
    if (i < graph.beams.size()) {
      selection.add(graph.beams[i]);
    } else {
      selection.add(graph.balls[i - graph.beams.size()]);
    }
  }
  return selection.take();
}

}  // namespace cutwater
