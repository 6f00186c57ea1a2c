#pragma once

// For code that includes deal.II, 9.4 or later.

#include <Cutwater/Adapters/BoxGrids.hpp>
#include <Cutwater/Adapters/FluidDomain.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/function.h>
#include <deal.II/base/point.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/grid/tria.h>
#include <deal.II/non_matching/immersed_surface_quadrature.h>
#include <deal.II/non_matching/mesh_classifier.h>

namespace cutwater {

namespace detail {

/// The point; in 2D, in the plane at z.
template <int dim>
Vec3<double> dealiiPoint(const dealii::Point<dim>& p, double z) {
  if constexpr (dim == 3) return {p[0], p[1], p[2]};
  return {p[0], p[1], z};
}

template <int dim>
Box<double> dealiiBox(const dealii::BoundingBox<dim>& box, double z) {
  const auto& [lower, upper] = box.get_boundary_points();
  return {dealiiPoint(lower, z), dealiiPoint(upper, z)};
}

/// Of the active cells, by their indices.
template <int dim>
std::vector<Box<double>> dealiiBoxes(const dealii::Triangulation<dim>& mesh, double z) {
  std::vector<Box<double>> boxes(mesh.n_active_cells());
  for (const auto& cell : mesh.active_cell_iterators()) {
    boxes[cell->active_cell_index()] = dealiiBox(cell->bounding_box(), z);
  }
  return boxes;
}

/// Fluid is inside deal.II's domain.
inline dealii::NonMatching::LocationToLevelSet dealiiLocation(FluidClass kind) {
  using Location = dealii::NonMatching::LocationToLevelSet;
  switch (kind) {
    case FluidClass::Fluid:
      return Location::inside;
    case FluidClass::Body:
      return Location::outside;
    default:
      return Location::intersected;
  }
}

}  // namespace detail

/// Options of DealIIFunction and DealIIClassifier; lengths in the units of the mesh.
struct DealIIOptions {
  /// Of the plane in which functions and classifiers in 2D are evaluated.
  double z = 0;
  /// Half-width of the centred differences of the gradient that give the Hessian. 0: there is none,
  /// and hessian() is that of deal.II, which reports this. The error is that of the gradient
  /// divided by this width, plus the width's square times the fourth derivative. Set it for smooth
  /// solids only, to about 1e-4 of their radii of curvature: at edges and far away from a solid,
  /// distances have kinks.
  double hessianStep = 0;
};

/// A FluidDomain as a level set function of deal.II, negative in the fluid.
template <int dim>
class DealIIFunction : public dealii::Function<dim> {
  static_assert(dim == 2 || dim == 3);

 public:
  explicit DealIIFunction(FluidDomain<double> domain, const DealIIOptions& options = {})
      : domain_(std::move(domain)), options_(options) {}

  double value(const dealii::Point<dim>& p, unsigned int /*component*/ = 0) const override {
    return domain_.levelSet(pointOf(p));
  }

  /// Runs in the calling thread, since deal.II calls it from its own threads.
  /// @throws Error if the lists differ in size.
  void value_list(const std::vector<dealii::Point<dim>>& points, std::vector<double>& values,
                  unsigned int /*component*/ = 0) const override {
    std::vector<Vec3<double>> at;
    at.reserve(points.size());
    for (const auto& p : points) at.push_back(pointOf(p));
    domain_.levelSets(at, values, {.threads = 1});
  }

  dealii::Tensor<1, dim> gradient(const dealii::Point<dim>& p,
                                  unsigned int /*component*/ = 0) const override {
    const auto g = domain_.gradient(pointOf(p));
    dealii::Tensor<1, dim> result;
    for (int axis = 0; axis < dim; ++axis) result[axis] = g[axis];
    return result;
  }

  /// See DealIIOptions::hessianStep.
  dealii::SymmetricTensor<2, dim> hessian(const dealii::Point<dim>& p,
                                          unsigned int component = 0) const override {
    const double step = options_.hessianStep;
    if (!(step > 0)) return dealii::Function<dim>::hessian(p, component);
    dealii::SymmetricTensor<2, dim> result;
    for (int i = 0; i < dim; ++i) {
      auto before = p;
      auto after = p;
      before[i] -= step;
      after[i] += step;
      const auto difference = domain_.gradient(pointOf(after)) - domain_.gradient(pointOf(before));
      // A mixed derivative has a single entry, to which both orders contribute.
      for (int j = 0; j < dim; ++j) {
        result[i][j] += difference[j] / (2 * step) * (i == j ? 1 : 0.5);
      }
    }
    return result;
  }

 private:
  [[nodiscard]] Vec3<double> pointOf(const dealii::Point<dim>& p) const {
    return detail::dealiiPoint(p, options_.z);
  }

  FluidDomain<double> domain_;
  DealIIOptions options_;
};

/// Locates cells as NonMatching::MeshClassifier does (inside is fluid), but with certainty: that
/// class examines only a few points of each face, and misses what does not show there.
///
/// A cell is represented by its bounding box. This is exact for boxes; other cells may be called
/// intersected unnecessarily, but are not missed unless a mapping bends them beyond their corners.
template <int dim>
class DealIIClassifier {
  static_assert(dim == 2 || dim == 3);

 public:
  /// Inside, outside or intersected.
  using Location = dealii::NonMatching::LocationToLevelSet;

  explicit DealIIClassifier(FluidDomain<double> domain, const DealIIOptions& options = {})
      : domain_(std::move(domain)), options_(options) {}

  /// Locates a closed box: inside and outside only if no surface touches it.
  [[nodiscard]] Location location(const dealii::BoundingBox<dim>& box) const {
    return detail::dealiiLocation(domain_.classify(detail::dealiiBox(box, options_.z)));
  }

  /// Classifies all active cells, in parallel. Call it again whenever the mesh has changed.
  void reclassify(const dealii::Triangulation<dim>& triangulation) {
    const auto boxes = detail::dealiiBoxes(triangulation, options_.z);
    classes_.assign(boxes.size(), FluidClass::Unknown);
    domain_.classify(boxes, classes_);
  }

  /// What reclassify() found for an active cell; unassigned if the cell was not among them.
  template <typename Cell>
  [[nodiscard]] Location location(const Cell& cell) const {
    const std::size_t index = cell->active_cell_index();
    return index < classes_.size() ? detail::dealiiLocation(classes_[index]) : Location::unassigned;
  }

  /// The number of cells that are called intersected because their location could not be decided.
  [[nodiscard]] std::size_t undecided() const {
    std::size_t count = 0;
    for (const auto kind : classes_) count += kind == FluidClass::Unknown ? 1 : 0;
    return count;
  }

 private:
  FluidDomain<double> domain_;
  DealIIOptions options_;
  std::vector<FluidClass> classes_;  // of active cells
};

/// Quadratures of a connected part of the fluid in a cell, in the unit cell, as FEValues,
/// FEImmersedSurfaceValues and FEFaceValues of deal.II take them. All weights are positive.
struct DealIIPiece {
  dealii::Quadrature<3> inside;  ///< of its volume
  /// Of its wall; normals point out of the fluid, as the gradient of deal.II's level set does.
  dealii::NonMatching::ImmersedSurfaceQuadrature<3> surface;
  /// Of the open parts of the cell's faces; without points where a face is closed.
  std::array<dealii::Quadrature<2>, 6> faces;
};

/// The active cells of a mesh, cut by a CellCutter or a SolidCutter: where they are, and
/// quadratures of the fluid in them, in place of NonMatching::QuadratureGenerator. They are of
/// connected parts, so a cell that a plate divides has two; the parts of a face are the same for
/// the cells on both sides; and a level set, its Hessian and smoothness are not needed.
///
/// Cells must be boxes, those of one level between planes that are the same for all of them, as
/// those of a hyper_rectangle are, refined anyhow. The face between cells of two levels is whole
/// for the coarser one: integrate over the finer ones' faces.
class DealIICutCells {
 public:
  /// Inside is fluid; a cell that the surface touches in a face is intersected.
  using Location = dealii::NonMatching::LocationToLevelSet;

  /// @param cutter  a CellCutter, or a SolidCutter, whose options say how many points there are.
  /// @param mesh  its active cells as they are now; it is not needed any more then.
  /// @param options  see there: of a CellCutter, quadratureDegree is that of exactness.
  /// @throws Error(Argument) for other cells than boxes between planes, and as the cutter does.
  template <typename Cutter>
  DealIICutCells(const Cutter& cutter, const dealii::Triangulation<3>& mesh,
                 CutOptions options = {}) {
    options.quadrature = true;
    std::vector<int> levels(mesh.n_active_cells());
    for (const auto& cell : mesh.active_cell_iterators()) {
      levels[cell->active_cell_index()] = cell->level();
    }
    const auto cells = gridsOf(detail::dealiiBoxes(mesh, 0), levels);
    places_ = cells.places;
    blocks_.resize(cells.grids.size());
    const ParallelOptions parallel{.threads = options.threads, .progress = options.progress};
    options.threads = 1;
    options.progress = {};
    parallelFor(blocks_.size(), parallel, [&](std::size_t begin, std::size_t end) {
      for (auto n = begin; n < end; ++n) blocks_[n] = cutter.cut(cells.grids[n], options);
    });
  }

  /// Where an active cell is.
  template <typename Cell>
  [[nodiscard]] Location location(const Cell& cell) const {
    if (pieceCount(cell) > 0) return Location::intersected;
    const auto& [block, index] = placeOf(cell);
    return detail::dealiiLocation(blocks_[block].classOf(index));
  }
  /// The number of connected parts of the fluid in a cell that is intersected; 0 for others.
  template <typename Cell>
  [[nodiscard]] std::size_t pieceCount(const Cell& cell) const {
    const auto [first, last] = piecesOf(cell);
    return last - first;
  }
  /// One of these. It takes memory of its own.
  template <typename Cell>
  [[nodiscard]] DealIIPiece piece(const Cell& cell, std::size_t number = 0) const {
    const auto [first, last] = piecesOf(cell);
    require(number < last - first, "DealIICutCells: there is no such piece",
            Named{"piece", number});
    const auto& [block, index] = placeOf(cell);
    const auto& cut = blocks_[block];
    const auto piece = static_cast<std::uint32_t>(first + number);
    const auto box = cut.boxOf(index);
    DealIIPiece result;
    result.inside = insideOf(cut, piece, box);
    result.surface = surfaceOf(cut, piece, box);
    for (unsigned face = 0; face < result.faces.size(); ++face) {
      result.faces[face] = openPartOf(cut, piece, index, face);
    }
    return result;
  }
  /// What was cut, in blocks of some cells of a level each, with some that are no active cells.
  [[nodiscard]] const std::vector<CutCells>& blocks() const { return blocks_; }

 private:
  template <typename Cell>
  [[nodiscard]] const BoxPlace& placeOf(const Cell& cell) const {
    const std::size_t number = cell->active_cell_index();
    require(number < places_.size(), "DealIICutCells: the cell was not in the mesh that was cut",
            Named{"cell", number});
    return places_[number];
  }
  /// The first piece of a cell in its block, and the one after its last.
  template <typename Cell>
  [[nodiscard]] std::array<std::size_t, 2> piecesOf(const Cell& cell) const {
    const auto& [block, index] = placeOf(cell);
    const auto& cut = blocks_[block];
    const auto row = cut.rowOf(index);
    if (row == CutCells::kNoRow) return {};
    return {cut.cells.firstPiece[row], cut.cells.firstPiece[row + 1]};
  }

  [[nodiscard]] static dealii::Point<3> unitPoint(const Vec3<double>& p, const Box<double>& box) {
    const auto from = p - box.lower;
    const auto size = box.size();
    return {from.x / size.x, from.y / size.y, from.z / size.z};
  }
  [[nodiscard]] static dealii::Quadrature<3> insideOf(const CutCells& cut, std::uint32_t piece,
                                                      const Box<double>& box) {
    const auto size = box.size();
    std::vector<dealii::Point<3>> points;
    std::vector<double> weights;
    for (const auto& p : cut.quadrature.volume.pointsOf(piece)) points.push_back(unitPoint(p, box));
    for (const double weight : cut.quadrature.volume.weightsOf(piece)) {
      weights.push_back(weight / (size.x * size.y * size.z));
    }
    return {points, weights};
  }
  /// In the unit cell, the components of an area's vector are shares of the cell's faces.
  [[nodiscard]] static dealii::NonMatching::ImmersedSurfaceQuadrature<3> surfaceOf(
      const CutCells& cut, std::uint32_t piece, const Box<double>& box) {
    const auto size = box.size();
    const auto& rows = cut.quadrature.wall;
    const auto at = rows.pointsOf(piece);
    const auto areas = rows.weightsOf(piece);
    std::vector<dealii::Point<3>> points;
    std::vector<double> weights;
    std::vector<dealii::Tensor<1, 3>> normals;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const auto& n = cut.quadrature.wallNormals[rows.first[piece] + i];
      const auto vector = areas[i] * Vec3<double>{n.x / (size.y * size.z), n.y / (size.z * size.x),
                                                  n.z / (size.x * size.y)};
      const double area = length(vector);
      points.push_back(unitPoint(at[i], box));
      weights.push_back(area);
      auto& normal = normals.emplace_back();
      for (int axis = 0; axis < 3; ++axis) {
        normal[static_cast<unsigned>(axis)] = vector[axis] / area;
      }
    }
    return {points, weights, normals};
  }
  /// Of a face in deal.II's order, whose own axes follow its normal's cyclically.
  [[nodiscard]] static dealii::Quadrature<2> openPartOf(const CutCells& cut, std::uint32_t piece,
                                                        const Index3& index, unsigned face) {
    const int axis = static_cast<int>(face / 2);
    const bool isHigh = face % 2 != 0;
    const auto box = cut.boxOf(index);
    const auto stepAlong = [&](int a) { return isHigh && axis == a ? 1 : 0; };
    const Index3 above{index.i + stepAlong(0), index.j + stepAlong(1), index.k + stepAlong(2)};
    const auto orderOf = [](const Index3& cell) { return std::tuple(cell.k, cell.j, cell.i); };
    std::vector<dealii::Point<2>> points;
    std::vector<double> weights;
    const auto& arcs = cut.arcs;
    auto arc = static_cast<std::size_t>(
        std::ranges::lower_bound(arcs.cell, orderOf(above), {}, orderOf) - arcs.cell.begin());
    for (; arc < arcs.cell.size() && arcs.cell[arc] == above; ++arc) {
      if (arcs.axis[arc] != axis || (isHigh ? arcs.below : arcs.above)[arc] != piece) continue;
      for (const auto& p : cut.quadrature.arc.pointsOf(arc)) {
        const auto unit = unitPoint(p, box);
        points.emplace_back(unit[(face / 2 + 1) % 3], unit[(face / 2 + 2) % 3]);
      }
      for (const double weight : cut.quadrature.arc.weightsOf(arc)) {
        weights.push_back(weight / cut.faceArea(index, axis));
      }
    }
    return {points, weights};
  }

  std::vector<CutCells> blocks_;
  std::vector<BoxPlace> places_;  // of active cells
};

}  // namespace cutwater
