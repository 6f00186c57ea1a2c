#pragma once

#include <Cutwater/Render/Detail/SliceFrame.hpp>
#include <Cutwater/Render/Slice.hpp>

#include <vector>

/// Internals of renderSlice(), for its own parts only.
namespace cutwater::detail {

/// Values at the centres of a plot's pixels and of one more on each side, and the pixels' colours.
template <std::floating_point T>
class SliceField {
 public:
  SliceField(const SignedDistanceFunction<T>& solid, const SlicePlane<T>& plane,
             const SliceWindow<T>& window, const PlotArea& area, const SliceOptions<T>& options);

  [[nodiscard]] double least() const { return least_; }        ///< at most 0
  [[nodiscard]] double greatest() const { return greatest_; }  ///< at least 0

  /// Draws the plot with lines of equal distance. `scale`: relative to the usual thickness of
  /// lines.
  void draw(Image& image, const LineSpacing& spacing, double scale) const;

 private:
  [[nodiscard]] double value(int x, int y) const {
    return static_cast<double>(
        values_[static_cast<std::size_t>(y + 1) * stride_ + static_cast<std::size_t>(x + 1)]);
  }
  [[nodiscard]] double slope(int x, int y) const;
  [[nodiscard]] Rgb color(int x, int y, const LineSpacing& spacing, double scale) const;

  PlotArea area_;
  std::size_t stride_;
  std::vector<T> values_;
  double pixel_;
  double least_ = 0;
  double greatest_ = 0;
};

extern template class SliceField<float>;
extern template class SliceField<double>;

}  // namespace cutwater::detail
