#pragma once

#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/Detail/Curved/NearestFew.hpp>
#include <Cutwater/CutCells/Detail/Curved/RulePoints.hpp>

#include <array>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace cutwater {

/// The connected parts of the fluid in a box, or in a rectangle across an axis. Blocks of spans are
/// one part if a path along the axes, from a span of one to a near one of the other, meets no wall.
class FluidParts {
 public:
  /// `points`: that make up the fluid.
  FluidParts(const FluidField& field, const Box<double>& box, const RulePoints& points);

  [[nodiscard]] std::size_t count() const { return count_; }
  /// That of a block, which a point belongs to; that of the point alone, if it belongs to none.
  [[nodiscard]] std::uint32_t of(std::uint32_t block, const Vec3<double>& point);
  /// The part to which a point in the fluid belongs: that of a near span to which such a path
  /// leads.
  [[nodiscard]] std::uint32_t at(const Vec3<double>& point) const;
  /// Moves a rectangle to another plane across its axis, of the same values in this field.
  void moveTo(int axis, double plane, const FluidField& field);

 private:
  struct Block {
    std::uint32_t number = 0;
    LinePlace place;
    std::size_t count = 0;  // of spans
    FluidSpan longest;
    std::vector<FluidSpan> samples;  // some spans
    Box<double> bounds;              // of these
    std::uint64_t sides = 0;         // of surfaces, by a bit for each
  };
  struct Pair {
    const Block* a = nullptr;
    const Block* b = nullptr;
  };
  /// Those that are neighbours first, then by distance.
  using NearestPairs = NearestFew<std::pair<bool, double>, Pair>;
  struct NearestSpans {
    double distance = std::numeric_limits<double>::infinity();  // squared
    const FluidSpan* a = nullptr;
    const FluidSpan* b = nullptr;
  };
  [[nodiscard]] static NearestSpans nearestSpans(const Block& one, const Block& other);
  [[nodiscard]] std::vector<Block> blocksIn(const RulePoints& points) const;
  void connect(std::span<const Block> blocks);
  void connectAlike(std::span<const Block> blocks, detail::DisjointSets& sets) const;
  void connectParts(std::span<const Block> blocks, detail::DisjointSets& sets) const;
  void tryAll(NearestPairs& pairs, detail::DisjointSets& sets) const;
  [[nodiscard]] bool isClear(const Vec3<double>& from, const Vec3<double>& to,
                             std::span<const int> order, LineCrossings& crossings) const;
  [[nodiscard]] bool isAnyClear(const Vec3<double>& from, const Vec3<double>& to) const;
  [[nodiscard]] bool areConnected(const Block& one, const Block& other) const;

  const FluidField* field_;
  Box<double> box_;
  std::vector<const FluidField*> surfaces_;  // that may meet it, if they are known
  std::size_t count_ = 1;
  std::vector<FluidSpan> spans_;            // if there are several parts
  std::vector<std::uint32_t> partOfBlock_;  // kNone: it has no spans, and was not asked for
};

}  // namespace cutwater
