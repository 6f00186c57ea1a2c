#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Scene/Detail/SceneRecord.hpp>
#include <Cutwater/Surface/Cleaning/Clean.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>

namespace cutwater::scene {

namespace {

using enum KeyType;
using Record = SceneRecord;

std::vector<SceneKey> cleaningKeys() {
  return {{"clean", Flag, "whether to put it in order first, as told below", "false"},
          {"weld_within", Positive, "merge points so close to one another", kOptional},
          {"split_junctions_within", Positive, "put points so close to an edge into it", kOptional},
          {"opposite",
           Choice,
           "two equal faces of opposite orientation",
           "\"keep\"",
           {"cancel", "keep"}},
          {"orient", Flag, "turn faces outward", "true"},
          {"nested",
           Choice,
           "shells within shells",
           "\"as they are\"",
           {"as they are", "cavities", "solids"}}};
}

std::vector<SceneKey> meshKeys() {
  std::vector<SceneKey> keys{
      {"mesh", File, "STL, OBJ, PLY, OFF or legacy VTK, also gzip-compressed"},
      {"scale", Positive, "coordinates are multiplied by it", "1"},
      {"signs",
       Choice,
       "how to tell inside from outside: by the nearest faces, or by how often the surface goes "
       "round a point; or as a check of the surface suggests",
       "\"auto\"",
       {"auto", "nearest", "winding"}},
      {"require_watertight", Flag, "refuse a surface that does not bound a solid", "false"},
      {"find_self_intersections", Flag,
       "look for them everywhere on a closed surface, not only at probes", "true"},
      {"probes", Whole, "places that the check looks at where it proves nothing", "1024"}};
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
  auto soup = readSurface(r.file("mesh"), {.scale = r.number("scale")}).soup;
  if (r.flag("clean")) {
    clean(soup, cleaningOf(r));
  } else {
    refuseCleaning(r);
  }
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
