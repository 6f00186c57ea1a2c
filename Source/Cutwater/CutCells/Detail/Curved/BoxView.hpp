#pragma once

#include <Cutwater/CutCells/Detail/Curved/LineCrossings.hpp>
#include <Cutwater/CutCells/Detail/Curved/SurfaceKinks.hpp>

#include <array>
#include <optional>

namespace cutwater {

/// The axes along which a box is swept: by lines, in rows of lines, in slices of rows. A flat box
/// has one slice, across the last of them.
struct SweepAxes {
  int line = 0;
  int row = 1;
  int slice = 2;
};

/// The line of a box in a slice and a row; and the row along one of the ends of lines.
[[nodiscard]] AxisLine lineAt(const Box<double>& box, const SweepAxes& axes, double slice,
                              double row);
[[nodiscard]] AxisLine rimAt(const Box<double>& box, const SweepAxes& axes, double slice,
                             double end);

/// The axis across a box without extent; -1: it has some along all.
[[nodiscard]] int flatAxisOf(const Box<double>& box);

/// A face of a box across an axis, as a flat box.
[[nodiscard]] Box<double> faceOf(Box<double> box, int axis, bool isHigh);

/// The parts of a box, or of a rectangle across an axis, that have a point of it as a corner.
struct PartsAround {
  std::array<Box<double>, 8> boxes;
  std::size_t count = 0;
};
[[nodiscard]] PartsAround partsAround(const Box<double>& box, const Vec3<double>& point,
                                      int flatAxis);

/// An edge of a box, and where it crosses the wall.
struct CrossedEdge {
  AxisLine line;
  bool startsInFluid = false;
  std::vector<double> crossings;        ///< ascending
  std::vector<Vec3<double>> gradients;  ///< of the field there
};
/// Finds crossings of edges, and gradients there if they are asked for.
void findCrossings(const FluidField& field, std::span<CrossedEdge* const> edges,
                   bool withGradients);

/// The corners and edges of a box, or of a rectangle, whose corners are the lower ones across its
/// axis.
struct BoxSamples {
  std::array<double, 8> values{};
  std::array<Vec3<double>, 8> gradients;
  std::vector<const CrossedEdge*> edges;  ///< along x, y, z
  std::vector<int> corners;               ///< at which each edge begins
};

/// A box, or a rectangle across an axis, as seen from its corners and edges: where the wall passes
/// through edges, with which normals, and along which axes it is a graph there.
class BoxView {
 public:
  BoxView(const FluidField& field, const Box<double>& box);
  /// With samples that are known. Views the edges.
  BoxView(const FluidField& field, const Box<double>& box, BoxSamples samples);
  BoxView(const BoxView&) = delete;
  BoxView& operator=(const BoxView&) = delete;
  ~BoxView() = default;

  [[nodiscard]] const Box<double>& box() const { return box_; }
  /// The axis across a rectangle; -1: the box is none.
  [[nodiscard]] int flatAxis() const { return flatAxis_; }
  [[nodiscard]] bool isFree(int axis) const { return axis != flatAxis_; }
  [[nodiscard]] bool isFluid(int corner) const { return samples_.values[asIndex(corner)] > 0; }
  /// Whether the wall passes through edges.
  [[nodiscard]] bool isCrossed() const { return !normals_.empty(); }

  /// A point inside, or within one of its faces, that is on the other side than all corners around
  /// it, where the derivatives at the corners lead to one.
  [[nodiscard]] std::optional<Vec3<double>> turningPoint() const;
  /// A point on the other side than all corners, if no edge is crossed: the one that a search finds
  /// which leaves out what the field's steepness excludes. It ends after some hundred values.
  [[nodiscard]] std::optional<Vec3<double>> hiddenPoint() const;
  /// One in one of the faces of a box, which are searched by themselves.
  [[nodiscard]] std::optional<Vec3<double>> hiddenPointInFaces() const;
  /// Axes along which the wall is a graph, and its rims on the ends of lines are; the best ones if
  /// `isGood` says that these are none.
  [[nodiscard]] SweepAxes bestAxes(bool& isGood) const;
  /// A point on the other side than points above and below it along an axis, in a coarse lattice:
  /// the wall is no graph along that axis, whatever edges tell.
  [[nodiscard]] std::optional<Vec3<double>> pointAgainstGraph(int axis) const;
  /// Whether the wall has an edge between the crossings with the most different normals.
  [[nodiscard]] bool hasKink() const { return isKinked(field_, places_, normals_, flatAxis_); }
  /// Whether values along lines of this axis seem to have no turning points.
  [[nodiscard]] bool isMonotone(int axis) const;
  /// The coordinates at which edges along an axis cross the wall, ascending.
  [[nodiscard]] std::vector<double> crossingsAlong(int axis) const;
  /// The length of the fluid on the edges along an axis, on each side of another one, in a
  /// rectangle.
  [[nodiscard]] double fluidLength(int axis, int side) const;
  [[nodiscard]] const BoxSamples& samples() const { return samples_; }

 private:
  static constexpr std::size_t asIndex(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] Vec3<double> inPlane(Vec3<double> gradient) const;
  [[nodiscard]] bool isTouched(const Vec3<double>& point, int across) const;
  void sampleCorners();
  void findEdges();
  [[nodiscard]] std::optional<Vec3<double>> turnIn(unsigned axes, int corner) const;
  [[nodiscard]] bool turnsAlong(int axis, unsigned axes, int corner, double& low,
                                double& high) const;
  void noteNormals();

  const FluidField& field_;
  Box<double> box_;
  int flatAxis_ = -1;
  std::vector<CrossedEdge> ownEdges_;
  BoxSamples samples_;
  std::vector<Vec3<double>> places_;   // of all crossings of edges
  std::vector<Vec3<double>> normals_;  // there
  std::vector<int> axisOf_;            // of their edges
};

}  // namespace cutwater
