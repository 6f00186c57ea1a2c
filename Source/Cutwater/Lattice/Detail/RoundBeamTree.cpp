#include <Cutwater/Lattice/Detail/RoundBeamTree.hpp>

namespace cutwater::detail {

namespace {

/// A length in the tree's frame, beyond which rounding exceeds the size of the tree, and any beam
/// may be the nearest as computed.
constexpr double kFarthest = 0x1p58;

template <std::floating_point T>
std::vector<Box<double>> boxesOf(std::span<const ConeSphereBeam<T>> beams) {
  std::vector<Box<double>> boxes;
  boxes.reserve(beams.size());
  for (const auto& beam : beams) {
    const auto box = beam.boundingBox();
    require(isFinite(box), "BeamLattice: need a finite bounding box", Named{"beam", boxes.size()});
    boxes.push_back({Vec3<double>(box.lower), Vec3<double>(box.upper)});
  }
  return boxes;
}

}  // namespace

template <std::floating_point T>
RoundBeamTree<T>::RoundBeamTree(std::vector<ConeSphereBeam<T>> beams) : beams_(std::move(beams)) {
  arrays_ = buildBvh<16, BeamPacket::kWidth>(boxesOf<T>(beams_));
  packets_ = packBeams<T>(beams_, arrays_);
  for (const auto& beam : beams_) size_ = std::max(size_, double{beam.size()});
}

/// Bounds a leaf's beams by its packet, and evaluates those that may win once the least is known.
template <std::floating_point T>
class RoundBeamTree<T>::Search {
 public:
  /// `error`: twice the error of values.
  Search(const RoundBeamTree& tree, const Vec3<T>& point, T limit, double error)
      : tree_(tree), point_(point), best_{.primitive = kNone, .distance = limit} {
    const auto& frame = tree.arrays_.frame;
    q_ = frame.toFrame(Vec3<double>(point));
    slack_ = error * frame.scale + 0x1p-49 * (1 + length(q_));
    bounds_.least = std::min(double{limit} * frame.scale, 0x1p60);
  }

  [[nodiscard]] bool isFar() const { return maxComponent(abs(q_)) > kFarthest; }

  /// Returns the limit that no further value needs to exceed.
  double operator()(std::span<const std::uint32_t> slots) {
    const auto leaf =
        static_cast<std::size_t>(slots.data() - tree_.arrays_.slots.data()) / BeamPacket::kWidth;
    for (auto lanes = boundBeams(tree_.packets_[leaf], q_, slack_, bounds_); lanes != 0;
         lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
      if (slots[lane] == kNone) break;
      if (count_ == kMost) evaluate();
      candidates_[count_++] = {slots[lane], bounds_.lower[lane]};
    }
    return bounds_.least / tree_.arrays_.frame.scale;
  }

  NearestPrimitive<T> result() {
    evaluate();
    return best_;
  }
  NearestPrimitive<T> resultOfAll() {
    for (std::uint32_t id = 0; id < tree_.beams_.size(); ++id) offer(id);
    return best_;
  }

 private:
  struct Candidate {
    std::uint32_t id;
    float lower;
  };

  void offer(std::uint32_t id) {
    const NearestPrimitive<T> candidate{id, tree_.beams_[id].distance(point_)};
    if (IsBefore<T, ConeSphereBeam<T>>()(candidate, best_)) best_ = candidate;
  }
  void evaluate() {
    const double limit = bounds_.least + slack_;
    for (std::size_t i = 0; i < count_; ++i) {
      if (double{candidates_[i].lower} <= limit) offer(candidates_[i].id);
    }
    count_ = 0;
    const double scale = tree_.arrays_.frame.scale;
    bounds_.least = std::min(bounds_.least, double{best_.distance} * scale + slack_);
  }

  static constexpr std::size_t kMost = 32;

  const RoundBeamTree& tree_;
  Vec3<T> point_;
  Vec3<double> q_;  // in the tree's frame, like all lengths below
  double slack_ = 0;
  BeamBounds bounds_;
  std::size_t count_ = 0;
  std::array<Candidate, kMost> candidates_;
  NearestPrimitive<T> best_;
};

template <std::floating_point T>
NearestPrimitive<T> RoundBeamTree<T>::nearest(const Vec3<T>& point, T limit) const {
  const Vec3<double> p(point);
  // The error of a value is less than 8 eps of the sizes; twice that, as two are compared, and half
  // as much again.
  const double error = 24 * double{std::numeric_limits<T>::epsilon()} * (length(p) + size_);
  Search search(*this, point, limit, error);
  if (search.isFar()) return search.resultOfAll();
  arrays_.tree().nearest(p, double{limit}, error, search);
  return search.result();
}

template class RoundBeamTree<float>;
template class RoundBeamTree<double>;

}  // namespace cutwater::detail
