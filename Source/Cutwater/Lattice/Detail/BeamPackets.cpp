#include <Cutwater/Lattice/Detail/BeamPackets.hpp>
#include <Cutwater/Simd/InstructionSet.hpp>

#include <algorithm>

namespace cutwater {

namespace {

using BoundBeams = std::uint32_t(const BeamPacket&, const Vec3<double>&, double, BeamBounds&);

/// Lanes without a beam hold a ball with a radius less than any other.
constexpr float kNoRadius = -0x1p90F;

}  // namespace

#define CUTWATER_DECLARE(set)                                                            \
  namespace set {                                                                        \
  std::uint32_t boundBeams(const BeamPacket&, const Vec3<double>&, double, BeamBounds&); \
  }
CUTWATER_FOR_INSTRUCTION_SETS(CUTWATER_DECLARE)
#undef CUTWATER_DECLARE

std::uint32_t boundBeams(const BeamPacket& packet, const Vec3<double>& q, double slack,
                         BeamBounds& bounds) {
  static BoundBeams* const function = CUTWATER_BEST_OF(BoundBeams, boundBeams);
  return function(packet, q, slack, bounds);
}

namespace {

/// A cone-sphere in the tree's frame.
struct FramedBeam {
  Vec3<double> start, direction;
  double length, radius, narrowing, cosine;
};

template <std::floating_point T>
FramedBeam framed(const ConeSphereBeam<T>& beam, const BvhFrame& frame) {
  const auto hull = beam.profile().hull();
  const Vec3<double> direction(beam.axis().direction());
  const auto start = Vec3<double>(beam.axis().origin()) + double{hull.start} * direction;
  return {frame.toFrame(start),      direction,      frame.scale * hull.height,
          frame.scale * hull.radius, hull.narrowing, hull.cosine};
}

BeamPacket packed(std::span<const FramedBeam> beams) {
  BeamPacket packet{};
  Box<double> box;
  for (const auto& beam : beams) {
    box.extend(beam.start).extend(beam.start + beam.length * beam.direction);
  }
  packet.center = Vec3<float>(box.center());
  packet.radius.fill(kNoRadius);
  packet.cosine.fill(1);
  double reach = 0;
  for (std::size_t lane = 0; lane < beams.size(); ++lane) {
    const auto& beam = beams[lane];
    const auto start = beam.start - Vec3<double>(packet.center);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      packet.start[axis][lane] = static_cast<float>(start[static_cast<int>(axis)]);
      packet.direction[axis][lane] = static_cast<float>(beam.direction[static_cast<int>(axis)]);
    }
    packet.length[lane] = static_cast<float>(beam.length);
    packet.radius[lane] = static_cast<float>(beam.radius);
    packet.narrowing[lane] = static_cast<float>(beam.narrowing);
    packet.cosine[lane] = static_cast<float>(beam.cosine * (1 - 0x1p-22));
    const double radii = beam.radius + std::abs(beam.narrowing) * beam.length;
    reach = std::max(reach, oneNorm(start) + beam.length + radii);
  }
  packet.reach = static_cast<float>(1.001 * reach + 0x1p-60);
  return packet;
}

}  // namespace

template <std::floating_point T>
std::vector<BeamPacket> packBeams(std::span<const ConeSphereBeam<T>> beams,
                                  const BeamBvhArrays& arrays) {
  std::vector<BeamPacket> packets;
  packets.reserve(arrays.slots.size() / BeamPacket::kWidth);
  std::array<FramedBeam, BeamPacket::kWidth> ofLeaf;
  for (std::size_t first = 0; first < arrays.slots.size(); first += BeamPacket::kWidth) {
    std::size_t count = 0;
    for (; count < BeamPacket::kWidth && arrays.slots[first + count] != kNone; ++count) {
      ofLeaf[count] = framed(beams[arrays.slots[first + count]], arrays.frame);
    }
    packets.push_back(packed(std::span(ofLeaf).first(count)));
  }
  return packets;
}

template std::vector<BeamPacket> packBeams(std::span<const ConeSphereBeam<float>>,
                                           const BeamBvhArrays&);
template std::vector<BeamPacket> packBeams(std::span<const ConeSphereBeam<double>>,
                                           const BeamBvhArrays&);

}  // namespace cutwater
