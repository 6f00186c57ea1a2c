#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Surface/Detail/ContactSearch.hpp>
#include <Cutwater/Surface/Detail/PairSearch.hpp>
#include <Cutwater/Triangles/TriangleIntersection.hpp>

#include <algorithm>
#include <atomic>

namespace cutwater {

namespace {

using CornerIds = std::array<std::uint32_t, 3>;

/// Takes the pairs that a search finds, from several threads.
class ContactCount {
 public:
  explicit ContactCount(const PairTest& pairs) : pairs_(pairs), touchedEdges_(pairs.triangles()) {
    for (std::uint32_t t = 0; t < touchedEdges_.size(); ++t) {
      if (!pairs.hasArea(t)) touchedEdges_[t] = 7;
    }
  }

  /// Returns whether to continue.
  bool take(std::uint32_t first, std::uint32_t second) {
    if (meetWithin(pointsOf(first), pointsOf(second))) return isFew(++overlaps_);
    mark(first, second);
    return isFew(++touches_);
  }

  [[nodiscard]] SurfaceContacts result() {
    const bool isCounted = isFew(overlaps_) && isFew(touches_);
    return {isCounted ? overlaps_.load() : SurfaceContacts::kMost, std::move(touchedEdges_)};
  }

 private:
  static bool isFew(std::size_t count) { return count < SurfaceContacts::kMost; }

  [[nodiscard]] const Vec3<double>& corner(std::uint32_t t, std::size_t i) const {
    return pairs_.position(pairs_.corners(t)[i % 3]);
  }
  [[nodiscard]] std::array<Vec3<double>, 3> pointsOf(std::uint32_t t) const {
    return {corner(t, 0), corner(t, 1), corner(t, 2)};
  }

  /// Marks the edges of two triangles that lie on one line but are not the same edge.
  void mark(std::uint32_t a, std::uint32_t b) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (isSameEdge(a, i, b, j) || !areOnOneLine(a, i, b, j)) continue;
        const unsigned bits = haveAPartInCommon(a, i, b, j) ? 1U | 1U << 3U : 1U;
        std::atomic_ref(touchedEdges_[a]) |= static_cast<std::uint8_t>(bits << i);
        std::atomic_ref(touchedEdges_[b]) |= static_cast<std::uint8_t>(bits << j);
      }
    }
  }
  [[nodiscard]] bool isSameEdge(std::uint32_t a, std::size_t i, std::uint32_t b,
                                std::size_t j) const {
    const auto& ofA = pairs_.corners(a);
    const auto& ofB = pairs_.corners(b);
    const auto p = ofA[i];
    const auto q = ofA[(i + 1) % 3];
    const auto r = ofB[j];
    const auto s = ofB[(j + 1) % 3];
    return (p == r && q == s) || (p == s && q == r);
  }
  [[nodiscard]] bool areOnOneLine(std::uint32_t a, std::size_t i, std::uint32_t b,
                                  std::size_t j) const {
    const auto& p = corner(a, i);
    const auto& q = corner(a, i + 1);
    return !hasArea({p, q, corner(b, j)}) && !hasArea({p, q, corner(b, j + 1)});
  }
  /// Of edges on one line: but not both ends.
  [[nodiscard]] bool haveAPartInCommon(std::uint32_t a, std::size_t i, std::uint32_t b,
                                       std::size_t j) const {
    int axis = 0;
    while (axis < 2 && corner(a, i)[axis] == corner(a, i + 1)[axis]) ++axis;
    const auto [from, to] = std::minmax({corner(a, i)[axis], corner(a, i + 1)[axis]});
    const auto [first, last] = std::minmax({corner(b, j)[axis], corner(b, j + 1)[axis]});
    return std::max(from, first) < std::min(to, last) && (from != first || to != last);
  }

  const PairTest& pairs_;
  std::vector<std::uint8_t> touchedEdges_;
  std::atomic<std::size_t> overlaps_{0};
  std::atomic<std::size_t> touches_{0};
};

SurfaceContacts contactsOver(std::span<const Vec3<double>> positions,
                             std::span<const CornerIds> triangles, const TriangleTree& tree,
                             PairTest::Changed changed) {
  const PairTest pairs(positions, triangles, 0, changed);
  const PairSearch search(pairs, tree, 0);
  ContactCount contacts(pairs);
  const std::atomic<std::uint32_t> lastWanted{kNone};
  const auto take = [&](std::uint32_t first, std::uint32_t second) {
    return contacts.take(first, second);
  };
  parallelFor(search.tasks(), {.progress = {}}, [&](std::size_t task, std::size_t) {
    search.run(task, {lastWanted, take});
  });
  return contacts.result();
}

}  // namespace

template <std::floating_point T>
SurfaceContacts findContacts(std::span<const Vec3<T>> positions,
                             std::span<const CornerIds> triangles, const TriangleTree& tree,
                             std::span<const std::uint8_t> changed) {
  if constexpr (std::same_as<T, double>) {
    return contactsOver(positions, triangles, tree, changed);
  } else {
    const std::vector<Vec3<double>> inDouble(positions.begin(), positions.end());
    return contactsOver(inDouble, triangles, tree, changed);
  }
}

template <std::floating_point T>
SurfaceContacts findContacts(std::span<const Vec3<T>> positions,
                             std::span<const CornerIds> triangles) {
  const auto tree = buildTriangleTree(positions, triangles);
  return findContacts(positions, triangles, tree.tree());
}

std::vector<std::uint8_t> findCloseTriangles(std::span<const Vec3<double>> positions,
                                             std::span<const CornerIds> triangles,
                                             const TriangleTree& tree, double clearance) {
  const PairTest pairs(positions, triangles, 0, {}, clearance);
  const PairSearch search(pairs, tree, 0);
  std::vector<std::uint8_t> isClose(triangles.size());
  std::atomic<std::size_t> count{0};
  const std::atomic<std::uint32_t> lastWanted{kNone};
  const auto take = [&](std::uint32_t first, std::uint32_t second) {
    for (const auto t : {first, second}) {
      std::atomic_ref<std::uint8_t>(isClose[t]).store(1, std::memory_order_relaxed);
    }
    return ++count < SurfaceContacts::kMost;
  };
  parallelFor(search.ranges(), {.progress = {}}, [&](std::size_t task, std::size_t) {
    search.run(task, {lastWanted, take});
  });
  if (count >= SurfaceContacts::kMost) return std::vector<std::uint8_t>(triangles.size(), 1);
  for (std::uint32_t i = 0; i < tree.slots().size(); ++i) {
    const auto t = tree.slots()[i];
    if (t != kNone && search.isCrowded(i / TriangleTree::kLeafWidth)) isClose[t] = 1;
  }
  return isClose;
}

// NOLINTBEGIN(bugprone-macro-parentheses): a type
#define CUTWATER_INSTANTIATE(T)                                                               \
  template SurfaceContacts findContacts(std::span<const Vec3<T>>, std::span<const CornerIds>, \
                                        const TriangleTree&, std::span<const std::uint8_t>);  \
  template SurfaceContacts findContacts(std::span<const Vec3<T>>, std::span<const CornerIds>);
// NOLINTEND(bugprone-macro-parentheses)
CUTWATER_INSTANTIATE(float)
CUTWATER_INSTANTIATE(double)
#undef CUTWATER_INSTANTIATE

}  // namespace cutwater
