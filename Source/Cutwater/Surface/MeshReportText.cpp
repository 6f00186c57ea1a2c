#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/MeshReport.hpp>
#include <Cutwater/Text/Numbers.hpp>
#include <Cutwater/Text/ReportLine.hpp>

#include <string_view>

namespace cutwater {
namespace {

using text::counted;
using text::reportLine;

std::string textOf(std::size_t count) {
  return detail::toText(static_cast<long long>(count));
}

std::string textOf(const EdgePlace& edge) {
  return textOf(index(edge.origin)) + "-" + textOf(index(edge.target));
}

template <MeshId Id>
std::string textOf(Id id) {
  return textOf(std::size_t{index(id)});
}

/// A kind of defect, in the wording of the summary and of the table.
struct Kind {
  std::string_view singular;
  std::string_view plural;
  std::string_view places;  ///< what the numbers after it denote
};

/// Calls visit(kind, findings) for all kinds, worst first.
template <typename Visit>
void forAllDefects(const MeshReport& r, Visit visit) {
  visit(Kind{"open edge", "open edges", "vertices"}, r.boundaryEdges);
  visit(Kind{"non-manifold edge", "non-manifold edges", "vertices"}, r.nonManifoldEdges);
  visit(Kind{"mis-oriented edge", "mis-oriented edges", "vertices"}, r.misorientedEdges);
  visit(Kind{"non-manifold vertex", "non-manifold vertices", "vertices"}, r.nonManifoldVertices);
  visit(Kind{"face with repeated corners", "faces with repeated corners", "faces"},
        r.repeatedCornerFaces);
  visit(Kind{"face of no area", "faces of no area", "faces"}, r.zeroAreaFaces);
  visit(Kind{"duplicate face", "duplicate faces", "faces"}, r.duplicateFaces);
  visit(Kind{"face turned against its duplicate", "faces turned against their duplicates", "faces"},
        r.oppositeFaces);
  visit(Kind{"unused vertex", "unused vertices", "vertices"}, r.unusedVertices);
}

template <typename Place>
std::string withExamples(const Kind& kind, const Findings<Place>& findings) {
  std::string result = textOf(findings.count);
  if (!findings) return result;
  result += "  (" + std::string(kind.places);
  for (const auto& place : findings.examples) result.append(" ").append(textOf(place));
  return result + (findings.count > findings.examples.size() ? " ...)" : ")");
}

std::string yesOrNo(bool value) {
  return value ? "yes" : "no";
}

}  // namespace

bool MeshReport::isClean() const {
  bool clean = faces > 0 && !isInsideOut();
  forAllDefects(*this, [&](const Kind&, const auto& findings) { clean = clean && !findings; });
  return clean;
}

std::string MeshReport::summary() const {
  std::string result = isClosed() ? "closed" : "not closed";
  result += isOriented() ? ", oriented" : ", not oriented";
  result += isManifold() ? ", manifold" : ", not manifold";
  if (isInsideOut()) result += ", inside out";
  std::string_view separator = "; ";
  forAllDefects(*this, [&](const Kind& kind, const auto& findings) {
    if (!findings) return;
    result += std::string(separator) + counted(findings.count, kind.singular, kind.plural);
    separator = ", ";
  });
  return result + "; " + counted(triangles, "triangle", "triangles") + ", " +
         counted(components, "component", "components");
}

std::string MeshReport::table() const {
  std::string result;
  result += reportLine("vertices", textOf(vertices));
  result += reportLine("edges", textOf(edges));
  result += reportLine("faces", textOf(faces));
  result += reportLine("triangles", textOf(triangles));
  result += reportLine("components", textOf(components));
  result += reportLine("closed", yesOrNo(isClosed()));
  result += reportLine("oriented", yesOrNo(isOriented()));
  result += reportLine("manifold", yesOrNo(isManifold()));
  result += reportLine("inside out", yesOrNo(isInsideOut()));
  result += reportLine("Euler characteristic", detail::toText(eulerCharacteristic));
  result += reportLine("genus", genus ? detail::toText(*genus) : "-");
  result += reportLine("area", detail::toText(area));
  result += reportLine("volume", isClosed() ? detail::toText(volume) : "-");
  forAllDefects(*this, [&](const Kind& kind, const auto& findings) {
    result += reportLine(kind.plural, withExamples(kind, findings));
  });
  return result;
}

}  // namespace cutwater
