#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceFrame.hpp>
#include <Cutwater/CutCells/Detail/Tiles/RectanglePieces.hpp>

#include <algorithm>
#include <utility>

namespace cutwater {

namespace {

/// What an open part has of an edge of the face.
struct Rim {
  int side = 0;
  std::uint32_t part = 0;
  Interval<double> ends;
};

class Finder {
 public:
  Finder(const FacePieces& faces, const SideStretches& sides, std::uint32_t face,
         RectanglePieces& out)
      : regions_(faces.meetingRegions(face)),
        frame_(faces.surface().numbers(), faces.planes(), face),
        out_(out) {
    for (int side = 0; side < 4; ++side) {
      const auto edge = edgeOfFace(frame_.axes().across, frame_.place(), side);
      stretches_[asIndex(side)] = sides.of(edge.axis, edge.place);
      firstNode_[asIndex(side) + 1] =
          firstNode_[asIndex(side)] + static_cast<std::uint32_t>(stretches_[asIndex(side)].size());
    }
    for (auto& node : firstNode_) node += static_cast<std::uint32_t>(regions_.parts().size());
  }

  void run() {
    findRims();
    sets_.reset(firstNode_[4]);
    for (const auto& rim : rims_) joinStretches(rim);
    addPieces();
    for (auto wall : regions_.walls()) addWall(wall);
    for (const auto& rim : rims_) addRimWalls(rim);
  }

 private:
  [[nodiscard]] int along(int side) const {
    return side < 2 ? frame_.axes().first : frame_.axes().second;
  }
  [[nodiscard]] int across(int side) const {
    return side < 2 ? frame_.axes().second : frame_.axes().first;
  }
  [[nodiscard]] Interval<double> edge(int side) const {
    return {frame_.corner(0)[along(side)], frame_.corner(3)[along(side)]};
  }

  void findRims() {
    for (const auto& [polygon, point, isFluid, part] : regions_.regions()) {
      if (part == kNone) continue;
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const auto& p = polygon[k];
        const auto& q = polygon[(k + 1) % polygon.size()];
        for (int side = 0; side < 4; ++side) {
          const double plane = frame_.corner(side % 2 == 0 ? 0 : 3)[across(side)];
          if (p[across(side)] != plane || q[across(side)] != plane) continue;
          const double from = p[along(side)];
          const double to = q[along(side)];
          rims_.push_back({side, part, {std::min(from, to), std::max(from, to)}});
        }
      }
    }
  }
  void joinStretches(const Rim& rim) {
    const auto whole = edge(rim.side);
    const auto stretches = stretches_[asIndex(rim.side)];
    for (std::uint32_t s = 0; s < stretches.size(); ++s) {
      const double common =
          std::min(stretches[s].to, rim.ends.upper) - std::max(stretches[s].from, rim.ends.lower);
      if (common > kSliver * (whole.upper - whole.lower)) {
        sets_.unite(rim.part, firstNode_[asIndex(rim.side)] + s);
      }
    }
  }

  void addPieces() {
    const auto parts = regions_.parts();
    pieceOf_.assign(firstNode_[4], kNone);
    std::vector<Vec3<double>> moments;
    for (std::uint32_t part = 0; part < parts.size(); ++part) {
      if (parts[part].isNothing) continue;
      auto& piece = pieceOf_[sets_.find(part)];
      if (piece == kNone) {
        piece = static_cast<std::uint32_t>(out_.pieces.size());
        out_.pieces.push_back({.face = parts[part].face, .centroid = {}});
        moments.emplace_back();
      }
      out_.pieces[piece].area += parts[part].area;
      moments[piece] += parts[part].area * parts[part].centroid;
    }
    for (std::size_t n = 0; n < moments.size(); ++n) {
      out_.pieces[n].centroid = moments[n] / out_.pieces[n].area;
    }
    for (std::size_t side = 0; side < 4; ++side) {
      for (auto node = firstNode_[side]; node < firstNode_[side + 1]; ++node) {
        out_.ofStretches[side].push_back(pieceOf_[sets_.find(node)]);
      }
    }
  }
  void addWall(FaceRegions::Wall wall) {
    wall.part = pieceOf_[sets_.find(wall.part)];
    if (wall.part != kNone) out_.walls.push_back(wall);
  }
  /// Where the edge is in the body, or a baffle covers it: a wall lies in it.
  void addRimWalls(const Rim& rim) {
    double from = rim.ends.lower;
    for (const auto& stretch : stretches_[asIndex(rim.side)]) {
      addRimWall(rim, from, std::min(stretch.from, rim.ends.upper));
      from = std::max(from, stretch.to);
    }
    addRimWall(rim, from, rim.ends.upper);
  }
  void addRimWall(const Rim& rim, double from, double to) {
    if (!(from < to)) return;
    regions_.shareRim(rim.side, {from, to}, [&](std::uint32_t patch, const Interval<double>& part) {
      EdgeStretch stretch;
      stretch.from = part.lower;
      stretch.to = part.upper;
      const auto ends = frame_.endsOf(rim.side, stretch);
      addWall({rim.part, patch, ends[0], ends[1]});
    });
  }

  const FaceRegions& regions_;
  FaceFrame frame_;
  RectanglePieces& out_;
  std::array<std::span<const EdgeStretch>, 4> stretches_;
  std::array<std::uint32_t, 5> firstNode_{};  // of the stretches of each side, behind the parts
  detail::DisjointSets sets_;                 // of parts, then stretches
  std::vector<Rim> rims_;
  std::vector<std::uint32_t> pieceOf_;  // by root
};

}  // namespace

RectanglePieces::RectanglePieces(const FacePieces& faces, const SideStretches& sides,
                                 std::uint32_t face) {
  Finder(faces, sides, face, *this).run();
}

}  // namespace cutwater
