#include "Report/JsonViews.hpp"

#include <Cutwater/Surface/MeshReport.hpp>

namespace cutwater::tool {

namespace {

const char* keyOf(CleanKind kind) {
  switch (kind) {
    case CleanKind::EqualPoints:
      return "equalPoints";
    case CleanKind::ClosePoints:
      return "closePoints";
    case CleanKind::DegenerateFaces:
      return "degenerateFaces";
    case CleanKind::DuplicateFaces:
      return "duplicateFaces";
    case CleanKind::OppositeFaces:
      return "oppositeFaces";
    case CleanKind::Junctions:
      return "junctions";
    case CleanKind::UnusedPoints:
      return "unusedPoints";
    case CleanKind::TurnedFaces:
      return "turnedFaces";
    case CleanKind::TurnedShells:
      return "turnedShells";
    case CleanKind::UnorientableShells:
      return "unorientableShells";
  }
  return "";
}

Json placesJson(const Findings<Vec3<double>>& found) {
  Json places = Json::array();
  for (const auto& place : found.examples) places.push(toJson(place));
  return places;
}

Json jsonOf(const CleanReport& report) {
  Json corrections = Json::array();
  for (const auto& step : report.steps) {
    corrections.push({{"key", keyOf(step.kind)},
                      {"count", step.correction.places.count},
                      {"largest", step.correction.largest},
                      {"before", toJson(step.before)},
                      {"after", toJson(step.after)},
                      {"places", placesJson(step.correction.places)}});
  }
  return {{"corrections", std::move(corrections)}};
}

Json jsonOf(const OpeningReport& report) {
  return {{"openingsClosed", report.closed.count}, {"closedAt", placesJson(report.closed)},
          {"rimsLeft", report.left.count},         {"leftAt", placesJson(report.left)},
          {"rimEdges", report.rimEdges},           {"pointsMoved", report.pointsMoved},
          {"farthestMove", report.farthestMove},   {"facesRemoved", report.facesRemoved},
          {"facesAdded", report.facesAdded},       {"areaAdded", report.areaAdded},
          {"before", toJson(report.before)},       {"after", toJson(report.after)}};
}

#ifdef CUTWATER_HAS_REPAIR
Json jsonOf(const HoleReport& report) {
  return {{"holesFilled", report.filled.count},    {"filledAt", placesJson(report.filled)},
          {"tooManyEdges", report.tooLong.count},  {"tooWide", report.tooWide.count},
          {"unfillable", report.unfillable.count}, {"late", report.late.count},
          {"facesAdded", report.facesAdded},       {"areaAdded", report.areaAdded},
          {"widestFilled", report.widestFilled},   {"crossings", report.crossings},
          {"before", toJson(report.before)},       {"after", toJson(report.after)}};
}

Json jsonOf(const SelfIntersectionRepairReport& report) {
  return {{"pairsBefore", report.pairsBefore}, {"pairsAfter", report.pairsAfter},
          {"facesBefore", report.facesBefore}, {"facesAfter", report.facesAfter},
          {"farthest", report.farthest},       {"before", toJson(report.before)},
          {"after", toJson(report.after)}};
}

Json jsonOf(const WrapReport& report) {
  return {{"facesBefore", report.facesBefore}, {"facesAfter", report.facesAfter},
          {"offset", report.offset},           {"nearest", report.nearest},
          {"farthest", report.farthest},       {"before", toJson(report.before)},
          {"after", toJson(report.after)}};
}
#endif

}  // namespace

Json toJson(const Vec3<double>& v) {
  return Json::array({v.x, v.y, v.z});
}

Json toJson(const Box<double>& box) {
  if (box.empty()) return nullptr;
  return {{"lower", toJson(box.lower)}, {"upper", toJson(box.upper)}};
}

Json toJson(const std::vector<Defect>& defects) {
  Json list = Json::array();
  for (const auto& defect : defects) {
    Json places = Json::array();
    for (const auto& place : defect.places) {
      places.push({{"point", toJson(place.point)}, {"faces", place.faces}});
    }
    list.push({{"key", defect.key},
               {"severity", nameOf(defect.severity)},
               {"name", defect.name},
               {"count", defect.count},
               {"complete", defect.isComplete},
               {"meaning", defect.meaning},
               {"places", std::move(places)}});
  }
  return list;
}

Json toJson(const std::vector<Advice>& next) {
  Json list = Json::array();
  for (const auto& advice : next) {
    list.push({{"command", advice.command}, {"purpose", advice.purpose}});
  }
  return list;
}

Json toJson(const SurfaceMeasure& measure) {
  return {{"area", measure.area}, {"volume", measure.volume}};
}

Json toJson(const StepReport& report) {
  return std::visit([](const auto& r) { return jsonOf(r); }, report);
}

Json checkJson(const Diagnosis& found) {
  const auto& report = found.report;
  Json json{{"watertight", report.isClosedOriented()},
            {"sound", found.isSound()},
            {"verdict", found.verdict()},
            {"summary", report.summary()},
            {"closed", report.isClosed()},
            {"oriented", report.isOriented()},
            {"manifold", report.isManifold()},
            {"insideOut", report.isInsideOut()},
            {"selfIntersections", found.selfIntersections.pairs.count},
            {"selfIntersectionsComplete", found.selfIntersections.complete},
            {"faces", report.faces},
            {"triangles", report.triangles},
            {"edges", report.edges},
            {"vertices", report.vertices},
            {"eulerCharacteristic", report.eulerCharacteristic}};
  json["genus"] = report.genus ? Json(*report.genus) : Json(nullptr);
  return json;
}

Json toJson(const SignReport& signs) {
  Json json{
      {"scheme", signs.scheme == SignScheme::WindingNumber ? "windingNumber" : "nearestFeature"},
      {"summary", signs.summary()},
      {"sound", signs.isSound()},
      {"proven", signs.isProven},
      {"doubt", signs.doubt()},
      {"probes", signs.probes},
      {"unsoundProbes", signs.unsound},
      {"ambiguousProbes", signs.ambiguous},
      {"unbalancedEdges", signs.unbalancedEdges},
      {"touchingEdges", signs.touchingEdges},
      {"shells", signs.shells},
      {"turnedFaces", signs.turnedFaces},
      {"turnedShells", signs.turnedShells},
      {"unorientableShells", signs.unorientable}};
  return json;
}

}  // namespace cutwater::tool
