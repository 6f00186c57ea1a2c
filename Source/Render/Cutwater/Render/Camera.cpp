#include <Cutwater/Core/Detail/UnitVector.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/Camera.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace cutwater {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Whether two unit vectors are parallel, up to rounding.
bool parallel(const Vec3<double>& a, const Vec3<double>& b) {
  return length(cross(a, b)) < 1e-12;
}

/// cos and sin of an angle in degrees, exact where they are 0 or 1.
double cosine(double degrees) {
  return std::remainder(degrees, 180) == 90 || std::remainder(degrees, 180) == -90
             ? 0
             : std::cos(degrees * kDegree);
}
double sine(double degrees) {
  return std::remainder(degrees, 180) == 0 ? 0 : std::sin(degrees * kDegree);
}

}  // namespace

View View::from(const Vec3<double>& side, const Vec3<double>& up) {
  const auto back = detail::unitVector("View", "side", side);
  auto above = detail::unitVector("View", "up direction", up);
  if (parallel(above, back)) above = {0, 1, 0};
  if (parallel(above, back)) above = {0, 0, 1};
  return {back, normalized(above - dot(above, back) * back)};
}

View View::fromAngles(double azimuth, double elevation) {
  require(std::isfinite(azimuth) && std::abs(elevation) <= 90,
          "View: need a finite azimuth and an elevation from -90 to 90 degrees",
          Named{"azimuth", azimuth}, Named{"elevation", elevation});
  const Vec3<double> along{cosine(azimuth), sine(azimuth), 0};
  const double c = cosine(elevation);
  const double s = sine(elevation);
  // The direction ahead of the viewer is up, also in views from above or below.
  const Vec3<double> back{c * along.x, c * along.y, s};
  return {back, {-s * along.x, -s * along.y, c}};
}

View View::named(std::string_view name) {
  constexpr std::string_view kAxes = "xyz";
  if (name == "iso") return from({1, -1, 1});
  const auto axis = name.size() == 2 ? kAxes.find(name[1]) : std::string_view::npos;
  if (axis == std::string_view::npos || (name[0] != '+' && name[0] != '-')) {
    throw Error(ErrorKind::Argument,
                "View: need +x, -x, +y, -y, +z, -z or iso, not '" + std::string(name) + "'");
  }
  Vec3<double> side;
  side[static_cast<int>(axis)] = name[0] == '+' ? 1 : -1;
  return from(side);
}

namespace detail {

namespace {

/// Visits the corners of a box, with coordinates about its centre to the right, up and towards the
/// viewer.
template <typename Visit>
void forCorners(const Box<double>& box, const View& view, Visit visit) {
  const auto right = view.right();
  for (int i = 0; i < 8; ++i) {
    const auto p = box.corner(i) - box.center();
    visit(Vec3<double>{dot(p, right), dot(p, view.up), dot(p, view.back)});
  }
}

/// The size of a pixel at a distance of 1.
double pixelAtOne(const Frame& frame, double fieldOfView) {
  return 2 * std::tan(0.5 * fieldOfView * kDegree) / std::max(frame.width, frame.height);
}

}  // namespace

Camera::Camera(const View& view, const Box<double>& box, const Frame& frame, double fieldOfView)
    : view_(view),
      perspective_(fieldOfView > 0),
      origin_(box.center()),
      pixel_(perspective_ ? pixelAtOne(frame, fieldOfView) : 0),
      centerX_(frame.centerX),
      centerY_(frame.centerY) {
  double distance = 0;
  forCorners(box, view, [&](const Vec3<double>& p) {
    const double pixels = std::max(std::abs(p.x) / frame.width, std::abs(p.y) / frame.height) * 2;
    if (perspective_) {
      distance = std::max(distance, p.z + pixels / pixel_);
    } else {
      pixel_ = std::max(pixel_, pixels);
    }
  });
  origin_ += distance * view.back;
}

Camera::Camera(const Eye& eye, const Frame& frame, double fieldOfView)
    : view_(View::from(eye.position - eye.target, eye.up)),
      perspective_(true),
      origin_(eye.position),
      pixel_(pixelAtOne(frame, fieldOfView)),
      centerX_(frame.centerX),
      centerY_(frame.centerY) {}

Camera Camera::zoomed(const Frame& part, const Frame& frame) const {
  auto camera = *this;
  const double factor = std::max(part.width / frame.width, part.height / frame.height);
  camera.pixel_ *= factor;
  camera.centerX_ = frame.centerX + (centerX_ - part.centerX) / factor;
  camera.centerY_ = frame.centerY + (centerY_ - part.centerY) / factor;
  return camera;
}

Ray Camera::ray(double x, double y) const {
  const auto aside = pixel_ * (x - centerX_) * view_.right() + pixel_ * (centerY_ - y) * view_.up;
  if (perspective_) return {origin_, normalized(aside - view_.back)};
  return {origin_ + aside, -view_.back};
}

std::array<double, 2> Camera::project(const Vec3<double>& point) const {
  const auto p = point - origin_;
  const double pixel = pixelSize(perspective_ ? -dot(p, view_.back) : 0);
  return {centerX_ + dot(p, view_.right()) / pixel, centerY_ - dot(p, view_.up) / pixel};
}

double Camera::nearest() const {
  return perspective_ ? 0 : -std::numeric_limits<double>::infinity();
}

double Camera::pixelSize(double along) const {
  return perspective_ ? pixel_ * along : pixel_;
}

}  // namespace detail

}  // namespace cutwater
