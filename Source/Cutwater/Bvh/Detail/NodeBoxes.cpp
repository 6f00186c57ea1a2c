#include <Cutwater/Bvh/Detail/BinaryBvh.hpp>
#include <Cutwater/Bvh/Detail/NodeBoxes.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cutwater::detail {

namespace {

double summedArea(const std::vector<Box<double>>& boxes) {
  return std::transform_reduce(boxes.begin(), boxes.end(), 0.0, std::plus<>(), halfArea);
}

}  // namespace

BvhFrame frameOf(const Box<double>& box) {
  const double extent = maxComponent(box.size());
  if (!(extent > 0) || !std::isfinite(extent)) return {.center = box.center(), .scale = 1};
  // Well within double's range of exponents, so that lengths divided by the scale are finite.
  const int exponent = std::clamp(std::ilogb(extent), -900, 900);
  return {.center = box.center(), .scale = std::ldexp(1.0, -exponent)};
}

NodeBoxes::NodeBoxes(const NodeContents& contents, std::span<const NodeChild> children)
    : contents_(contents),
      children_(children),
      begin_(children.front().begin),
      end_(children.back().end) {
  fitAligned();
  if (contents.corners != nullptr) turnIfSmaller();
}

NodeBoxes::NodeBoxes(const NodeContents& contents, std::span<const NodeChild> children,
                     const BoxAxes& axes)
    : contents_(contents),
      children_(children),
      begin_(children.front().begin),
      end_(children.back().end) {
  fitAligned();
  if (axes == kAligned) return;
  axes_ = axes;
  boxes_ = boxesAlong(axes, 1);
}

void NodeBoxes::fitAligned() {
  Box<double> whole;
  for (const auto& child : children_) {
    const auto& frame = contents_.frame;
    boxes_.push_back({frame.toFrame(child.box.lower), frame.toFrame(child.box.upper)});
    whole.extend(boxes_.back());
  }
  center_ = static_cast<Vec3<float>>(whole.center());
  const Vec3<double> origin(center_);
  for (auto& box : boxes_) box = {box.lower - origin, box.upper - origin};
  // Conversion to the frame, the difference from its centre, three products and two sums.
  rounding_ = 0x1p-49 * maxComponent(max(abs(whole.lower), abs(whole.upper)));
}

void NodeBoxes::turnIfSmaller() {
  constexpr std::uint32_t kFew = 1024;  // these fit into a cache
  if (end_ - begin_ <= kFew) {
    std::vector<Corners> local;
    local.reserve(end_ - begin_);
    for (auto place = begin_; place < end_; ++place) local.push_back(corners(place));
    local_ = std::move(local);
  }
  const auto turned = axesOfTriangles();
  // Every sixteenth triangle is often enough to see that turning gains nothing.
  const bool isLarge = local_.empty();
  if (isLarge && !(summedArea(boxesAlong(turned, 16)) < summedArea(boxes_))) return;
  auto turnedBoxes = boxesAlong(turned, 1);
  if (summedArea(turnedBoxes) < summedArea(boxes_)) {
    axes_ = turned;
    boxes_ = std::move(turnedBoxes);
  }
}

Box<float> NodeBoxes::box(std::size_t child) const {
  constexpr float kInf = std::numeric_limits<float>::infinity();
  const Box<double> exact = boxes_[child].grown(rounding_);
  const Box<float> nearest{static_cast<Vec3<float>>(exact.lower),
                           static_cast<Vec3<float>>(exact.upper)};
  Box<float> result;
  for (int axis = 0; axis < 3; ++axis) {
    result.lower[axis] = std::nextafter(nearest.lower[axis], -kInf);
    result.upper[axis] = std::nextafter(nearest.upper[axis], kInf);
  }
  return result;
}

Vec3<double> NodeBoxes::toNode(const Vec3<double>& p) const {
  return contents_.frame.toFrame(p) - Vec3<double>(center_);
}

auto NodeBoxes::corners(std::uint32_t place) const -> Corners {
  if (!local_.empty()) return local_[place - begin_];
  auto result = (*contents_.corners)(contents_.order[place]);
  for (auto& corner : result) corner = toNode(corner);
  return result;
}

BoxAxes NodeBoxes::axesOfTriangles() const {
  constexpr std::uint32_t kSamples = 128;  // so that large nodes cost no more than small ones
  const std::uint32_t stride = 1 + (end_ - begin_) / kSamples;
  const auto found = fittingAxes((end_ - begin_ + stride - 1) / stride, [&](std::size_t i) {
    return corners(begin_ + static_cast<std::uint32_t>(i) * stride);
  });
  return found.value_or(axes_);
}

std::vector<Box<double>> NodeBoxes::boxesAlong(const BoxAxes& axes, std::uint32_t stride) const {
  std::vector<Box<double>> boxes;
  boxes.reserve(children_.size());
  for (const auto& child : children_) {
    Box<double> box;
    for (std::uint64_t i = child.begin; i < child.end; i += stride) {
      const auto place = static_cast<std::uint32_t>(i);
      if (contents_.corners != nullptr) {
        for (const auto& v : corners(place)) box.extend(along(axes, v));
      } else {
        const auto& own = contents_.boxes[contents_.order[place]];
        for (int k = 0; k < 8; ++k) box.extend(along(axes, toNode(own.corner(k))));
      }
    }
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace cutwater::detail
