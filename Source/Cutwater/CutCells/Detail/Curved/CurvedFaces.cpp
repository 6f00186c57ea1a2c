#include <Cutwater/CutCells/Detail/Curved/CurvedFaces.hpp>
#include <Cutwater/CutCells/Detail/Curved/GridSamples.hpp>

#include <algorithm>
#include <array>

namespace cutwater {

namespace {

double areaOf(const Box<double>& face) {
  const auto size = face.size();
  return size.x * size.y + size.y * size.z + size.z * size.x;  // two of them are 0
}

void addSpan(const FluidSpan& span, OpenPart& part) {
  const auto middle = span.middle();
  if (part.spans.empty()) part.inside = middle;
  part.area += span.size();
  part.centroid += span.size() * (middle - part.inside);
  part.spans.push_back(span);
}

}  // namespace

void CurvedFace::moveTo(int axis, double plane, const FluidField& field) {
  for (auto& part : parts) {
    part.centroid[axis] = part.inside[axis] = plane;
    for (auto& span : part.spans) span.line.start[axis] = plane;
  }
  if (connected) connected->moveTo(axis, plane, field);
}

CurvedFace wholeFace(const Box<double>& face, FluidRule& rule) {
  CurvedFace result{.parts = {}, .area = areaOf(face), .isWhole = true};
  rule.takeAll(face);
  result.parts.push_back({result.area, face.center(), face.center(), rule.points().spans});
  return result;
}

CurvedFace openPartsOf(const FluidField& field, const BoxView& face, FluidRule& rule,
                       double tolerance) {
  rule.findIn(face, tolerance);
  double area = 0;
  for (const auto& span : rule.points().spans) area += span.size();
  const double whole = areaOf(face.box());
  if (area <= kNothingOfCell * whole) return {};
  if (area >= (1 - kNothingOfCell) * whole) return wholeFace(face.box(), rule);
  FluidParts connected(field, face.box(), rule.points());
  CurvedFace result{.parts = {}, .gap = rule.gap()};
  result.parts.resize(std::max<std::size_t>(1, connected.count()));
  for (const auto& span : rule.points().spans) {
    addSpan(span, result.parts[connected.of(span.block, span.middle())]);
  }
  const auto isNothing = [&](const OpenPart& part) { return part.area <= kNothingOfCell * whole; };
  std::uint32_t count = 0;
  for (const auto& part : result.parts) result.partOf.push_back(isNothing(part) ? kNone : count++);
  std::erase_if(result.parts, isNothing);
  if (count > 1) result.connected.emplace(std::move(connected));
  for (auto& part : result.parts) {
    part.centroid = part.inside + part.centroid / part.area;
    result.area += part.area;
  }
  return result;
}

CurvedFace openPartsOf(const FluidField& field, const Box<double>& face, FluidRule& rule,
                       double tolerance) {
  std::array<Vec3<double>, 8> corners;
  for (int i = 0; i < 8; ++i) corners[static_cast<std::size_t>(i)] = face.corner(i);
  std::array<double, 8> values{};
  field.values(corners, values);
  if (leavesRoom(field, face, values)) {
    return openPartsOf(field, BoxView(field, face), rule, tolerance);
  }
  return values[0] > 0 ? wholeFace(face, rule) : CurvedFace{};
}

}  // namespace cutwater
