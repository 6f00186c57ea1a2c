#pragma once

#include <Cutwater/Core/Box.hpp>

#include <string_view>

namespace cutwater {

/// The directions in which a solid is seen.
struct View {
  Vec3<double> back;  ///< unit, from the solid towards the viewer
  Vec3<double> up;    ///< unit, upwards in the picture, at a right angle to `back`

  /// Unit, to the right in the picture.
  [[nodiscard]] Vec3<double> right() const { return cross(up, back); }

  /// From this side, of any length. Where `up` points along it, y is up instead (or z, for that).
  /// @throws Error unless both are finite and not zero.
  static View from(const Vec3<double>& side, const Vec3<double>& up = {0, 0, 1});
  /// The viewer's direction in degrees: azimuth from +x towards +y, elevation above the xy plane.
  /// @throws Error unless the angles are finite and |elevation| <= 90.
  static View fromAngles(double azimuth, double elevation);
  /// From "+x", "-x", "+y", "-y", "+z", "-z", with z upwards (y, where z is along the view), or
  /// "iso": from +x, -y and +z alike.
  /// @throws Error for any other name.
  static View named(std::string_view name);
};

/// Where the viewer's eye is, for a picture in perspective.
struct Eye {
  Vec3<double> position;
  Vec3<double> target;  ///< what is in the middle of the picture
  Vec3<double> up{0, 0, 1};
};

namespace detail {

/// A straight line from `origin`, along a unit vector.
struct Ray {
  Vec3<double> origin;
  Vec3<double> direction;

  [[nodiscard]] Vec3<double> at(double along) const { return origin + along * direction; }
};

/// How many pixels of a picture there are, and which of them is where.
struct Frame {
  double centerX, centerY;  ///< in pixels
  double width, height;     ///< of what the box must fit into
};

/// The line of sight of every point of a picture, in its continuous pixel coordinates.
class Camera {
 public:
  /// Shows a box as large as the frame allows. `fieldOfView`: the angle of the frame's longer side
  /// in degrees, for perspective; 0: orthographic.
  Camera(const View& view, const Box<double>& box, const Frame& frame, double fieldOfView);
  Camera(const Eye& eye, const Frame& frame, double fieldOfView);

  /// Turns to a part of the picture, in its pixels, and shows that as large as the frame allows.
  [[nodiscard]] Camera zoomed(const Frame& part, const Frame& frame) const;

  [[nodiscard]] Ray ray(double x, double y) const;
  /// Where a ray begins to see: -infinity if the viewer is far away.
  [[nodiscard]] double nearest() const;
  /// The size of a pixel at this distance along a ray, in the units of the solid.
  [[nodiscard]] double pixelSize(double along) const;
  [[nodiscard]] const View& view() const { return view_; }
  [[nodiscard]] bool isOrthographic() const { return !perspective_; }

 private:
  View view_;
  bool perspective_;
  Vec3<double> origin_;       // the eye, or the point in the middle of the picture
  double pixel_;              // its size; in perspective, at a distance of 1
  double centerX_, centerY_;  // the pixel of the origin, or of what lies straight ahead of it
};

}  // namespace detail

}  // namespace cutwater
