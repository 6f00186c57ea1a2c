#pragma once

#include <Cutwater/Bvh/Detail/SplitItem.hpp>

#include <memory>
#include <optional>
#include <span>

namespace cutwater::detail {

/// A range of items to be split.
struct ItemRange {
  std::size_t begin;
  std::size_t end;
  bool inSecond = false;  ///< which of the two arrays holds them
  Bounds4 middles = {};   ///< of all items' boxes
  float frameExtent = 0;  ///< largest extent of the middles when the frame was chosen; 0: none yet
  [[nodiscard]] std::size_t count() const { return end - begin; }
};

/// The items of a build, in two arrays: splits read one and write the other. Disjoint ranges may be
/// split concurrently. Large ranges are split in parallel, in chunks of a fixed size, so that the
/// result does not depend on the number of threads.
class BinnedSplits {
 public:
  BinnedSplits(std::span<const Box<double>> boxes, std::uint32_t leafWidth, int threads);

  [[nodiscard]] ItemRange all() const { return {.begin = 0, .end = boxes_.size()}; }
  [[nodiscard]] std::span<SplitItem> items(const ItemRange& range) const;

  /// Must be called before a split. Ensures that the resolution of single precision, 2^-24 of the
  /// frame's extent, is small compared with the items.
  void refine(ItemRange& range) const;

  struct Halves {
    ItemRange left, right;
  };
  /// Splits at the best boundary of 16 bins along each axis; nothing if all middles fall into one
  /// bin.
  [[nodiscard]] std::optional<Halves> split(const ItemRange& range) const;
  /// Splits in the middle of the longest extent of the middles, so that leaves are full.
  [[nodiscard]] Halves halves(const ItemRange& range) const;

 private:
  struct Bins;
  struct Choice;
  class Binning;

  [[nodiscard]] Choice choose(const Bins& bins) const;
  [[nodiscard]] Halves scatter(const ItemRange& range, const Binning& binning, const Choice& choice,
                               std::span<const Bins> chunks) const;
  template <typename Body>
  void forChunks(const ItemRange& range, Body&& body) const;

  std::span<const Box<double>> boxes_;
  std::size_t leafWidth_;
  int threads_;
  std::array<std::unique_ptr<SplitItem[]>, 2> items_;
};

}  // namespace cutwater::detail
