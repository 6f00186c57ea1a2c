#pragma once

#include <Cutwater/Polyhedra/Detail/CellFaces.hpp>
#include <Cutwater/Polyhedra/Detail/SimpleLoops.hpp>
#include <Cutwater/Polyhedra/FluidMesh.hpp>

#include <span>
#include <unordered_map>
#include <vector>

namespace cutwater {

/// A mesh some of whose cells are changed: it remembers what is new.
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

  /// The faces of a cell, by their numbers, and one of them.
  [[nodiscard]] const std::vector<std::uint32_t>& facesOf(std::uint32_t cell);
  [[nodiscard]] const Face& face(std::uint32_t number);

  std::uint32_t addPoint(const Vec3<double>& point);
  /// Adds a cell without faces in the leaf and region of another one.
  std::uint32_t addCellLike(std::uint32_t cell, double volume);
  void setVolume(std::uint32_t cell, double volume) { mesh_.cells.volume[cell] = volume; }
  void addFace(Face face);
  void setLoop(std::uint32_t face, CornerLoop loop) { edit(face).loop = std::move(loop); }
  /// Gives a face of one cell to another one.
  void move(std::uint32_t face, std::uint32_t from, std::uint32_t to);
  /// Lets an edge of a cell go through a point, in all faces around it.
  void divideEdge(std::uint32_t cell, std::uint32_t a, std::uint32_t b, std::uint32_t point);

  /// The mesh, with cells in the order of their leaves.
  [[nodiscard]] FluidMesh take() &&;

 private:
  Face& edit(std::uint32_t face);
  std::vector<std::uint32_t>& editFacesOf(std::uint32_t cell);
  [[nodiscard]] Face original(std::uint32_t face) const;

  FluidMesh mesh_;
  CellFaces cells_;
  std::uint32_t faceCount_ = static_cast<std::uint32_t>(mesh_.faces.count());
  std::unordered_map<std::uint32_t, Face> faces_;  // that were asked for
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> facesOf_;
};

}  // namespace cutwater
