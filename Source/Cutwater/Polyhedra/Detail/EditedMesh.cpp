#include <Cutwater/Polyhedra/Detail/EditedMesh.hpp>
#include <Cutwater/Polyhedra/Detail/FaceRows.hpp>
#include <Cutwater/Polyhedra/Detail/JoinedPolygons.hpp>

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

EditedMesh::Face& EditedMesh::known(std::uint32_t face) {
  const auto known = faces_.find(face);
  return known != faces_.end() ? known->second : faces_.emplace(face, original(face)).first->second;
}

EditedMesh::Face& EditedMesh::edit(std::uint32_t face) {
  auto& it = known(face);
  if (trial_.isOn) trial_.faces.try_emplace(face, it);
  return it;
}

const EditedMesh::Face& EditedMesh::face(std::uint32_t number) {
  return known(number);
}

EditedMesh::FaceNumbers& EditedMesh::knownFacesOf(std::uint32_t cell) {
  const auto [known, isNew] = facesOf_.try_emplace(cell);
  if (isNew && cell < cells_.count()) {
    const auto faces = cells_.of(cell);
    known->second.assign(faces.begin(), faces.end());
  }
  return known->second;
}

EditedMesh::FaceNumbers& EditedMesh::editFacesOf(std::uint32_t cell) {
  auto& faces = knownFacesOf(cell);
  if (trial_.isOn) trial_.facesOf.try_emplace(cell, faces);
  return faces;
}

const std::vector<std::uint32_t>& EditedMesh::facesOf(std::uint32_t cell) {
  return knownFacesOf(cell);
}

std::vector<std::uint32_t> EditedMesh::neighboursOf(std::uint32_t cell) {
  std::vector<std::uint32_t> result;
  for (const auto number : facesOf(cell)) {
    const auto there = face(number).across(cell);
    if (there != kNone && std::ranges::count(result, there) == 0) result.push_back(there);
  }
  return result;
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

void EditedMesh::setVolume(std::uint32_t cell, double volume) {
  auto& now = mesh_.cells.volume[cell];
  if (trial_.isOn) trial_.volumes.emplace_back(cell, now);
  now = volume;
}

void EditedMesh::addFace(Face face) {
  editFacesOf(face.cell).push_back(faceCount_);
  if (face.other != kNone) editFacesOf(face.other).push_back(faceCount_);
  faces_.emplace(faceCount_++, std::move(face));
}

void EditedMesh::removeFace(std::uint32_t face) {
  auto& it = edit(face);
  std::erase(editFacesOf(it.cell), face);
  if (it.other != kNone) std::erase(editFacesOf(it.other), face);
  it.loop.clear();
}

void EditedMesh::move(std::uint32_t face, std::uint32_t from, std::uint32_t to) {
  auto& it = edit(face);
  (it.cell == from ? it.cell : it.other) = to;
  std::erase(editFacesOf(from), face);
  editFacesOf(to).push_back(face);
}

std::uint32_t EditedMesh::join(std::uint32_t cell, std::uint32_t joined) {
  const auto& [leaf, volume, region] = mesh_.cells;
  if (leaf[joined] < leaf[cell]) std::swap(cell, joined);
  for (const auto number : std::vector(facesOf(joined))) {
    if (face(number).across(joined) == cell) {
      removeFace(number);
    } else {
      move(number, joined, cell);
    }
  }
  setVolume(cell, volume[cell] + volume[joined]);
  joined_.push_back(joined);
  return cell;
}

bool EditedMesh::joinFaces(std::uint32_t face, std::uint32_t joined) {
  auto loop = known(joined).loop;
  if (known(face).cell != known(joined).cell) std::ranges::reverse(loop);
  auto rims = joinedPair(known(face).loop, loop);
  if (rims.empty()) return false;
  removeFace(joined);
  setLoop(face, std::move(rims.front()));
  for (std::size_t n = 1; n < rims.size(); ++n) {
    auto part = known(face);
    part.loop = std::move(rims[n]);
    addFace(std::move(part));
  }
  return true;
}

void EditedMesh::divideEdge(std::uint32_t cell, std::uint32_t a, std::uint32_t b,
                            std::uint32_t point) {
  std::vector<std::uint32_t> around{cell};
  for (std::size_t n = 0; n < around.size(); ++n) {
    for (const auto number : std::vector(facesOf(around[n]))) {
      const auto& loop = face(number).loop;
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const auto next = loop[(k + 1) % loop.size()];
        if (!(loop[k] == a && next == b) && !(loop[k] == b && next == a)) continue;
        auto& divided = edit(number);
        divided.loop.insert(divided.loop.begin() + static_cast<std::ptrdiff_t>(k + 1), point);
        const auto there = divided.across(around[n]);
        if (there != kNone && std::ranges::count(around, there) == 0) around.push_back(there);
        break;
      }
    }
  }
}

bool EditedMesh::closeFold(std::uint32_t cell, std::uint32_t face, std::uint32_t opposite) {
  const auto outward = [&](const Face& it) {
    auto loop = it.loop;
    if (it.cell != cell) std::ranges::reverse(loop);
    return loop;
  };
  if (known(face).loop.size() != known(opposite).loop.size()) return false;
  const auto one = known(face);
  const auto other = known(opposite);
  auto loop = outward(one);
  std::ranges::reverse(loop);
  const auto reversed = outward(other);
  if (reversed.empty()) return false;
  const auto start = std::ranges::find(loop, reversed.front());
  if (start == loop.end()) return false;
  std::rotate(loop.begin(), start, loop.end());
  if (loop != reversed) return false;
  const auto beyond = one.across(cell);
  const auto there = other.across(cell);
  removeFace(face);
  removeFace(opposite);
  if (beyond == there) return true;  // nothing is left between them
  // The loop looks out of the cell where the other face is: away from what is beyond the first.
  if (beyond != kNone) {
    addFace({.loop = std::move(loop), .cell = beyond, .other = there, .patch = other.patch});
  } else {
    std::ranges::reverse(loop);
    addFace({.loop = std::move(loop), .cell = there, .other = kNone, .patch = one.patch});
  }
  return true;
}

void EditedMesh::begin() {
  trial_.isOn = true;
  trial_.points = mesh_.points.size();
  trial_.cells = mesh_.cells.leaf.size();
  trial_.faceCount = faceCount_;
  trial_.joined = joined_.size();
}

void EditedMesh::undo() {
  for (auto& [number, face] : trial_.faces) faces_[number] = std::move(face);
  for (; faceCount_ > trial_.faceCount; --faceCount_) faces_.erase(faceCount_ - 1);
  for (auto& [cell, faces] : trial_.facesOf) facesOf_[cell] = std::move(faces);
  auto& rows = mesh_.cells;
  for (auto cell = static_cast<std::uint32_t>(trial_.cells); cell < rows.leaf.size(); ++cell) {
    facesOf_.erase(cell);
  }
  for (auto it = trial_.volumes.rbegin(); it != trial_.volumes.rend(); ++it) {
    rows.volume[it->first] = it->second;
  }
  rows.leaf.resize(trial_.cells);
  rows.region.resize(trial_.cells);
  rows.volume.resize(trial_.cells);
  mesh_.points.resize(trial_.points);
  joined_.resize(trial_.joined);
  keep();
}

void EditedMesh::keep() {
  trial_.isOn = false;
  trial_.faces.clear();
  trial_.facesOf.clear();
  trial_.volumes.clear();
}

FluidMesh EditedMesh::take() && {
  const auto count = mesh_.cells.leaf.size();
  mesh_.joinedPieces += joined_.size();
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::ranges::stable_sort(order, {}, [&](std::uint32_t cell) { return mesh_.cells.leaf[cell]; });
  std::vector<char> isJoined(count, 0);
  for (const auto cell : joined_) isJoined[cell] = 1;
  std::vector<std::uint32_t> number(count);
  FluidMesh::Cells rows;
  for (const auto cell : order) {
    if (isJoined[cell] != 0) continue;
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
    if (face.loop.empty()) continue;
    faces.add(face.loop, number[face.cell], face.other == kNone ? kNone : number[face.other],
              face.patch);
  }
  for (auto& patch : mesh_.patches) patch.faceCount = 0;
  mesh_.faces = faces.inOrder(rows.leaf.size(), mesh_.points, mesh_.patches);
  mesh_.cells = std::move(rows);
  return std::move(mesh_);
}

}  // namespace cutwater
