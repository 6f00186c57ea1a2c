#include <Cutwater/CutCells/Detail/Curved/SurfaceKinks.hpp>

#include <utility>

namespace cutwater {

bool isKinked(const FluidField& field, std::span<const Vec3<double>> points,
              std::span<const Vec3<double>> normals, int flatAxis) {
  constexpr double kBend = 0.94;       // cosine of 20 degrees
  constexpr double kOpposite = -0.85;  // from there, no way along the surface is known
  double least = kBend;
  std::pair<std::size_t, std::size_t> ends;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double cosine = dot(normals[i], normals[j]);
      if (cosine < least && cosine > kOpposite) least = cosine, ends = {i, j};
    }
  }
  if (least == kBend) return false;
  const auto slopeAt = [&](const Vec3<double>& point) {
    auto slope = field.gradient(point);
    if (flatAxis >= 0) slope[flatAxis] = 0;
    return slope;
  };
  // Halves the way along the surface, and goes on where the normals differ more.
  auto from = points[ends.first];
  auto to = points[ends.second];
  auto atFrom = normals[ends.first];
  auto atTo = normals[ends.second];
  constexpr int kHalvings = 6;
  constexpr int kSteps = 2;  // back to the surface
  for (int i = 0; i < kHalvings; ++i) {
    auto middle = 0.5 * (from + to);
    for (int step = 0; step < kSteps; ++step) {
      const auto slope = slopeAt(middle);
      const double steepness = lengthSquared(slope);
      if (steepness > 0) middle -= (field.value(middle) / steepness) * slope;
    }
    const auto normal = normalized(slopeAt(middle));
    if (dot(atFrom, normal) < dot(normal, atTo)) {
      to = middle, atTo = normal;
    } else {
      from = middle, atFrom = normal;
    }
  }
  return dot(atFrom, atTo) < kBend;
}

}  // namespace cutwater
