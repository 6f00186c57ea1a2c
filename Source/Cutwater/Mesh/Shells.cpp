#include <Cutwater/Bvh/LinearBVH.hpp>
#include <Cutwater/Mesh/Shells.hpp>

#include <cmath>
#include <numbers>

namespace cutwater {

namespace {

bool isWithin(const Box<double>& inner, const Box<double>& outer) {
  return outer.contains(inner.lower) && outer.contains(inner.upper);
}

/// A shell's bounding box, for finding what contains it.
struct ShellBox {
  Box<double> box;
  std::uint32_t shell = 0;
  Box<double> boundingBox() const { return box; }
  double distance(const Vec3<double>& p) const {
    return length(max(max(box.lower - p, p - box.upper), Vec3<double>{}));
  }
};

struct Shell {
  std::vector<FaceId> faces;
  Box<double> box;
  double volume = 0;
};

template <std::floating_point T>
class ShellSearch {
 public:
  explicit ShellSearch(const DcelMesh<T>& mesh) : mesh_(mesh), taken_(mesh.faces().size()) {
    for (const FaceId face : mesh.faces()) {
      if (!taken_[index(face)]) shells_.push_back(shellFrom(face));
    }
  }

  InsideOutShells run() const {
    InsideOutShells result;
    result.faces.resize(mesh_.faces().size());
    if (std::ranges::none_of(shells_, [](const auto& s) { return s.volume < 0; })) return result;
    const auto boxes = shellBoxes();
    for (std::uint32_t s = 0; s < shells_.size(); ++s) {
      if (!(shells_[s].volume < 0) || isCavity(s, boxes)) continue;
      turn(s, result);
      for (const auto inner : boxesTouching(s, boxes)) {
        if (isWithin(shells_[inner].box, shells_[s].box) && contains(s, inner)) turn(inner, result);
      }
    }
    return result;
  }

 private:
  using Boxes = LinearBVH<double, ShellBox>;

  Shell shellFrom(FaceId seed) {
    Shell shell;
    std::vector<FaceId> pending{seed};
    taken_[index(seed)] = true;
    while (!pending.empty()) {
      const FaceId face = pending.back();
      pending.pop_back();
      shell.faces.push_back(face);
      for (const VertexId v : mesh_.vertices(face)) {
        shell.box.extend(Vec3<double>(mesh_.position(v)));
      }
      for (const FaceId next : mesh_.neighbours(face)) {
        if (!taken_[index(next)]) pending.push_back(next);
        taken_[index(next)] = true;
      }
    }
    for (const FaceId face : shell.faces) {
      const auto [a, b, c] = corners(face, shell.box.center());
      shell.volume += dot(a, cross(b, c));  // six times; only its sign matters
    }
    return shell;
  }

  std::array<Vec3<double>, 3> corners(FaceId face, const Vec3<double>& origin) const {
    const auto v = mesh_.vertices(face);
    return {Vec3<double>(mesh_.position(v[0])) - origin,
            Vec3<double>(mesh_.position(v[1])) - origin,
            Vec3<double>(mesh_.position(v[2])) - origin};
  }

  Boxes shellBoxes() const {
    std::vector<ShellBox> boxes;
    for (std::uint32_t s = 0; s < shells_.size(); ++s) boxes.push_back({shells_[s].box, s});
    return Boxes(std::move(boxes));
  }

  std::vector<std::uint32_t> boxesTouching(std::uint32_t s, const Boxes& boxes) const {
    std::vector<std::uint32_t> result;
    boxes.overlapping(shells_[s].box, [&](std::uint32_t other) {
      if (other != s) result.push_back(other);
      return true;
    });
    return result;
  }

  bool isCavity(std::uint32_t s, const Boxes& boxes) const {
    return std::ranges::any_of(boxesTouching(s, boxes), [&](std::uint32_t outer) {
      return isWithin(shells_[s].box, shells_[outer].box) &&
             (shells_[outer].volume > 0 || contains(outer, s));
    });
  }

  /// Whether a vertex of `inner` lies in `outer`: the solid angle that `outer` spans there is 4 pi
  /// times +-1, or 0 (van Oosterom and Strackee 1983, "The solid angle of a plane triangle").
  bool contains(std::uint32_t outer, std::uint32_t inner) const {
    const auto p = Vec3<double>(mesh_.position(mesh_.vertices(shells_[inner].faces.front())[0]));
    double angle = 0;
    for (const FaceId face : shells_[outer].faces) {
      const auto [a, b, c] = corners(face, p);
      const double la = length(a);
      const double lb = length(b);
      const double lc = length(c);
      angle += 2 * std::atan2(dot(a, cross(b, c)),
                              la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return std::abs(angle) > 2 * std::numbers::pi;
  }

  void turn(std::uint32_t s, InsideOutShells& result) const {
    for (const FaceId face : shells_[s].faces) result.faces[index(face)] = true;
    ++result.count;
  }

  const DcelMesh<T>& mesh_;
  std::vector<bool> taken_;
  std::vector<Shell> shells_;
};

}  // namespace

template <std::floating_point T>
InsideOutShells findInsideOutShells(const DcelMesh<T>& mesh) {
  return ShellSearch<T>(mesh).run();
}

template InsideOutShells findInsideOutShells(const DcelMesh<float>&);
template InsideOutShells findInsideOutShells(const DcelMesh<double>&);

}  // namespace cutwater
