#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Lattice/Spine.hpp>

#include <array>

/// Mappings of the unit cube to shapes, for HexahedralCells: plain functions of u in [0, 1]^3 that
/// preserve orientation. Any callable will do as well.
namespace cutwater {

/// Maps to a box: regular cells.
class BoxMapping {
 public:
  /// @throws Error unless the box is finite, with a positive size along each axis.
  explicit BoxMapping(const Box<double>& box);

  /// The image of u, and the axes along which 0 and 1 have the same image.
  [[nodiscard]] Vec3<double> operator()(const Vec3<double>& u) const;
  [[nodiscard]] std::array<bool, 3> closedAxes() const { return {}; }

 private:
  Box<double> box_;
};

/// A pipe about the z axis, from z = 0 to its length, or the part of it between two angles.
struct PipeSegment {
  double innerRadius;
  double outerRadius;
  double length;
  double fromDegrees = 0;  ///< from the x axis towards the y axis
  double toDegrees = 360;
};

/// Maps to a pipe: u.x runs along its radii, u.y around it, u.z along it. Closed around a full
/// turn.
class PipeMapping {
 public:
  /// @throws Error unless 0 < inner radius < outer radius, the length is positive, and angles
  /// ascend by at most a full turn.
  explicit PipeMapping(const PipeSegment& pipe);

  /// The image of u, and the axes along which 0 and 1 have the same image.
  [[nodiscard]] Vec3<double> operator()(const Vec3<double>& u) const;
  [[nodiscard]] std::array<bool, 3> closedAxes() const;

 private:
  PipeSegment pipe_;
};

/// Maps to a solid cylinder about the z axis, from z = 0 to its length. Its cross-section is a
/// square with its sides bent to arcs: x = a sqrt(1 - b^2 / 2), y = b sqrt(1 - a^2 / 2) for a, b in
/// [-1, 1] (Fong 2015, "Analytical methods for squaring the disc": elliptical grid mapping).
class CylinderMapping {
 public:
  /// @throws Error unless both are positive and finite.
  CylinderMapping(double radius, double length);

  /// The image of u, and the axes along which 0 and 1 have the same image.
  [[nodiscard]] Vec3<double> operator()(const Vec3<double>& u) const;
  [[nodiscard]] std::array<bool, 3> closedAxes() const { return {}; }

 private:
  double radius_;
  double length_;
};

/// A lens about the z axis, between two spherical caps, with its middle at the origin.
struct Lens {
  double diameter;
  double centerThickness;
  double frontRadius;  ///< of curvature, of the face towards -z; negative: concave; infinite: flat
  double backRadius;   ///< of the face towards z
};

/// Maps to a lens: u.z runs from its front to its back; the cross-section is that of
/// CylinderMapping.
class LensMapping {
 public:
  /// @throws Error unless diameter and thickness are positive and finite, radii of curvature are at
  /// least half the diameter, and the faces do not meet inside it, so that the rim has a positive
  /// thickness.
  explicit LensMapping(const Lens& lens);

  /// The image of u, and the axes along which 0 and 1 have the same image.
  [[nodiscard]] Vec3<double> operator()(const Vec3<double>& u) const;
  [[nodiscard]] std::array<bool, 3> closedAxes() const { return {}; }

 private:
  Lens lens_;
};

/// Bends the image of another mapping: its z axis, from 0 on, becomes the spine. Where the spine is
/// curved, all points of the shape must be nearer to it than its radius of curvature; otherwise
/// cells turn inside out.
template <typename Mapping>
class AlongSpine {
 public:
  AlongSpine(Spine spine, Mapping mapping)
      : spine_(std::move(spine)), mapping_(std::move(mapping)) {}

  /// The image of u, and the axes along which 0 and 1 have the same image.
  [[nodiscard]] Vec3<double> operator()(const Vec3<double>& u) const {
    const auto straight = mapping_(u);
    const auto frame = spine_.frameAt(straight.z);
    return frame.point + straight.x * frame.normal + straight.y * frame.binormal;
  }
  [[nodiscard]] std::array<bool, 3> closedAxes() const { return mapping_.closedAxes(); }

 private:
  Spine spine_;
  Mapping mapping_;
};

}  // namespace cutwater
