#include "Options/RefinementOptions.hpp"

#include <Cutwater/Core/Error.hpp>

#include <algorithm>

#include "Options/Arguments.hpp"

namespace cutwater::tool {

namespace {

/// The text before the last colon, and the level after it.
struct Leveled {
  std::string what;
  int level;
};

Leveled leveled(const std::string& option, const std::string& text, const std::string& need) {
  const auto colon = text.rfind(':');
  const auto level = text.substr(colon == std::string::npos ? text.size() : colon + 1);
  if (level.empty() || level.find_first_not_of("0123456789") != std::string::npos ||
      level.size() > 2) {
    refuse(option, text, need);
  }
  return {text.substr(0, colon), std::stoi(level)};
}

/// The same where a number stands before the only colon.
Leveled leveledNumber(const std::string& option, const std::string& text, const std::string& need) {
  if (text.find(':') != text.rfind(':')) refuse(option, text, need);
  return leveled(option, text, need);
}

Refinement<double>::Band bandOf(const std::string& text) {
  const auto [what, level] = leveledNumber("--band", text, "a distance and a level: 0.5:4");
  const double distance = numbers("--band", what, 1).front();
  if (distance < 0) refuse("--band", text, "a distance from 0");
  return {distance, level};
}

Refinement<double>::Angle leveledAngle(const std::string& option, const std::string& text) {
  const auto [what, level] = leveledNumber(option, text, "degrees and a level: 20:7");
  return {angleOf(option, what), level};
}

Refinement<double>::Width widthOf(const std::string& option, const std::string& text) {
  const auto [what, level] = leveledNumber(option, text, "a number of cells and a level: 4:8");
  return {positiveNumber(option, what), level};
}

RefinementOptions::Patch patchOf(const std::string& text) {
  const auto [name, level] = leveled("--patch", text, "a patch's name and a level: propeller:8");
  if (name.empty()) refuse("--patch", text, "a patch's name before the colon");
  return {name, level};
}

}  // namespace

Option addRefinementOptions(Command command, RefinementOptions& options) {
  auto& rules = options.rules;
  const auto level = command.addNumber(
      "--level", "N", "Refine what the surface meets to this level: so many halvings of the roots",
      rules.cut, {0, 20});
  command.addRepeated(
      "--band", "DISTANCE:LEVEL",
      "Refine what is within this distance of the surface, in its units, to that level; may be "
      "repeated",
      [&](const std::string& text) { rules.bands.push_back(bandOf(text)); });
  command.addRepeated("--patch", "NAME:LEVEL",
                      "Refine what this patch of the surface meets to that level; may be repeated",
                      [&](const std::string& text) { options.patches.push_back(patchOf(text)); });
  command.addRepeated(
      "--curvature", "DEGREES:LEVEL",
      "Refine cells in which the surface's normals differ by more than this angle",
      [&](const std::string& text) { rules.curvature = leveledAngle("--curvature", text); });
  command.addRepeated(
      "--edges", "DEGREES:LEVEL",
      "Refine cells that meet an edge at which the surface bends by more than this angle",
      [&](const std::string& text) { rules.edges = leveledAngle("--edges", text); });
  command.addRepeated(
      "--gaps", "CELLS:LEVEL",
      "Refine gaps until there are so many cells between sheets that face each other",
      [&](const std::string& text) { rules.gaps = widthOf("--gaps", text); });
  command.addRepeated("--walls", "CELLS:LEVEL",
                      "Refine walls until there are so many cells from one side to the other",
                      [&](const std::string& text) { rules.walls = widthOf("--walls", text); });
  return level;
}

Refinement<double> rulesFor(const RefinementOptions& options,
                            const std::vector<std::string>& patchNames) {
  constexpr std::size_t kFew = 20;
  auto rules = options.rules;
  for (const auto& [name, level] : options.patches) {
    const auto before = rules.patches.size();
    for (std::uint32_t id = 0; id < patchNames.size(); ++id) {
      if (patchNames[id] == name) rules.patches.push_back({id, level});
    }
    if (rules.patches.size() > before) continue;
    std::string message = "--patch: no patch is called '" + name + "'; there are: ";
    for (std::size_t i = 0; i < std::min(kFew, patchNames.size()); ++i) {
      message += (i > 0 ? ", " : "") + patchNames[i];
    }
    if (patchNames.size() > kFew) message += ", ...";
    throw Error(ErrorKind::Argument, message);
  }
  return rules;
}

}  // namespace cutwater::tool
