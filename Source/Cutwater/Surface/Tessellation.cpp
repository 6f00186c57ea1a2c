#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace cutwater::tessellation {
namespace {

using Corners = std::vector<std::uint32_t>;

void requireSize(double size, const char* message) {
  require(size > 0 && std::isfinite(size), message, Named{"size", size});
}

void requireCorners(double corners) {
  if (corners < kNone) return;
  throw Error(ErrorKind::Limit, "tessellation: more than 2^32 - 2 corners");
}

std::uint32_t addPoint(PolygonSoup& soup, const Vec3<double>& p) {
  soup.points.push_back(p);
  return static_cast<std::uint32_t>(soup.points.size() - 1);
}

PolygonSoup named(PolygonSoup soup, const char* name) {
  soup.patchNames = {name};
  return soup;
}

PolygonSoup icosahedron() {
  constexpr double kGolden = std::numbers::phi;
  PolygonSoup soup;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-kGolden, kGolden}) {  // points 6 i + 0, 1, 2 and + 3, 4, 5
      soup.points.insert(soup.points.end(), {{a, b, 0}, {0, a, b}, {b, 0, a}});
    }
  }
  // Every triple at mutual distance 2, the edge length, is a face; it faces outwards if its volume
  // is > 0.
  const auto near = [&](std::uint32_t i, std::uint32_t k) {
    return lengthSquared(soup.points[i] - soup.points[k]) < 4.5;
  };
  for (std::uint32_t i = 0; i < 12; ++i) {
    for (std::uint32_t j = i + 1; j < 12; ++j) {
      for (std::uint32_t k = j + 1; k < 12; ++k) {
        if (!near(i, j) || !near(j, k) || !near(k, i)) continue;
        const auto& p = soup.points;
        const bool outwards = dot(p[i], cross(p[j], p[k])) > 0;
        soup.addPolygon(outwards ? Corners{i, j, k} : Corners{i, k, j});
      }
    }
  }
  return soup;
}

/// Cuts every triangle into four; the new points are not yet on the sphere.
PolygonSoup quartered(const PolygonSoup& soup) {
  PolygonSoup result;
  result.points = soup.points;
  std::unordered_map<std::uint64_t, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto key = (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b);
    const auto [at, isNew] = middles.try_emplace(key, 0);
    if (isNew) at->second = addPoint(result, 0.5 * (soup.points[a] + soup.points[b]));
    return at->second;
  };
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto c = soup.polygon(i);
    const std::array m{middle(c[0], c[1]), middle(c[1], c[2]), middle(c[2], c[0])};
    for (const auto& corners : {Corners{c[0], m[0], m[2]}, Corners{c[1], m[1], m[0]},
                                Corners{c[2], m[2], m[1]}, Corners{m[0], m[1], m[2]}}) {
      result.addPolygon(corners);
    }
  }
  return result;
}

/// The (n + 1)^3 lattice places of a box, of which only those on its sides become points.
class BoxLattice {
 public:
  BoxLattice(PolygonSoup& soup, const Box<double>& box, int n) : soup_(soup), box_(box), n_(n) {}

  /// The n x n rectangles with place[axis] == side.
  void addSide(std::size_t axis, int side) {
    // (axis, u, v) is right-handed: counter-clockwise seen from the upper side.
    const std::size_t u = (axis + (side > 0 ? 1 : 2)) % 3;
    const std::size_t v = (axis + (side > 0 ? 2 : 1)) % 3;
    const auto at = [&](int i, int j) {
      Place place{};
      place[axis] = side;
      place[u] = i;
      place[v] = j;
      return idAt(place);
    };
    for (int j = 0; j < n_; ++j) {
      for (int i = 0; i < n_; ++i) {
        soup_.addPolygon(Corners{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }

 private:
  using Place = std::array<int, 3>;

  std::uint32_t idAt(const Place& place) {
    std::uint64_t key = 0;
    Vec3<double> p;
    for (int axis = 0; axis < 3; ++axis) {
      const int i = place[static_cast<std::size_t>(axis)];
      key = key * (static_cast<std::uint64_t>(n_) + 1) + static_cast<std::uint64_t>(i);
      const double t = static_cast<double>(i) / n_;
      p[axis] = (1 - t) * box_.lower[axis] + t * box_.upper[axis];
    }
    const auto [known, isNew] = ids_.try_emplace(key, 0);
    if (isNew) known->second = addPoint(soup_, p);
    return known->second;
  }

  PolygonSoup& soup_;
  Box<double> box_;
  int n_;
  std::unordered_map<std::uint64_t, std::uint32_t> ids_;
};

/// The points of a profile turned about the axis, as n ids per ring; a point on the axis repeats.
class Rings {
 public:
  Rings(PolygonSoup& soup, std::span<const ProfilePoint> profile, int n)
      : n_(static_cast<std::size_t>(n)) {
    for (const auto& [radius, z] : profile) {
      if (radius == 0) {
        ids_.insert(ids_.end(), n_, addPoint(soup, {0, 0, z}));
        continue;
      }
      for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        ids_.push_back(addPoint(soup, {radius * std::cos(angle), radius * std::sin(angle), z}));
      }
    }
  }

  [[nodiscard]] std::uint32_t operator()(std::size_t ring, std::size_t section) const {
    return ids_[ring * n_ + section % n_];
  }

 private:
  std::size_t n_;
  std::vector<std::uint32_t> ids_;
};

}  // namespace

PolygonSoup icosphere(double radius, int subdivisions) {
  requireSize(radius, "icosphere: need 0 < radius < infinity");
  require(subdivisions >= 0 && subdivisions <= 12, "icosphere: need 0 <= subdivisions <= 12",
          Named{"subdivisions", subdivisions});
  PolygonSoup soup = icosahedron();
  for (int i = 0; i < subdivisions; ++i) {
    soup = quartered(soup);
    for (auto& p : soup.points) p = normalized(p);
  }
  for (auto& p : soup.points) p = radius * normalized(p);
  return named(std::move(soup), "sphere");
}

PolygonSoup box(const Vec3<double>& lower, const Vec3<double>& upper, int n) {
  require(isFinite(lower) && isFinite(upper) && lower.x < upper.x && lower.y < upper.y &&
              lower.z < upper.z,
          "box: need lower < upper, both finite", Named{"lower", lower}, Named{"upper", upper});
  require(n >= 1, "box: need at least one rectangle per side", Named{"n", n});
  requireCorners(24.0 * n * n);
  PolygonSoup soup;
  BoxLattice lattice(soup, {lower, upper}, n);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    lattice.addSide(axis, 0);
    lattice.addSide(axis, n);
  }
  return named(std::move(soup), "box");
}

PolygonSoup revolve(std::span<const ProfilePoint> profile, int n, ProfileEnds ends) {
  const bool closed = ends == ProfileEnds::Closed;
  const std::size_t count = profile.size();
  require(n >= 3, "revolve: need at least three sections", Named{"n", n});
  require(count >= (closed ? 3 : 2), "revolve: too few points", Named{"points", count});
  requireCorners(4.0 * n * static_cast<double>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const bool isEnd = !closed && (i == 0 || i + 1 == count);
    const auto& [radius, z] = profile[i];
    require((radius > 0 || (isEnd && radius == 0)) && std::isfinite(radius) && std::isfinite(z),
            "revolve: need positive radii, or zero at an open end", Named{"point", i},
            Named{"radius", radius}, Named{"z", z});
  }
  require(closed || count > 2 || profile[0].radius > 0 || profile[1].radius > 0,
          "revolve: the profile is the axis");

  PolygonSoup soup;
  const Rings id(soup, profile, n);
  const auto sections = static_cast<std::size_t>(n);
  for (std::size_t ring = 0; ring + (closed ? 0 : 1) < count; ++ring) {
    const std::size_t above = (ring + 1) % count;
    for (std::size_t i = 0; i < sections; ++i) {
      Corners corners{id(ring, i), id(ring, i + 1), id(above, i + 1), id(above, i)};
      if (profile[above].radius == 0) corners.pop_back();
      if (profile[ring].radius == 0) corners.erase(corners.begin());
      soup.addPolygon(corners);
    }
  }
  if (closed) return named(std::move(soup), "revolution");
  Corners bottom;
  Corners top;
  for (std::size_t i = 0; i < sections; ++i) {
    bottom.push_back(id(0, sections - i));
    top.push_back(id(count - 1, i));
  }
  if (profile.front().radius > 0) soup.addPolygon(bottom);
  if (profile.back().radius > 0) soup.addPolygon(top);
  return named(std::move(soup), "revolution");
}

PolygonSoup torus(double major, double minor, int n, int m) {
  require(0 < minor && minor < major && std::isfinite(major), "torus: need 0 < minor < major",
          Named{"minor", minor}, Named{"major", major});
  require(m >= 3, "torus: need at least three sections of the tube", Named{"m", m});
  std::vector<ProfilePoint> circle;
  for (int i = 0; i < m; ++i) {
    const double angle = 2 * std::numbers::pi * i / m;
    circle.push_back({major + minor * std::cos(angle), minor * std::sin(angle)});
  }
  return named(revolve(circle, n, ProfileEnds::Closed), "torus");
}

PolygonSoup cylinder(double radius, double height, int n) {
  requireSize(radius, "cylinder: need 0 < radius < infinity");
  requireSize(height, "cylinder: need 0 < height < infinity");
  const std::array<ProfilePoint, 2> wall{{{radius, 0}, {radius, height}}};
  return named(revolve(wall, n, ProfileEnds::OnAxis), "cylinder");
}

PolygonSoup cone(double radius, double height, int n) {
  requireSize(radius, "cone: need 0 < radius < infinity");
  requireSize(height, "cone: need 0 < height < infinity");
  const std::array<ProfilePoint, 2> wall{{{radius, 0}, {0, height}}};
  return named(revolve(wall, n, ProfileEnds::OnAxis), "cone");
}

PolygonSoup capsule(double radius, double height, int n, int m) {
  requireSize(radius, "capsule: need 0 < radius < infinity");
  requireSize(height, "capsule: need 0 < height < infinity");
  require(m >= 1, "capsule: need at least one section from pole to equator", Named{"m", m});
  std::vector<ProfilePoint> profile{{0, -radius}};
  for (int i = 1; i <= m; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / m;
    profile.push_back({radius * std::sin(angle), -radius * std::cos(angle)});
  }
  for (std::size_t i = profile.size(); i-- > 0;) {
    profile.push_back({profile[i].radius, height - profile[i].z});
  }
  return named(revolve(profile, n, ProfileEnds::OnAxis), "capsule");
}

}  // namespace cutwater::tessellation
