#include "Format.hpp"
#include "InfoFacts.hpp"
#include "JsonView.hpp"

namespace cutwater::tool {

namespace {

Json fileJson(const InfoFacts& facts) {
  const auto& surface = facts.surface;
  const auto& report = surface.report;
  Json json{{"name", facts.options.file},
            {"format", formatOf(surface)},
            {"bytes", report.bytes},
            {"compressed", report.compressed}};
  json["bytesOnDisk"] = facts.bytesOnDisk ? Json(*facts.bytesOnDisk) : Json(nullptr);
  json["scale"] = facts.options.scale;
  json["moved"] = !facts.options.placement.isIdentity();
  json["notes"] = report.notes;
  if (surface.prepared) {
    json["preparedSigns"] = surface.prepared->signs;
    json["preparedFromXxh64"] = hexadecimal(surface.prepared->info.source);
  }
  return json;
}

Json surfaceJson(const InfoFacts& facts) {
  const auto& soup = facts.surface.soup;
  const auto& report = facts.found.report;
  Json json{{"polygons", soup.polygonCount()},
            {"triangles", report.triangles},
            {"points", soup.points.size()},
            {"pointsInFile", facts.surface.report.pointsInFile},
            {"pointsMerged", facts.surface.pointsMerged},
            {"boundingBox", toJson(soup.boundingBox())},
            {"area", report.area}};
  json["volume"] = report.isClosed() ? Json(report.volume) : Json(nullptr);
  json["solidVolume"] = facts.solidVolume ? Json(*facts.solidVolume) : Json(nullptr);
  json["components"] = report.components;
  return json;
}

Json patchesJson(const PolygonSoup& soup) {
  Json list = Json::array();
  const auto polygons = polygonsPerPatch(soup);
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    list.push_back({{"name", soup.patchNames[i]}, {"polygons", polygons[i]}});
  }
  return list;
}

Json openingsJson(const Treatments& treatments) {
  Json list = Json::array();
  for (const auto& rim : treatments.openings) {
    Json json{{"edges", rim.points.size()}, {"box", toJson(rim.box)}};
    const auto plane = cutwater::planeOf(rim, treatments.planeTolerance);
    json["axis"] = plane ? Json(std::string(1, "xyz"[plane->axis])) : Json(nullptr);
    json["at"] = plane ? Json(plane->at) : Json(nullptr);
    list.push_back(std::move(json));
  }
  return list;
}

Json memoryJson(const MemoryUse& use) {
  return {
      {"bytes", use.bytes}, {"bytesPerTriangle", use.bytesPerTriangle}, {"peakBytes", use.peak}};
}

Json solidJson(const SolidFacts& solid) {
  Json json{{"signs", signsJson(solid.signs)},
            {"distances", meaningOf(solid.guarantee)},
            {"memory", memoryJson(solid.memory)}};
  if (solid.memoryInFloat) json["memoryInFloat"] = memoryJson(*solid.memoryInFloat);
  return json;
}

Json secondsJson(const InfoFacts& facts) {
  Json json{{"read", facts.surface.secondsToRead},
            {"weld", facts.surface.secondsToWeld},
            {"check", facts.found.secondsToCheck},
            {"selfIntersections", facts.found.secondsToSearch}};
  if (facts.solid) json["build"] = facts.solid->seconds;
  json["tryRepairs"] = facts.secondsToTreat;
  return json;
}

}  // namespace

std::string jsonOf(const InfoFacts& facts) {
  Json json{{"file", fileJson(facts)},
            {"surface", surfaceJson(facts)},
            {"patches", patchesJson(facts.surface.soup)},
            {"check", checkJson(facts.found, facts.defects, facts.signs())},
            {"defects", toJson(facts.defects)},
            {"openings", openingsJson(facts.treatments)}};
  json["signedDistance"] = facts.solid ? solidJson(*facts.solid) : Json(nullptr);
  json["next"] = toJson(facts.next);
  json["seconds"] = secondsJson(facts);
  return dumped(json);
}

}  // namespace cutwater::tool
