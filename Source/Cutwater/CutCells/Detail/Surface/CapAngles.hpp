#pragma once

#include <Cutwater/Bvh/Detail/BinaryBvh.hpp>
#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/CutCells/Detail/Surface/CapPlanes.hpp>
#include <Cutwater/CutCells/Detail/Surface/CutSurface.hpp>
#include <Cutwater/Triangles/QueryBox.hpp>
#include <Cutwater/Triangles/WindingNumber.hpp>

namespace cutwater {

/// Whether there is a point in a box where a body closed by caps, and the winding number of the
/// open surface, disagree.
enum class Disagreement : std::uint8_t { None, Possible, Found };

/// Triangles of caps, and the solid angle that they subtend, in turns of 4 pi: positive where they
/// are seen from within.
class CapSheet {
 public:
  CapSheet(const HoleCaps& caps, const CapGroup& group);

  [[nodiscard]] bool isFlat() const { return isFlat_; }
  /// Whether a triangle may meet the box.
  [[nodiscard]] bool mayMeet(const Box<double>& box, const QueryBox& query) const;
  /// Encloses the solid angle in the middle of a box that no triangle meets, and in all of it.
  struct Angles {
    Interval<double> center;
    Interval<double> all;
  };
  [[nodiscard]] Angles anglesIn(const Box<double>& box) const;

 private:
  [[nodiscard]] bool mayMeet(const detail::BinaryNode& node, const Box<double>& box,
                             const QueryBox& query) const;
  [[nodiscard]] WindingNumber<double> winding() const {
    return {positions_, triangles_, bvh_.tree(), arrays_.moments, arrays_.edges, arrays_.openEdges};
  }

  bool isFlat_;
  std::vector<Vec3<double>> positions_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Box<double>> boxes_;
  detail::BinaryBvh boxTree_;
  BvhArrays<WindingTree::kArity, WindingTree::kLeafWidth> bvh_;
  WindingArrays arrays_;
};

/// Finds where a body closed by caps and the winding number of its open surface disagree.
///
/// The winding number W of the surface with its caps is a whole number, and the body is where it is
/// 1 at least. That of the open surface is W - s, s being the solid angle of the caps: they
/// disagree only where s is beyond 1/2, in the body, or below -1/2, outside of it. Away from caps,
/// s changes no faster than the edges of their rims let it (Biot and Savart: see
/// WindingNumber::gradientBound()); and whatever the point, caps in one plane have at most 1/2, so
/// that these alone never disagree.
class CapAngles {
 public:
  /// How far beyond 1/2 the angle must be. By the same amount, the sheet that closes the hole of a
  /// MeshSDF is in front of a flat cap.
  static constexpr double kMargin = WindingNumber<double>::kThreshold - 0.5;

  /// Caps in the world, of a surface in this frame.
  CapAngles(const HoleCaps& caps, const CutFrame& frame);

  /// Whether a box has points in the body, or outside of it.
  struct Sides {
    bool inside = true;
    bool outside = true;
  };
  /// In a box in the frame.
  [[nodiscard]] Disagreement in(const Box<double>& box, Sides sides) const;

 private:
  std::vector<CapSheet> sheets_;
  std::vector<CapSheet> whole_;  // all of them as one, if there are several
  Box<double> reach_;
};

}  // namespace cutwater
