#include <Cutwater/CutCells/Detail/Moments/ArcMoments.hpp>
#include <Cutwater/CutCells/Detail/Moments/TileMoments.hpp>

#include <algorithm>

namespace cutwater {

namespace {

using Coefficients = std::array<double, Monomials<3>::kCount>;

/// Sums up the moments of pieces by the divergence theorem: a triangle of a wall adds those of the
/// tetrahedron that it makes with a point of the piece, and an open part its distance from that
/// point times its own.
class PieceMoments {
 public:
  PieceMoments(const FacePieces& faces, const CellPieces& content, const CutFrame& frame,
               CutCells::Moments& out)
      : faces_(faces),
        surface_(faces.surface()),
        content_(content),
        frame_(frame),
        out_(out),
        count_(out.perPiece()),
        references_(content.pieces.size()),
        hasReference_(content.pieces.size()) {
    out.volume.resize(content.pieces.size() * count_);
    out.wall.resize(content.pieces.size() * count_);
    out.wallVector.resize(content.pieces.size() * count_);
  }

  void add(const ArcMoments& arcs) {
    for (std::uint32_t i = 0; i < content_.ofFragments.size(); ++i) addFragment(i);
    const auto& [of, polygons] = content_.meetingWalls;
    for (std::size_t n = 0; n < of.size(); ++n) {
      const auto [piece, patch] = of[n];
      refer(piece, polygons.of(n)[0]);
      if (patch != kNone) addPolygon(piece, polygons.of(n), !WallPolygons::isOfArc(patch));
    }
    applyFactors();
    for (const auto& side : sidesOf(content_, surface_.numbers())) addOpenSide(side, arcs);
    for (std::uint32_t piece = 0; piece < content_.pieces.size(); ++piece) moveToCentroids(piece);
  }

 private:
  [[nodiscard]] int degree() const { return out_.degree; }

  void refer(std::uint32_t piece, const Vec3<double>& point) {
    if (hasReference_[piece] == 0) references_[piece] = point;
    hasReference_[piece] = 1;
  }

  void addFragment(std::uint32_t number) {
    const auto piece = content_.ofFragments[number];
    if (piece == kNone) return;
    const auto& fragment = surface_.fragments()[number];
    const auto points = surface_.points(fragment);
    refer(piece, points[0]);
    if (surface_.patchOf(fragment.triangle) != kNone) {
      addPolygon(piece, points, content_.isWall(number));
    }
  }
  /// A convex polygon, with its normal into the fluid.
  void addPolygon(std::uint32_t piece, std::span<const Vec3<double>> polygon, bool isWall) {
    const auto& reference = references_[piece];
    const auto a = polygon[0] - reference;
    Coefficients corner{1};
    addCorner(corner, degree(), asArray(a));
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      auto h = corner;
      addCorner(h, degree(), asArray(polygon[k - 1] - reference));
      addCorner(h, degree(), asArray(polygon[k] - reference));
      const auto twice = -cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
      addTetrahedron(piece, h, dot(a, twice));
      if (isWall) addTriangle(piece, h, twice);
    }
  }
  /// Takes six times its volume.
  void addTetrahedron(std::uint32_t piece, const Coefficients& h, double volume) {
    const auto first = piece * count_;
    for (std::size_t i = 0; i < count_; ++i) out_.volume[first + i] += volume * h[i];
  }
  /// Takes twice its vector.
  void addTriangle(std::uint32_t piece, const Coefficients& h, const Vec3<double>& vector) {
    const double area = length(vector);
    const auto first = piece * count_;
    for (std::size_t i = 0; i < count_; ++i) {
      out_.wall[first + i] += area * h[i];
      out_.wallVector[first + i] += h[i] * vector;
    }
  }
  /// Those of simplices, see addCorner().
  void applyFactors() {
    for (std::size_t i = 0; i < out_.volume.size(); ++i) {
      const auto& monomial = kMonomials<3>[i % count_];
      const double ofTriangle = monomial.factorials * factorialRatio(0, monomial.degree + 2);
      out_.volume[i] *= ofTriangle / (monomial.degree + 3);
      out_.wall[i] *= ofTriangle;
      out_.wallVector[i] = ofTriangle * out_.wallVector[i];
    }
  }

  void addOpenSide(const PieceSide& side, const ArcMoments& arcs) {
    const int across = side.face / 2;
    const auto place = surface_.numbers().placeOfFace(content_.arcs[side.arc].face);
    auto about = arcs.centroid(side.arc);
    about[across] = faces_.planes().at(across, place[asIndex(across)]);
    refer(side.piece, about);
    const auto way = about - references_[side.piece];
    std::array<double, Monomials<2>::kCount> ofFace{};
    std::ranges::copy(arcs.of(side.arc), ofFace.begin());
    shift(std::span(ofFace), degree(), alongFace(way, across));
    const auto moments = inSpace(ofFace, degree(), across, way[across]);
    const double outwards = side.face % 2 == 1 ? way[across] : -way[across];
    for (std::size_t i = 0; i < count_; ++i) {
      out_.volume[side.piece * count_ + i] += outwards * moments[i] / (kMonomials<3>[i].degree + 3);
    }
  }

  /// And to the units of the world.
  void moveToCentroids(std::uint32_t piece) {
    const auto from = references_[piece];
    const auto ofPiece = asArray(from - asStated(frame_, content_.pieces[piece].centroid));
    const auto ofWall = asArray(from - asStated(frame_, content_.pieces[piece].wallCentroid));
    const auto first = piece * count_;
    shift(std::span(out_.volume).subspan(first, count_), degree(), ofPiece);
    shift(std::span(out_.wall).subspan(first, count_), degree(), ofWall);
    shift(std::span(out_.wallVector).subspan(first, count_), degree(), ofWall);
    for (std::size_t i = 0; i < count_; ++i) {
      const double unit = unitOf(frame_, kMonomials<3>[i].degree + 2);
      out_.volume[first + i] /= unit * frame_.scale;
      out_.wall[first + i] /= unit;
      out_.wallVector[first + i] = out_.wallVector[first + i] / unit;
    }
  }

  const FacePieces& faces_;
  const TileSurface& surface_;
  const CellPieces& content_;
  const CutFrame& frame_;
  CutCells::Moments& out_;
  std::size_t count_;
  std::vector<Vec3<double>> references_;
  std::vector<char> hasReference_;
};

}  // namespace

CutCells::Moments findMoments(const FacePieces& faces, const CellPieces& content,
                              const CutFrame& frame, int degree) {
  CutCells::Moments result{.degree = degree, .volume = {}, .wall = {}, .wallVector = {}, .arc = {}};
  const ArcMoments arcs(faces, content, frame, degree);
  PieceMoments(faces, content, frame, result).add(arcs);
  for (std::size_t arc = 0; arc < content.arcs.size(); ++arc) {
    const auto own = arcs.of(arc);
    for (std::size_t i = 0; i < own.size(); ++i) {
      result.arc.push_back(own[i] / unitOf(frame, kMonomials<2>[i].degree + 2));
    }
  }
  return result;
}

}  // namespace cutwater
