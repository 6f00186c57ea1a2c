#pragma once

#include <Cutwater/Operations/Algebra.hpp>

#include <random>

namespace cutwater::test {

/// Random expressions of shapes and operators, about as large as the unit ball and about where it
/// is; the same ones on every run, and in float and double up to rounding.
template <std::floating_point T>
class RandomTrees {
 public:
  /// `grid`: if not 0, all numbers are multiples of it, and much coincides or is aligned.
  /// `asked`: if given, counts how often a shape of the trees is asked for anything.
  explicit RandomTrees(unsigned seed, double grid = 0, std::size_t* asked = nullptr)
      : engine_(seed), grid_(grid), asked_(asked) {}

  /// An operator of Algebra.hpp over trees of which one has depth - 1 levels of operators, the
  /// others fewer; depth 0 is a shape.
  Solid<T> tree(int depth);
  /// Shapes drawn for all trees so far, and functions that displace them.
  [[nodiscard]] int leaves() const { return leaves_; }

 private:
  using Maker = Solid<T> (RandomTrees::*)(int depth);

  double uniform(double a, double b) { return std::uniform_real_distribution<>(a, b)(engine_); }
  int below(int end) { return static_cast<int>(uniform(0, end)); }
  T number(double a, double b) {
    const double x = uniform(a, b);
    if (grid_ == 0) return static_cast<T>(x);
    const double coarse = std::round(x / grid_) * grid_;
    return static_cast<T>(a > 0 ? std::max(coarse, grid_) : coarse);
  }
  Vec3<T> point(double extent);
  Vec3<T> direction();
  Smoothing<T> smoothing();
  AffineMap<T> map();

  Solid<T> shape();
  Solid<T> anyShape();
  Solid<T> roundShape(int kind);
  Solid<T> centredShape(int kind);
  Solid<T> unboundedShape(int kind);
  Solid<T> combination(int depth);
  Solid<T> smoothCombination(int depth);
  Solid<T> manyOperands(int depth);
  Solid<T> motion(int depth);
  Solid<T> image(int depth);
  Solid<T> grown(int depth);
  Solid<T> pointMap(int depth);
  Solid<T> repetition(int depth);
  Solid<T> userFunction(int depth);
  Solid<T> other(int depth) { return tree(below(depth)); }
  Solid<T> first(int depth) { return tree(depth - 1); }

  std::mt19937 engine_;
  double grid_;
  std::size_t* asked_;
  int leaves_ = 0;
};

extern template class RandomTrees<float>;
extern template class RandomTrees<double>;

}  // namespace cutwater::test
