// The search of TriangleSearch.hpp, compiled once per instruction set.

#include <Cutwater/Triangles/Search/ClusterSearch.inl>
#include <Cutwater/Triangles/Search/TriangleSearch.hpp>

namespace cutwater::CUTWATER_SIMD {

namespace {

/// Interleaves the searches of several points: while one waits for memory, the others proceed. Each
/// processes a run of neighbouring points, where the last result bounds the next.
template <typename T>
class Team {
 public:
  using Nearest = typename TriangleSurface<T>::Nearest;

  CUTWATER_INLINE Team(const TriangleSearch& tree, const KernelTriangles<T>& surface,
                       const Vec3<T>* points, Nearest* bests)
      : points_(points), bests_(bests), search_{{tree, surface}, {tree, surface}, {tree, surface},
                                                {tree, surface}, {tree, surface}, {tree, surface},
                                                {tree, surface}, {tree, surface}} {}

  CUTWATER_INLINE void run(std::size_t count) {
    int busy = 0;
    for (int i = 0; i < kSize; ++i) {
      next_[i] = count * static_cast<std::size_t>(i) / kSize;
      end_[i] = count * static_cast<std::size_t>(i + 1) / kSize;
      if (next_[i] == end_[i]) continue;
      active_[busy++] = i;
      search_[i].start(points_[next_[i]], bests_[next_[i]], TriangleSearch::kAnywhere);
    }
    while (busy > 0) {
      for (int n = 0; n < busy;) {
        const int i = active_[n];
        if (search_[i].step()) {
          search_[i].prefetch();
          ++n;
        } else if (proceed(i)) {
          ++n;
        } else {
          active_[n] = active_[--busy];
        }
      }
    }
  }

 private:
  /// Moves to the next point of the run; returns false at its end.
  CUTWATER_INLINE bool proceed(int i) {
    search_[i].evaluate();
    const std::size_t done = next_[i]++;
    if (next_[i] == end_[i]) return false;
    const Vec3<double> way = Vec3<double>(points_[next_[i]]) - Vec3<double>(points_[done]);
    const double reach = __builtin_sqrt(double{bests_[done].distanceSquared}) +
                         __builtin_sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
    search_[i].start(points_[next_[i]], bests_[next_[i]],
                     reach * (1 + 0x1p-20) + double{bests_[done].error});
    return true;
  }

  static constexpr int kSize = 8;

  const Vec3<T>* points_;
  Nearest* bests_;
  Search<T> search_[kSize];
  std::size_t next_[kSize];
  std::size_t end_[kSize];
  int active_[kSize];  // those with remaining points
};

// Never inlined, so that the scratch memory of the two is never on the stack at once.

/// Returns the number of points, from the first on, for which a shared search paid off; the rest
/// have too little in common.
template <typename T>
[[gnu::noinline]] std::size_t nearestTogether(const TriangleSearch& tree,
                                              const KernelTriangles<T>& surface,
                                              const Vec3<T>* points,
                                              typename TriangleSurface<T>::Nearest* bests,
                                              std::size_t count) {
  constexpr std::size_t kMost = ClusterPoints<T>::kMost;
  ClusterSearch<T> search(tree, surface);
  std::size_t done = 0;
  while (count - done >= ClusterPoints<T>::kBrick) {
    const std::size_t some = count - done < kMost ? count - done : kMost;
    if (!search.run(points + done, bests + done, static_cast<int>(some))) {
      return done + static_cast<std::size_t>(search.next());
    }
    done += some;
  }
  return done;
}

template <typename T>
[[gnu::noinline]] void nearestInTurns(const TriangleSearch& tree, const KernelTriangles<T>& surface,
                                      const Vec3<T>* points,
                                      typename TriangleSurface<T>::Nearest* bests,
                                      std::size_t count) {
  Team<T>(tree, surface, points, bests).run(count);
}

template <typename T>
[[gnu::noinline]] void nearestOfManyWithin(const TriangleSearch& tree,
                                           const KernelTriangles<T>& surface, const Vec3<T>* points,
                                           typename TriangleSurface<T>::Nearest* bests,
                                           std::size_t count, double reach) {
  constexpr std::size_t kMost = ClusterPoints<T>::kMost;
  ClusterSearch<T> search(tree, surface);
  for (std::size_t done = 0; done < count; done += kMost) {
    const std::size_t some = count - done < kMost ? count - done : kMost;
    if (search.runWithin(points + done, bests + done, static_cast<int>(some), reach)) continue;
    for (std::size_t i = done; i < done + some; ++i) {
      nearestOne(tree, surface, points[i], bests[i], reach);
    }
  }
}

template <typename T>
CUTWATER_INLINE inline void nearestOfMany(const TriangleSearch& tree,
                                          const KernelTriangles<T>& surface, const Vec3<T>* points,
                                          typename TriangleSurface<T>::Nearest* bests,
                                          std::size_t count) {
  auto done = nearestTogether(tree, surface, points, bests, count);
  if (tree.isSmall) {  // no memory latency to hide
    for (; done < count; ++done) nearestOne(tree, surface, points[done], bests[done]);
  }
  if (done < count) nearestInTurns(tree, surface, points + done, bests + done, count - done);
}

}  // namespace

#define CUTWATER_DEFINE(T)                                                                   \
  void nearestTriangle(const TriangleSearch& tree, const KernelTriangles<T>& surface,        \
                       const Vec3<T>& p, TriangleSurface<T>::Nearest& best, double reach) {  \
    nearestOne(tree, surface, p, best, reach);                                               \
  }                                                                                          \
  void nearestTriangles(const TriangleSearch& tree, const KernelTriangles<T>& surface,       \
                        const Vec3<T>* points, TriangleSurface<T>::Nearest* bests,           \
                        std::size_t count) {                                                 \
    nearestOfMany(tree, surface, points, bests, count);                                      \
  }                                                                                          \
  void nearestTrianglesWithin(const TriangleSearch& tree, const KernelTriangles<T>& surface, \
                              const Vec3<T>* points, TriangleSurface<T>::Nearest* bests,     \
                              std::size_t count, double reach) {                             \
    nearestOfManyWithin(tree, surface, points, bests, count, reach);                         \
  }
CUTWATER_DEFINE(float)
CUTWATER_DEFINE(double)
#undef CUTWATER_DEFINE

}  // namespace cutwater::CUTWATER_SIMD
