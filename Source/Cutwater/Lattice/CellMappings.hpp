#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Lattice/Spine.hpp>

#include <array>

/// Mappings of the unit cube to shapes, for HexahedralCells: plain functions of u in [0, 1]^3, that
/// keep right-handed what is right-handed. Any callable will do as well.
namespace cutwater {

/// To a box: regular cells.
class BoxMapping {
 public:
  /// @throws Error unless the box is finite, with some size along each axis.
  explicit BoxMapping(const Box<double>& box);

  /// Where u goes to, and the axes along which 0 and 1 go to the same place.
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

/// To a pipe: u.x is along its radii, u.y round it, u.z along it. Closed round a full turn.
class PipeMapping {
 public:
  /// @throws Error unless 0 < inner radius < outer radius, the length is positive, and angles
  /// ascend by at most a full turn.
  explicit PipeMapping(const PipeSegment& pipe);

  /// Where u goes to, and the axes along which 0 and 1 go to the same place.
  [[nodiscard]] Vec3<double> operator()(const Vec3<double>& u) const;
  [[nodiscard]] std::array<bool, 3> closedAxes() const;

 private:
  PipeSegment pipe_;
};

/// To a solid cylinder about the z axis, from z = 0 to its length. Its section is a square with
/// its sides bent to arcs: x = a sqrt(1 - b^2 / 2), y = b sqrt(1 - a^2 / 2) for a, b in [-1, 1]
/// (Fong 2015, "Analytical methods for squaring the disc": elliptical grid mapping).
class CylinderMapping {
 public:
  /// @throws Error unless both are positive and finite.
  CylinderMapping(double radius, double length);

  /// Where u goes to, and the axes along which 0 and 1 go to the same place.
  [[nodiscard]] Vec3<double> operator()(const Vec3<double>& u) const;
  [[nodiscard]] std::array<bool, 3> closedAxes() const { return {}; }

 private:
  double radius_;
  double length_;
};

/// A lens about the z axis, between two spherical caps, its middle at the origin.
struct Lens {
  double diameter;
  double centerThickness;
  double frontRadius;  ///< of curvature, of the face towards -z; negative: concave; infinite: flat
  double backRadius;   ///< of the face towards z
};

/// To a lens: u.z is from its front to its back, the section is that of CylinderMapping.
class LensMapping {
 public:
  /// @throws Error unless diameter and thickness are positive and finite, radii of curvature are at
  /// least half the diameter, and the faces do not meet within it: the rim has some thickness.
  explicit LensMapping(const Lens& lens);

  /// Where u goes to, and the axes along which 0 and 1 go to the same place.
  [[nodiscard]] Vec3<double> operator()(const Vec3<double>& u) const;
  [[nodiscard]] std::array<bool, 3> closedAxes() const { return {}; }

 private:
  Lens lens_;
};

/// What another mapping maps to, bent: its z axis, from 0 on, becomes the spine. Points beyond
/// where the spine curves fold back: the radii there must be smaller than those of its curvature.
template <typename Mapping>
class AlongSpine {
 public:
  AlongSpine(Spine spine, Mapping mapping)
      : spine_(std::move(spine)), mapping_(std::move(mapping)) {}

  /// Where u goes to, and the axes along which 0 and 1 go to the same place.
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
