#include <Cutwater/Grid/BlockFill.hpp>
#include <Cutwater/Sdf/Defaults.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

namespace {

/// Points are evaluated in batches of this many; a batch's scratch fits the L1 cache.
constexpr std::size_t kBatch = 256;
/// Points of a tile, as powers of two: large ones are left out at the price of one value, small
/// ones are work for more threads.
constexpr int kBandTileBits = 12;
constexpr int kFullTileBits = 9;
/// Blocks of so many points are not divided: values in more places would cost more than they save.
constexpr int kLeafBits = 6;
/// Others are, in so many halvings.
constexpr int kDivisionBits = 3;

/// The same value at all indices of a block.
template <typename Value>
void fillBlock(const GridView<Value>& view, const GridBlock& block, Value value) {
  if (view.data == nullptr) return;
  const auto& [first, size] = block;
  for (auto k = first[2]; k < first[2] + size[2]; ++k) {
    for (auto j = first[1]; j < first[1] + size[1]; ++j) {
      Value* const row = &view.at(first[0], j, k);
      if (view.stride[0] == 1) {
        std::fill_n(row, size[0], value);
      } else {
        for (std::uint32_t i = 0; i < size[0]; ++i) row[i * view.stride[0]] = value;
      }
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
      : fill_(fill), tile_(tile), batch_(batch) {
    // Of each coordinate only once.
    const auto longest = std::max({tile.size[0], tile.size[1], tile.size[2]});
    for (std::uint32_t n = 0; n < longest; ++n) {
      Offset offset{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        offset[axis] = tile.first[axis] + std::min(n, tile.size[axis] - 1);
      }
      positions_[n] = fill.patch_.level.position(fill.index(offset));
    }
    std::array<Finding, 1> whole{Finding{.block = tile}};
    settle(whole, fill.order_.bits());
  }

 private:
  /// What is known of a block.
  struct Finding {
    GridBlock block;
    std::uint32_t number = 0;  // of its first point in the tile's order
    Box<T> box{};              // around its positions
    bool isBeyond = false;     // all of it
    T sign = 1;                // on which side
    Vec3<T> center{};          // within the radius of it, all is beyond,
    T radiusSquared = -1;      // if it is positive
  };

  [[nodiscard]] Vec3<T> position(const Offset& offset) const {
    return {positions_[offset[0] - tile_.first[0]].x, positions_[offset[1] - tile_.first[1]].y,
            positions_[offset[2] - tile_.first[2]].z};
  }

  /// Fills blocks of 2^bits points, less what is beyond the tile's end.
  void settle(std::span<Finding> blocks, int bits) {
    if (fill_.hasBand()) judge(blocks);
    for (const auto& found : blocks) {
      if (found.isBeyond) {
        fill_.fillConstant(found.block, std::copysign(fill_.limit_, found.sign));
      } else if (bits <= kLeafBits) {
        addPoints(found, bits);
      } else {
        divide(found.number, std::max(bits - kDivisionBits, kLeafBits), bits);
      }
    }
  }

  /// Into blocks of 2^part points.
  void divide(std::uint32_t number, int part, int bits) {
    std::array<Finding, 1U << kDivisionBits> parts;
    std::size_t count = 0;
    const auto end = number + (1U << bits);
    for (; number < end; number += 1U << part) {
      const auto block = blockAt(number, part);
      if (block.size != Offset{}) parts[count++] = {.block = block, .number = number};
    }
    settle(std::span(parts).first(count), part);
  }

  /// What the tile has of a block; of size 0 if nothing.
  [[nodiscard]] GridBlock blockAt(std::uint32_t number, int bits) const {
    const auto offset = fill_.order_.offset(number);
    GridBlock block;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (offset[axis] >= tile_.size[axis]) return {};
      block.first[axis] = tile_.first[axis] + offset[axis];
      block.size[axis] = std::min(fill_.order_.shape(bits)[axis], tile_.size[axis] - offset[axis]);
    }
    return block;
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

  void addPoints(const Finding& found, int bits) {
    for (std::uint32_t n = 0; n < 1U << bits; ++n) {
      auto offset = fill_.order_.offset(found.number + n);
      if (offset[0] >= tile_.size[0] || offset[1] >= tile_.size[1] || offset[2] >= tile_.size[2]) {
        continue;
      }
      for (std::size_t axis = 0; axis < 3; ++axis) offset[axis] += tile_.first[axis];
      const auto point = position(offset);
      if (lengthSquared(point - found.center) < found.radiusSquared) {
        fill_.write(offset, std::copysign(fill_.limit_, found.sign), kNone);
      } else {
        batch_.add(point, offset);
      }
    }
  }

  const BlockFill& fill_;
  GridBlock tile_;
  Batch& batch_;
  std::array<Vec3<T>, TileOrder::kLongest> positions_;
};

template <std::floating_point T>
BlockFill<T>::BlockFill(const SignedDistanceFunction<T>& solid, const Patch<T>& patch,
                        const FillTargets<T>& targets, T limit)
    : solid_(solid),
      patch_(patch),
      targets_(targets),
      limit_(limit),
      promise_(solid.guarantee()),
      order_({double{patch.level.spacing().x}, double{patch.level.spacing().y},
              double{patch.level.spacing().z}},
             {patch.indices.length(0), patch.indices.length(1), patch.indices.length(2)},
             hasBand() ? kBandTileBits : kFullTileBits) {}

template <std::floating_point T>
std::array<std::size_t, 3> BlockFill<T>::tiles() const {
  std::array<std::size_t, 3> tiles{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t edge = tileShape()[axis];
    tiles[axis] = (patch_.indices.length(static_cast<int>(axis)) + edge - 1) / edge;
  }
  return tiles;
}

template <std::floating_point T>
std::size_t BlockFill<T>::tileCount() const {
  const auto [nx, ny, nz] = tiles();
  return nx * ny * nz;
}

template <std::floating_point T>
std::size_t BlockFill<T>::grain() const {
  return std::max<std::size_t>(1, (2 * kBatch) >> order_.bits());
}

template <std::floating_point T>
GridBlock BlockFill<T>::tile(std::size_t number) const {
  const auto counts = tiles();
  GridBlock block;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t edge = tileShape()[axis];
    const auto length = patch_.indices.length(static_cast<int>(axis));
    const auto first = number % counts[axis] * edge;
    number /= counts[axis];
    block.first[axis] = static_cast<std::uint32_t>(first);
    block.size[axis] = static_cast<std::uint32_t>(std::min(edge, length - first));
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
  fillBlock(targets_.distance, block, distance);
  fillBlock(targets_.patch, block, kNone);
}

template <std::floating_point T>
void BlockFill<T>::evaluate(std::span<const Vec3<T>> points,
                            std::span<const Offset> offsets) const {
  if (targets_.patch.data == nullptr || hasBand()) {
    std::array<T, kBatch> distances;
    solid_.signedDistances(points, std::span(distances).first(points.size()), {.threads = 1});
    evaluate(points, offsets, distances);
    return;
  }
  // The closest point tells the distance as well.
  std::array<SurfacePoint<T>, kBatch> hits;
  solid_.closestPoints(points, std::span(hits).first(points.size()), {.threads = 1});
  for (std::size_t n = 0; n < points.size(); ++n) {
    write(offsets[n], hits[n].distance, hits[n].owner.patch);
  }
}

template <std::floating_point T>
void BlockFill<T>::evaluate(std::span<const Vec3<T>> points, std::span<const Offset> offsets,
                            std::span<const T> distances) const {
  std::array<Vec3<T>, kBatch> within;
  std::array<std::size_t, kBatch> which;
  std::size_t count = 0;
  for (std::size_t n = 0; n < points.size(); ++n) {
    if (targets_.patch.data == nullptr || std::abs(distances[n]) > limit_) {
      write(offsets[n], distances[n], kNone);
    } else {
      within[count] = points[n];
      which[count++] = n;
    }
  }
  if (count == 0) return;
  std::array<SurfacePoint<T>, kBatch> hits;
  solid_.closestPoints(std::span<const Vec3<T>>(within).first(count), std::span(hits).first(count),
                       {.threads = 1});
  for (std::size_t i = 0; i < count; ++i) {
    write(offsets[which[i]], distances[which[i]], hits[i].owner.patch);
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
