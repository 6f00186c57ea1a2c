#pragma once

#include <Cutwater/Render/Camera.hpp>
#include <Cutwater/Render/Detail/Oklch.hpp>
#include <Cutwater/Render/Detail/SurfaceSample.hpp>

/// Internals of render(), for its own parts only.
namespace cutwater::detail {

/// Light from the sky around the viewer, brighter from above, a lamp over the viewer's left
/// shoulder, and a weak one from the other side.
class Shading {
 public:
  /// `scale`: scale of lines on the picture; see PictureStyle.
  Shading(const View& view, double scale);

  /// Shades a surface of this colour.
  [[nodiscard]] Rgb surface(const SurfaceSample& sample, const Rgb& color) const;
  /// Shades the face of a cut, flat and hatched, so that it does not look like a surface.
  [[nodiscard]] Rgb cutFace(const Rgb& color, const PicturePoint& at) const;

 private:
  View view_;
  double scale_;
  Vec3<double> key_;
  Vec3<double> fill_;
  Vec3<double> gloss_;  // halfway between lamp and viewer
};

}  // namespace cutwater::detail
