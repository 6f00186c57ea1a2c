#pragma once

#include <Cutwater/Polyhedra/Detail/CellFaces.hpp>
#include <Cutwater/Polyhedra/Detail/SimpleLoops.hpp>
#include <Cutwater/Polyhedra/FluidMesh.hpp>

#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace cutwater {

/// A mesh some of whose cells are changed: it remembers what is new. Changes can be tried: from
/// begin() on they are undone by undo(), until keep().
class EditedMesh {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;

  struct Face {
    CornerLoop loop;  ///< counterclockwise as seen from outside its cell
    std::uint32_t cell = 0;
    std::uint32_t other = kNone;  ///< the cell on the other side; kNone: it is in a patch
    std::uint32_t patch = 0;

    [[nodiscard]] std::uint32_t across(std::uint32_t from) const {
      return from == cell ? other : cell;
    }
  };

  explicit EditedMesh(FluidMesh mesh) : mesh_(std::move(mesh)), cells_(mesh_) {}
  ~EditedMesh() = default;
  EditedMesh(const EditedMesh&) = delete;
  EditedMesh& operator=(const EditedMesh&) = delete;
  EditedMesh(EditedMesh&&) = delete;
  EditedMesh& operator=(EditedMesh&&) = delete;

  [[nodiscard]] const FluidMesh& mesh() const { return mesh_; }
  [[nodiscard]] const std::vector<Vec3<double>>& points() const { return mesh_.points; }

  /// The faces of a cell, by their numbers, and one of them: without corners, if it was removed.
  [[nodiscard]] const std::vector<std::uint32_t>& facesOf(std::uint32_t cell);
  [[nodiscard]] const Face& face(std::uint32_t number);
  /// The cells on the other side of a cell's faces.
  [[nodiscard]] std::vector<std::uint32_t> neighboursOf(std::uint32_t cell);

  std::uint32_t addPoint(const Vec3<double>& point);
  /// Adds a cell without faces in the leaf and region of another one.
  std::uint32_t addCellLike(std::uint32_t cell, double volume);
  void setVolume(std::uint32_t cell, double volume);
  void addFace(Face face);
  void removeFace(std::uint32_t face);
  void setLoop(std::uint32_t face, CornerLoop loop) { edit(face).loop = std::move(loop); }
  /// Gives a face of one cell to another one.
  void move(std::uint32_t face, std::uint32_t from, std::uint32_t to);
  /// Lets an edge of a cell go through a point, in all faces around it.
  void divideEdge(std::uint32_t cell, std::uint32_t a, std::uint32_t b, std::uint32_t point);
  /// Makes one cell of two, without the faces between them: that of the first leaf, which is
  /// returned.
  std::uint32_t join(std::uint32_t cell, std::uint32_t joined);
  /// Makes one face of two of a cell that have the same cell or patch beyond, or several where its
  /// rim touches itself. Whether they share one chain of edges, without which it is not done.
  bool joinFaces(std::uint32_t face, std::uint32_t joined);
  /// Leaves out two faces of a cell that are one, seen from both sides: what is beyond one of them
  /// is beside what is beyond the other then. Whether they are.
  bool closeFold(std::uint32_t cell, std::uint32_t face, std::uint32_t opposite);

  /// Trials, one at a time; whether a face or the faces of a cell were changed in this one.
  void begin();
  void undo();
  void keep();
  /// Visits the numbers of faces that were changed, and of cells whose faces were.
  template <typename VisitFace, typename VisitCell>
  void forChanged(const VisitFace& visitFace, const VisitCell& visitCell) const {
    for (const auto& [cell, faces] : trial_.facesOf) visitCell(cell);
    for (const auto& [number, before] : trial_.faces) {
      visitFace(number);
      const auto& face = faces_.at(number);
      visitCell(face.cell);
      if (face.other != kNone) visitCell(face.other);
    }
  }
  [[nodiscard]] bool isChangedFace(std::uint32_t face) const {
    return trial_.isOn && (face >= trial_.faceCount || trial_.faces.contains(face));
  }
  [[nodiscard]] bool isChangedCell(std::uint32_t cell) const {
    return trial_.isOn && (cell >= trial_.cells || trial_.facesOf.contains(cell));
  }

  /// The mesh, with cells in the order of their leaves.
  [[nodiscard]] FluidMesh take() &&;

 private:
  using FaceNumbers = std::vector<std::uint32_t>;

  /// What there was before.
  struct Trial {
    bool isOn = false;
    std::size_t points = 0;
    std::size_t cells = 0;
    std::uint32_t faceCount = 0;
    std::size_t joined = 0;
    std::unordered_map<std::uint32_t, Face> faces;
    std::unordered_map<std::uint32_t, FaceNumbers> facesOf;
    std::vector<std::pair<std::uint32_t, double>> volumes;
  };

  Face& known(std::uint32_t face);
  FaceNumbers& knownFacesOf(std::uint32_t cell);
  Face& edit(std::uint32_t face);
  FaceNumbers& editFacesOf(std::uint32_t cell);
  [[nodiscard]] Face original(std::uint32_t face) const;

  FluidMesh mesh_;
  CellFaces cells_;
  std::uint32_t faceCount_ = static_cast<std::uint32_t>(mesh_.faces.count());
  std::unordered_map<std::uint32_t, Face> faces_;  // that were asked for
  std::unordered_map<std::uint32_t, FaceNumbers> facesOf_;
  std::vector<std::uint32_t> joined_;  // cells that are parts of others
  Trial trial_;
};

}  // namespace cutwater
