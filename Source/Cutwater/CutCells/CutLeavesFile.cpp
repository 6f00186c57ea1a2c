#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/CutCells/Detail/Rows/RowFile.hpp>
#include <Cutwater/CutCells/Detail/Rows/RowFlaws.hpp>

// A file of cut leaves, see RowFile.hpp.

namespace cutwater {

namespace {

constexpr RowFileKind kLeavesFile{
    .magic = {'\x89', 'C', 'u', 't', 'L', 'e', 'a', '\x1a'}, .version = 3, .rows = "leaves"};

/// Visits all that is in cut leaves. What is added to them and not named here does not compile.
template <typename Leaves, typename Visit>
void visitLeaves(Leaves& all, Visit&& visit) {
  auto& [cut, pieces, arcs, openArcs, wallParts, patchNames, classes, moments, quadrature,
         wholeFluid, wholeBody, arcPolygons, wallPolygons, firstWallPolygon] = all;
  const auto visitEach = [&](auto&... arrays) { (visit(arrays), ...); };
  auto& [leaf, box, firstPiece, fluidCorners, meets, wallFaces, error] = cut;
  visitEach(leaf, box, firstPiece, fluidCorners, meets, wallFaces, error);
  visitPieces(pieces, visit);
  auto& [below, above, leafBelow, leafAbove, area, centroid, faceArea, axis] = arcs;
  visitEach(below, above, leafBelow, leafAbove, area, centroid, faceArea, axis);
  visitOpenArcs(openArcs, visit);
  visitWallParts(wallParts, visit);
  visitEach(patchNames, classes, wholeFluid, wholeBody);
  visitOnRequest(all, visit);
}

}  // namespace

std::vector<std::byte> toBytes(const CutLeaves& leaves) {
  if (const auto* const flaw = flawOf(leaves)) {
    throw Error(ErrorKind::Argument,
                std::string("toBytes: need cut leaves as they are made: ") + flaw);
  }
  RowWriter writer;
  visitLeaves(leaves, writer);
  return std::move(writer).finish(kLeavesFile);
}

CutLeaves cutLeavesFrom(std::span<const std::byte> bytes) {
  CutLeaves leaves;
  RowReader reader(bytes, kLeavesFile);
  visitLeaves(leaves, reader);
  reader.finish(flawOf(leaves));
  return leaves;
}

void saveCutLeaves(const std::filesystem::path& path, const CutLeaves& leaves) {
  saveRows(path, toBytes(leaves));
}

CutLeaves loadCutLeaves(const std::filesystem::path& path) {
  return loadRows(path, cutLeavesFrom);
}

}  // namespace cutwater
