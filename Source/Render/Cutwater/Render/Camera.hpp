#pragma once

#include <Cutwater/Core/Box.hpp>

#include <array>
#include <string_view>

namespace cutwater {

/// The directions from which a solid is viewed.
struct View {
  Vec3<double> back;  ///< unit, from the solid towards the viewer
  Vec3<double> up;    ///< unit, upwards in the picture, at a right angle to `back`

  /// Unit, to the right in the picture.
  [[nodiscard]] Vec3<double> right() const { return cross(up, back); }

  /// The view from a side, given by a vector of any length. If `up` is parallel to it, y is up
  /// instead (or z, if `side` is along y).
  /// @throws Error unless both are finite and not zero.
  static View from(const Vec3<double>& side, const Vec3<double>& up = {0, 0, 1});
  /// The viewer's direction in degrees: azimuth from +x towards +y, elevation above the xy plane.
  /// @throws Error unless the angles are finite and |elevation| <= 90.
  static View fromAngles(double azimuth, double elevation);
  /// The view from "+x", "-x", "+y", "-y", "+z" or "-z", with z upwards (y for views along z), or
  /// "iso": equally from +x, -y and +z.
  /// @throws Error for any other name.
  static View named(std::string_view name);
};

/// The position of the viewer's eye, for a picture in perspective.
struct Eye {
  Vec3<double> position;
  Vec3<double> target;  ///< the point in the middle of the picture
  Vec3<double> up{0, 0, 1};
};

namespace detail {

/// A straight line from `origin`, along a unit vector.
struct Ray {
  Vec3<double> origin;
  Vec3<double> direction;

  [[nodiscard]] Vec3<double> at(double along) const { return origin + along * direction; }
};

/// The centre and size of a frame in a picture, in pixels.
struct Frame {
  double centerX, centerY;  ///< in pixels
  double width, height;     ///< of the frame that the box must fit into
};

/// The line of sight of every point of a picture, in its continuous pixel coordinates.
class Camera {
 public:
  /// Shows a box as large as the frame allows. `fieldOfView`: angle that the frame's longer side
  /// subtends, in degrees, for perspective; 0: orthographic.
  Camera(const View& view, const Box<double>& box, const Frame& frame, double fieldOfView);
  Camera(const Eye& eye, const Frame& frame, double fieldOfView);

  /// Returns a camera turned to a part of the picture, in its pixels, which it shows as large as
  /// the frame allows.
  [[nodiscard]] Camera zoomed(const Frame& part, const Frame& frame) const;

  [[nodiscard]] Ray ray(double x, double y) const;
  /// The x and y of the ray through a point before the viewer.
  [[nodiscard]] std::array<double, 2> project(const Vec3<double>& point) const;
  /// Distance along a ray from which on it can see anything: -infinity for an orthographic view.
  [[nodiscard]] double nearest() const;
  /// The size of a pixel at this distance along a ray, in the units of the solid.
  [[nodiscard]] double pixelSize(double along) const;
  [[nodiscard]] const View& view() const { return view_; }
  [[nodiscard]] bool isOrthographic() const { return !perspective_; }

 private:
  View view_;
  bool perspective_;
  Vec3<double> origin_;       // the eye, or the point in the middle of the picture
  double pixel_;              // size of a pixel; in perspective, at a distance of 1
  double centerX_, centerY_;  // pixel of the origin, or of the direction straight ahead
};

}  // namespace detail

}  // namespace cutwater
