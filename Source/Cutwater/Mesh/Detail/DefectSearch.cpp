#include <Cutwater/Mesh/Detail/DefectSearch.hpp>
#include <Cutwater/Surface/Detail/Shells.hpp>
#include <Cutwater/Surface/Triangulation.hpp>
#include <Cutwater/Text/Numbers.hpp>

#include <algorithm>
#include <utility>

namespace cutwater::detail {

namespace {

using text::grouped;
using text::number;

constexpr std::size_t kMostPlaces = Findings<FaceId>::kExamples;

/// Goes through the findings on one surface, kind by kind.
class DefectSearch {
 public:
  DefectSearch(const PolygonSoup& soup, const DcelMesh<double>& mesh, const Diagnosis& found)
      : soup_(soup), mesh_(mesh), report_(found.report), found_(found), signs_(found.signs) {}

  std::vector<Defect> run() {
    examineExtent();
    examineEdges();
    examineIntersections();
    examineOrientation();
    examineFaces();
    examineHarmless();
    std::ranges::stable_sort(defects_, {}, &Defect::severity);
    return std::move(defects_);
  }

 private:
  void examineExtent() {
    if (report_.triangles == 0) {
      add(Severity::Error, "noFaces", "no faces with three corners", "the surface bounds nothing",
          std::max<std::size_t>(report_.faces, 1));
      return;
    }
    const auto axis = flatAxis(soup_);
    if (!axis || (report_.isClosed() && report_.volume != 0)) return;
    add(Severity::Error, "flat", "faces in one plane",
        std::string("all of the surface lies at ") + "xyz"[*axis] + " = " +
            number(soup_.boundingBox().center()[*axis]) +
            " and bounds nothing; it may be one patch of more",
        report_.faces);
  }

  void examineEdges() {
    addEdges(report_.boundaryEdges, "openEdges", "open edges",
             "the surface ends there; " + gapMeaning());
    addEdges(report_.nonManifoldEdges, "nonManifoldEdges", "non-manifold edges",
             "more than two faces meet there; " + (report_.boundaryEdges || !isUnbalanced()
                                                       ? "signs go by the " + scheme()
                                                       : gapMeaning()));
    if (isAmbiguous() && !report_.boundaryEdges && !report_.nonManifoldEdges) {
      add(Severity::Error, "ambiguousSigns", "ambiguous probes", gapMeaning(), signs_->ambiguous);
    }
  }

  void examineIntersections() {
    const auto& pairs = found_.selfIntersections.pairs;
    if (pairs) {
      // Every duplicate forms a pair with the face that it equals.
      const bool isAllEqual =
          pairs.count == report_.duplicateFaces.count + report_.oppositeFaces.count;
      const bool isTouching = signs_ && signs_->selfIntersections == std::size_t{0};
      auto& defect = add(
          isAllEqual || isTouching ? Severity::Note : Severity::Warning, "selfIntersections",
          "pairs of faces that intersect",
          isTouching ? "they touch, at edges or corners that they do not share, and no more: this "
                       "changes neither signs nor distances"
          : isAllEqual ? "no others than faces that are equal, see there; signs go by the winding "
                         "number"
                       : "signs go by the winding number: what overlaps is a union; distances "
                         "inside are those to the nearest face, be it hidden in the solid or not",
          pairs.count);
      defect.isComplete = found_.selfIntersections.complete;
      for (const auto& pair : pairs.examples) defect.places.push_back(placeOf(pair));
    }
    if (signs_ && signs_->unsound > 0) {
      add(Severity::Warning, "unsoundSurface", "probes without a solid just behind them",
          "of " + grouped(signs_->probes, "probe") +
              " all over the surface: shells overlap, touch or lie within each other, and their "
              "union is meant",
          signs_->unsound);
    }
  }

  void examineOrientation() {
    if (!signs_) return;
    if (signs_->unorientable == 0 && signs_->turnedFaces == 0 && signs_->turnedShells == 0) return;
    const auto shells = orientShells(mesh_);
    if (shells.unorientable > 0) {
      add(Severity::Error, "unorientableShells", "parts like a Moebius strip",
          "they have no inside and no outside", shells.unorientable);
    }
    if (shells.turnedFaces > 0) {
      auto& defect = add(Severity::Warning, "turnedFaces", "faces turned against their neighbours",
                         "signs and normals are those of faces that agree; the file's do not",
                         shells.turnedFaces);
      for (std::uint32_t i = 0; i < shells.disagreeing.size(); ++i) {
        if (shells.disagreeing[i]) addPlace(defect, placeOf(FaceId{i}));
      }
    }
    if (shells.turnedShells() == 0) return;
    auto& defect = add(Severity::Warning, "insideOutShells", "shells inside out",
                       "their normals point into the solid; signs are as if they were turned",
                       shells.turnedShells());
    for (const auto shell : shells.insideOut) {
      addPlace(defect, placeOf(FaceId{shells.firstFaces[shell]}));
    }
  }

  void examineFaces() {
    addFaces(report_.oppositeFaces, Severity::Warning, "oppositeFaces",
             "faces equal to another that looks the opposite way",
             "panels of no thickness: distances see them, signs do not; if they are debris, "
             "repair --cancel-opposite removes them");
    addFaces(report_.duplicateFaces, Severity::Note, "duplicateFaces", "duplicate faces",
             isUnbalanced() ? "the winding number counts them twice; repair removes them"
                            : "repair removes them");
    addFaces(report_.repeatedCornerFaces, Severity::Note, "repeatedCorners",
             "faces with repeated corners", "of no influence; repair removes them");
    addFaces(report_.zeroAreaFaces, Severity::Note, "zeroAreaFaces", "faces of no area",
             "distances see them as edges, signs do not; repair removes them");
    const auto cut = triangulate(soup_);
    if (cut.polygonsWarped == 0) return;
    auto& defect =
        add(Severity::Note, "nonPlanarPolygons", "polygons that are not planar",
            "the surface is that of the triangles they are cut into; the worst is " +
                number(100 * cut.relativeWarp, 2) + " % of its size from flat, the first place",
            cut.polygonsWarped);
    addPlace(defect, placeOf(FaceId{cut.mostWarped}));
  }

  void examineHarmless() {
    addVertices(report_.nonManifoldVertices, "nonManifoldVertices", "non-manifold vertices",
                "faces touch there at a point only; signs are exact all the same");
    addVertices(report_.unusedVertices, "unusedPoints", "unused points", "no face has them");
    if (report_.components > 1) {
      add(Severity::Note, "components", "components",
          "parts that share no edge; their union is meant", report_.components);
    }
  }

  // Defects of one kind, if there are any.

  Defect& add(Severity severity, std::string key, std::string name, std::string meaning,
              std::size_t count) {
    return defects_.emplace_back(Defect{.severity = severity,
                                        .key = std::move(key),
                                        .name = std::move(name),
                                        .meaning = std::move(meaning),
                                        .count = count});
  }

  void addEdges(const Findings<EdgePlace>& edges, const char* key, const char* name,
                const std::string& meaning) {
    if (!edges) return;
    const bool isWorst = &edges == &report_.boundaryEdges || !report_.boundaryEdges;
    auto& defect = add(isAmbiguous() && isWorst ? Severity::Error : Severity::Warning, key, name,
                       meaning, edges.count);
    for (const auto& edge : edges.examples) {
      addPlace(defect, {0.5 * mesh_.position(edge.origin) + 0.5 * mesh_.position(edge.target),
                        {index(mesh_.face(edge.halfEdge))}});
    }
  }

  void addFaces(const Findings<FaceId>& faces, Severity severity, const char* key, const char* name,
                const std::string& meaning) {
    if (!faces) return;
    auto& defect = add(severity, key, name, meaning, faces.count);
    for (const FaceId face : faces.examples) addPlace(defect, placeOf(face));
  }

  void addVertices(const Findings<VertexId>& vertices, const char* key, const char* name,
                   const char* meaning) {
    if (!vertices) return;
    auto& defect = add(Severity::Note, key, name, meaning, vertices.count);
    for (const VertexId v : vertices.examples) addPlace(defect, {mesh_.position(v), {}});
  }

  // Places.

  static void addPlace(Defect& defect, DefectPlace place) {
    if (defect.places.size() < kMostPlaces) defect.places.push_back(std::move(place));
  }

  [[nodiscard]] DefectPlace placeOf(FaceId face) const {
    return {mesh_.centroid(face), {index(face)}};
  }

  /// The middle of the intersection of their boxes.
  [[nodiscard]] DefectPlace placeOf(const FacePair& pair) const {
    if (pair.first == pair.second) return placeOf(pair.first);
    return {boxOf(pair.first).intersection(boxOf(pair.second)).center(),
            {index(pair.first), index(pair.second)}};
  }

  [[nodiscard]] Box<double> boxOf(FaceId face) const {
    Box<double> box;
    for (const VertexId v : mesh_.vertices(face)) box.extend(mesh_.position(v));
    return box;
  }

  // Words.

  [[nodiscard]] bool isUnbalanced() const { return signs_ && !signs_->isClosed(); }
  [[nodiscard]] bool isAmbiguous() const { return isUnbalanced() && signs_->ambiguous > 0; }

  [[nodiscard]] std::string scheme() const {
    return signs_ && signs_->scheme == SignScheme::NearestFeature ? "nearest feature"
                                                                  : "winding number";
  }

  /// The consequence of gaps for the sign.
  [[nodiscard]] std::string gapMeaning() const {
    if (!signs_) return "it bounds nothing";
    if (!isUnbalanced()) return "signs go by the " + scheme();
    const auto probes = grouped(signs_->probes, "probe") + " of the box";
    if (!isAmbiguous()) {
      return "signs go by the winding number, and are clear at all " + probes;
    }
    return "signs go by the winding number, and are a matter of opinion at " +
           grouped(signs_->ambiguous) + " of " + probes;
  }

  const PolygonSoup& soup_;
  const DcelMesh<double>& mesh_;
  const MeshReport& report_;
  const Diagnosis& found_;
  const std::optional<SignReport>& signs_;
  std::vector<Defect> defects_;
};

}  // namespace

std::vector<Defect> findDefects(const PolygonSoup& soup, const DcelMesh<double>& mesh,
                                const Diagnosis& found) {
  return DefectSearch(soup, mesh, found).run();
}

std::optional<int> flatAxis(const PolygonSoup& soup) {
  constexpr double kRounding = 1e-9;
  const auto box = soup.boundingBox();
  if (box.empty()) return {};
  const auto size = box.size();
  for (const int axis : {0, 1, 2}) {
    if (size[axis] <= kRounding * box.diagonal()) return axis;
  }
  return {};
}

}  // namespace cutwater::detail
