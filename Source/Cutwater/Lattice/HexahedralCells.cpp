#include <Cutwater/Core/Detail/MixedBits.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/HexahedralCells.hpp>

#include <algorithm>

namespace cutwater {

namespace {

/// The number after x of SplitMix64.
std::uint64_t after(std::uint64_t x) {
  return detail::mixed(x + detail::kGoldenIncrement);
}

/// A point of the unit ball, uniformly distributed: the first that lies in it of a sequence of
/// points of the cube around it.
Vec3<double> inUnitBall(const std::array<std::int64_t, 3>& corner, std::uint64_t seed) {
  std::uint64_t state = after(seed);
  for (const auto index : corner) state = after(state ^ static_cast<std::uint64_t>(index));
  const auto next = [&] {
    state = after(state);
    return 0x1p-52 * static_cast<double>(state >> 11U) - 1;  // in [-1, 1)
  };
  for (;;) {
    const double x = next();
    const double y = next();
    const Vec3<double> p{x, y, next()};
    if (lengthSquared(p) <= 1) return p;
  }
}

Vec3<double> between(const Vec3<double>& a, const Vec3<double>& b, double t) {
  return (1 - t) * a + t * b;  // a and b themselves, to the bit, at 0 and 1
}

}  // namespace

HexahedralCells::HexahedralCells(const Counts& count, Mapping mapping,
                                 const std::array<bool, 3>& closed)
    : count_(count), closed_(closed) {
  double corners = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t least = closed[axis] ? 3 : 1;
    require(count[axis] >= least,
            "HexahedralCells: need a cell along each axis, and 3 along a closed one",
            Named{"axis", axis}, Named{"count", count[axis]});
    corners *= 1.0 + count[axis];
  }
  if (corners > 0x1p31) {
    throw Error(ErrorKind::Limit, "HexahedralCells: need at most 2^31 corners");
  }
  requireClosed(mapping);
  corners_.resize(static_cast<std::size_t>(cornersAlong(0) * cornersAlong(1) * cornersAlong(2)));
  forEachCorner([&](const Corner& at, Vec3<double>& corner) {
    Vec3<double> u;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      u[static_cast<int>(axis)] = static_cast<double>(at[axis]) / count_[axis];
    }
    corner = mapping(u);
    require(isFinite(corner), "HexahedralCells: need a mapping to finite points", Named{"u", u});
  });
  requireNotTurned();
}

template <typename Visit>
void HexahedralCells::forEachCorner(Visit&& visit) {
  std::size_t index = 0;
  for (std::int64_t z = 0; z < cornersAlong(2); ++z) {
    for (std::int64_t y = 0; y < cornersAlong(1); ++y) {
      for (std::int64_t x = 0; x < cornersAlong(0); ++x) {
        visit(Corner{x, y, z}, corners_[index++]);
      }
    }
  }
}

void HexahedralCells::requireClosed(Mapping mapping) const {
  constexpr double kSame = 1e-9;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!closed_[i]) continue;
    const auto axis = static_cast<int>(i);
    Vec3<double> begin{0.375, 0.375, 0.375};
    Vec3<double> end = begin;
    Vec3<double> middle = begin;
    begin[axis] = 0;
    end[axis] = 1;
    middle[axis] = 0.5;
    const auto from = mapping(begin);
    require(length(mapping(end) - from) <= kSame * length(mapping(middle) - from),
            "HexahedralCells: need a mapping that is the same at 0 and 1 of a closed axis",
            Named{"axis", axis});
  }
}

void HexahedralCells::requireNotTurned() const {
  const double sign = detail::firstJacobian(cornersOf({})) < 0 ? -1 : 1;
  for (std::int64_t z = 0; z < count_[2]; ++z) {
    for (std::int64_t y = 0; y < count_[1]; ++y) {
      for (std::int64_t x = 0; x < count_[0]; ++x) {
        require(detail::hasPositiveJacobian(cornersOf({x, y, z}), sign),
                "HexahedralCells: need cells that are neither flat nor turned inside out",
                Named{"cell", Corner{x, y, z}});
      }
    }
  }
}

HexahedralCells HexahedralCells::withNoise(const NodeNoise& noise) const {
  require(noise.amplitude >= 0 && std::isfinite(noise.amplitude),
          "HexahedralCells: need an amplitude of noise that is finite and not negative",
          Named{"amplitude", noise.amplitude});
  auto moved = *this;
  moved.forEachCorner([&](const Corner& at, Vec3<double>& corner) {
    if (noise.keepsBoundary && isOnBoundary(at)) return;
    const double unit = noise.unit == NoiseUnit::ShortestEdge ? shortestEdgeAt(at) : 1.0;
    corner += noise.amplitude * unit * inUnitBall(at, noise.seed);
  });
  moved.requireNotTurned();
  return moved;
}

bool HexahedralCells::isOnBoundary(const Corner& corner) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!closed_[axis] && (corner[axis] == 0 || corner[axis] == count_[axis])) return true;
  }
  return false;
}

double HexahedralCells::shortestEdgeAt(const Corner& at) const {
  const auto& here = corner(at[0], at[1], at[2]);
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const std::int64_t step : {-1, 1}) {
      auto other = at;
      other[axis] += step;
      if (!closed_[axis] && (other[axis] < 0 || other[axis] > count_[axis])) continue;
      shortest = std::min(shortest, length(corner(other[0], other[1], other[2]) - here));
    }
  }
  return shortest;
}

const Vec3<double>& HexahedralCells::corner(std::int64_t i, std::int64_t j, std::int64_t k) const {
  const auto wrapped = [&](std::int64_t index, std::size_t axis) {
    const std::int64_t count = count_[axis];
    return closed_[axis] ? (index % count + count) % count : index;
  };
  const auto index =
      wrapped(i, 0) + cornersAlong(0) * (wrapped(j, 1) + cornersAlong(1) * wrapped(k, 2));
  return corners_[static_cast<std::size_t>(index)];
}

std::array<Vec3<double>, 8> HexahedralCells::cornersOf(const Corner& cell) const {
  std::array<Vec3<double>, 8> corners;
  for (int i = 0; i < 8; ++i) {
    corners[static_cast<std::size_t>(i)] =
        corner(cell[0] + (i & 1), cell[1] + (i >> 1 & 1), cell[2] + (i >> 2 & 1));
  }
  return corners;
}

Vec3<double> HexahedralCells::at(const Vec3<double>& inCells) const {
  Corner cell;
  Vec3<double> local;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<int>(i);
    double first = std::floor(inCells[axis]);
    if (!closed_[i]) first = std::clamp(first, 0.0, count_[i] - 1.0);
    cell[i] = static_cast<std::int64_t>(first);
    local[axis] = inCells[axis] - first;
  }
  const auto c = cornersOf(cell);
  const auto alongX = [&](std::size_t i) { return between(c[i], c[i + 1], local.x); };
  const auto lower = between(alongX(0), alongX(2), local.y);
  const auto upper = between(alongX(4), alongX(6), local.y);
  return between(lower, upper, local.z);
}

}  // namespace cutwater
