#include <Cutwater/Polyhedra/Detail/EditedMesh.hpp>
#include <Cutwater/Polyhedra/Detail/FaceRows.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace cutwater {

EditedMesh::Face EditedMesh::original(std::uint32_t face) const {
  const auto& faces = mesh_.faces;
  const auto loop = faces.of(face);
  Face result{.loop = {loop.begin(), loop.end()}, .cell = faces.owner[face]};
  if (face < faces.neighbour.size()) {
    result.other = faces.neighbour[face];
  } else {
    const auto after =
        std::ranges::upper_bound(mesh_.patches, face, {}, &FluidMesh::Patch::firstFace);
    result.patch = static_cast<std::uint32_t>(after - mesh_.patches.begin() - 1);
  }
  return result;
}

EditedMesh::Face& EditedMesh::edit(std::uint32_t face) {
  const auto known = faces_.find(face);
  return known != faces_.end() ? known->second : faces_.emplace(face, original(face)).first->second;
}

const EditedMesh::Face& EditedMesh::face(std::uint32_t number) {
  return edit(number);
}

std::vector<std::uint32_t>& EditedMesh::editFacesOf(std::uint32_t cell) {
  const auto [known, isNew] = facesOf_.try_emplace(cell);
  if (isNew && cell < cells_.count()) {
    const auto faces = cells_.of(cell);
    known->second.assign(faces.begin(), faces.end());
  }
  return known->second;
}

const std::vector<std::uint32_t>& EditedMesh::facesOf(std::uint32_t cell) {
  return editFacesOf(cell);
}

std::uint32_t EditedMesh::addPoint(const Vec3<double>& point) {
  mesh_.points.push_back(point);
  return static_cast<std::uint32_t>(mesh_.points.size() - 1);
}

std::uint32_t EditedMesh::addCellLike(std::uint32_t cell, double volume) {
  auto& rows = mesh_.cells;
  rows.leaf.push_back(rows.leaf[cell]);
  rows.region.push_back(rows.region[cell]);
  rows.volume.push_back(volume);
  return static_cast<std::uint32_t>(rows.leaf.size() - 1);
}

void EditedMesh::addFace(Face face) {
  editFacesOf(face.cell).push_back(faceCount_);
  if (face.other != kNone) editFacesOf(face.other).push_back(faceCount_);
  faces_.emplace(faceCount_++, std::move(face));
}

void EditedMesh::move(std::uint32_t face, std::uint32_t from, std::uint32_t to) {
  auto& it = edit(face);
  (it.cell == from ? it.cell : it.other) = to;
  std::erase(editFacesOf(from), face);
  editFacesOf(to).push_back(face);
}

void EditedMesh::divideEdge(std::uint32_t cell, std::uint32_t a, std::uint32_t b,
                            std::uint32_t point) {
  std::vector<std::uint32_t> around{cell};
  for (std::size_t n = 0; n < around.size(); ++n) {
    for (const auto number : std::vector(facesOf(around[n]))) {
      auto& face = edit(number);
      auto& loop = face.loop;
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const auto next = loop[(k + 1) % loop.size()];
        if (!(loop[k] == a && next == b) && !(loop[k] == b && next == a)) continue;
        loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(k + 1), point);
        const auto there = face.across(around[n]);
        if (there != kNone && std::ranges::count(around, there) == 0) around.push_back(there);
        break;
      }
    }
  }
}

FluidMesh EditedMesh::take() && {
  const auto count = mesh_.cells.leaf.size();
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::ranges::stable_sort(order, {}, [&](std::uint32_t cell) { return mesh_.cells.leaf[cell]; });
  std::vector<std::uint32_t> number(count);
  FluidMesh::Cells rows;
  for (const auto cell : order) {
    number[cell] = static_cast<std::uint32_t>(rows.leaf.size());
    rows.leaf.push_back(mesh_.cells.leaf[cell]);
    rows.volume.push_back(mesh_.cells.volume[cell]);
    rows.region.push_back(mesh_.cells.region[cell]);
  }
  FaceRows faces;
  CornerLoop corners;
  for (std::uint32_t n = 0; n < faceCount_; ++n) {
    const auto known = faces_.find(n);
    const auto face = known != faces_.end() ? known->second : original(n);
    faces.add(face.loop, number[face.cell], face.other == kNone ? kNone : number[face.other],
              face.patch);
  }
  for (auto& patch : mesh_.patches) patch.faceCount = 0;
  mesh_.faces = faces.inOrder(count, mesh_.points, mesh_.patches);
  mesh_.cells = std::move(rows);
  return std::move(mesh_);
}

}  // namespace cutwater
