#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/EdgeCrossings.hpp>

#include <algorithm>
#include <atomic>
#include <limits>

namespace cutwater {

namespace {

using Wide = std::array<std::int64_t, 3>;

/// Nodes along each side of a tile, as a power of two. A thread halves its tile until nothing in a
/// part can be cut, or one node is left. In all grid patches, tiles begin at multiples of their
/// size, so the queries about an edge do not depend on the grid patch.
constexpr int kTileBits = 5;

/// The values to write for an edge.
template <std::floating_point T>
struct EdgeRecord {
  std::uint32_t count = 0;
  T first = std::numeric_limits<T>::quiet_NaN();
  T last = std::numeric_limits<T>::quiet_NaN();
  std::uint32_t firstPatch = kNone;
  std::uint32_t lastPatch = kNone;

  void writeTo(const EdgeCrossingTargets<T>& targets, std::size_t i, std::size_t j,
               std::size_t k) const {
    const auto write = [&](const auto& view, auto value) {
      if (view.data != nullptr) view.at(i, j, k) = value;
    };
    write(targets.count, count);
    write(targets.first, first);
    write(targets.last, last);
    write(targets.firstPatch, firstPatch);
    write(targets.lastPatch, lastPatch);
  }
};

template <std::floating_point T>
class EdgeWalk {
 public:
  EdgeWalk(const SignedDistanceFunction<T>& solid, const GridPatch<T>& gridPatch,
           const std::array<EdgeCrossingTargets<T>, 3>& targets)
      : solid_(solid), gridPatch_(gridPatch), targets_(targets) {
    const auto& [lo, hi] = gridPatch.indices;
    lower_ = {lo.i, lo.j, lo.k};
    upper_ = {hi.i, hi.j, hi.k};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      firstTile_[axis] = lower_[axis] >> kTileBits;  // rounds down, negative ones as well
      tiles_[axis] = static_cast<std::size_t>((upper_[axis] >> kTileBits) - firstTile_[axis] + 1);
    }
  }

  [[nodiscard]] std::size_t tileCount() const { return tiles_[0] * tiles_[1] * tiles_[2]; }

  void walkTile(std::size_t number) {
    Wide first{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto tile = firstTile_[axis] + static_cast<std::int64_t>(number % tiles_[axis]);
      first[axis] = tile << kTileBits;
      number /= tiles_[axis];
    }
    walk(first, kTileBits, {});
  }

  [[nodiscard]] const EdgeCrossingReport& report() const { return report_; }

 private:
  /// Processes the edges that begin at the nodes from `first` on, 2^bits along each axis.
  void walk(const Wide& first, int bits, BoxHint hint) {
    const std::int64_t width = std::int64_t{1} << bits;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (first[axis] > upper_[axis] || first[axis] + width <= lower_[axis]) return;
    }
    const Box<T> box{position(first),
                     position({first[0] + width, first[1] + width, first[2] + width})};
    if (!mayBeCut(solid_.classify(box, &hint))) {
      writeFree(first, width);
    } else if (bits == 0) {
      for (std::size_t axis = 0; axis < 3; ++axis) walkEdge(first, axis);
    } else {
      const auto half = width / 2;
      for (int part = 0; part < 8; ++part) {
        walk({first[0] + ((part & 1) != 0 ? half : 0), first[1] + ((part & 2) != 0 ? half : 0),
              first[2] + ((part & 4) != 0 ? half : 0)},
             bits - 1, hint);
      }
    }
  }

  void writeFree(const Wide& first, std::int64_t width) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Wide begin{};
      Wide end{};
      for (std::size_t a = 0; a < 3; ++a) {
        begin[a] = std::max(first[a], lower_[a]);
        end[a] = std::min(first[a] + width, upper_[a] + (a == axis ? 0 : 1));
      }
      for (auto k = begin[2]; k < end[2]; ++k) {
        for (auto j = begin[1]; j < end[1]; ++j) {
          for (auto i = begin[0]; i < end[0]; ++i) write(axis, {i, j, k}, {});
        }
      }
    }
  }

  void walkEdge(const Wide& node, std::size_t axis) {
    auto next = node;
    ++next[axis];
    if (next[axis] > upper_[axis]) return;
    const Segment<T> edge{position(node), position(next)};
    EdgeRecord<T> record;
    const auto a = static_cast<int>(axis);
    const auto found = solid_.crossings(edge, [&](const Crossing<T>& crossing) {
      record.last = std::clamp(crossing.point[a], edge.start[a], edge.end[a]);
      record.lastPatch = crossing.owner.patch;
      if (record.count == 0) {
        record.first = record.last;
        record.firstPatch = record.lastPatch;
      }
      ++record.count;
      return true;
    });
    report_.crossed += record.count > 0 ? 1 : 0;
    report_.unresolved += found.unresolved > 0 ? 1 : 0;
    write(axis, node, record);
  }

  void write(std::size_t axis, const Wide& node, const EdgeRecord<T>& record) const {
    record.writeTo(targets_[axis], static_cast<std::size_t>(node[0] - lower_[0]),
                   static_cast<std::size_t>(node[1] - lower_[1]),
                   static_cast<std::size_t>(node[2] - lower_[2]));
  }

  /// Position of a node; that of the last index if the node is beyond it.
  [[nodiscard]] Vec3<T> position(const Wide& node) const {
    static constexpr std::int64_t kLast = std::numeric_limits<std::int32_t>::max();
    const auto index = [](std::int64_t i) { return static_cast<std::int32_t>(std::min(i, kLast)); };
    return gridPatch_.level.position({index(node[0]), index(node[1]), index(node[2])});
  }

  const SignedDistanceFunction<T>& solid_;
  const GridPatch<T>& gridPatch_;
  const std::array<EdgeCrossingTargets<T>, 3>& targets_;
  Wide lower_{};
  Wide upper_{};
  Wide firstTile_{};
  std::array<std::size_t, 3> tiles_{};
  EdgeCrossingReport report_;
};

}  // namespace

template <std::floating_point T>
EdgeCrossingReport edgeCrossings(const SignedDistanceFunction<T>& solid,
                                 const GridPatch<T>& gridPatch,
                                 const std::array<EdgeCrossingTargets<T>, 3>& targets,
                                 const EdgeCrossingOptions& options) {
  require(gridPatch.level.centering() == Centering::Node, "edgeCrossings: need a level of nodes");
  require(options.threads >= 0, "edgeCrossings: need threads >= 0",
          Named{"threads", options.threads});
  if (gridPatch.indices.empty()) return {};
  const EdgeWalk<T> walk(solid, gridPatch, targets);
  std::atomic<std::size_t> crossed{0};
  std::atomic<std::size_t> unresolved{0};
  parallelFor(walk.tileCount(), {.threads = options.threads, .progress = options.progress},
              [&](std::size_t begin, std::size_t end) {
                auto own = walk;
                for (auto number = begin; number < end; ++number) own.walkTile(number);
                crossed += own.report().crossed;
                unresolved += own.report().unresolved;
              });
  return {crossed, unresolved};
}

template EdgeCrossingReport edgeCrossings(const SignedDistanceFunction<float>&,
                                          const GridPatch<float>&,
                                          const std::array<EdgeCrossingTargets<float>, 3>&,
                                          const EdgeCrossingOptions&);
template EdgeCrossingReport edgeCrossings(const SignedDistanceFunction<double>&,
                                          const GridPatch<double>&,
                                          const std::array<EdgeCrossingTargets<double>, 3>&,
                                          const EdgeCrossingOptions&);

}  // namespace cutwater
