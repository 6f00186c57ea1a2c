#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Scene/Detail/SceneRecord.hpp>
#include <Cutwater/Tpms/TwoFluids.hpp>

#include <limits>

namespace cutwater::scene {

namespace {

using enum KeyType;
using Record = SceneRecord;

const std::vector<TpmsPattern>& allPatterns() {
  static const auto kPatterns = TpmsPattern::all();
  return kPatterns;
}

SceneKey patternKey(const char* name, const char* meaning) {
  SceneKey key{name, Choice, meaning};
  for (const auto& pattern : allPatterns()) key.choices.push_back(pattern.name());
  return key;
}

const TpmsPattern& patternOf(const Record& r, std::string_view key) {
  return allPatterns()[r.choice(key)];
}

/// The form of a number, such as "level", of this type, which depends on the value of a solid.
SceneForm rampForm(const std::string& number, KeyType type, std::vector<std::string> presets = {}) {
  SceneForm form{
      .name = "a " + number + " by a distance",
      .meaning = "A " + number + " that is linear in the signed distance to another solid.",
      .keys = {{"near", KeyType::Solid,
                "the other solid; what counts is its value, the signed distance or a lower bound "
                "of it; `move` of this solid moves both"},
               {"start", type, "the " + number + " where that value is 0 or less"},
               {"end", type, "the " + number + " where that value is `over` or more"},
               {"over", Positive, "a length"}}};
  for (std::size_t i = 0; i < presets.size(); ++i) form.keys[i + 1].preset = presets[i];
  return form;
}

GradedValue<double> rampOf(const Record& part) {
  return GradedValue<double>::byValueOf(
      part.solid("near"),
      {.start = part.number("start"), .end = part.number("end"), .over = part.number("over")});
}

GradedValue<double> gradedOf(const Record& r, std::string_view key) {
  const auto parts = r.parts(key);
  return parts.empty() ? GradedValue<double>(r.number(key)) : rampOf(parts.front());
}

const std::vector<SceneForm>& levelForms() {
  static const std::vector<SceneForm> kForms{rampForm("level", Number)};
  return kForms;
}

const std::vector<SceneForm>& halfThicknessForms() {
  static const std::vector<SceneForm> kForms{rampForm("half thickness", Positive)};
  return kForms;
}

const std::vector<SceneForm>& transitionForms() {
  static const auto kForms = [] {
    auto byPlace = rampForm("weight", NotNegative, {"0", "1"});
    SceneForm even{.name = "a transition",
                   .meaning = "A weight that is the same everywhere.",
                   .keys = {{"weight", NotNegative, "the weight of `to`, from 0 to 1"}}};
    for (auto* form : {&byPlace, &even}) {
      form->keys.push_back(patternKey("to", "the pattern where the weight is 1"));
    }
    return std::vector<SceneForm>{byPlace, even};
  }();
  return kForms;
}

TpmsField<double> fieldOf(const Record& r, const TpmsMap<double>& map) {
  const auto& pattern = patternOf(r, "tpms");
  const auto parts = r.parts("transition");
  if (parts.empty()) return {pattern, map};
  const auto& part = parts.front();
  const auto weight = part.form().identifyingKey() == "weight"
                          ? GradedValue<double>(part.number("weight"))
                          : rampOf(part);
  return {TpmsTransition<double>{pattern, patternOf(part, "to"), weight}, map};
}

const std::vector<SceneForm>& cellForms() {
  static const std::vector<SceneForm> kForms{
      {.name = "cells around an axis",
       .meaning = "Cells along radius, angle and height about the z axis.",
       .keys = {{"radial_size", Positive, "the size of a cell along the radius"},
                {"cells_per_turn", Whole, "number of cells around the axis"},
                {"axial_size", Positive, "the size of a cell along z"},
                {"turns_per_length", Number,
                 "turns by which cells twist around the axis, per length", "0"}}},
      {.name = "cells of sizes by the place",
       .meaning = "Cells whose size along each axis depends on the place along it.",
       .keys = {{"x", SizesByPlace, "the size along x, or pairs of a place and the size there"},
                {"y", SizesByPlace, "the same along y"},
                {"z", SizesByPlace, "the same along z"}}}};
  return kForms;
}

CellSizes<double> sizesOf(const Record& part, std::string_view axis) {
  if (part.isNumber(axis)) return part.number(axis);
  std::vector<CellSizeAt<double>> sizes;
  for (const auto& [place, size] : part.outline(axis)) sizes.push_back({place, size});
  return CellSizes<double>(sizes);
}

int cellsPerTurn(const Record& part) {
  constexpr int kMost = std::numeric_limits<int>::max();
  const auto count = part.whole("cells_per_turn");
  if (count > kMost) part.fail("cells_per_turn", "\"cells_per_turn\" must not exceed 2^31 - 1");
  return static_cast<int>(count);
}

TpmsMap<double> cellsOf(const Record& r) {
  if (r.isNumber("cell")) return r.number("cell");
  const auto parts = r.parts("cell");
  if (parts.empty()) return TpmsMap<double>(r.point("cell"));
  const auto& part = parts.front();
  if (part.form().identifyingKey() == "x") {
    return TpmsMap<double>({sizesOf(part, "x"), sizesOf(part, "y"), sizesOf(part, "z")});
  }
  return TpmsMap<double>::cylindrical({.radialSize = part.number("radial_size"),
                                       .cellsPerTurn = cellsPerTurn(part),
                                       .axialSize = part.number("axial_size"),
                                       .turnsPerLength = part.number("turns_per_length")});
}

const std::vector<SceneForm>& deformationForms() {
  static const std::vector<SceneForm> kForms{
      {.name = "a deformation",
       .meaning = "Random shifts at the nodes of a grid, trilinear in between.",
       .keys = {{"amplitude", NotNegative, "shifts are at most this, along each axis"},
                {"spacing", Sizes,
                 "spacing of the grid at whose nodes shifts are random; trilinear in between"},
                {"seed", Whole, "a different seed gives different shifts", "1"}}}};
  return kForms;
}

TpmsMap<double> mapOf(const Record& r) {
  auto map = cellsOf(r);
  for (const auto& part : r.parts("deformation")) {
    map = map.deformed({.amplitude = part.number("amplitude"),
                        .spacing = part.point("spacing"),
                        .seed = part.whole("seed")});
  }
  return map;
}

SceneForm tpmsForm() {
  return {
      .name = "tpms",
      .meaning = "A wall, a channel or a network, by levels of a triply periodic function F.",
      .keys = {patternKey("tpms", "the pattern F"),
               {"part",
                Choice,
                "the part that is solid. wall: abs(F) < level; channels: abs(F) > level; "
                "channel A: F > level; channel B: F < -level; wall in A and wall in B: the "
                "halves of the wall with F > 0 and F < 0",
                "\"wall\"",
                {"wall", "channels", "channel A", "channel B", "wall in A", "wall in B"}},
               {.name = "cell",
                .type = SizesOrPart,
                .meaning = "the side of a cubic cell, or the sides along each axis; or a table",
                .forms = &cellForms()},
               {.name = "level",
                .type = NumberOrPart,
                .meaning = "in units of F; a table, if it depends on the place",
                .forms = &levelForms()},
               {.name = "transition",
                .type = Part,
                .meaning = "a transition to another pattern, F = (1 - w) `tpms` + w `to`, with a "
                           "weight w",
                .preset = kOptional,
                .forms = &transitionForms()},
               {.name = "deformation",
                .type = Part,
                .meaning = "random deformation of the cells",
                .preset = kOptional,
                .forms = &deformationForms()}},
      .make = [](const Record& r) -> SceneSolid {
        return TpmsSolid<double>(fieldOf(r, mapOf(r)), static_cast<TpmsPart>(r.choice("part")),
                                 gradedOf(r, "level"));
      }};
}

MetricWall<double> evenWall(const Record& r) {
  return {patternOf(r, "even_wall"), r.number("cell"), gradedOf(r, "half_thickness")};
}

SceneForm evenWallForm() {
  return {
      .name = "even_wall",
      .meaning =
          "A wall of even thickness: all points within half the thickness of the surface "
          "F = 0.",
      .keys = {patternKey("even_wall", "the pattern F"),
               {"cell", Positive, "the side of a cubic cell"},
               {.name = "half_thickness",
                .type = PositiveOrPart,
                .meaning =
                    "how far to either side of the surface; a table, if it depends on the place",
                .forms = &halfThicknessForms()}},
      .make = [](const Record& r) -> SceneSolid { return evenWall(r); }};
}

/// The channels on both sides of the named wall, moved with the wall.
TpmsChannels<double> channelsOf(const Record& r) {
  const auto& core = r.record("core");
  const auto sidesOf = [&]() -> TpmsChannels<double> {
    const auto& name = core.form().name;
    if (name == "even_wall") return TpmsChannels<double>::of(evenWall(core));
    if (name != "tpms" || static_cast<TpmsPart>(core.choice("part")) != TpmsPart::Wall) {
      r.fail(
          "core",
          "\"core\": need the name of an \"even_wall\", or of a \"tpms\" whose part is \"wall\"");
    }
    return TpmsChannels<double>::of(fieldOf(core, mapOf(core)), gradedOf(core, "level"));
  };
  const auto [a, b] = sidesOf();
  return {placed(named(a, "channel A"), core), placed(named(b, "channel B"), core)};
}

TwoFluids<double> twoFluidsOf(const Record& r) {
  const auto channels = channelsOf(r);
  const double cap = r.number("cap");
  if (r.form().name == "box") {
    const CrossFlow<double> flow{.axisOfA = static_cast<int>(r.choice("axis_of_a")),
                                 .axisOfB = static_cast<int>(r.choice("axis_of_b")),
                                 .capThickness = cap};
    return twoFluidsIn<double>({r.point("lower"), r.point("upper")}, channels, flow);
  }
  const CylinderFlow<double> flow{.radius = r.number("radius"),
                                  .z = {r.number("lower"), r.number("upper")},
                                  .capThickness = cap};
  return twoFluidsIn<double>(flow, channels);
}

SceneForm exchangerForm(const char* name, const char* meaning, std::vector<SceneKey> keys) {
  keys.insert(keys.begin(),
              {"core", KeyType::Solid, "the wall between the fluids, a `tpms` or an `even_wall`"});
  keys.push_back({"cap", Positive, "the thickness of the caps that close the channels"});
  return {.name = name,
          .meaning = meaning,
          .keys = std::move(keys),
          .make = [](const Record& r) -> SceneSolid { return twoFluidsOf(r).wall; },
          .kindKey = "exchanger",
          .operandCopies = 2};
}

SceneSolid fluid(const Record& r) {
  const auto& exchanger = r.record("of");
  if (exchanger.form().kindKey != "exchanger")
    r.fail("of", "\"of\": need the name of an \"exchanger\"");
  const auto parts = twoFluidsOf(exchanger);
  return placed(r.text("fluid") == "A" ? parts.a : parts.b, exchanger);
}

std::vector<SceneForm> exchangers() {
  return {
      exchangerForm("box",
                    "The solid of a heat exchanger in a box, each fluid in a channel of its own.",
                    {{"lower", Point, "the corner of the least coordinates"},
                     {"upper", Point, "the opposite corner"},
                     {"axis_of_a", Choice, "fluid A flows along it", "\"x\"", {"x", "y", "z"}},
                     {"axis_of_b", Choice, "fluid B flows along it", "\"y\"", {"x", "y", "z"}}}),
      exchangerForm("cylinder",
                    "The same in a cylinder about the z axis: A flows from end to end, B through "
                    "the curved side.",
                    {{"radius", Positive, "the radius of the cylinder"},
                     {"lower", Number, "the z where it begins"},
                     {"upper", Number, "the z where it ends"}}),
      {.name = "fluid",
       .meaning = "One of the fluids of an exchanger: it meets the wall without gap or overlap, "
                  "to the bit.",
       .keys = {{"fluid", Choice, "which of them", {}, {"A", "B"}},
                {"of", KeyType::Solid, "the `exchanger`"}},
       .make = fluid}};
}

}  // namespace

const std::vector<SceneForm>& tpmsForms() {
  static const auto kForms = [] {
    std::vector<SceneForm> all{tpmsForm(), evenWallForm()};
    for (auto& form : exchangers()) all.push_back(std::move(form));
    return all;
  }();
  return kForms;
}

}  // namespace cutwater::scene
