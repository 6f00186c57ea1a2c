#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/BeamLattice.hpp>
#include <Cutwater/Lattice/CellMappings.hpp>
#include <Cutwater/Lattice/ConformalBeams.hpp>
#include <Cutwater/Scene/Detail/SceneLattices.hpp>

#include <limits>

namespace cutwater::scene {

namespace {

using enum KeyType;
using Record = SceneRecord;

SceneKey length() {
  return {"length", Positive, "the length along z, from z = 0; without it, that of the spine",
          kOptional};
}

const std::vector<SceneForm>& fitForms() {
  static const std::vector<SceneForm> kForms{
      {.name = "a pipe",
       .meaning = "A pipe about the z axis, or the part of it between two angles; `cells` are "
                  "counted along its radius, around it and along it.",
       .keys = {{"inner_radius", Positive, "its inner radius"},
                {"outer_radius", Positive, "its outer radius"},
                length(),
                {"from_degrees", Number, "the angle where it begins, from x towards y", "0"},
                {"to_degrees", Number, "the angle where it ends", "360"}}},
      {.name = "a cylinder",
       .meaning = "A solid cylinder about the z axis.",
       .keys = {{"radius", Positive, "its radius"}, length()}},
      {.name = "a lens",
       .meaning = "A lens about the z axis, with its middle at the origin.",
       .keys = {{"diameter", Positive, "its diameter"},
                {"center_thickness", Positive, "its thickness on the axis"},
                {"front_radius", Number,
                 "radius of curvature of its lower face; below 0: concave; without it, flat",
                 kOptional},
                {"back_radius", Number, "the same of its upper face", kOptional}}},
      {.name = "a box",
       .meaning = "A box along the axes.",
       .keys = {{"lower", Point, "the corner of the least coordinates"},
                {"upper", Point, "the opposite corner"}}}};
  return kForms;
}

const std::vector<SceneForm>& noiseForms() {
  static const std::vector<SceneForm> kForms{
      {.name = "noise",
       .meaning = "Shifts of the corners of cells.",
       .keys = {{"amplitude", NotNegative, "corners are shifted by no more than this"},
                {"seed", Whole, "a different seed gives different shifts", "0"},
                {"unit",
                 Choice,
                 "the unit of the amplitude: that of lengths, or the shortest edge at the corner",
                 "\"length\"",
                 {"length", "shortest edge"}},
                {"keeps_boundary", Flag, "corners on the boundary do not move", "false"}}}};
  return kForms;
}

double lengthOf(const Record& fit, const std::optional<Spine>& spine) {
  if (fit.has("length")) return fit.number("length");
  if (!spine) fit.fail("length", "\"length\" is needed where there is no \"spine\"");
  return spine->length();
}

PipeMapping pipeOf(const Record& fit, const std::optional<Spine>& spine) {
  return PipeMapping({.innerRadius = fit.number("inner_radius"),
                      .outerRadius = fit.number("outer_radius"),
                      .length = lengthOf(fit, spine),
                      .fromDegrees = fit.number("from_degrees"),
                      .toDegrees = fit.number("to_degrees")});
}

LensMapping lensOf(const Record& fit) {
  constexpr double kFlat = std::numeric_limits<double>::infinity();
  return LensMapping({.diameter = fit.number("diameter"),
                      .centerThickness = fit.number("center_thickness"),
                      .frontRadius = fit.optionalNumber("front_radius").value_or(kFlat),
                      .backRadius = fit.optionalNumber("back_radius").value_or(kFlat)});
}

HexahedralCells hexahedraOf(const Record& r) {
  const auto count = r.counts("cells");
  std::optional<Spine> spine;
  if (r.has("spine")) spine.emplace(r.points("spine"), r.point("side"));
  if (!spine && r.isGiven("side")) r.fail("side", "\"side\" needs a \"spine\"");
  const auto along = [&](const auto& mapping) {
    return spine ? HexahedralCells(count, AlongSpine(*spine, mapping))
                 : HexahedralCells(count, mapping);
  };
  const auto fit = r.parts("fit").front();
  const auto& shape = fit.form().name;
  if (shape == "a pipe") return along(pipeOf(fit, spine));
  if (shape == "a cylinder") {
    return along(CylinderMapping(fit.number("radius"), lengthOf(fit, spine)));
  }
  if (shape == "a lens") return along(lensOf(fit));
  return along(BoxMapping({fit.point("lower"), fit.point("upper")}));
}

void requireFewBeams(const Record& r, const UnitCell& cell) {
  double beams = static_cast<double>(cell.struts().size());
  beams *= static_cast<double>(r.whole("subdivisions"));
  for (const auto count : r.counts("cells")) beams *= count;
  if (beams <= static_cast<double>(r.maxBeams())) return;
  throw Error(ErrorKind::Limit,
              "its cells have more than " + std::to_string(r.maxBeams()) + " beams");
}

SceneSolid conformal(const Record& r) {
  const auto cell = unitCellOf(r, "conformal");
  requireFewBeams(r, cell);
  auto cells = hexahedraOf(r);
  for (const auto& noise : r.parts("noise")) {
    cells = cells.withNoise({.amplitude = noise.number("amplitude"),
                             .seed = noise.whole("seed"),
                             .unit = static_cast<NoiseUnit>(noise.choice("unit")),
                             .keepsBoundary = noise.flag("keeps_boundary")});
  }
  return BeamLattice<double>(
      beamsOf(cell, cells, strutRadiusOf(r), {.subdivisions = r.whole("subdivisions")}));
}

}  // namespace

SceneForm conformalForm() {
  return {
      .name = "conformal",
      .meaning = "Struts of unit cells that are fitted to a shape, also along a curve.",
      .keys = {unitCellKey("conformal"),
               {"cells", Counts, "number of cells along each axis of the shape"},
               strutRadiusKey(),
               {.name = "fit", .type = Part, .meaning = "the shape", .forms = &fitForms()},
               {"spine", Points, "a smooth curve through these becomes the shape's z axis",
                kOptional},
               {"side", Point,
                "the direction of the shape's x axis at the beginning of the curve; zero: "
                "chosen for you",
                "[0, 0, 0]"},
               {.name = "noise",
                .type = Part,
                .meaning = "shifts corners at random",
                .preset = kOptional,
                .forms = &noiseForms()},
               {"subdivisions", Whole, "number of beams into which a bent strut is divided", "4"},
               reentrantHeightKey()},
      .make = conformal};
}

}  // namespace cutwater::scene
