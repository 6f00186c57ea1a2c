#include <Cutwater/Io/VtpSurface.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Scene/Detail/SceneRecord.hpp>
#include <Cutwater/Surface/Cleaning/Clean.hpp>

namespace cutwater::scene {

namespace {

using enum KeyType;
using Record = SceneRecord;

std::vector<SceneKey> cleaningKeys() {
  return {{"clean", Flag, "clean the surface first; the next five keys say how", "false"},
          {"weld_within", Positive, "merge points that are within this of one another", kOptional},
          {"split_junctions_within", Positive,
           "insert points of rims that are within this of another rim's edge into that edge",
           kOptional},
          {"opposite",
           Choice,
           "what to do with two equal faces of opposite orientation",
           "\"keep\"",
           {"cancel", "keep"}},
          {"orient", Flag, "turn faces outward", "true"},
          {"nested",
           Choice,
           "what shells inside other shells are",
           "\"as they are\"",
           {"as they are", "cavities", "solids"}}};
}

std::vector<SceneKey> meshKeys() {
  std::vector<SceneKey> keys{
      {"mesh", File, anySurfaceFormats("or") + ", also gzip-compressed"},
      {"scale", Positive, "coordinates are multiplied by it", "1"},
      {"signs",
       Choice,
       "how inside is decided. nearest: by the nearest faces; winding: by the winding number; "
       "auto: a check of the surface chooses",
       "\"auto\"",
       {"auto", "nearest", "winding"}},
      {"require_watertight", Flag, "refuse a surface that does not bound a solid", "false"},
      {"find_self_intersections", Flag,
       "search a closed surface for self-intersections everywhere, not only at the probes", "true"},
      {"probes", Whole, "number of points that the check tests where it does not search everywhere",
       "1024"}};
  for (auto& key : cleaningKeys()) keys.push_back(std::move(key));
  return keys;
}

CleanOptions cleaningOf(const Record& r) {
  return {.weldWithin = r.optionalNumber("weld_within"),
          .splitJunctionsWithin = r.optionalNumber("split_junctions_within"),
          .opposite = static_cast<OppositeFaces>(r.choice("opposite")),
          .orient = r.flag("orient"),
          .nested = static_cast<NestedShells>(r.choice("nested"))};
}

/// Refuses options of cleaning if there is none, as they would have no effect.
void refuseCleaning(const Record& r) {
  for (const auto& key : cleaningKeys()) {
    if (key.name != "clean" && r.isGiven(key.name)) {
      r.fail(key.name, '"' + key.name + "\" needs \"clean = true\"");
    }
  }
}

SceneSolid mesh(const Record& r) {
  auto soup = readAnySurface(r.file("mesh"), {.scale = r.number("scale")}).soup;
  if (r.flag("clean")) {
    clean(soup, cleaningOf(r));
  } else {
    refuseCleaning(r);
  }
  if (soup.patchNames.size() == 1 && !r.name().empty()) soup.patchNames.front() = r.name();
  return MeshSDF<double>(soup, {.signs = static_cast<SignScheme>(r.choice("signs")),
                                .requireWatertight = r.flag("require_watertight"),
                                .findSelfIntersections = r.flag("find_self_intersections"),
                                .probes = r.whole("probes")});
}

}  // namespace

const std::vector<SceneForm>& surfaceForms() {
  static const std::vector<SceneForm> kForms{
      {.name = "mesh", .meaning = "A surface mesh from a file.", .keys = meshKeys(), .make = mesh},
      {.name = "prepared",
       .meaning = "A mesh that `cutwater prepare` has made ready, in double precision.",
       .keys = {{"prepared", File, "what `cutwater prepare` wrote"}},
       .make = [](const Record& r) -> SceneSolid {
         return MeshSDF<double>::open(r.file("prepared"));
       }},
  };
  return kForms;
}

}  // namespace cutwater::scene
