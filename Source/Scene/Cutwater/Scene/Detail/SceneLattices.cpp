#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Tables.hpp>
#include <Cutwater/Lattice/BeamGraph.hpp>
#include <Cutwater/Lattice/BeamLattice.hpp>
#include <Cutwater/Lattice/PackedBed.hpp>
#include <Cutwater/Lattice/PeriodicLattice.hpp>
#include <Cutwater/Scene/Detail/SceneLattices.hpp>

namespace cutwater::scene {

namespace {

using enum KeyType;
using Record = SceneRecord;

const std::string kReentrant = "re-entrant";

const std::vector<UnitCell>& allCells() {
  static const auto kCells = UnitCell::all();
  return kCells;
}

std::vector<std::string> cellNames() {
  std::vector<std::string> names;
  for (const auto& cell : allCells()) names.push_back(cell.name());
  return names;
}

const std::vector<SceneForm>& radiusForms() {
  static const std::vector<SceneForm> kForms{
      {.name = "a radius by the place in the cell",
       .meaning = "A radius that is linear in the distance to the centre of the cell.",
       .keys = {{"at_center", Positive, "the radius at the centre of a cell"},
                {"at_corners", Positive, "the radius at its corners"}}},
      {.name = "a radius by a distance",
       .meaning = "A radius that is linear in the distance to another solid's surface, on both "
                  "sides of it.",
       .keys = {{"near", KeyType::Solid,
                 "the radius depends on the distance to this solid; `move` of the lattice moves "
                 "both"},
                {"start", Positive, "the radius at its surface"},
                {"end", Positive, "the radius at the distance `over`, and beyond"},
                {"over", Positive, "a length"}}}};
  return kForms;
}

}  // namespace

Thickness<double> strutRadiusOf(const Record& r) {
  const auto parts = r.parts("radius");
  if (parts.empty()) return r.number("radius");
  const auto& part = parts.front();
  if (part.form().identifyingKey() == "at_center") {
    return Thickness<double>::byDistanceToCellCenter(part.number("at_center"),
                                                     part.number("at_corners"));
  }
  return Thickness<double>::byDistanceTo(
      part.solid("near"),
      {.start = part.number("start"), .end = part.number("end"), .over = part.number("over")});
}

UnitCell unitCellOf(const Record& r, std::string_view key) {
  if (r.text(key) == kReentrant) return UnitCell::reentrant(r.number("height"));
  if (r.isGiven("height")) r.fail("height", "only re-entrant cells have a \"height\"");
  return allCells()[r.choice(key)];
}

SceneKey unitCellKey(const char* name) {
  return {.name = name, .type = Choice, .meaning = "the unit cell's name", .choices = cellNames()};
}

SceneKey strutRadiusKey() {
  return {.name = "radius",
          .type = PositiveOrPart,
          .meaning = "the struts' radius; a table, if it depends on the place",
          .forms = &radiusForms()};
}

SceneKey reentrantHeightKey() {
  return {"height", Positive,
          "only of re-entrant cells: the length of the upright struts in cells, between 0.5 and 1",
          "0.7"};
}

namespace {

SceneSolid lattice(const Record& r) {
  const auto cell = unitCellOf(r, "lattice");
  const auto thickness = strutRadiusOf(r);
  return PeriodicLattice<double>(cell, {.period = r.point("cell"), .count = r.counts("count")},
                                 thickness);
}

SceneSolid beams(const Record& r) {
  const auto graph = readBeams(r.file("beams"), {.scale = r.number("scale")});
  if (!r.has("within")) return BeamLattice<double>(graph);
  return BeamLattice<double>(beamsWithin(graph, r.solid("within")));
}

SceneForm latticeForm() {
  return {.name = "lattice",
          .meaning = "Round struts along the edges of repeated unit cells.",
          .keys = {unitCellKey("lattice"),
                   {"cell", Sizes, "the sides of a cell"},
                   strutRadiusKey(),
                   {"count", Counts, "cells along each axis, from the origin; 0: without end",
                    "[0, 0, 0]"},
                   reentrantHeightKey()},
          .make = lattice};
}

}  // namespace

const std::vector<SceneForm>& latticeForms() {
  static const std::vector<SceneForm> kForms{
      latticeForm(),
      conformalForm(),
      {.name = "beams",
       .meaning = "Beams and balls from a text table with lines `node, x, y, z`, `beam, i, j, "
                  "radius, radius` and `ball, i, radius`.",
       .keys = {{"beams", File, "the table"},
                {"scale", Positive, "coordinates and radii are multiplied by it", "1"},
                {"within", KeyType::Solid, "leave out beams that lie outside of this solid",
                 kOptional}},
       .make = beams},
      {.name = "balls",
       .meaning = "A packed bed: balls from a text table with lines `x, y, z, radius`.",
       .keys = {{"balls", File, "the table"},
                {"scale", Positive, "coordinates and radii are multiplied by it", "1"}},
       .make = [](const Record& r) -> SceneSolid {
         return PackedBed<double>(readBalls(r.file("balls"), {.scale = r.number("scale")}));
       }},
  };
  return kForms;
}

}  // namespace cutwater::scene
