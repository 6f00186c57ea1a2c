#pragma once

#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Lattice/Beam.hpp>

namespace cutwater {

/// The cone-spheres of a leaf in single precision, component by component. A search reads these
/// before it evaluates in full the few that may be the nearest.
///
/// Lengths are in the tree's frame. Unused lanes are far away from everything.
struct alignas(64) BeamPacket {
  static constexpr int kWidth = 16;
  using Lanes = std::array<float, kWidth>;

  std::array<Lanes, 3> start;      ///< of the axis, relative to `center`
  std::array<Lanes, 3> direction;  ///< of unit length
  Lanes length;
  Lanes radius;     ///< at the start
  Lanes narrowing;  ///< by how much the radius shrinks per length
  Lanes cosine;     ///< of the angle between the axis and the flank; rounded down
  Vec3<float> center;
  float reach = 0;                         ///< exceeds coordinates, lengths and radii
  std::array<std::uint32_t, 12> unused{};  ///< pads the cache line with known bytes
};

/// The tree of round beams.
using BeamBvhArrays = BvhArrays<16, BeamPacket::kWidth>;

/// One packet for each leaf of the tree.
template <std::floating_point T>
[[nodiscard]] std::vector<BeamPacket> packBeams(std::span<const ConeSphereBeam<T>> beams,
                                                const BeamBvhArrays& arrays);

/// Bounds of the values of a packet's beams at a point, in the tree's frame.
struct BeamBounds {
  alignas(64) std::array<float, BeamPacket::kWidth> lower;
  /// Upper bound of the least value of all: the one passed in, or one from this packet's beams.
  double least;
};

/// Bounds the values at `q`, whose coordinates in the tree's frame must not exceed 2^58. Returns a
/// bit for each lane whose value may be within `slack` of the least. Compiled for each instruction
/// set from one source: BeamPackets.inl.
[[nodiscard]] std::uint32_t boundBeams(const BeamPacket& packet, const Vec3<double>& q,
                                       double slack, BeamBounds& bounds);

extern template std::vector<BeamPacket> packBeams(std::span<const ConeSphereBeam<float>>,
                                                  const BeamBvhArrays&);
extern template std::vector<BeamPacket> packBeams(std::span<const ConeSphereBeam<double>>,
                                                  const BeamBvhArrays&);

}  // namespace cutwater
