#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Detail/HalfSpaceFaces.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace cutwater::detail {

namespace {

DoubleDouble3 widened(const Vec3<double>& v) {
  return {v.x, v.y, v.z};
}
DoubleDouble3 operator*(const DoubleDouble& s, const DoubleDouble3& v) {
  return {s * v.x, s * v.y, s * v.z};
}

/// The plane normal . x = offset, with a normal whose largest component is about 1.
struct WidePlane {
  DoubleDouble3 normal;
  DoubleDouble offset;

  explicit WidePlane(const ExactHalfSpace& half) {
    int exponent = 0;
    std::frexp(maxComponent(abs(half.normal)), &exponent);
    const auto scaled = [=](double v) { return std::ldexp(v, -exponent); };  // exact
    normal = widened({scaled(half.normal.x), scaled(half.normal.y), scaled(half.normal.z)});
    offset = dot(normal, widened(half.point));
  }
  [[nodiscard]] DoubleDouble value(const DoubleDouble3& x) const { return dot(normal, x) - offset; }
};

/// A polygon in one plane, to be clipped by the others. Corner i is where side i starts.
class ClippedFace {
 public:
  struct Side {
    DoubleDouble3 start;
    std::uint32_t plane;
  };

  /// Starts as large as the box whose planes follow the first `count`: x, -x, y, -y, z, -z.
  ClippedFace(std::span<const WidePlane> planes, std::uint32_t plane, std::uint32_t count)
      : planes_(planes), plane_(plane) {
    const auto normal = static_cast<Vec3<double>>(planes[plane].normal);
    const auto size = abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto u = count + 2 * static_cast<std::uint32_t>((axis + 1) % 3);
    const auto v = count + 2 * static_cast<std::uint32_t>((axis + 2) % 3);
    std::array<std::uint32_t, 4> order{v + 1, u, v, u + 1};  // counterclockwise
    if (normal[axis] < 0) std::ranges::reverse(order);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto before = order[(i + 3) % 4];
      sides_.push_back({*meetingPoint(plane, before, order[i]), order[i]});
    }
  }

  [[nodiscard]] const std::vector<Side>& sides() const { return sides_; }

  void clipBy(std::uint32_t other) {
    if (other == plane_ || sides_.empty()) return;
    if (isParallelTo(other)) {
      if (!isWithinParallel(other)) sides_.clear();
      return;
    }
    std::vector<DoubleDouble> values;
    for (const auto& side : sides_) values.push_back(planes_[other].value(side.start));
    if (std::ranges::none_of(values, [](const auto& v) { return v > 0.0; })) return;

    std::vector<Side> kept;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const auto next = (i + 1) % sides_.size();
      const bool leaves = !(values[i] > 0.0) && values[next] > 0.0;
      const bool enters = values[i] > 0.0 && !(values[next] > 0.0);
      if (!(values[i] > 0.0)) kept.push_back(sides_[i]);
      if (!leaves && !enters) continue;
      const auto crossing = meetingPoint(plane_, sides_[i].plane, other);
      const auto part = values[i] / (values[i] - values[next]);
      const auto along = sides_[next].start - sides_[i].start;
      kept.push_back({crossing ? *crossing : sides_[i].start + part * along,
                      leaves ? other : sides_[i].plane});
    }
    sides_ = std::move(kept);
  }

 private:
  /// Below, planes are so nearly parallel to one line that rounding moves the point they share.
  static constexpr double kLeastDeterminant = 0x1p-40;

  /// The point that three planes share, where it is well defined.
  [[nodiscard]] std::optional<DoubleDouble3> meetingPoint(std::uint32_t a, std::uint32_t b,
                                                          std::uint32_t c) const {
    const auto& [na, da] = planes_[a];
    const auto& [nb, db] = planes_[b];
    const auto& [nc, dc] = planes_[c];
    const auto bc = cross(nb, nc);
    const auto determinant = dot(na, bc);
    if (std::abs(determinant.high) < kLeastDeterminant) return std::nullopt;
    const auto sum = da * bc + db * cross(nc, na) + dc * cross(na, nb);
    return (1.0 / determinant) * sum;
  }
  [[nodiscard]] bool isParallelTo(std::uint32_t other) const {
    // The bound on what remains, by rounding alone, of products that cancel.
    const auto c = cross(planes_[plane_].normal, planes_[other].normal);
    return length(static_cast<Vec3<double>>(c)) < 0x1p-94;
  }
  /// Whether this plane lies within the half-space of a parallel one; of equal planes, only the
  /// first does.
  [[nodiscard]] bool isWithinParallel(std::uint32_t other) const {
    const auto& mine = planes_[plane_];
    const auto& theirs = planes_[other];
    const auto squared = dot(mine.normal, mine.normal);
    const auto foot = (mine.offset / squared) * mine.normal;
    const double value = theirs.value(foot).high;
    const double rounding = 0x1p-94 * (std::abs(mine.offset.high) + std::abs(theirs.offset.high));
    if (std::abs(value) > rounding) return value < 0;
    return plane_ < other || dot(mine.normal, theirs.normal) < 0.0;
  }

  std::span<const WidePlane> planes_;
  std::uint32_t plane_;
  std::vector<Side> sides_;
};

void requireThat(bool ok, const char* name, const char* what, std::size_t count) {
  if (ok) return;
  const std::string message = std::string(name) + ": " + what;
  require(false, message.c_str(), Named{"half-spaces", count});
}

/// The planes of all half-spaces, followed by those of a box far around their points.
std::vector<WidePlane> planesAndBox(std::span<const ExactHalfSpace> halfSpaces) {
  std::vector<WidePlane> planes;
  double reach = 0;
  for (const auto& half : halfSpaces) {
    planes.emplace_back(half);
    reach = std::max(reach, maxComponent(abs(half.point)));
  }
  const double far = 0x1p30 * (reach > 0 ? reach : 1);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      ExactHalfSpace half;
      half.point[axis] = side * far;
      half.normal[axis] = side;
      planes.emplace_back(half);
    }
  }
  return planes;
}

bool haveInside(std::span<const HalfSpaceFace> faces, std::span<const WidePlane> planes) {
  Vec3<double> sum;
  double count = 0;
  for (const auto& face : faces) {
    for (const auto& corner : face.corners) sum += corner.position, ++count;
  }
  const auto middle = widened(sum / count);
  return std::ranges::all_of(
      faces, [&](const auto& face) { return planes[face.plane].value(middle) < 0.0; });
}

}  // namespace

std::vector<HalfSpaceFace> halfSpaceFaces(const char* name,
                                          std::span<const ExactHalfSpace> halfSpaces) {
  const auto planes = planesAndBox(halfSpaces);
  const auto count = static_cast<std::uint32_t>(halfSpaces.size());
  std::vector<HalfSpaceFace> faces;
  bool isBounded = true;
  for (std::uint32_t i = 0; i < count; ++i) {
    ClippedFace clipped(planes, i, count);
    for (std::uint32_t j = 0; j < count; ++j) clipped.clipBy(j);
    if (clipped.sides().size() < 3) continue;
    HalfSpaceFace face{i, {}};
    for (const auto& side : clipped.sides()) {
      isBounded = isBounded && side.plane < count;
      face.corners.push_back({static_cast<Vec3<double>>(side.start), side.plane});
    }
    faces.push_back(std::move(face));
  }
  requireThat(!faces.empty(), name, "the half-spaces have no inside in common", halfSpaces.size());
  requireThat(isBounded, name, "the half-spaces bound no finite solid", halfSpaces.size());
  requireThat(haveInside(faces, planes), name, "the half-spaces have no inside in common",
              halfSpaces.size());
  return faces;
}

Vec3<double> sideDirection(const Vec3<double>& normal, const Vec3<double>& across) {
  const WidePlane a({{}, normal});
  const WidePlane b({{}, across});
  const auto direction = static_cast<Vec3<double>>(cross(a.normal, b.normal));
  return normalized(direction / maxComponent(abs(direction)));
}

}  // namespace cutwater::detail
