#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace cutwater {

/// Handles into a mesh: 32-bit indices that cannot be mistaken for one another.
enum class VertexId : std::uint32_t {};
enum class HalfEdgeId : std::uint32_t {};
enum class FaceId : std::uint32_t {};

/// The three corners of a triangle, counter-clockwise seen from outside.
using TriangleCorners = std::array<VertexId, 3>;

/// No half-edge, no face: kNone as a handle.
inline constexpr HalfEdgeId kNoHalfEdge{kNone};
inline constexpr FaceId kNoFace{kNone};

/// One of the three handle types.
template <typename Id>
concept MeshId =
    std::same_as<Id, VertexId> || std::same_as<Id, HalfEdgeId> || std::same_as<Id, FaceId>;

/// The handle's index into arrays of the mesh.
template <MeshId Id>
[[nodiscard]] constexpr std::uint32_t index(Id id) {
  return static_cast<std::uint32_t>(id);
}

/// The handles first, first + 1, ..., last - 1.
template <MeshId Id>
class IdRange {
 public:
  /// Goes from each handle to the next.
  class Iterator {
   public:
    using value_type = Id;
    using difference_type = std::ptrdiff_t;

    constexpr Iterator() = default;
    constexpr explicit Iterator(std::uint32_t at) : at_(at) {}
    constexpr Id operator*() const { return Id{at_}; }
    constexpr Iterator& operator++() {
      ++at_;
      return *this;
    }
    constexpr Iterator operator++(int) { return Iterator(at_++); }
    constexpr bool operator==(const Iterator&) const = default;

   private:
    std::uint32_t at_ = 0;
  };

  constexpr IdRange(std::uint32_t first, std::uint32_t last) : first_(first), last_(last) {}
  [[nodiscard]] constexpr Iterator begin() const { return Iterator(first_); }
  [[nodiscard]] constexpr Iterator end() const { return Iterator(last_); }
  [[nodiscard]] constexpr std::uint32_t size() const { return last_ - first_; }
  [[nodiscard]] constexpr bool empty() const { return first_ == last_; }

 private:
  std::uint32_t first_;
  std::uint32_t last_;
};

/// The elements of a range as mapped by `map`, without those that it maps to "none".
///
/// A view: it holds iterators into the mesh, which must outlive it. (std::views would do, but costs
/// a third of a second of compile time for every file that includes a mesh.)
template <std::forward_iterator Source, typename Map>
class MappedRange {
 public:
  /// The result of `map`.
  using Id = decltype(std::declval<const Map&>()(*std::declval<Source>()));

  /// Skips elements that are mapped to "none".
  class Iterator {
   public:
    using value_type = Id;
    using difference_type = std::ptrdiff_t;

    constexpr Iterator() = default;
    constexpr Iterator(Source at, const MappedRange* range) : at_(at), range_(range) { skip(); }
    constexpr Id operator*() const { return id_; }
    constexpr Iterator& operator++() {
      ++at_;
      skip();
      return *this;
    }
    constexpr Iterator operator++(int) {
      Iterator before = *this;
      ++*this;
      return before;
    }
    constexpr bool operator==(const Iterator& other) const { return at_ == other.at_; }

   private:
    constexpr void skip() {
      for (; at_ != range_->last_; ++at_) {
        id_ = range_->map_(*at_);
        if (id_ != Id{kNone}) return;
      }
    }

    Source at_{};
    const MappedRange* range_ = nullptr;
    Id id_{kNone};
  };

  constexpr MappedRange(Source first, Source last, Map map)
      : first_(first), last_(last), map_(map) {}
  [[nodiscard]] constexpr Iterator begin() const { return Iterator(first_, this); }
  [[nodiscard]] constexpr Iterator end() const { return Iterator(last_, this); }

 private:
  Source first_;
  Source last_;
  Map map_;
};

}  // namespace cutwater
