#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Scene/Detail/SceneRecord.hpp>

namespace cutwater::scene {

namespace {

using enum KeyType;
using Record = SceneRecord;

/// Keys of a smooth union, intersection or difference.
std::vector<SceneKey> withFillet(SceneKey operands) {
  return {std::move(operands),
          {"reach", NotNegative,
           "surfaces that meet are blended within about this distance; 0: a sharp edge", "0"},
          {"fillet",
           Choice,
           "the rounding's kind. quadratic: continuous normals; cubic: continuous curvature; "
           "circular: an arc; exponential: smooth everywhere",
           "\"quadratic\"",
           {"quadratic", "cubic", "circular", "exponential"}}};
}
Smoothing<double> smoothingOf(const Record& r) {
  return {.reach = r.number("reach"), .kind = static_cast<SmoothKind>(r.choice("fillet"))};
}

SceneSolid difference(const Record& r) {
  auto operands = r.solids("difference");
  for (std::size_t i = 1; i < operands.size(); ++i) operands[i] = ~operands[i];
  return smoothIntersectionOf(operands, smoothingOf(r));
}

SceneSolid exclusive(const Record& r) {
  const auto operands = r.solids("xor");
  auto result = operands.front();
  for (std::size_t i = 1; i < operands.size(); ++i) result = result ^ operands[i];
  return result;
}

SceneSolid blend(const Record& r) {
  const auto operands = r.solids("blended");
  if (operands.size() != 2) r.fail("blended", "need two solids");
  return blended(operands[0], operands[1], r.number("t"));
}

std::vector<SceneForm> combinations() {
  return {
      {.name = "union",
       .meaning = "All points of any of the solids.",
       .keys = withFillet({"union", Solids, "what is united"}),
       .make = [](const Record& r) { return smoothUnionOf(r.solids("union"), smoothingOf(r)); }},
      {.name = "intersection",
       .meaning = "All points common to the solids.",
       .keys = withFillet({"intersection", Solids, "what is intersected"}),
       .make =
           [](const Record& r) {
             return smoothIntersectionOf(r.solids("intersection"), smoothingOf(r));
           }},
      {.name = "difference",
       .meaning = "All points of the first solid that are in none of the others.",
       .keys = withFillet({"difference", Solids, "the solid, and what is taken away"}),
       .make = difference},
      {.name = "xor",
       .meaning = "All points of one solid or the other, but not of both; of more than two, one "
                  "after the other: (a xor b) xor c.",
       .keys = {{"xor", Solids, "the solids"}},
       .make = exclusive},
      {.name = "complement",
       .meaning = "All points that are not in the solid.",
       .keys = {{"complement", KeyType::Solid, "the solid"}},
       .make = [](const Record& r) { return ~r.solid("complement"); }},
      {.name = "blended",
       .meaning = "A solid between two others, a and b: its value is (1 - t) a + t b.",
       .keys = {{"blended", Solids, "a and b"}, {"t", NotNegative, "from 0, which is a, to 1"}},
       .make = blend},
  };
}

std::vector<SceneForm> walls() {
  return {
      {.name = "copy",
       .meaning = "The same solid, to be moved; it shares the other's memory.",
       .keys = {{"copy", KeyType::Solid, "the solid"}},
       .make = [](const Record& r) { return r.solid("copy"); }},
      {.name = "offset",
       .meaning = "The solid grown by a distance, its edges rounded, or shrunk.",
       .keys = {{"offset", KeyType::Solid, "the solid"},
                {"distance", Number, "how far; below 0: shrunk"}},
       .make = [](const Record& r) { return offset(r.solid("offset"), r.number("distance")); }},
      {.name = "shell",
       .meaning = "A wall about the solid's surface.",
       .keys = {{"shell", KeyType::Solid, "the solid"},
                {"half_thickness", Positive, "how far to either side"}},
       .make = [](const Record& r) { return shell(r.solid("shell"), r.number("half_thickness")); }},
      {.name = "scaled",
       .meaning = "The solid made larger or smaller, about the origin.",
       .keys = {{"scaled", KeyType::Solid, "the solid"},
                {"factor", Number, "how many times as large; below 0: mirrored, too"}},
       .make = [](const Record& r) { return scaled(r.solid("scaled"), r.number("factor")); }},
      {.name = "elongated",
       .meaning = "The solid cut at the planes x = 0, y = 0 and z = 0, its parts moved apart and "
                  "the gaps filled.",
       .keys = {{"elongated", KeyType::Solid, "the solid"},
                {"half", Point, "how far to either side along each axis, 0 or more"}},
       .make = [](const Record& r) { return elongated(r.solid("elongated"), r.point("half")); }},
      {.name = "transformed",
       .meaning = "The solid stretched, sheared or turned: its image under an affine map.",
       .keys = {{"transformed", KeyType::Solid, "the solid"},
                {"columns", Columns, "images of the unit vectors along x, y and z"},
                {"translation", Point, "the image of the origin", "[0, 0, 0]"}},
       .make =
           [](const Record& r) {
             return transformed(r.solid("transformed"),
                                AffineMap<double>{r.columns("columns"), r.point("translation")});
           }},
      {.name = "inverted",
       .meaning = "The image under inversion in the unit sphere: p becomes p / |p|^2.",
       .keys = {{"inverted", KeyType::Solid, "the solid"}},
       .make = [](const Record& r) { return inverted(r.solid("inverted")); }},
  };
}

/// Keys of the operand, and of a plane given by its normal and a point.
std::vector<SceneKey> withPlane(const char* name) {
  return {{name, KeyType::Solid, "the solid"},
          {"normal", Point, "the normal of the plane, of any length"},
          {"point", Point, "a point of the plane", "[0, 0, 0]"}};
}

SceneSolid repetition(const Record& r) {
  return repeated(r.solid("repeated"), {.period = r.point("period"), .count = r.counts("count")});
}

std::vector<SceneForm> repetitions() {
  return {
      {.name = "mirrored",
       .meaning = "The mirror image.",
       .keys = withPlane("mirrored"),
       .make =
           [](const Record& r) {
             return mirrored(r.solid("mirrored"), r.point("normal"), r.point("point"));
           }},
      {.name = "folded",
       .meaning = "The part on the side that the normal points to, and its mirror image.",
       .keys = withPlane("folded"),
       .make =
           [](const Record& r) {
             return folded(r.solid("folded"), r.point("normal"), r.point("point"));
           }},
      {.name = "unfolded",
       .meaning = "All of the solid and all of its mirror image.",
       .keys = withPlane("unfolded"),
       .make =
           [](const Record& r) {
             return unfolded(r.solid("unfolded"), r.point("normal"), r.point("point"));
           },
       .operandCopies = 2},
      {.name = "repeated",
       .meaning = "Copies at multiples of a period.",
       .keys = {{"repeated", KeyType::Solid, "the solid"},
                {"period", Point, "the period along each axis; 0: not repeated along it"},
                {"count", Counts, "copies along each axis, the original first; 0: without end",
                 "[0, 0, 0]"}},
       .make = repetition},
  };
}

const std::vector<SceneForm>& moveForms() {
  static const std::vector<SceneForm> kForms{
      {.name = "translate",
       .meaning = "A motion without rotation.",
       .keys = {{"translate", Point, "how far along each axis"}}},
      {.name = "rotate",
       .meaning = "A right-handed rotation.",
       .keys = {{"rotate", Number, "the angle in degrees"},
                {"axis", Axis, "the direction of the axis"},
                {"through", Point, "a point of the axis", "[0, 0, 0]"}}}};
  return kForms;
}

void rotate(SceneSolid& solid, const Record& turn) {
  const auto axis = turn.axis("axis");
  const auto through = turn.point("through");
  const double degrees = turn.number("rotate");
  const int* const coordinate = std::get_if<int>(&axis);
  if (coordinate != nullptr && through == Vec3<double>{}) {
    solid.rotate(degrees, *coordinate);
    return;
  }
  Vec3<double> direction{};
  if (coordinate != nullptr) {
    direction[*coordinate] = 1;
  } else {
    direction = std::get<Vec3<double>>(axis);
  }
  solid.rotate(degrees, direction, through);
}

}  // namespace

const std::vector<SceneForm>& operatorForms() {
  static const auto kForms = [] {
    std::vector<SceneForm> all;
    for (auto* group : {combinations, walls, repetitions}) {
      for (auto& form : group()) all.push_back(std::move(form));
    }
    return all;
  }();
  return kForms;
}

const std::vector<SceneKey>& commonKeys() {
  static const std::vector<SceneKey> kKeys{
      {.name = "move",
       .type = Parts,
       .meaning = "motions, one after the other",
       .preset = "[]",
       .forms = &moveForms()},
      {.name = "patch",
       .type = Text,
       .meaning = "the name of its patch; if it has several, a prefix of their names, as in "
                  "\"mast/shroud\"; without it, a shape, a lattice, or a mesh of one patch is "
                  "called after its table",
       .preset = kOptional}};
  return kKeys;
}

SceneSolid placed(SceneSolid solid, const SceneRecord& record) {
  for (const auto& step : record.parts("move")) {
    if (step.form().name == "rotate") {
      rotate(solid, step);
    } else {
      solid.translate(step.point("translate"));
    }
  }
  return record.has("patch") ? named(solid, record.text("patch")) : solid;
}

}  // namespace cutwater::scene
