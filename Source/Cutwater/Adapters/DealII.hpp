#pragma once

// For code that includes deal.II, 9.4 or later.

#include <Cutwater/Adapters/FluidDomain.hpp>

#include <cstddef>
#include <utility>
#include <vector>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/function.h>
#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>
#include <deal.II/non_matching/mesh_classifier.h>

namespace cutwater {

namespace detail {

/// The point; in 2D, in the plane at z.
template <int dim>
Vec3<double> dealiiPoint(const dealii::Point<dim>& p, double z) {
  if constexpr (dim == 3) return {p[0], p[1], p[2]};
  return {p[0], p[1], z};
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
    return asLocation(domain_.classify(boxOf(box)));
  }

  /// Classifies all active cells, in parallel. Call it again whenever the mesh has changed.
  void reclassify(const dealii::Triangulation<dim>& triangulation) {
    std::vector<Box<double>> boxes(triangulation.n_active_cells());
    for (const auto& cell : triangulation.active_cell_iterators()) {
      boxes[cell->active_cell_index()] = boxOf(cell->bounding_box());
    }
    classes_.assign(boxes.size(), FluidClass::Unknown);
    domain_.classify(boxes, classes_);
  }

  /// What reclassify() found for an active cell; unassigned if the cell was not among them.
  template <typename Cell>
  [[nodiscard]] Location location(const Cell& cell) const {
    const std::size_t index = cell->active_cell_index();
    return index < classes_.size() ? asLocation(classes_[index]) : Location::unassigned;
  }

  /// The number of cells that are called intersected because their location could not be decided.
  [[nodiscard]] std::size_t undecided() const {
    std::size_t count = 0;
    for (const auto kind : classes_) count += kind == FluidClass::Unknown ? 1 : 0;
    return count;
  }

 private:
  static Location asLocation(FluidClass kind) {
    switch (kind) {
      case FluidClass::Fluid:
        return Location::inside;
      case FluidClass::Body:
        return Location::outside;
      default:
        return Location::intersected;
    }
  }

  [[nodiscard]] Box<double> boxOf(const dealii::BoundingBox<dim>& box) const {
    const auto& [lower, upper] = box.get_boundary_points();
    return {detail::dealiiPoint(lower, options_.z), detail::dealiiPoint(upper, options_.z)};
  }

  FluidDomain<double> domain_;
  DealIIOptions options_;
  std::vector<FluidClass> classes_;  // of active cells
};

}  // namespace cutwater
