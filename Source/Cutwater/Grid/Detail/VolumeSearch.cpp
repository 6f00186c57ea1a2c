#include <Cutwater/Core/Detail/ParallelBatches.hpp>
#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/PlaneFraction.hpp>
#include <Cutwater/Grid/Detail/VolumeSearch.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

namespace {

/// Small enough that a batch's scratch memory fits the L1 and L2 caches.
constexpr std::size_t kVolumeBatch = 256;
/// Cells that are divided at once.
constexpr std::size_t kChunk = 8192;

constexpr const char* kSides = "solidVolume: need sides from 1e-80 to 1e80";

/// Relative error of sums of cell volumes, batch by batch.
constexpr double kSumError = kVolumeError + kVolumeBatch * 0x1p-53 + 0x1p-52;

}  // namespace

template <std::floating_point T>
VolumeSearch<T>::VolumeSearch(const SignedDistanceFunction<T>& solid, const Box<T>& box,
                              const VolumeOptions& options)
    : solid_(solid), options_(options), grid_(box), boxVolume_(0) {
  require(!box.empty() && isFinite(box), "solidVolume: need a finite box",
          Named{"lower", box.lower}, Named{"upper", box.upper});
  for (int axis = 0; axis < 3; ++axis) flat_[axis] = box.lower[axis] == box.upper[axis] ? 1 : 0;
  // Products of the box's sides must not overflow, and those of a cell's sides not underflow.
  const Vec3<double> size = Vec3<double>(box.upper) - Vec3<double>(box.lower);
  const auto sides = size + flat_;
  require(1e-80 <= std::min({sides.x, sides.y, sides.z}) && maxComponent(size) <= 1e80, kSides,
          Named{"size", size});
  boxVolume_ = volumeOf(box, flat_);
  require(options.fraction >= 0 && options.relative >= 0, "solidVolume: need tolerances >= 0",
          Named{"fraction", options.fraction}, Named{"relative", options.relative});
  require(options.cells > 0, "solidVolume: need cells > 0", Named{"cells", options.cells});
  require(options.threads >= 0, "solidVolume: need threads >= 0",
          Named{"threads", options.threads});
}

template <std::floating_point T>
VolumeBounds VolumeSearch<T>::run(FunctionRef<bool(const Interval<double>&)> isEnough) {
  start();
  while (!open_.empty() && divideAll(isEnough)) {
  }
  VolumeBounds result{.volume = volume(),
                      .boxVolume = boxVolume_,
                      .cells = cells_,
                      .isWithinTolerance = isWithinTolerance()};
  const auto& [lower, upper] = result.volume;
  result.estimate = 0.5 * (lower + upper);
  if (options_.isEstimated) {
    result.estimate = std::clamp(double(inside_ + estimated_), lower, upper);
  }
  return result;
}

template <std::floating_point T>
void VolumeSearch<T>::start() {
  OpenCell whole{};
  const auto kind = solid_.classify(grid_.cell({}), &whole.hint);
  cells_ = 1;
  if (mayBeCut(kind)) open_.push_back(whole);
  if (kind == BoxClass::Inside) inside_ = boxVolume_;
  if (kind == BoxClass::Outside) outside_ = boxVolume_;
}

template <std::floating_point T>
bool VolumeSearch<T>::divideAll(FunctionRef<bool(const Interval<double>&)> isEnough) {
  const auto parents = grid_;  // of this generation
  const bool isDivided = grid_.divide();
  const auto children = static_cast<std::size_t>(grid_.children());
  std::size_t done = 0;
  const auto isOver = [&] {
    return !isDivided || options_.cells - cells_ < children || isWithinTolerance() ||
           isEnough(volume());
  };
  while (done < open_.size() && !isOver()) {
    const auto room = (options_.cells - cells_) / children;
    const auto some = std::span(open_).subspan(done, std::min({kChunk, room, open_.size() - done}));
    classifyChildren(some);
    done += some.size();
    // Cells for which there is no room will not be divided.
    const auto left = std::min(open_.size() - done, room - some.size());
    keepOpen(some, room - some.size() - left);
  }
  const bool isAtEnd = done < open_.size();
  if (isAtEnd && options_.isEstimated) {
    estimate(open_.size() - done,
             [&](std::size_t n) { return parents.cell(open_[done + n].index); });
    estimate(next_.size(), [&](std::size_t n) { return grid_.cell(next_[n].index); });
  }
  open_.swap(next_);
  next_.clear();
  return !isAtEnd;
}

template <std::floating_point T>
Box<T> VolumeSearch<T>::childBox(std::span<const OpenCell> parents, std::size_t child) const {
  const auto children = static_cast<std::size_t>(grid_.children());
  return grid_.cell(
      grid_.child(parents[child / children].index, static_cast<int>(child % children)));
}

template <std::floating_point T>
void VolumeSearch<T>::classifyChildren(std::span<const OpenCell> parents) {
  const auto count = parents.size() * static_cast<std::size_t>(grid_.children());
  classes_.resize(count);
  hints_.resize(count);
  decided_.assign((count + kVolumeBatch - 1) / kVolumeBatch, {});
  parallelBatches(
      count, kVolumeBatch, {.threads = options_.threads},
      [&](std::size_t first, std::size_t batch) { classifyBatch(parents, first, batch); });
  // Added in order, whichever thread classified them.
  for (const auto& batch : decided_) {
    inside_ += batch.inside;
    outside_ += batch.outside;
  }
  cells_ += count;
}

template <std::floating_point T>
void VolumeSearch<T>::classifyBatch(std::span<const OpenCell> parents, std::size_t first,
                                    std::size_t count) {
  const auto children = static_cast<std::size_t>(grid_.children());
  Scratch<Box<T>, kVolumeBatch> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    boxes[i] = childBox(parents, first + i);
    hints_[first + i] = parents[(first + i) / children].hint;
  }
  const auto classes = std::span(classes_).subspan(first, count);
  solid_.classify(boxes.first(count), classes, std::span(hints_).subspan(first, count),
                  {.threads = 1});
  auto& decided = decided_[first / kVolumeBatch];
  for (std::size_t i = 0; i < count; ++i) {
    if (classes[i] == BoxClass::Inside) decided.inside += volumeOf(boxes[i], flat_);
    if (classes[i] == BoxClass::Outside) decided.outside += volumeOf(boxes[i], flat_);
  }
}

template <std::floating_point T>
void VolumeSearch<T>::keepOpen(std::span<const OpenCell> parents, std::size_t most) {
  const auto children = static_cast<std::size_t>(grid_.children());
  std::vector<std::size_t> left;
  for (std::size_t n = 0; n < classes_.size(); ++n) {
    if (!mayBeCut(classes_[n])) continue;
    if (next_.size() >= most) {
      left.push_back(n);
      continue;
    }
    const auto& parent = parents[n / children].index;
    next_.push_back({grid_.child(parent, static_cast<int>(n % children)), hints_[n]});
  }
  if (options_.isEstimated) {
    estimate(left.size(), [&](std::size_t n) { return childBox(parents, left[n]); });
  }
}

template <std::floating_point T>
Interval<double> VolumeSearch<T>::volume() const {
  // The box's own volume is known only to within kSumError, too; and the bounds must not cross.
  const double lower = std::max(0.0, double(inside_) * (1 - kSumError));
  const double upper = boxVolume_ * (1 + kSumError) - double(outside_) * (1 - kSumError);
  return {lower, std::max(lower, upper)};
}

template <std::floating_point T>
bool VolumeSearch<T>::isWithinTolerance() const {
  const auto [lower, upper] = volume();
  return upper - lower <= std::max(options_.fraction * boxVolume_, options_.relative * lower);
}

template <std::floating_point T>
void VolumeSearch<T>::estimate(std::size_t count, FunctionRef<Box<T>(std::size_t)> cellOf) {
  std::vector<double> parts((count + kVolumeBatch - 1) / kVolumeBatch);
  parallelBatches(count, kVolumeBatch, {.threads = options_.threads},
                  [&](std::size_t first, std::size_t batch) {
                    parts[first / kVolumeBatch] = estimateBatch(first, batch, cellOf);
                  });
  for (const double part : parts) estimated_ += part;
}

template <std::floating_point T>
double VolumeSearch<T>::estimateBatch(std::size_t first, std::size_t count,
                                      FunctionRef<Box<T>(std::size_t)> cellOf) const {
  Scratch<Vec3<T>, kVolumeBatch> centers;
  Scratch<T, kVolumeBatch> values;
  for (std::size_t i = 0; i < count; ++i) centers[i] = cellOf(first + i).center();
  solid_.signedDistances(centers.first(count), values.first(count), {.threads = 1});
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto box = cellOf(first + i);
    const Vec3<double> gradient(solid_.gradient(centers[i]));
    const Vec3<double> size(box.size());
    sum += volumeOf(box, flat_) *
           planeFraction(double{values[i]},
                         {gradient.x * size.x, gradient.y * size.y, gradient.z * size.z});
  }
  return sum;
}

template <std::floating_point T>
void requireVolume(const Box<T>& box) {
  const Vec3<double> size = Vec3<double>(box.upper) - Vec3<double>(box.lower);
  require(std::min({size.x, size.y, size.z}) > 0, kSides, Named{"size", size});
}

template void requireVolume(const Box<float>&);
template void requireVolume(const Box<double>&);
template class VolumeSearch<float>;
template class VolumeSearch<double>;

}  // namespace cutwater::detail
