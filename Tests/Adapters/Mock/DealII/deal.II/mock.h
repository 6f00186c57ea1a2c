#pragma once

// The part of deal.II 9.4 that Cutwater's adapter and its tests use, in deal.II's names and with
// its meaning, so that they can be compiled and run without deal.II. A triangulation is a cube,
// divided evenly.

#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace dealii {

template <int rank, int dim, typename Number = double>
class Tensor;

template <int dim, typename Number>
class Tensor<1, dim, Number> {
 public:
  const Number& operator[](unsigned int i) const { return at_[i]; }
  Number& operator[](unsigned int i) { return at_[i]; }

 protected:
  std::array<Number, dim> at_{};
};

template <int dim, typename Number = double>
class Point : public Tensor<1, dim, Number> {
 public:
  Point() = default;
  Point(Number x, Number y) requires(dim == 2) { this->at_ = {x, y}; }
  Point(Number x, Number y, Number z) requires(dim == 3) { this->at_ = {x, y, z}; }
};

template <int rank, int dim, typename Number = double>
class SymmetricTensor;

/// One entry for each of the two orders of a pair.
template <int dim, typename Number>
class SymmetricTensor<2, dim, Number> {
 public:
  class Row {
   public:
    Row(SymmetricTensor& tensor, unsigned int i) : tensor_(tensor), i_(i) {}
    Number& operator[](unsigned int j) { return tensor_.entry(i_, j); }

   private:
    SymmetricTensor& tensor_;
    unsigned int i_;
  };
  Row operator[](unsigned int i) { return {*this, i}; }

 private:
  Number& entry(unsigned int i, unsigned int j) { return i < j ? at_[i][j] : at_[j][i]; }
  std::array<std::array<Number, dim>, dim> at_{};
};

template <int dim, typename Number = double>
class Function {
 public:
  virtual ~Function() = default;
  virtual Number value(const Point<dim>& /*p*/, unsigned int /*component*/ = 0) const {
    throw std::logic_error("ExcPureFunctionCalled");
  }
  virtual void value_list(const std::vector<Point<dim>>& points, std::vector<Number>& values,
                          unsigned int component = 0) const {
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = value(points[i], component);
  }
  virtual Tensor<1, dim, Number> gradient(const Point<dim>& /*p*/,
                                          unsigned int /*component*/ = 0) const {
    throw std::logic_error("ExcPureFunctionCalled");
  }
  /// Zero, as in deal.II's release build; an exception in its debug build.
  virtual SymmetricTensor<2, dim, Number> hessian(const Point<dim>& /*p*/,
                                                  unsigned int /*component*/ = 0) const {
    return {};
  }
};

template <int dim>
class BoundingBox {
 public:
  explicit BoundingBox(std::pair<Point<dim>, Point<dim>> points) : points_(std::move(points)) {}
  const std::pair<Point<dim>, Point<dim>>& get_boundary_points() const { return points_; }

 private:
  std::pair<Point<dim>, Point<dim>> points_;
};

template <int dim>
class MockCell {
 public:
  MockCell(const BoundingBox<dim>& box, unsigned int index, int level)
      : box_(box), index_(index), level_(level) {}
  BoundingBox<dim> bounding_box() const { return box_; }
  int level() const { return level_; }
  unsigned int active_cell_index() const { return index_; }

 private:
  BoundingBox<dim> box_;
  unsigned int index_;
  int level_;
};

template <int dim>
class Triangulation {
 public:
  using active_cell_iterator = std::shared_ptr<const MockCell<dim>>;

  void refine_global(unsigned int times) {
    level_ += static_cast<int>(times);
    divide(cells_ << times);
  }
  unsigned int n_active_cells() const { return static_cast<unsigned int>(active_.size()); }
  const std::vector<active_cell_iterator>& active_cell_iterators() const { return active_; }

  void create(double lower, double upper) {  // for GridGenerator
    lower_ = lower;
    upper_ = upper;
    divide(1);
  }

 private:
  void divide(unsigned int cells) {
    cells_ = cells;
    active_.clear();
    const unsigned int count = dim == 3 ? cells * cells * cells : cells * cells;
    for (unsigned int index = 0; index < count; ++index) {
      std::pair<Point<dim>, Point<dim>> corners;
      for (unsigned int dir = 0, rest = index; dir < dim; ++dir, rest /= cells) {
        corners.first[dir] = side(rest % cells);
        corners.second[dir] = side(rest % cells + 1);
      }
      active_.push_back(std::make_shared<MockCell<dim>>(BoundingBox<dim>(corners), index, level_));
    }
  }
  double side(unsigned int i) const { return lower_ + (upper_ - lower_) / cells_ * i; }

  double lower_ = 0;
  double upper_ = 1;
  unsigned int cells_ = 1;
  int level_ = 0;
  std::vector<active_cell_iterator> active_;
};

namespace GridGenerator {
template <int dim>
void hyper_cube(Triangulation<dim>& triangulation, double lower = 0, double upper = 1) {
  triangulation.create(lower, upper);
}
}  // namespace GridGenerator

template <int dim>
class Quadrature {
 public:
  Quadrature() = default;
  Quadrature(std::vector<Point<dim>> points, std::vector<double> weights)
      : points_(std::move(points)), weights_(std::move(weights)) {
    if (points_.size() != weights_.size()) throw std::logic_error("ExcDimensionMismatch");
  }
  const std::vector<Point<dim>>& get_points() const { return points_; }
  const std::vector<double>& get_weights() const { return weights_; }
  unsigned int size() const { return static_cast<unsigned int>(weights_.size()); }

 private:
  std::vector<Point<dim>> points_;
  std::vector<double> weights_;
};

namespace NonMatching {
template <int dim>
class ImmersedSurfaceQuadrature : public Quadrature<dim> {
 public:
  ImmersedSurfaceQuadrature() = default;
  ImmersedSurfaceQuadrature(std::vector<Point<dim>> points, std::vector<double> weights,
                            std::vector<Tensor<1, dim>> normals)
      : Quadrature<dim>(std::move(points), std::move(weights)), normals_(std::move(normals)) {}
  const std::vector<Tensor<1, dim>>& get_normal_vectors() const { return normals_; }

 private:
  std::vector<Tensor<1, dim>> normals_;
};

enum class LocationToLevelSet { inside, outside, intersected, unassigned };
}  // namespace NonMatching

}  // namespace dealii
