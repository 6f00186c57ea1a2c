#include <Cutwater/Grid/BlockFill.hpp>
#include <Cutwater/Sdf/Defaults.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

namespace {

/// Points are evaluated in batches of this many; a batch's scratch fits the L1 cache.
constexpr std::size_t kBatch = 256;
/// Edges of tiles: large ones are left out at the price of one value, small ones are work for more
/// threads.
constexpr std::uint32_t kBandTile = 16;
constexpr std::uint32_t kFullTile = 8;
/// Blocks of this edge are not halved: values in more places would cost more than they save.
constexpr std::uint32_t kLeaf = 4;

template <typename Visit>
void forEach(const GridBlock& block, Visit visit) {
  const auto& [first, size] = block;
  for (auto k = first[2]; k < first[2] + size[2]; ++k) {
    for (auto j = first[1]; j < first[1] + size[1]; ++j) {
      for (auto i = first[0]; i < first[0] + size[0]; ++i) visit(Offset{i, j, k});
    }
  }
}

}  // namespace

/// Collects points to evaluate.
template <std::floating_point T>
class BlockFill<T>::Batch {
 public:
  explicit Batch(const BlockFill& fill) : fill_(fill) {}

  void add(const Vec3<T>& point, const Offset& offset) {
    points_[count_] = point;
    offsets_[count_] = offset;
    if (++count_ == kBatch) flush();
  }
  void flush() {
    fill_.evaluate(std::span<const Vec3<T>>(points_).first(count_),
                   std::span<const Offset>(offsets_).first(count_));
    count_ = 0;
  }

 private:
  const BlockFill& fill_;
  std::array<Vec3<T>, kBatch> points_;
  std::array<Offset, kBatch> offsets_;
  std::size_t count_ = 0;
};

/// One tile, being filled.
template <std::floating_point T>
class BlockFill<T>::Tile {
 public:
  Tile(const BlockFill& fill, const GridBlock& tile, Batch& batch)
      : fill_(fill), first_(tile.first), batch_(batch) {
    // Of each coordinate only once.
    const auto longest = std::max({tile.size[0], tile.size[1], tile.size[2]});
    for (std::uint32_t n = 0; n < longest; ++n) {
      Offset offset{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        offset[axis] = first_[axis] + std::min(n, tile.size[axis] - 1);
      }
      positions_[n] = fill.patch_.level.position(fill.index(offset));
    }
    std::array<Finding, 1> whole{Finding{.block = tile}};
    settle(whole, fill.edge_);
  }

 private:
  /// What is known of a block.
  struct Finding {
    GridBlock block;
    Box<T> box{};           // around its positions
    bool isBeyond = false;  // all of it
    T sign = 1;             // on which side
    Vec3<T> center{};       // within the radius of it, all is beyond,
    T radiusSquared = -1;   // if it is positive
  };

  [[nodiscard]] Vec3<T> position(const Offset& offset) const {
    return {positions_[offset[0] - first_[0]].x, positions_[offset[1] - first_[1]].y,
            positions_[offset[2] - first_[2]].z};
  }

  /// Fills blocks of at most this edge.
  void settle(std::span<Finding> blocks, std::uint32_t edge) {
    if (fill_.hasBand()) judge(blocks);
    for (const auto& found : blocks) {
      if (found.isBeyond) {
        fill_.fillConstant(found.block, std::copysign(fill_.limit_, found.sign));
      } else if (edge <= kLeaf) {
        addPoints(found);
      } else {
        halve(found.block, edge / 2);
      }
    }
  }

  void halve(const GridBlock& block, std::uint32_t half) {
    std::array<Finding, 8> parts;
    std::size_t count = 0;
    for (std::uint32_t n = 0; n < 8; ++n) {
      GridBlock part = block;
      bool isEmpty = false;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool isUpper = (n >> axis & 1U) != 0;
        const auto lower = std::min(half, block.size[axis]);
        part.first[axis] += isUpper ? lower : 0;
        part.size[axis] = isUpper ? block.size[axis] - lower : lower;
        isEmpty = isEmpty || part.size[axis] == 0;
      }
      if (!isEmpty) parts[count++].block = part;
    }
    settle(std::span(parts).first(count), half);
  }

  /// Which of at most 8 blocks are beyond the limit.
  void judge(std::span<Finding> blocks) const {
    std::array<Vec3<T>, 8> centers;
    std::array<T, 8> values;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const auto& [first, size] = blocks[i].block;
      const Offset last{first[0] + size[0] - 1, first[1] + size[1] - 1, first[2] + size[2] - 1};
      // Coordinates grow with the index, rounding included: no position is outside.
      blocks[i].box = {position(first), position(last)};
      centers[i] = blocks[i].box.center();
    }
    if (fill_.promise_.lipschitz) {
      fill_.solid_.signedDistances(std::span<const Vec3<T>>(centers).first(blocks.size()),
                                   std::span(values).first(blocks.size()), {.threads = 1});
    }
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const auto box = OrientedBox<T>::of(blocks[i].box);
      if (fill_.promise_.lipschitz && box.isWithin(fill_.promise_.domain)) {
        conclude(blocks[i], box, values[i]);
      } else {
        const auto range = fill_.solid_.bounds(blocks[i].box);
        blocks[i].isBeyond = range.lower > fill_.limit_ || range.upper < -fill_.limit_;
        blocks[i].sign = range.lower;
      }
    }
  }

  /// From the value in the middle.
  void conclude(Finding& found, const OrientedBox<T>& box, T atCenter) const {
    const auto range = boundsAround(atCenter, box, fill_.promise_);
    const T missing = fill_.limit_ - (atCenter < 0 ? -range.upper : range.lower);
    found.isBeyond = missing < 0;
    found.sign = atCenter;
    // The bound for all within r of the centre exceeds that for all within box.radius() by the
    // Lipschitz constant times the difference, or more.
    constexpr T kOutward = 1 + 8 * std::numeric_limits<T>::epsilon();
    const T radius = box.radius() - kOutward * (missing / *fill_.promise_.lipschitz);
    found.center = box.center;
    if (radius > 0) found.radiusSquared = radius * radius / (kOutward * kOutward);
  }

  void addPoints(const Finding& found) {
    forEach(found.block, [&](const Offset& offset) {
      const auto point = position(offset);
      if (lengthSquared(point - found.center) < found.radiusSquared) {
        fill_.write(offset, std::copysign(fill_.limit_, found.sign), kNone);
      } else {
        batch_.add(point, offset);
      }
    });
  }

  const BlockFill& fill_;
  Offset first_;
  Batch& batch_;
  std::array<Vec3<T>, std::max(kBandTile, kFullTile)> positions_;
};

template <std::floating_point T>
BlockFill<T>::BlockFill(const SignedDistanceFunction<T>& solid, const Patch<T>& patch,
                        const FillTargets<T>& targets, T limit)
    : solid_(solid), patch_(patch), targets_(targets), limit_(limit), promise_(solid.guarantee()) {
  edge_ = hasBand() ? kBandTile : kFullTile;
}

template <std::floating_point T>
std::size_t BlockFill<T>::tileCount() const {
  std::size_t count = 1;
  for (int axis = 0; axis < 3; ++axis) count *= (patch_.indices.length(axis) + edge_ - 1) / edge_;
  return count;
}

template <std::floating_point T>
std::size_t BlockFill<T>::grain() const {
  std::size_t inTile = 1;
  for (int axis = 0; axis < 3; ++axis) {
    inTile *= std::clamp<std::size_t>(patch_.indices.length(axis), 1, edge_);
  }
  return (2 * kBatch + inTile - 1) / inTile;
}

template <std::floating_point T>
GridBlock BlockFill<T>::tile(std::size_t number) const {
  GridBlock block;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto length = patch_.indices.length(static_cast<int>(axis));
    const auto tiles = (length + edge_ - 1) / edge_;
    const auto first = number % tiles * edge_;
    number /= tiles;
    block.first[axis] = static_cast<std::uint32_t>(first);
    block.size[axis] = static_cast<std::uint32_t>(std::min<std::size_t>(edge_, length - first));
  }
  return block;
}

template <std::floating_point T>
void BlockFill<T>::fillTiles(std::size_t begin, std::size_t end) const {
  Batch batch(*this);
  for (auto number = begin; number < end; ++number) Tile(*this, tile(number), batch);
  batch.flush();
}

template <std::floating_point T>
Index3 BlockFill<T>::index(const Offset& offset) const {
  const auto along = [](std::int32_t lo, std::uint32_t n) {
    return static_cast<std::int32_t>(std::int64_t{lo} + n);
  };
  const auto& lo = patch_.indices.lo;
  return {along(lo.i, offset[0]), along(lo.j, offset[1]), along(lo.k, offset[2])};
}

template <std::floating_point T>
void BlockFill<T>::fillConstant(const GridBlock& block, T distance) const {
  forEach(block, [&](const Offset& offset) { write(offset, distance, kNone); });
}

template <std::floating_point T>
void BlockFill<T>::evaluate(std::span<const Vec3<T>> points,
                            std::span<const Offset> offsets) const {
  const bool wantsPatch = targets_.patch.data != nullptr;
  const bool isByPoint = wantsPatch && !hasBand();  // the closest point tells the distance as well
  std::array<T, kBatch> distances;
  if (!isByPoint) {
    solid_.signedDistances(points, std::span(distances).first(points.size()), {.threads = 1});
  }
  for (std::size_t n = 0; n < points.size(); ++n) {
    if (!wantsPatch || (hasBand() && std::abs(distances[n]) > limit_)) {
      write(offsets[n], distances[n], kNone);
    } else {
      const auto hit = solid_.closestPoint(points[n]);
      write(offsets[n], isByPoint ? hit.distance : distances[n], hit.owner.patch);
    }
  }
}

template <std::floating_point T>
void BlockFill<T>::write(const Offset& offset, T distance, std::uint32_t patch) const {
  const auto [i, j, k] = offset;
  if (targets_.distance.data != nullptr) {
    targets_.distance.at(i, j, k) =
        std::abs(distance) > limit_ ? std::copysign(limit_, distance) : distance;
  }
  if (targets_.patch.data != nullptr) targets_.patch.at(i, j, k) = patch;
}

template class BlockFill<float>;
template class BlockFill<double>;

}  // namespace cutwater::detail
