#include "Report/DiagnosisPage.hpp"

#include <algorithm>

#include "Report/Format.hpp"

namespace cutwater::tool {

namespace {

constexpr std::size_t kMostPlaces = 3;

std::string textOf(const DefectPlace& place) {
  std::string text = point(place.point, kPlaceDigits);
  for (std::size_t i = 0; i < place.faces.size(); ++i) {
    text += i > 0 ? " and " : place.faces.size() > 1 ? " faces " : " face ";
    text += std::to_string(place.faces[i]);
  }
  return text;
}

std::string placesOf(const Defect& defect) {
  std::string text = "at ";
  const std::size_t shown = std::min(defect.places.size(), kMostPlaces);
  for (std::size_t i = 0; i < shown; ++i) {
    text += (i == 0 ? "" : ", ") + textOf(defect.places[i]);
  }
  return text + (defect.count > shown && defect.places.size() >= kMostPlaces ? ", ..." : "");
}

}  // namespace

void describe(Page& page, const std::vector<Defect>& defects) {
  if (defects.empty()) {
    page.section("Defects: none");
    return;
  }
  page.section("Defects, the worst first; faces are polygons, counted from 0");
  for (const auto& defect : defects) {
    const auto count = (defect.isComplete ? "" : "> ") + grouped(defect.count);
    page.plain(leftAligned(nameOf(defect.severity), 7) + rightAligned(count, 11) + "  " +
               defect.name);
    const std::string indent(20, ' ');
    page.wrapped(indent, defect.meaning);
    if (!defect.places.empty()) page.wrapped(indent, placesOf(defect));
  }
}

void describe(Page& page, const std::vector<Advice>& next) {
  page.section("Next");
  for (const auto& advice : next) {
    page.plain(advice.command);
    page.wrapped("    ", advice.purpose);
  }
}

std::vector<Advice> usesOf(const std::string& file) {
  return {{"cutwater sample " + file + " -o field.vti", "the signed distance on a grid"},
          {"cutwater amr " + file + " --level 6 -o mesh.vtu", "an octree mesh around it"},
          {"cutwater slice " + file + " -o slice.png",
           "a picture of its signs in a plane; where there are errors, look at it first"}};
}

}  // namespace cutwater::tool
