#include "Report/Format.hpp"
#include "Report/InfoFacts.hpp"
#include "Report/JsonViews.hpp"

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
  json["solidVolume"] = facts.found.solidVolume ? Json(*facts.found.solidVolume) : Json(nullptr);
  json["components"] = report.components;
  return json;
}

Json patchesJson(const PolygonSoup& soup) {
  Json list = Json::array();
  const auto polygons = polygonsPerPatch(soup);
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    list.push({{"name", soup.patchNames[i]}, {"polygons", polygons[i]}});
  }
  return list;
}

Json openingsJson(const std::vector<Opening>& openings) {
  Json list = Json::array();
  for (const auto& [edges, box, plane] : openings) {
    Json json{{"edges", edges}, {"box", toJson(box)}};
    json["axis"] = plane ? Json(std::string(1, "xyz"[plane->axis])) : Json(nullptr);
    json["at"] = plane ? Json(plane->at) : Json(nullptr);
    list.push(std::move(json));
  }
  return list;
}

Json memoryJson(std::size_t bytes, const MeshReport& report) {
  return {{"bytes", bytes}, {"bytesPerTriangle", bytesPerTriangle(bytes, report)}};
}

Json signedDistanceJson(const InfoFacts& facts) {
  const auto& found = facts.found;
  if (!found.signs) return nullptr;
  Json json{{"signs", toJson(*found.signs)},
            {"distances", meaningOf(*found.guarantee)},
            {"memory", memoryJson(found.memoryBytes, found.report)}};
  if (facts.bytesInFloat) json["memoryInFloat"] = memoryJson(*facts.bytesInFloat, found.report);
  return json;
}

Json secondsJson(const InfoFacts& facts) {
  const auto& seconds = facts.found.seconds;
  Json json{{"read", facts.surface.secondsToRead},
            {"weld", facts.surface.secondsToWeld},
            {"check", seconds.check},
            {"selfIntersections", seconds.selfIntersections}};
  if (facts.found.signs) json["build"] = seconds.build;
  json["tryRepairs"] = seconds.treatments;
  return json;
}

}  // namespace

std::string jsonOf(const InfoFacts& facts) {
  Json json{{"file", fileJson(facts)},
            {"surface", surfaceJson(facts)},
            {"patches", patchesJson(facts.surface.soup)},
            {"check", checkJson(facts.found)},
            {"defects", toJson(facts.found.defects)},
            {"openings", openingsJson(facts.found.openings)},
            {"signedDistance", signedDistanceJson(facts)},
            {"next", toJson(facts.next)},
            {"seconds", secondsJson(facts)}};
  const auto& peak = facts.peakResidentBytes;
  json["peakResidentBytes"] = peak ? Json(*peak) : Json(nullptr);
  return json.text();
}

}  // namespace cutwater::tool
