#include <Cutwater/Bvh/Detail/BinaryBvh.hpp>
#include <Cutwater/Bvh/Detail/NodeBoxes.hpp>
#include <Cutwater/Core/Eigen.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Eigenvalues>

namespace cutwater::detail {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d principalAxis(const Matrix3d& symmetric) {
  Eigen::SelfAdjointEigenSolver<Matrix3d> solver;
  solver.computeDirect(symmetric);
  return solver.eigenvectors().col(2);
}

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
                     const Axes& axes)
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
  const Axes turned = fittingAxes();
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

NodeBoxes::Axes NodeBoxes::fittingAxes() const {
  constexpr std::uint32_t kSamples = 128;  // so that large nodes cost no more than small ones
  const std::uint32_t stride = 1 + (end_ - begin_) / kSamples;

  Matrix3d normals = Matrix3d::Zero();  // sum of A n n^T
  Matrix3d spread = Matrix3d::Zero();
  Vector3d sum = Vector3d::Zero();
  double samples = 0;
  for (std::uint64_t place = begin_; place < end_; place += stride) {
    const auto t = corners(static_cast<std::uint32_t>(place));
    const Vector3d areaNormal = toEigen(cross(t[1] - t[0], t[2] - t[0]));
    const double area = areaNormal.norm();
    if (area > 0) normals += areaNormal * (areaNormal / area).transpose();
    for (const auto& corner : t) {
      const Vector3d v = toEigen(corner);
      spread += v * v.transpose();
      sum += v;
      ++samples;
    }
  }
  const Vector3d n = principalAxis(normals);
  const Matrix3d flat = Matrix3d::Identity() - n * n.transpose();
  const Matrix3d covariance = spread - sum * sum.transpose() / samples;
  const Vector3d u = principalAxis(flat * covariance * flat);
  // Orthonormal even where the solver failed on degenerate matrices.
  const Vector3d first = (u - u.dot(n) * n).normalized();
  const Vector3d second = n.cross(first);
  const auto row = [](const Vector3d& v) {
    return static_cast<Vec3<float>>(Vec3<double>{v.x(), v.y(), v.z()});
  };
  const Axes axes{row(first), row(second), row(n)};
  const bool valid = std::ranges::all_of(axes, [](const auto& axis) {
    return std::abs(length(axis) - 1) < 0x1p-20F;  // false if anything is NaN
  });
  return valid ? axes : axes_;
}

std::vector<Box<double>> NodeBoxes::boxesAlong(const Axes& axes, std::uint32_t stride) const {
  const std::array<Vec3<double>, 3> rows{Vec3<double>(axes[0]), Vec3<double>(axes[1]),
                                         Vec3<double>(axes[2])};
  const auto turned = [&rows](const Vec3<double>& v) -> Vec3<double> {
    return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
  };
  std::vector<Box<double>> boxes;
  boxes.reserve(children_.size());
  for (const auto& child : children_) {
    Box<double> box;
    for (std::uint64_t i = child.begin; i < child.end; i += stride) {
      const auto place = static_cast<std::uint32_t>(i);
      if (contents_.corners != nullptr) {
        for (const auto& v : corners(place)) box.extend(turned(v));
      } else {
        const auto& own = contents_.boxes[contents_.order[place]];
        for (int k = 0; k < 8; ++k) box.extend(turned(toNode(own.corner(k))));
      }
    }
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace cutwater::detail
