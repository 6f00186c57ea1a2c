#include <algorithm>

#include "Report/DiagnosisPage.hpp"
#include "Report/Format.hpp"
#include "Report/InfoFacts.hpp"
#include "Report/Page.hpp"

namespace cutwater::tool {

namespace {

constexpr std::size_t kMostPatches = 40;  // listed
constexpr std::size_t kMostOpenings = 8;

void describeFile(Page& page, const InfoFacts& facts) {
  const auto& surface = facts.surface;
  const auto& report = surface.report;
  page.section("File");
  page.line("name", facts.options.file);
  page.line("format", formatOf(surface));
  page.line("size", bytes(report.bytes) + (report.compressed && facts.bytesOnDisk
                                               ? ", " + bytes(*facts.bytesOnDisk) + " compressed"
                                               : ""));
  if (facts.options.scale != 1) page.line("scaled by", number(facts.options.scale));
  if (!facts.options.placement.isIdentity()) page.line("moved", "as told by the options");
  for (const auto& note : report.notes) page.line("note", note);
  if (!surface.prepared) return;
  page.line("signs", surface.prepared->signs);
  if (const auto hash = surface.prepared->info.source; hash != 0) {
    page.line("made from", "a file of XXH64 " + hexadecimal(hash));
  }
}

std::string volumeOf(const InfoFacts& facts) {
  const auto& report = facts.found.report;
  if (!report.isClosed()) return "not computed: the surface is not closed";
  auto volume = number(report.volume);
  const auto& signs = facts.found.signs;
  if (!signs || (signs->turnedFaces == 0 && signs->turnedShells == 0)) return volume;
  return volume + " of the faces as they are; " +
         (facts.found.solidVolume
              ? number(*facts.found.solidVolume) + " of the solid, with all facing outward"
              : "the solid's is another, as some must be turned");
}

void describeSurface(Page& page, const InfoFacts& facts) {
  const auto& soup = facts.surface.soup;
  const auto& report = facts.found.report;
  page.section("Surface");
  page.line("polygons",
            grouped(soup.polygonCount()) + (report.triangles == soup.polygonCount()
                                                ? ", all triangles"
                                                : ", as " + grouped(report.triangles, "triangle")));
  page.line("points", grouped(soup.points.size()) + " (" +
                          grouped(facts.surface.report.pointsInFile) + " in the file, " +
                          grouped(facts.surface.pointsMerged) + " merged with equal ones)");
  const auto box = soup.boundingBox();
  if (!box.empty()) {
    page.line("bounding box", point(box.lower) + " to " + point(box.upper));
    page.line("extent", extent(box.size()));
  }
  page.line("area", number(report.area));
  page.line("volume", volumeOf(facts));
  page.line("components", grouped(report.components));
  page.line("topology", "Euler characteristic " + std::to_string(report.eulerCharacteristic) +
                            (report.genus ? ", genus " + std::to_string(*report.genus)
                                          : ", no genus: not a closed, oriented manifold"));
}

void describePatches(Page& page, const PolygonSoup& soup) {
  const auto polygons = polygonsPerPatch(soup);
  page.section("Patches: " + grouped(polygons.size()));
  for (std::size_t i = 0; i < std::min(polygons.size(), kMostPatches); ++i) {
    page.line(rightAligned(grouped(i), 4) + "  " + soup.patchNames[i],
              grouped(polygons[i], "polygon"));
  }
  if (polygons.size() > kMostPatches) {
    page.plain("... and " + grouped(polygons.size() - kMostPatches) + " more");
  }
}

void describeCheck(Page& page, const InfoFacts& facts) {
  page.section("Check");
  page.line("watertight", facts.found.report.isClosedOriented() ? "yes" : "no");
  page.line("in short", facts.found.report.summary());
  page.line("self-intersections", facts.found.selfIntersections ? "yes, see below" : "none");
  page.line("verdict", facts.found.verdict());
}

void describeOpenings(Page& page, const std::vector<Opening>& openings) {
  if (openings.empty()) return;
  page.section("Openings: " + grouped(openings.size()) + ", the largest first");
  for (std::size_t i = 0; i < std::min(openings.size(), kMostOpenings); ++i) {
    const auto& opening = openings[i];
    const auto plane = planeOf(opening);
    page.wrapped(rightAligned(grouped(opening.edges, "edge"), 18) + "  ",
                 (plane ? "in the plane " + *plane + ", " : "") +
                     point(opening.box.lower, kPlaceDigits) + " to " +
                     point(opening.box.upper, kPlaceDigits));
  }
  if (openings.size() > kMostOpenings) {
    page.plain("... and " + grouped(openings.size() - kMostOpenings) + " more");
  }
}

std::string textOfMemory(std::size_t size, const MeshReport& report) {
  return bytes(size) + ", " + grouped(bytesPerTriangle(size, report), "byte") + " per triangle";
}

void describeSigns(Page& page, const InfoFacts& facts) {
  const auto& found = facts.found;
  if (!found.signs) return;
  page.section("Signed distance");
  page.line("signs", found.signs->summary());
  page.line("distances", meaningOf(*found.guarantee));
  page.line("memory", textOfMemory(found.memoryBytes, found.report));
  if (facts.bytesInFloat) {
    page.line("memory in float", textOfMemory(*facts.bytesInFloat, found.report));
  }
}

void describeTimings(Page& page, const InfoFacts& facts) {
  page.section("Timings");
  page.line("read", duration(facts.surface.secondsToRead));
  page.line("weld", duration(facts.surface.secondsToWeld));
  const auto& found = facts.found;
  page.line("mesh and check", duration(found.seconds.check));
  page.line("self-intersections", duration(found.seconds.selfIntersections));
  if (found.signs) page.line("build", duration(found.seconds.build));
  if (!found.defects.empty()) page.line("try repairs", duration(found.seconds.treatments));
}

/// Of all the program did, and not of the signed distance alone.
void describeMemory(Page& page, const InfoFacts& facts) {
  if (!facts.peakResidentBytes) return;
  page.section("Memory of this program");
  page.line("peak, resident", bytes(*facts.peakResidentBytes) + " for all of the above together");
}

}  // namespace

std::string pageOf(const InfoFacts& facts) {
  Page page;
  describeFile(page, facts);
  describeSurface(page, facts);
  describePatches(page, facts.surface.soup);
  describeCheck(page, facts);
  describe(page, facts.found.defects);
  describeOpenings(page, facts.found.openings);
  describeSigns(page, facts);
  if (!facts.next.empty()) describe(page, facts.next);

  describeTimings(page, facts);
  describeMemory(page, facts);
  return page.text();
}

}  // namespace cutwater::tool
