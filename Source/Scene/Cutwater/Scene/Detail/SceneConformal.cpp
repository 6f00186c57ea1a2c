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
  return {"length", Positive, "along z, from 0; none: the spine's", kOptional};
}

const std::vector<SceneForm>& fitForms() {
  static const std::vector<SceneForm> kForms{
      {.name = "a pipe",
       .meaning = "About the z axis, all round or between two angles; cells across, round, along.",
       .keys = {{"inner_radius", Positive,
                 "of a pipe about the z axis; cells across, round, along"},
                {"outer_radius", Positive, "of the pipe"},
                length(),
                {"from_degrees", Number, "where it begins, from x towards y", "0"},
                {"to_degrees", Number, "where it ends", "360"}}},
      {.name = "a cylinder",
       .meaning = "A solid one about the z axis.",
       .keys = {{"radius", Positive, "of a cylinder about the z axis"}, length()}},
      {.name = "a lens",
       .meaning = "About the z axis, its middle at the origin.",
       .keys = {{"diameter", Positive, "of a lens about the z axis, its middle at the origin"},
                {"center_thickness", Positive, "of the lens"},
                {"front_radius", Number, "of its lower face; below 0: concave; none: flat",
                 kOptional},
                {"back_radius", Number, "of its upper face", kOptional}}},
      {.name = "a box",
       .meaning = "Along the axes.",
       .keys = {{"lower", Point, "the corner of a box"}, {"upper", Point, "the opposite"}}}};
  return kForms;
}

const std::vector<SceneForm>& noiseForms() {
  static const std::vector<SceneForm> kForms{
      {.name = "noise",
       .meaning = "Shifts of the corners of cells.",
       .keys = {{"amplitude", NotNegative, "corners are shifted by no more than that"},
                {"seed", Whole, "other numbers give other shifts", "0"},
                {"unit", Choice, "of the amplitude", "\"length\"", {"length", "shortest edge"}},
                {"keeps_boundary", Flag, "corners at ends of rows stay", "false"}}}};
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

HexahedralCells cellsOf(const Record& r) {
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
  auto cells = cellsOf(r);
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
  return {.name = "conformal",
          .meaning = "Struts of unit cells that are fitted to a shape, also along a curve.",
          .keys = {unitCellKey("conformal"),
                   {"cells", Counts, "how many, along each axis of the shape"},
                   strutRadiusKey(),
                   {.name = "fit", .type = Part, .meaning = "the shape", .forms = &fitForms()},
                   {"spine", Points, "a smooth curve through these becomes the shape's z axis",
                    kOptional},
                   {"side", Point, "where the shape's x axis looks to where the curve begins",
                    "[0, 0, 0]"},
                   {.name = "noise",
                    .type = Part,
                    .meaning = "shifts corners at random",
                    .preset = kOptional,
                    .forms = &noiseForms()},
                   {"subdivisions", Whole, "beams that a bent strut is made of", "4"},
                   reentrantHeightKey()},
          .make = conformal};
}

}  // namespace cutwater::scene
