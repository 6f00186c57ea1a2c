#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/Triangles/OpenEdges.hpp>

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace cutwater::detail {

/// The boundary of the faces that would close a surface: every open edge in the opposite direction,
/// as often as it is open. At each vertex as many edges begin as end, so a walk along them returns
/// to the vertex where it started.
class RimLoops {
 public:
  explicit RimLoops(std::span<const OpenEdge> edges) {
    struct Directed {
      std::uint32_t from, to;
    };
    std::vector<Directed> directed;
    for (const auto& e : edges) {
      const bool upward = e.multiplicity < 0;
      const Directed one = upward ? Directed{e.lower, e.upper} : Directed{e.upper, e.lower};
      directed.insert(directed.end(), static_cast<std::size_t>(std::abs(e.multiplicity)), one);
    }
    std::ranges::stable_sort(directed, {}, &Directed::from);
    for (const auto& d : directed) {
      if (vertices_.empty() || vertices_.back() != d.from) {
        vertices_.push_back(d.from);
        next_.push_back(targets_.size());
      }
      targets_.push_back(d.to);
    }
    for (auto& target : targets_) {
      target = static_cast<std::uint32_t>(std::ranges::lower_bound(vertices_, target) -
                                          vertices_.begin());
    }
    ends_.assign(next_.begin() + (next_.empty() ? 0 : 1), next_.end());
    ends_.push_back(targets_.size());
    place_.assign(vertices_.size(), kNone);
  }

  /// The vertices at which edges begin, in ascending order: loops contain indices into this list.
  [[nodiscard]] const std::vector<std::uint32_t>& vertices() const { return vertices_; }

  /// Visits loops that together use every edge once; none passes a vertex twice.
  template <typename Visit>
  void run(Visit&& visit) {
    for (std::uint32_t start = 0; start < vertices_.size(); ++start) {
      enter(start);
      while (next_[path_.back()] < ends_[path_.back()]) {
        const auto to = targets_[next_[path_.back()]++];
        if (place_[to] == kNone) {
          enter(to);
        } else {
          visit(std::span<const std::uint32_t>(path_).subspan(place_[to]));
          leaveUntil(to);
        }
      }
      assert(path_.size() == 1);
      place_[start] = kNone;
      path_.clear();
    }
  }

 private:
  void enter(std::uint32_t vertex) {
    place_[vertex] = static_cast<std::uint32_t>(path_.size());
    path_.push_back(vertex);
  }
  void leaveUntil(std::uint32_t vertex) {
    for (; path_.back() != vertex; path_.pop_back()) place_[path_.back()] = kNone;
  }

  std::vector<std::uint32_t> vertices_;
  std::vector<std::uint32_t> targets_;  // of the edges, by the vertex at which they begin
  std::vector<std::size_t> next_;       // per vertex: the first edge not yet used ...
  std::vector<std::size_t> ends_;       // ... and the end of its edges
  std::vector<std::uint32_t> path_;
  std::vector<std::uint32_t> place_;  // per vertex: its index in the path
};

}  // namespace cutwater::detail
