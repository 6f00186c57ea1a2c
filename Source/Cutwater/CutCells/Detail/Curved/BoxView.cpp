#include <Cutwater/CutCells/Detail/Curved/BoxView.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cutwater {

namespace {

unsigned bit(int axis) {
  return 1U << static_cast<unsigned>(axis);
}

}  // namespace

AxisLine lineAt(const Box<double>& box, const SweepAxes& axes, double slice, double row) {
  AxisLine line{box.lower, box.upper[axes.line], axes.line};
  line.start[axes.row] = row;
  line.start[axes.slice] = slice;
  return line;
}

AxisLine rimAt(const Box<double>& box, const SweepAxes& axes, double slice, double end) {
  AxisLine line{box.lower, box.upper[axes.row], axes.row};
  line.start[axes.line] = end;
  line.start[axes.slice] = slice;
  return line;
}

int flatAxisOf(const Box<double>& box) {
  for (const int axis : {2, 1, 0}) {
    if (box.lower[axis] == box.upper[axis]) return axis;
  }
  return -1;
}

Box<double> faceOf(Box<double> box, int axis, bool isHigh) {
  (isHigh ? box.lower : box.upper)[axis] = (isHigh ? box.upper : box.lower)[axis];
  return box;
}

PartsAround partsAround(const Box<double>& box, const Vec3<double>& point, int flatAxis) {
  PartsAround parts;
  for (unsigned corner = 0; corner < 8; ++corner) {
    if (flatAxis >= 0 && (corner & bit(flatAxis)) != 0) continue;
    auto& part = parts.boxes[parts.count++];
    part = box;
    for (int axis = 0; axis < 3; ++axis) {
      auto& end = (corner & bit(axis)) != 0 ? part.lower : part.upper;
      if (axis != flatAxis) end[axis] = point[axis];
    }
  }
  return parts;
}

void findCrossings(const FluidField& field, std::span<CrossedEdge* const> edges,
                   bool withGradients) {
  std::vector<AxisLine> lines;
  for (const auto* edge : edges) lines.push_back(edge->line);
  LineCrossings found(field);
  found.find(lines);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    edges[i]->startsInFluid = found.startsInFluid(i);
    for (const double at : found.of(i)) {
      edges[i]->crossings.push_back(at);
      if (withGradients) edges[i]->gradients.push_back(field.gradient(edges[i]->line.at(at)));
    }
  }
}

BoxView::BoxView(const FluidField& field, const Box<double>& box)
    : BoxView(field, box, BoxSamples{}) {
  sampleCorners();
  findEdges();
  noteNormals();
}

BoxView::BoxView(const FluidField& field, const Box<double>& box, BoxSamples samples)
    : field_(field), box_(box), flatAxis_(flatAxisOf(box)), samples_(std::move(samples)) {
  noteNormals();
}

void BoxView::sampleCorners() {
  std::array<Vec3<double>, 8> corners;
  for (int i = 0; i < 8; ++i) corners[asIndex(i)] = box_.corner(i);
  field_.values(corners, samples_.values);
  for (int i = 0; i < 8; ++i) {
    const bool isCopy = flatAxis_ >= 0 && (static_cast<unsigned>(i) & bit(flatAxis_)) != 0;
    samples_.gradients[asIndex(i)] = isCopy ? samples_.gradients[asIndex(i) - bit(flatAxis_)]
                                            : field_.gradient(corners[asIndex(i)]);
  }
}

void BoxView::findEdges() {
  constexpr std::size_t kMost = 12;
  ownEdges_.reserve(kMost);
  for (int axis = 0; axis < 3; ++axis) {
    if (!isFree(axis)) continue;
    for (int i = 0; i < 8; ++i) {
      const auto bits = static_cast<unsigned>(i);
      if ((bits & bit(axis)) != 0 || (flatAxis_ >= 0 && (bits & bit(flatAxis_)) != 0)) continue;
      ownEdges_.push_back(
          {.line = {box_.corner(i), box_.upper[axis], axis}, .crossings = {}, .gradients = {}});
      samples_.corners.push_back(i);
    }
  }
  std::vector<CrossedEdge*> edges;
  for (auto& edge : ownEdges_) {
    edges.push_back(&edge);
    samples_.edges.push_back(&edge);
  }
  findCrossings(field_, edges, true);
}

void BoxView::noteNormals() {
  for (const auto* edge : samples_.edges) {
    for (std::size_t i = 0; i < edge->gradients.size(); ++i) {
      places_.push_back(edge->line.at(edge->crossings[i]));
      normals_.push_back(inPlane(edge->gradients[i]));
      axisOf_.push_back(edge->line.axis);
    }
  }
}

/// The direction of a gradient; in a rectangle, in its plane.
Vec3<double> BoxView::inPlane(Vec3<double> gradient) const {
  if (flatAxis_ >= 0) gradient[flatAxis_] = 0;
  return normalized(gradient);
}

std::optional<Vec3<double>> BoxView::pointAgainstGraph(int axis) const {
  constexpr std::size_t kLines = 3;   // along each other axis
  constexpr std::size_t kPoints = 5;  // of a line, with its ends
  const auto size = box_.size();
  const std::array others{(axis + 1) % 3, (axis + 2) % 3};
  std::array<Vec3<double>, kLines * kLines * kPoints> points;
  std::size_t count = 0;
  const auto share = [](std::size_t part, std::size_t of) {
    return static_cast<double>(part) / static_cast<double>(of);
  };
  const auto lines = [&](int other) { return isFree(other) ? kLines : 1; };
  for (std::size_t i = 0; i < lines(others[0]); ++i) {
    for (std::size_t j = 0; j < lines(others[1]); ++j) {
      auto p = box_.lower;
      p[others[0]] += size[others[0]] * share(i + 1, kLines + 1);
      p[others[1]] += size[others[1]] * share(j + 1, kLines + 1);
      for (std::size_t k = 0; k < kPoints; ++k) {
        p[axis] = k + 1 == kPoints ? box_.upper[axis]
                                   : box_.lower[axis] + size[axis] * share(k, kPoints - 1);
        points[count++] = p;
      }
    }
  }
  std::array<double, points.size()> values{};
  field_.values(std::span(points).first(count), std::span(values).first(count));
  for (std::size_t line = 0; line < count; line += kPoints) {
    std::size_t first = 0;  // where the side changes
    for (auto i = line + 1; i < line + kPoints; ++i) {
      if ((values[i] > 0) == (values[i - 1] > 0)) continue;
      if (first != 0) return points[first];
      first = i;
    }
  }
  return {};
}

std::vector<double> BoxView::crossingsAlong(int axis) const {
  std::vector<double> result;
  for (const auto* edge : samples_.edges) {
    if (edge->line.axis != axis) continue;
    result.insert(result.end(), edge->crossings.begin(), edge->crossings.end());
  }
  std::ranges::sort(result);
  return result;
}

/// Whether a wall touches a rectangle in a point of an edge, across an axis of which it is: then
/// the point is no body. One that ends there, as at the edge of a cuboid, does not.
bool BoxView::isTouched(const Vec3<double>& point, int across) const {
  constexpr double kInside = 1e-3;   // of the rectangle
  constexpr double kTouching = 0.1;  // the sine of the angle between wall and rectangle
  if (field_.value(point) != 0) return false;
  auto beside = point;
  beside[across] += kInside * (box_.center()[across] - point[across]);
  if (!(field_.value(beside) > 0)) return false;
  const auto slope = field_.gradient(beside);
  auto along = slope;
  along[flatAxis_] = 0;
  return length(along) <= kTouching * length(slope);
}

double BoxView::fluidLength(int axis, int side) const {
  const int other = 3 - axis - flatAxis_;
  for (std::size_t i = 0; i < samples_.edges.size(); ++i) {
    const auto& edge = *samples_.edges[i];
    const bool isHigh = (static_cast<unsigned>(samples_.corners[i]) & bit(other)) != 0;
    if (edge.line.axis != axis || isHigh != (side == 1)) continue;
    double sum = 0;
    const auto add = [&](double from, double to, bool, bool) { sum += to - from; };
    const auto addTouched = [&](double from, double to, bool, bool) {
      if (isTouched(edge.line.at(0.5 * (from + to)), other)) sum += to - from;
    };
    forFluidStretches(edge.line, edge.startsInFluid, edge.crossings, add);
    forFluidStretches(edge.line, !edge.startsInFluid, edge.crossings, addTouched);
    return sum;
  }
  return 0;
}

bool BoxView::isMonotone(int axis) const {
  const auto sign = [&](const Vec3<double>& v) { return v[axis] > 0 ? 1 : v[axis] < 0 ? -1 : 0; };
  const int first = sign(samples_.gradients[0]);
  const auto isSame = [&](const Vec3<double>& v) { return sign(v) == first; };
  return first != 0 && std::ranges::all_of(samples_.gradients, isSame) &&
         std::ranges::all_of(normals_, isSame);
}

SweepAxes BoxView::bestAxes(bool& isGood) const {
  constexpr double kSlope = 0.3;
  // The least component along each axis that the normals have.
  Vec3<double> least{1, 1, 1};
  for (const auto& n : normals_) least = min(least, abs(n));
  if (flatAxis_ >= 0) least[flatAxis_] = -1;
  SweepAxes axes;
  for (int axis = 0; axis < 3; ++axis) {
    if (least[axis] > least[axes.line]) axes.line = axis;
  }
  isGood = least[axes.line] >= kSlope;
  axes.row = (axes.line + 1) % 3;
  axes.slice = (axes.line + 2) % 3;
  if (flatAxis_ >= 0) {
    if (axes.row == flatAxis_) std::swap(axes.row, axes.slice);
    return axes;
  }
  // Likewise of the rims in the faces at the ends of lines.
  double alongRow = 1;
  double alongSlice = 1;
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    if (axisOf_[i] == axes.line) continue;
    auto n = normals_[i];
    n[axes.line] = 0;
    n = normalized(n);
    alongRow = std::min(alongRow, std::abs(n[axes.row]));
    alongSlice = std::min(alongSlice, std::abs(n[axes.slice]));
  }
  if (alongSlice > alongRow) {
    std::swap(axes.row, axes.slice);
    std::swap(alongRow, alongSlice);
  }
  isGood = isGood && alongRow >= kSlope;
  return axes;
}

std::optional<Vec3<double>> BoxView::turningPoint() const {
  constexpr unsigned kAll = 7;
  const unsigned free = flatAxis_ < 0 ? kAll : kAll - bit(flatAxis_);
  if (const auto inside = turnIn(free, 0)) return inside;
  if (flatAxis_ >= 0) return {};
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, 1}) {
      const auto turn = turnIn(kAll - bit(axis), side * static_cast<int>(bit(axis)));
      if (turn) return turn;
    }
  }
  return {};
}

/// Branch and bound for the least value of a function with a Lipschitz constant (Piyavskii 1972):
/// the box that may have the lowest one is divided first.
std::optional<Vec3<double>> BoxView::hiddenPoint() const {
  const std::size_t most = flatAxis_ < 0 ? 200 : 80;
  const bool liesInWall = std::ranges::all_of(samples_.values, [](double v) { return v == 0; });
  if (field_.steepness(box_) == 0 || liesInWall) return {};
  const double sign = isFluid(0) ? 1 : -1;
  struct Open {
    Box<double> box;
    double bound;  // no value in it is lower
  };
  std::vector<Open> open{{box_, 0}};
  const auto isLater = [](const Open& a, const Open& b) { return a.bound > b.bound; };
  std::size_t values = 0;
  while (!open.empty() && values < most) {
    std::ranges::pop_heap(open, isLater);
    const auto parent = open.back().box;
    open.pop_back();
    const auto parts = partsAround(parent, parent.center(), flatAxis_);
    std::array<Vec3<double>, 8> centers;
    for (std::size_t i = 0; i < parts.count; ++i) centers[i] = parts.boxes[i].center();
    std::array<double, 8> found{};
    field_.values(std::span(centers).first(parts.count), std::span(found).first(parts.count));
    values += parts.count;
    for (std::size_t i = 0; i < parts.count; ++i) {
      if ((found[i] > 0) != isFluid(0)) return centers[i];
      const double bound = sign * found[i] - field_.changeToCorners(parts.boxes[i]);
      if (bound > 0) continue;
      open.push_back({parts.boxes[i], bound});
      std::ranges::push_heap(open, isLater);
    }
  }
  return {};
}

std::optional<Vec3<double>> BoxView::hiddenPointInFaces() const {
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool isHigh : {false, true}) {
      const BoxView face(field_, faceOf(box_, axis, isHigh));
      if (const auto point = face.hiddenPoint()) return point;
    }
  }
  return {};
}

/// Mean derivatives along an axis, into the side of the corners, at both ends of the face (or the
/// box) that spans `axes` from a corner; whether values have a turning point between these.
bool BoxView::turnsAlong(int axis, unsigned axes, int corner, double& low, double& high) const {
  const double sign = isFluid(corner) ? 1 : -1;
  low = 0;
  high = 0;
  for (unsigned i = 0; i < 8; ++i) {
    if ((i & ~axes) != 0) continue;
    const auto at = i | static_cast<unsigned>(corner);
    ((i & bit(axis)) == 0 ? low : high) += sign * samples_.gradients[at][axis];
  }
  return low < 0 && high > 0;
}

/// By steps of Newton's method with the second derivatives between the corners.
std::optional<Vec3<double>> BoxView::turnIn(unsigned axes, int corner) const {
  for (unsigned i = 0; i < 8; ++i) {
    const auto at = i | static_cast<unsigned>(corner);
    if ((i & ~axes) == 0 && isFluid(static_cast<int>(at)) != isFluid(corner)) return {};
  }
  auto point = box_.corner(corner);
  Vec3<double> bend;
  double corners = 2;  // at each end of an axis
  if (axes == 7) corners = 4;
  for (int axis = 0; axis < 3; ++axis) {
    if ((axes & bit(axis)) == 0) continue;
    double low = 0;
    double high = 0;
    if (!turnsAlong(axis, axes, corner, low, high)) return {};
    const double width = box_.upper[axis] - box_.lower[axis];
    point[axis] = box_.lower[axis] + width * (low / (low - high));
    bend[axis] = (high - low) / (corners * width);
  }
  const double sign = isFluid(corner) ? 1 : -1;
  constexpr int kSteps = 6;
  constexpr double kMargin = 1e-3;  // from the sides, in shares of the box
  for (int step = 0; step < kSteps; ++step) {
    if ((field_.value(point) > 0) != isFluid(corner)) return point;
    const auto slope = sign * field_.gradient(point);
    for (int axis = 0; axis < 3; ++axis) {
      if ((axes & bit(axis)) == 0) continue;
      const double margin = kMargin * (box_.upper[axis] - box_.lower[axis]);
      point[axis] = std::clamp(point[axis] - slope[axis] / bend[axis], box_.lower[axis] + margin,
                               box_.upper[axis] - margin);
    }
  }
  return {};
}

}  // namespace cutwater
