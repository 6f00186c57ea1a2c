#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/BeamLattice.hpp>
#include <Cutwater/Lattice/Detail/CappedBeam.hpp>
#include <Cutwater/Lattice/Detail/NeighborLimits.hpp>
#include <Cutwater/Lattice/Detail/RoundBeamTree.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>

#include <algorithm>

namespace cutwater {

namespace {

/// Beams of one kind in a tree, with their indices among all.
template <std::floating_point T, typename Tree>
class BeamTree {
 public:
  using Kind =
      typename std::remove_cvref_t<decltype(std::declval<Tree>().primitives())>::value_type;

  BeamTree(std::vector<Kind> beams, std::vector<std::uint32_t> ids)
      : ids_(std::move(ids)), tree_(std::move(beams)) {}

  /// The better of `other` and the best in the tree.
  [[nodiscard]] NearestBeam<T> nearer(const NearestBeam<T>& other, const Vec3<T>& p) const;
  /// Null if the beam is not in this tree.
  [[nodiscard]] const Kind* find(std::uint32_t beam) const;
  /// Calls visit(beam) for those whose boxes meet `box`.
  template <typename Visit>
  void forBeamsIn(const Box<T>& box, const Visit& visit) const {
    tree_.overlapping(box, [&](std::uint32_t i) {
      if (beams()[i].boundingBox().overlaps(box)) visit(beams()[i]);
      return true;
    });
  }
  [[nodiscard]] const std::vector<Kind>& beams() const { return tree_.primitives(); }

 private:
  std::vector<std::uint32_t> ids_;  // ascending
  Tree tree_;
};

template <std::floating_point T, typename Tree>
NearestBeam<T> BeamTree<T, Tree>::nearer(const NearestBeam<T>& other, const Vec3<T>& p) const {
  const auto found = tree_.nearest(p, std::min(other.value, std::numeric_limits<T>::max()));
  if (found.primitive == kNone) return other;
  const NearestBeam<T> own{ids_[found.primitive], found.distance + T(0)};
  const bool isFirst = own.value == other.value && own.beam < other.beam;
  return own.value < other.value || isFirst ? own : other;
}

template <std::floating_point T, typename Tree>
auto BeamTree<T, Tree>::find(std::uint32_t beam) const -> const Kind* {
  const auto place = std::ranges::lower_bound(ids_, beam);
  if (place == ids_.end() || *place != beam) return nullptr;
  return &tree_.primitives()[static_cast<std::size_t>(place - ids_.begin())];
}

/// A single beam as a solid.
template <std::floating_point T, typename Kind>
class OneBeam final : public SignedDistanceFunction<T> {
 public:
  explicit OneBeam(const Kind& beam) : beam_(beam) {}

 private:
  T localSignedDistance(const Vec3<T>& p) const override { return beam_.distance(p); }
  Vec3<T> localGradient(const Vec3<T>& p) const override { return beam_.gradient(p); }
  Guarantee<T> localGuarantee() const override { return Guarantee<T>::exact(beam_.size()); }
  Box<T> localBoundingBox() const override { return beam_.boundingBox(); }

  Kind beam_;
};

}  // namespace

template <std::floating_point T>
struct BeamLattice<T>::Trees {
  BeamTree<T, detail::RoundBeamTree<T>> round;
  BeamTree<T, LinearBVH<T, CappedBeam<T>>> capped;

  template <typename Visit>
  void forKinds(Visit&& visit) const {
    visit(round);
    visit(capped);
  }
};

namespace {

/// Beams of the graph by kind, with their indices.
template <std::floating_point T>
class SortedBeams {
 public:
  explicit SortedBeams(const BeamGraph& graph) : graph_(graph) {
    const auto count = graph.beams.size() + graph.balls.size();
    require(count > 0, "BeamLattice: need a beam");
    if (count >= kNone) throw Error(ErrorKind::Limit, "BeamLattice: need less than 2^32 - 1 beams");
    for (std::uint32_t i = 0; i < graph.beams.size(); ++i)
      tryTo(i, [&] { add(i, graph.beams[i]); });
    for (const auto& ball : graph.balls) {
      const auto i = static_cast<std::uint32_t>(roundIds.size() + cappedIds.size());
      tryTo(i, [&] { add(i, ball); });
    }
  }

  std::vector<ConeSphereBeam<T>> round;
  std::vector<std::uint32_t> roundIds;
  std::vector<CappedBeam<T>> capped;
  std::vector<std::uint32_t> cappedIds;

 private:
  /// Adds the index of a beam to errors about it.
  template <typename Add>
  static void tryTo(std::uint32_t i, Add&& add) {
    try {
      add();
    } catch (const Error& error) {
      throw Error(error.kind(), "BeamLattice: beam " + std::to_string(i) + ": " + error.what());
    }
  }
  [[nodiscard]] Vec3<T> node(std::uint32_t index) const {
    require(index < graph_.nodes.size(), "need a node that there is", Named{"node", index},
            Named{"nodes", graph_.nodes.size()});
    return Vec3<T>(graph_.nodes[index]);
  }
  void add(std::uint32_t i, const BeamGraph::Beam& beam) {
    const auto a = node(beam.nodes[0]);
    const auto b = node(beam.nodes[1]);
    const auto atA = static_cast<T>(beam.radii[0]);
    const auto atB = static_cast<T>(beam.radii[1]);
    if (beam.body == BeamBody::ConeSphere) {
      round.emplace_back(a, b, atA, atB);
      roundIds.push_back(i);
    } else {
      capped.emplace_back(a, b, atA, atB, beam.caps);
      cappedIds.push_back(i);
    }
  }
  void add(std::uint32_t i, const BeamGraph::Ball& ball) {
    const auto radius = static_cast<T>(ball.radius);
    round.emplace_back(node(ball.node), node(ball.node), radius, radius);
    roundIds.push_back(i);
  }

  const BeamGraph& graph_;
};

}  // namespace

template <std::floating_point T>
BeamLattice<T>::BeamLattice(const BeamGraph& graph) {
  SortedBeams<T> sorted(graph);
  trees_ =
      std::make_shared<const Trees>(Trees{{std::move(sorted.round), std::move(sorted.roundIds)},
                                          {std::move(sorted.capped), std::move(sorted.cappedIds)}});
  guarantee_ = Guarantee<T>::exact(0);
  guarantee_.inside = Quality::LowerBound;
  trees_->forKinds([&](const auto& tree) {
    for (const auto& beam : tree.beams()) {
      guarantee_.size = std::max(guarantee_.size, beam.size());
      box_.extend(beam.boundingBox());
    }
  });
}

template <std::floating_point T>
NearestBeam<T> BeamLattice<T>::localNearest(const Vec3<T>& p) const {
  return localNearest(p, std::numeric_limits<T>::infinity());
}

template <std::floating_point T>
NearestBeam<T> BeamLattice<T>::localNearest(const Vec3<T>& p, T limit) const {
  NearestBeam<T> best{.value = limit};
  trees_->forKinds([&](const auto& tree) { best = tree.nearer(best, p); });
  return best.beam == kNone && std::isfinite(limit) ? localNearest(p) : best;
}

template <std::floating_point T>
void BeamLattice<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                          std::span<T> distances) const {
  detail::valuesInTurn(points, distances, guarantee_,
                       [this](const Vec3<T>& p, T limit) { return localNearest(p, limit).value; });
}

template <std::floating_point T>
NearestBeam<T> BeamLattice<T>::nearestBeam(const Vec3<T>& p) const {
  return isFinite(p) ? localNearest(this->placement().toLocal(p)) : NearestBeam<T>{};
}

template <std::floating_point T>
T BeamLattice<T>::localSignedDistance(const Vec3<T>& p) const {
  return localNearest(p).value;
}

template <std::floating_point T>
Vec3<T> BeamLattice<T>::gradientOf(std::uint32_t beam, const Vec3<T>& p) const {
  Vec3<T> gradient;
  trees_->forKinds([&](const auto& tree) {
    if (const auto* const own = tree.find(beam); own != nullptr) gradient = own->gradient(p);
  });
  return gradient;
}

template <std::floating_point T>
Vec3<T> BeamLattice<T>::localGradient(const Vec3<T>& p) const {
  return gradientOf(localNearest(p).beam, p);
}

template <std::floating_point T>
SurfacePoint<T> BeamLattice<T>::localClosestPoint(const Vec3<T>& p) const {
  const auto nearest = localNearest(p);
  auto found = detail::steppedPoint<T>([this](const Vec3<T>& q) { return localSignedDistance(q); },
                                       p, nearest.value, gradientOf(nearest.beam, p), guarantee_);
  if (!found) return SignedDistanceFunction<T>::localClosestPoint(p);
  found->owner.face = nearest.beam;
  return *found;
}

template <std::floating_point T>
SurfaceOwner BeamLattice<T>::localOwner(const Vec3<T>& p) const {
  return {.face = localNearest(p).beam};
}

template <std::floating_point T>
bool BeamLattice<T>::localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const {
  trees_->forKinds([&](const auto& tree) {
    tree.forBeamsIn(box.bounds(), [&](const auto& beam) {
      const Solid<T> solid = OneBeam<T, std::remove_cvref_t<decltype(beam)>>(beam);
      visit(solid, &solid);
    });
  });
  return true;
}

template class BeamLattice<float>;
template class BeamLattice<double>;

}  // namespace cutwater
