#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Polyhedra/Detail/CellChange.hpp>
#include <Cutwater/Polyhedra/Detail/EditedMesh.hpp>
#include <Cutwater/Polyhedra/Detail/FaceQuality.hpp>
#include <Cutwater/Polyhedra/Detail/MendedCells.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace cutwater {

namespace {

/// How much is wrong with a face: 0, if nothing is.
template <typename At>
double flawOf(const FaceBetween& between, std::span<const std::uint32_t> corners, const At& at,
              const MendingRules& rules) {
  double flaw = 0;
  if (!(between.pyramid() > 0)) flaw += 3;
  if (between.other && !(between.pyramidBeyond() > 0)) flaw += 3;
  if (!rules.joins) return flaw;
  const double skew = between.skewness(corners, at) / kMostSkewness;
  if (skew > 1) flaw += 1 + 0.1 * std::min(skew - 1, 1.0);
  if (!between.other) return flaw;
  const double cosine = between.orthogonality();
  if (cosine < kLeastOrthogonality) flaw += 0.5 + 0.1 * (kLeastOrthogonality - cosine);
  return flaw;
}

/// How much is wrong with a cell beside its faces: what is flat has no gradient along an axis.
double flawOfShape(double aspectRatio) {
  return aspectRatio < kMostAspectRatio ? 0 : 2;
}

class CellMending {
 public:
  CellMending(FluidMesh mesh, const MendingRules& rules) : mesh_(std::move(mesh)), rules_(rules) {}

  /// Mends faces, and those around them that are bad afterwards, as long as that helps.
  void mend(std::vector<std::uint32_t> pending) {
    constexpr std::size_t kMost = 10;  // changes for each face, so that it ends
    for (auto left = kMost * pending.size(); !pending.empty() && left > 0;) {
      const auto number = pending.back();
      pending.pop_back();
      const auto& face = mesh_.face(number);
      if (face.loop.empty() || !(flawAt(number) > 0)) continue;
      if (!findBest(face)) continue;
      for (const auto around : change()) {
        if (flawAt(around) > 0) pending.push_back(around);
      }
      --left;
    }
  }
  [[nodiscard]] FluidMesh take() && { return std::move(mesh_).take(); }

 private:
  static constexpr auto kNone = EditedMesh::kNone;
  using Cells = std::vector<std::uint32_t>;
  using Kind = CellChange::Kind;

  /// Of a cell.
  struct Shape {
    Vec3<double> center;
    double flaw = 0;
  };

  // ---- what there is

  [[nodiscard]] auto pointAt() const {
    return [this](std::uint32_t n) { return mesh_.points()[n]; };
  }
  FaceMoments momentsOf(std::uint32_t face) {
    if (mesh_.isChangedFace(face)) return faceMoments(mesh_.face(face).loop, pointAt());
    const auto [known, isNew] = faces_.try_emplace(face);
    if (isNew) known->second = faceMoments(mesh_.face(face).loop, pointAt());
    return known->second;
  }
  const Shape& shapeOf(std::uint32_t cell) {
    if (mesh_.isChangedCell(cell)) return newShape_ = newShapeOf(cell);
    const auto [known, isNew] = shapes_.try_emplace(cell);
    if (isNew) known->second = newShapeOf(cell);
    return known->second;
  }
  Shape newShapeOf(std::uint32_t cell) {
    std::vector<FaceMoments> faces;
    Vec3<double> seen;
    for (const auto face : mesh_.facesOf(cell)) {
      faces.push_back(momentsOf(face));
      if (mesh_.face(face).cell != cell) faces.back().area *= -1;
      seen += abs(faces.back().area);
    }
    const auto moments = cellMoments(faces);
    return {moments.center, flawOfShape(aspectRatio(seen, moments.volume))};
  }
  Vec3<double> centerOf(std::uint32_t cell) { return shapeOf(cell).center; }
  double flawOf(std::uint32_t number) {
    const auto& face = mesh_.face(number);
    FaceBetween between{momentsOf(number), centerOf(face.cell), {}};
    if (face.other != kNone) between.other = centerOf(face.other);
    return cutwater::flawOf(between, face.loop, pointAt(), rules_);
  }
  /// Of a face and its cells.
  double flawAt(std::uint32_t number) {
    const auto& face = mesh_.face(number);
    double flaw = flawOf(number) + shapeOf(face.cell).flaw;
    if (face.other != kNone) flaw += shapeOf(face.other).flaw;
    return flaw;
  }
  /// Of some cells and all of their faces, or something above a limit if they have more than that.
  double flawsOf(const Cells& cells, double limit = std::numeric_limits<double>::infinity()) {
    const auto faces = facesOf(cells);
    double sum = 0;
    for (const auto cell : cells) sum += shapeOf(cell).flaw;
    for (std::size_t n = 0; n < faces.size() && sum <= limit; ++n) sum += flawOf(faces[n]);
    return sum;
  }

  std::vector<std::uint32_t> facesOf(const Cells& cells) {
    std::vector<std::uint32_t> faces;
    for (const auto cell : cells) {
      const auto& of = mesh_.facesOf(cell);
      faces.insert(faces.end(), of.begin(), of.end());
    }
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
  }

  // ---- what can be done

  /// Finds the best change for a face; whether there is one.
  bool findBest(const EditedMesh::Face& face) {
    best_.reset();
    most_ = 1e-3;
    Cells cells = face.other == kNone ? Cells{face.cell} : Cells{face.cell, face.other};
    std::erase_if(cells, [&](auto cell) { return hopeless_.contains(cell); });
    if (rules_.joins) {
      for (const auto cell : cells) consider({.kind = Kind::CloseFolds, .cell = cell});
      for (const auto cell : cells) considerJoining(cell);
      for (const auto cell : cells) considerWalls(cell, false);
    }
    for (const auto cell : cells) considerDividing(cell);
    if (rules_.joins) {
      for (const auto cell : cells) {
        if (!best_) considerRegrouping(cell);
      }
      for (const auto cell : cells) {
        if (!best_) considerDividingTwice(cell);
      }
      for (const auto cell : cells) {
        if (!best_) considerDividingWalls(cell);
      }
    }
    for (const auto cell : cells) {
      if (!best_ && rules_.joinsSides) considerWalls(cell, true);
    }
    if (!best_) hopeless_.insert(cells.begin(), cells.end());
    return best_.has_value();
  }
  /// Makes that change. The faces of all cells that are not as they were.
  std::vector<std::uint32_t> change() {
    mesh_.begin();
    static_cast<void>(apply(*best_, mesh_));
    Cells cells;
    mesh_.forChanged([&](std::uint32_t number) { faces_.erase(number); },
                     [&](std::uint32_t cell) {
                       shapes_.erase(cell);
                       hopeless_.erase(cell);
                       cells.push_back(cell);
                     });
    mesh_.keep();
    for (const auto cell : cells) {
      for (const auto there : mesh_.neighboursOf(cell)) hopeless_.erase(there);
    }
    return facesOf(cells);
  }

  void considerJoining(std::uint32_t cell) {
    for (const auto there : mesh_.neighboursOf(cell)) {
      consider({.kind = Kind::Join, .cell = cell, .other = there});
      consider({.kind = Kind::JoinWithWalls, .cell = cell, .other = there});
    }
  }
  /// Joins those of a cell; with the sides of sheets also after it was joined to a neighbour.
  void considerWalls(std::uint32_t cell, bool joinsSides) {
    for (const auto number : std::vector(mesh_.facesOf(cell))) {
      const auto there = mesh_.face(number).across(cell);
      if (there == kNone) {
        consider(
            {.kind = Kind::JoinWalls, .cell = cell, .other = number, .joinsSides = joinsSides});
      } else if (joinsSides) {
        consider({.kind = Kind::JoinWithWalls, .cell = cell, .other = there, .joinsSides = true});
      }
    }
  }
  void considerDividing(std::uint32_t cell) {
    const auto planes = planesOf(cell);
    const auto other = static_cast<std::uint32_t>(mesh_.mesh().cells.leaf.size());  // part
    for (const auto& plane : planes) {
      besideParts_ = {};
      if (!consider({.kind = Kind::Divide, .cell = cell, .plane = plane})) continue;
      if (!rules_.joins) continue;
      const auto [besideFront, besideBehind] = besideParts_;
      const auto considerGiving = [&](Kind kind, const Cells& neighbours) {
        for (const auto there : neighbours) {
          if (there == cell || there == other) continue;
          consider({.kind = kind, .cell = cell, .other = there, .plane = plane});
        }
      };
      considerGiving(Kind::GiveFront, besideFront);
      considerGiving(Kind::GiveBehind, besideBehind);
    }
  }
  std::vector<DividingPlane> planesOf(std::uint32_t cell) {
    constexpr double kFar = 0.05;
    auto planes = dividingPlanes(mesh_, cell);
    for (std::size_t n = 0, count = planes.size(); n < count; ++n) {
      planes.push_back(planes[n]);
      planes.back().near = kFar;
    }
    return planes;
  }
  /// Joins a cell to a neighbour, and divides both otherwise.
  void considerRegrouping(std::uint32_t cell) {
    for (const auto there : mesh_.neighboursOf(cell)) {
      mesh_.begin();
      const auto planes = planesOf(mesh_.join(cell, there));
      mesh_.undo();
      for (const auto& plane : planes) {
        consider({.kind = Kind::JoinAndDivide, .cell = cell, .other = there, .plane = plane});
      }
    }
  }
  bool canDivide(std::uint32_t cell, const DividingPlane& plane) {
    mesh_.begin();
    const bool can = divideCell(mesh_, cell, plane).has_value();
    mesh_.undo();
    return can;
  }
  void considerDividingTwice(std::uint32_t cell) {
    constexpr std::size_t kMost = 12;
    auto planes = planesOf(cell);
    std::erase_if(planes, [&](const DividingPlane& plane) { return !canDivide(cell, plane); });
    if (planes.size() > kMost) planes.resize(kMost);
    for (const auto& plane : planes) {
      for (const auto& second : planes) {
        for (const auto kind : {Kind::DivideFront, Kind::DivideBehind}) {
          consider({.kind = kind, .cell = cell, .plane = plane, .second = second});
        }
      }
    }
  }
  /// Divides one by a line between two of its corners, as where it is folded.
  void considerDividingWalls(std::uint32_t cell) {
    constexpr std::size_t kMostCorners = 50;
    for (const auto number : std::vector(mesh_.facesOf(cell))) {
      const auto wall = mesh_.face(number);
      const auto& loop = wall.loop;
      if (wall.other != kNone || loop.size() > kMostCorners) continue;
      for (std::size_t a = 0; a + 2 < loop.size(); ++a) {
        for (std::size_t b = a + 2; b < loop.size(); ++b) {
          if (a == 0 && b + 1 == loop.size()) continue;  // side by side
          consider({.kind = Kind::DivideWall,
                    .cell = cell,
                    .other = number,
                    .corners = {loop[a], loop[b]}});
        }
      }
    }
  }
  /// Keeps a change, if it is the best so far; whether it can be made, and could be better.
  bool consider(const CellChange& change) {
    constexpr std::size_t kMostFaces = 100;  // more take too long, and joining makes more of them
    Cells cells{change.cell};
    if (change.hasNeighbour()) cells.push_back(change.other);
    std::size_t faces = 0;
    for (const auto cell : cells) faces += mesh_.facesOf(cell).size();
    if (faces > kMostFaces) return false;
    const double before = flawsOf(cells);
    if (!(before > most_)) return false;  // that cannot be better
    mesh_.begin();
    const auto after = apply(change, mesh_);
    const bool isPossible = !after.empty() && haveEnoughFaces(after);
    const double gain = isPossible ? before - flawsOf(after, before - most_) : 0;
    if (isPossible && change.kind == Kind::Divide) {
      besideParts_ = {mesh_.neighboursOf(after[0]), mesh_.neighboursOf(after[1])};
    }
    mesh_.undo();
    if (gain > most_) {
      most_ = gain;
      best_ = change;
    }
    return isPossible;
  }
  bool haveEnoughFaces(const Cells& cells) {
    return std::ranges::all_of(
        cells, [&](auto cell) { return mesh_.facesOf(cell).size() >= kFewestFaces; });
  }

  EditedMesh mesh_;
  MendingRules rules_;
  std::unordered_map<std::uint32_t, FaceMoments> faces_;  // that were asked for
  std::unordered_map<std::uint32_t, Shape> shapes_;       // of cells
  Shape newShape_;
  std::unordered_set<std::uint32_t> hopeless_;  // cells for which nothing helped
  std::optional<CellChange> best_;              // for a face, so far
  double most_ = 0;                             // what it gains
  std::array<Cells, 2> besideParts_;            // of the last division
};

/// The faces with which something is wrong, or with whose cells, ascending.
std::vector<std::uint32_t> badFaces(const FluidMesh& mesh, const MendingRules& rules) {
  constexpr std::size_t kGrain = 1024;
  const CellFaces cells(mesh);
  const FaceQuality quality(cells, rules.threads);
  std::vector<char> isBad(mesh.faces.count());
  parallelFor(isBad.size(), {.threads = rules.threads, .grain = kGrain},
              [&](std::size_t begin, std::size_t end) {
                for (auto face = begin; face < end; ++face) {
                  const double flaw = flawOfShape(quality.aspectRatio(mesh.faces.owner[face])) +
                                      flawOf(
                                          quality.between(face), mesh.faces.of(face),
                                          [&](std::uint32_t n) { return mesh.points[n]; }, rules);
                  isBad[face] = flaw > 0 ? 1 : 0;
                }
              });
  std::vector<std::uint32_t> bad;
  for (std::uint32_t face = 0; face < isBad.size(); ++face) {
    if (isBad[face] != 0) bad.push_back(face);
  }
  return bad;
}

}  // namespace

FluidMesh withMendedCells(FluidMesh mesh, const MendingRules& rules) {
  auto bad = badFaces(mesh, rules);
  if (bad.empty()) return mesh;
  std::ranges::reverse(bad);
  CellMending mending(std::move(mesh), rules);
  mending.mend(std::move(bad));
  return std::move(mending).take();
}

}  // namespace cutwater
