#include "Options/RepairSteps.hpp"

#include <Cutwater/Surface/Cleaning/CapOnPlane.hpp>
#include <Cutwater/Surface/Cleaning/ExtendTo.hpp>
#include <Cutwater/Surface/Cleaning/MirrorAt.hpp>

#include <algorithm>
#include <optional>

#include "Options/Arguments.hpp"
#include "Options/Choice.hpp"
#include "Report/Format.hpp"

namespace cutwater::tool {

namespace {

using Step = std::function<StepReport(PolygonSoup&)>;

const Choices<NestedShells>& nestings() {
  static const Choices<NestedShells> all{{"as-they-are", NestedShells::AsTheyAre},
                                         {"cavities", NestedShells::Cavities},
                                         {"solids", NestedShells::Solids}};
  return all;
}

/// "z=-1" as the axis and the coordinate.
struct AxisValue {
  int axis;
  double value;
};

AxisValue axisValueOf(const OpeningOption& option, const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) refuse(option.name, text, "an axis and a coordinate: z=0");
  return {axisOf(option.name, text.substr(0, equals)),
          numbers(option.name, text.substr(equals + 1), 1).front()};
}

SurfacePlane openingPlaneOf(const OpeningOption& option, const std::string& text) {
  if (text.find('=') != std::string::npos) {
    const auto [axis, value] = axisValueOf(option, text);
    SurfacePlane plane;
    plane.point[axis] = value;
    plane.normal[axis] = 1;
    return plane;
  }
  constexpr const char* kNeed =
      "a plane: AXIS=VALUE as in z=0, or a point and a normal: px,py,pz,nx,ny,nz";
  const auto v = numbers(option.name, text, kNeed);
  if (v.size() != 6 || (v[3] == 0 && v[4] == 0 && v[5] == 0)) refuse(option.name, text, kNeed);
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

/// The text before the first colon, and the text after it, if there is a colon.
std::pair<std::string, std::optional<std::string>> cutAtColon(const std::string& text) {
  const auto colon = text.find(':');
  if (colon == std::string::npos) return {text, {}};
  return {text.substr(0, colon), text.substr(colon + 1)};
}

Step capStep(const OpeningOption& option, double tolerance) {
  const auto [place, patch] = cutAtColon(option.value);
  CapOptions how{.tolerance = tolerance};
  if (patch && patch->empty()) refuse(option.name, option.value, "a patch's name after the colon");
  if (patch) how.patch = *patch;
  return [plane = openingPlaneOf(option, place), how](PolygonSoup& soup) {
    return capOnPlane(soup, plane, how);
  };
}

Step mirrorStep(const OpeningOption& option, double tolerance) {
  return [plane = openingPlaneOf(option, option.value), tolerance](PolygonSoup& soup) {
    return mirrorAt(soup, plane, tolerance);
  };
}

Step extendStep(const OpeningOption& option, double /*tolerance*/) {
  const auto to = axisValueOf(option, option.value);
  return [to](PolygonSoup& soup) { return extendTo(soup, to.axis, to.value); };
}

Step extendToBoxStep(const OpeningOption& option, double /*tolerance*/) {
  const auto [corners, side] = cutAtColon(option.value);
  const auto v = numbers(option.name, corners, 6);
  const Box<double> box{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
  constexpr const char* kNeed = "a side of the box after a colon: :-z or :+z";
  if (!side || side->size() != 2 || (side->front() != '-' && side->front() != '+')) {
    refuse(option.name, option.value, kNeed);
  }
  const int axis = axisOf(option.name, side->substr(1));
  const auto end = side->front() == '-' ? BoxEnd::Lower : BoxEnd::Upper;
  return [=](PolygonSoup& soup) { return extendToBox(soup, box, axis, end); };
}

struct OpeningKind {
  const char* name;
  const char* value;
  const char* meaning;
  Step (*step)(const OpeningOption&, double tolerance);
};

constexpr OpeningKind kOpenings[] = {
    {"--cap", "PLANE[:PATCH]",
     "Close the openings on a plane, z=0 or PX,PY,PZ,NX,NY,NZ (a point, a normal), with faces of "
     "this patch [cap]. This and the next three act in the order given and may be repeated",
     capStep},
    {"--mirror", "PLANE", "Make a whole of a half model: add its mirror image", mirrorStep},
    {"--extend", "AXIS=LEVEL",
     "Make a solid of a terrain: carry its rims on to a plane below or above it, z=-10",
     extendStep},
    {"--extend-to-box", "X0,Y0,Z0,X1,Y1,Z1:SIDE",
     "The same for one that ends short of a domain: out to the box's sides first, then to its end "
     "-z (below) or another",
     extendToBoxStep}};

void addCleanOptions(Command command, CleanOptions& options) {
  const auto length = [&](const char* name, std::optional<double>& value, const char* meaning) {
    command.add(name, "LENGTH", meaning,
                [name, &value](const std::string& text) { value = positiveNumber(name, text); });
  };
  length("--weld", options.weldWithin,
         "Merge points within this of one another, not equal ones only");
  length("--junctions", options.splitJunctionsWithin,
         "Put points of rims into the edges of others within this: cracks between parts");
  command.addFlag(
      "--cancel-opposite",
      "Remove pairs of equal faces that look opposite ways; panels of no thickness are made of "
      "them, too",
      [&] { options.opposite = OppositeFaces::Cancel; });
  addChoice(command, "--nested", options.nested, nestings(),
            "Shells within shells: a cavity if it is turned like one, by turns cavities and "
            "solids, or all solids [default: as-they-are]");
  command.addFlag("--no-orient", "Leave faces turned as they are", [&] { options.orient = false; });
}

}  // namespace

void addRepairOptions(Command command, RepairOptions& options) {
  addCleanOptions(command, options.clean);
  for (const auto& kind : kOpenings) {
    // The functions are called as options are read, so that they act in the order given.
    command.addInOrder(kind.name, kind.value, kind.meaning, [&](const std::string& text) {
      options.openings.push_back({kind.name, text});
    });
  }
  command.add(
      "--tolerance", "LENGTH",
      "Points at most this far from the planes of --cap and --mirror count as on them [default: "
      "0]",
      [&](const std::string& text) { options.tolerance = positiveNumber("--tolerance", text); });
  addMendingOptions(command, options.mending);
}

RepairOptions optionsOf(const Treatment& treatment) {
  const auto nameOf = [](ClosingKind kind) {
    return kind == ClosingKind::Cap      ? "--cap"
           : kind == ClosingKind::Mirror ? "--mirror"
                                         : "--extend";
  };
  RepairOptions options{.clean = treatment.clean,
                        .tolerance = treatment.tolerance,
                        .openings = {},
                        .mending = {.widestHole = treatment.widestHole}};
  for (const auto& [kind, plane] : treatment.closings) {
    options.openings.push_back(
        {nameOf(kind), std::string(1, "xyz"[plane.axis]) + "=" + exactly(plane.at)});
  }
  return options;
}

std::string commandLine(const RepairOptions& options) {
  const CleanOptions& clean = options.clean;
  std::string result;
  if (clean.weldWithin) result += " --weld " + exactly(*clean.weldWithin);
  if (clean.splitJunctionsWithin) result += " --junctions " + exactly(*clean.splitJunctionsWithin);
  if (clean.opposite == OppositeFaces::Cancel) result += " --cancel-opposite";
  for (const auto& [name, nested] : nestings()) {
    if (nested == clean.nested && nested != NestedShells::AsTheyAre) result += " --nested " + name;
  }
  if (!clean.orient) result += " --no-orient";
  for (const auto& opening : options.openings) {
    result += " " + opening.name + " " + shellWord(opening.value);
  }
  if (options.tolerance > 0) result += " --tolerance " + exactly(options.tolerance);
  return result + commandLine(options.mending);
}

std::vector<RepairStep> stepsOf(const RepairOptions& options) {
  std::vector<RepairStep> steps;
  steps.push_back({"clean", [how = options.clean](PolygonSoup& soup) { return clean(soup, how); }});
  for (const auto& option : options.openings) {
    const auto& kind = *std::ranges::find_if(
        kOpenings, [&](const OpeningKind& k) { return option.name == k.name; });
    steps.push_back(
        {option.name.substr(2) + " " + option.value, kind.step(option, options.tolerance)});
  }
  addMendingSteps(options.mending, steps);
  return steps;
}

std::string text(const StepReport& report) {
  return std::visit([](const auto& r) { return r.text(); }, report);
}

}  // namespace cutwater::tool
