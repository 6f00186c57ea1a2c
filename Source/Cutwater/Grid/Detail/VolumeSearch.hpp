#pragma once

#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/Grid/Detail/HalvedBox.hpp>
#include <Cutwater/Grid/SolidVolume.hpp>

#include <vector>

namespace cutwater::detail {

/// Bounds a volume by the cells of a HalvedBox, coarse ones first: see solidVolume(). A box without
/// extent along an axis or two is a rectangle or a segment: volumes are its areas or lengths.
template <std::floating_point T>
class VolumeSearch {
 public:
  /// The solid must outlive it. @throws Error as solidVolume(), but not for flat boxes.
  VolumeSearch(const SignedDistanceFunction<T>& solid, const Box<T>& box,
               const VolumeOptions& options);

  /// Runs until the options or isEnough() end the search; isEnough() is called after every few
  /// thousand cells.
  VolumeBounds run(FunctionRef<bool(const Interval<double>& volume)> isEnough);

 private:
  /// An undecided cell, and what is known about it.
  struct OpenCell {
    Index3 index;
    BoxHint hint;
  };

  void start();
  /// Divides the open cells of one generation and keeps those of the next. Returns false if the
  /// search is over.
  bool divideAll(FunctionRef<bool(const Interval<double>&)> isEnough);
  void classifyChildren(std::span<const OpenCell> parents);
  void classifyBatch(std::span<const OpenCell> parents, std::size_t first, std::size_t count);
  /// Keeps the open ones among the classified children, up to a total of `most`.
  void keepOpen(std::span<const OpenCell> parents, std::size_t most);
  [[nodiscard]] Box<T> childBox(std::span<const OpenCell> parents, std::size_t child) const;

  [[nodiscard]] Interval<double> volume() const;
  [[nodiscard]] bool isWithinTolerance() const;

  /// Adds the volume inside the planes that cut these cells.
  void estimate(std::size_t count, FunctionRef<Box<T>(std::size_t)> cellOf);
  [[nodiscard]] double estimateBatch(std::size_t first, std::size_t count,
                                     FunctionRef<Box<T>(std::size_t)> cellOf) const;

  /// Volumes of decided cells.
  struct Decided {
    double inside = 0;
    double outside = 0;
  };

  const SignedDistanceFunction<T>& solid_;
  VolumeOptions options_;
  HalvedBox<T> grid_;
  Vec3<double> flat_;  // 1 along axes without extent, else 0
  double boxVolume_;
  std::size_t cells_ = 0;
  DoubleDouble inside_;
  DoubleDouble outside_;
  DoubleDouble estimated_;

  std::vector<OpenCell> open_;
  std::vector<OpenCell> next_;
  // For the children of a few thousand cells.
  std::vector<BoxClass> classes_;
  std::vector<BoxHint> hints_;
  std::vector<Decided> decided_;  // of each batch
};

/// @throws Error for boxes without extent along an axis.
template <std::floating_point T>
void requireVolume(const Box<T>& box);

extern template void requireVolume(const Box<float>&);
extern template void requireVolume(const Box<double>&);
extern template class VolumeSearch<float>;
extern template class VolumeSearch<double>;

}  // namespace cutwater::detail
