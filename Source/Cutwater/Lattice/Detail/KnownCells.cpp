// Private: the named cells of UnitCell.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/UnitCell.hpp>

#include <numbers>

namespace cutwater {

namespace {

using Nodes = std::vector<Vec3<double>>;
using Struts = std::vector<CellStrut>;

// Constants without initialisation at run time: cells may be globals of a user's program.
constexpr Vec3<double> kMiddle{0.5, 0.5, 0.5};
constexpr std::array<Vec3<double>, 1> kCorner{{{0, 0, 0}}};
constexpr std::array<Vec3<double>, 1> kCenter{{kMiddle}};
constexpr std::array<Vec3<double>, 3> kFaces{{{0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}};
constexpr std::array<Vec3<double>, 4> kCornerAndFaces{
    {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}};

/// Struts from each node of `from` to each node of `to`, in any cell, no farther than `farthest`.
Struts joined(std::span<const Vec3<double>> from, std::span<const Vec3<double>> to,
              double farthest) {
  Struts struts;
  for (const auto& a : from) {
    for (const auto& node : to) {
      for (int i = 0; i < 27; ++i) {
        const int x = i % 3;
        const int y = i / 3 % 3;
        const int z = i / 9;
        const auto b = node + Vec3<double>{x - 1.0, y - 1.0, z - 1.0};
        const double distance = length(b - a);
        if (distance > UnitCell::kSame && distance < farthest + UnitCell::kSame)
          struts.push_back({a, b});
      }
    }
  }
  return struts;
}

Struts operator+(Struts a, const Struts& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Struts edges() {
  return joined(kCorner, kCorner, 1);
}
Struts edgesAlongZ() {
  return {{{0, 0, 0}, {0, 0, 1}}};
}
Struts bodyDiagonals() {
  return joined(kCorner, kCenter, 0.5 * std::numbers::sqrt3);
}
Struts faceDiagonals() {
  return joined(kCorner, kFaces, std::sqrt(0.5));
}
Struts octahedra() {
  return joined(kFaces, kFaces, std::sqrt(0.5));
}

/// The permutations of (x, y, z), with all signs, about the centre.
Nodes permuted(double x, double y, double z) {
  Nodes nodes;
  for (int signs = 0; signs < 8; ++signs) {
    const double a = (signs & 1) != 0 ? -x : x;
    const double b = (signs & 2) != 0 ? -y : y;
    const double c = (signs & 4) != 0 ? -z : z;
    for (const auto& p : Nodes{{a, b, c}, {b, c, a}, {c, a, b}, {a, c, b}, {c, b, a}, {b, a, c}}) {
      nodes.push_back(kMiddle + p);
    }
  }
  return nodes;
}

/// The orbits of three points under cyclic permutation, changes of sign, and (x, y, z) ->
/// (y + 1/2, x + 1/2, z + 1/2), each node several times: the foam of Weaire and Phelan 1994, "A
/// counter-example to Kelvin's conjecture on minimal surfaces", with straight edges.
Nodes foamNodes() {
  Nodes nodes;
  const Nodes kinds{{0, 0.25, 0.5}, {5.0 / 24, 5.0 / 24, 5.0 / 24}, {0, 5.0 / 32, 5.0 / 16}};
  for (const auto& kind : kinds) {
    for (int i = 0; i < 48; ++i) {
      Vec3<double> p = kind;
      for (int turn = i / 16; turn > 0; --turn) p = {p.y, p.z, p.x};
      for (int axis = 0; axis < 3; ++axis) {
        if ((i >> axis & 1) != 0) p[axis] = -p[axis];
      }
      if ((i & 8) != 0) p = Vec3<double>{p.y, p.x, p.z} + kMiddle;
      for (int axis = 0; axis < 3; ++axis) p[axis] -= std::floor(p[axis]);
      nodes.push_back(p);
    }
  }
  return nodes;
}

}  // namespace

UnitCell UnitCell::simpleCubic() {
  return {"simple cubic", edges()};
}

UnitCell UnitCell::bcc() {
  return {"BCC", bodyDiagonals()};
}

UnitCell UnitCell::fcc() {
  return {"FCC", faceDiagonals()};
}

UnitCell UnitCell::bccz() {
  return {"BCCz", bodyDiagonals() + edgesAlongZ()};
}

UnitCell UnitCell::fccz() {
  return {"FCCz", faceDiagonals() + edgesAlongZ()};
}

UnitCell UnitCell::cubicBcc() {
  return {"SC+BCC", edges() + bodyDiagonals()};
}

UnitCell UnitCell::fbcc() {
  return {"FBCC", faceDiagonals() + bodyDiagonals()};
}

UnitCell UnitCell::cubicFcc() {
  return {"SC+FCC", edges() + faceDiagonals()};
}

UnitCell UnitCell::octahedron() {
  return {"octahedron", octahedra()};
}

UnitCell UnitCell::octet() {
  return {"octet", faceDiagonals() + octahedra()};
}

UnitCell UnitCell::cuboctahedron() {
  const Nodes middles{{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}};
  return {"cuboctahedron", joined(middles, middles, std::sqrt(0.5))};
}

UnitCell UnitCell::kelvin() {
  const auto nodes = permuted(0, 0.25, 0.5);
  return {"Kelvin", joined(nodes, nodes, std::sqrt(0.125))};
}

UnitCell UnitCell::rhombicDodecahedron() {
  const auto inner = permuted(0.25, 0.25, 0.25);
  return {"rhombic dodecahedron", joined(inner, kCornerAndFaces, std::sqrt(3.0 / 16))};
}

UnitCell UnitCell::truncatedCube() {
  const double edge = std::numbers::sqrt2 - 1;
  const auto nodes = permuted(0.5, 0.5, 0.5 * edge);
  return {"truncated cube", joined(nodes, nodes, edge)};
}

UnitCell UnitCell::diamond() {
  const Nodes inner{{0.25, 0.25, 0.25}, {0.75, 0.75, 0.25}, {0.75, 0.25, 0.75}, {0.25, 0.75, 0.75}};
  return {"diamond", joined(inner, kCornerAndFaces, std::sqrt(3.0 / 16))};
}

UnitCell UnitCell::reentrant(double height) {
  require(0.5 < height && height < 1, "UnitCell::reentrant: need 1/2 < height < 1",
          Named{"height", height});
  const double top = 0.5 * height;
  Struts struts{{{0, 0, -top}, {0, 0, top}}, {{0.5, 0.5, 0.5 - top}, {0.5, 0.5, 0.5 + top}}};
  for (int i = 0; i < 8; ++i) {
    const double x = (i & 1) != 0 ? -0.5 : 0.5;
    const double y = (i & 2) != 0 ? -0.5 : 0.5;
    const double side = (i & 4) != 0 ? -1 : 1;
    struts.push_back({{0, 0, side * top}, {x, y, side * (0.5 - top)}});
  }
  return {"re-entrant", struts};
}

UnitCell UnitCell::srs() {
  Nodes nodes;
  for (const auto& [x, y, z] : {std::array{1, 1, 1},
                                {3, 7, 5},
                                {7, 5, 3},
                                {5, 3, 7},
                                {5, 5, 5},
                                {7, 3, 1},
                                {3, 1, 7},
                                {1, 7, 3}}) {
    nodes.push_back({x / 8.0, y / 8.0, z / 8.0});
  }
  return {"srs", joined(nodes, nodes, std::sqrt(0.125))};
}

UnitCell UnitCell::weairePhelan() {
  constexpr double kBetweenNeighbours = 0.318;  // the next are .3222 apart
  const auto nodes = foamNodes();
  return {"Weaire-Phelan", joined(nodes, nodes, kBetweenNeighbours)};
}

std::vector<UnitCell> UnitCell::all() {
  return {simpleCubic(),
          bcc(),
          fcc(),
          bccz(),
          fccz(),
          cubicBcc(),
          fbcc(),
          cubicFcc(),
          octahedron(),
          octet(),
          cuboctahedron(),
          kelvin(),
          rhombicDodecahedron(),
          truncatedCube(),
          diamond(),
          reentrant(0.7),
          srs(),
          weairePhelan()};
}

}  // namespace cutwater
