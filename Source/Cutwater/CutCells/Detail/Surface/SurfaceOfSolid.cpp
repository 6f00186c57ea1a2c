#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/Detail/Surface/PeriodicSoup.hpp>
#include <Cutwater/CutCells/Detail/Surface/SurfaceOfSolid.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Triangles/OpenEdges.hpp>

#include <algorithm>
#include <string>

namespace cutwater {

namespace {

template <std::floating_point T>
const MeshSDF<T>& meshOf(const Solid<T>& solid) {
  const auto* const mesh = solid.template as<MeshSDF<T>>();
  require(mesh != nullptr, "cut cells: need a mesh: other solids have a SolidCutter");
  return *mesh;
}

std::vector<OpenEdge> openEdgesOf(const PolygonSoup& soup) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto p = soup.polygon(i);
    triangles.push_back({p[0], p[1], p[2]});
  }
  return findOpenEdges(triangles, soup.points.size());
}

/// " in the patch ...", "" if patches have no names.
std::string openPatchesOf(const PolygonSoup& soup) {
  std::vector<std::string> names;
  for (const auto& edge : openEdgesOf(soup)) {
    const auto& name =
        soup.patchNames.empty() ? std::string() : soup.patchNames[soup.patches[edge.triangle]];
    if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  constexpr std::size_t kFew = 10;
  std::string list;
  for (std::size_t i = 0; i < std::min(kFew, names.size()); ++i) {
    list += (i > 0 ? ", \"" : " at patches \"") + names[i] + "\"";
  }
  return names.size() > kFew ? list + ", ..." : list;
}

void checkSigns(const SignReport& signs, const PolygonSoup& soup, const CutterOptions& options) {
  if (signs.unorientable > 0) {
    throw Error(ErrorKind::Topology,
                "cut cells: need a surface with two sides: " + signs.summary());
  }
  if (!signs.isClosed() && !options.capHoles) {
    throw Error(ErrorKind::Topology,
                "cut cells: need a surface that is closed, but for baffles, see "
                "CutterOptions::capHoles and baffles; it is open" +
                    openPatchesOf(soup) + ": " + signs.summary());
  }
}

/// Triangles with their vertices in the world, those in one place merged: where parts touch along
/// an edge, it is one edge.
template <std::floating_point T>
PolygonSoup placed(const Solid<T>& solid, PolygonSoup soup) {
  const auto placement = solid.placement();
  if (!placement.isIdentity()) {
    for (auto& p : soup.points) p = Vec3<double>(placement.toWorld(Vec3<T>(p)));
  }
  weldExactly(soup);
  return soup;
}

/// Closes the holes of triangles whose points are all different, by caps that it returns.
HoleCaps addCaps(PolygonSoup& soup) {
  const auto edges = openEdgesOf(soup);
  auto caps = capHoles<double>(soup.points, edges);
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  const auto patch = static_cast<std::uint32_t>(soup.patchNames.size());
  soup.patchNames.emplace_back("cap");
  soup.points.insert(soup.points.end(), caps.positions.begin(), caps.positions.end());
  for (const auto& [a, b, c] : caps.triangles) {
    soup.addPolygon(std::array{first + a, first + b, first + c});
    soup.patches.back() = patch;
  }
  weldExactly(soup);
  return caps;
}

/// The triangles that bound a body, in the world.
struct Walls {
  PolygonSoup triangles;
  MeetingsOf meetings = MeetingsOf::None;
  HoleCaps caps = {};  ///< among the triangles
};

template <std::floating_point T>
Walls wallsOf(const Solid<T>& solid, const MeshSDF<T>& mesh, const CutterOptions& options) {
  const auto& signs = mesh.signReport();
  Walls walls{.triangles = placed(solid, mesh.soup())};
  if (!signs.isSound() || signs.touchingEdges > 0) {
    walls.meetings = MeetingsOf::All;
  } else if (signs.shells > 1) {
    walls.meetings = MeetingsOf::Shells;
  }
  checkSigns(signs, walls.triangles, options);
  if (!signs.isClosed()) walls.caps = addCaps(walls.triangles);
  return walls;
}

/// The triangles of a soup that are of some patches, or those that are not.
PolygonSoup trianglesOf(const PolygonSoup& soup, std::span<const std::uint32_t> patches,
                        bool isOfPatches) {
  PolygonSoup result;
  result.points = soup.points;
  result.patchNames = soup.patchNames;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const bool isOne = std::ranges::find(patches, soup.patches[i]) != patches.end();
    if (isOne == isOfPatches) result.addPolygon(soup.polygon(i), soup.patches[i]);
  }
  return result;
}

/// Adds triangles with names of their own patches; patches of one name are one.
void addTriangles(PolygonSoup& soup, const PolygonSoup& added) {
  const auto firstPoint = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), added.points.begin(), added.points.end());
  for (std::size_t i = 0; i < added.polygonCount(); ++i) {
    const auto& name = added.patchNames[added.patches[i]];
    const auto found = std::ranges::find(soup.patchNames, name);
    const auto patch = static_cast<std::uint32_t>(found - soup.patchNames.begin());
    if (found == soup.patchNames.end()) soup.patchNames.push_back(name);
    const auto p = added.polygon(i);
    soup.addPolygon(std::array{firstPoint + p[0], firstPoint + p[1], firstPoint + p[2]}, patch);
  }
  weldExactly(soup);
}

/// The walls of a mesh, once its baffles are taken away, and these.
template <std::floating_point T>
Walls wallsAndBaffles(const Solid<T>& solid, const CutterOptions& options) {
  const auto soup = meshOf(solid).soup();
  const auto patches = patchesCalled(options.baffles, soup.patchNames, PatchRole::Baffle);
  const auto rest = trianglesOf(soup, patches, false);
  Walls walls;
  if (rest.polygonCount() > 0) walls = wallsOf(solid, MeshSDF<T>(rest), options);
  addTriangles(walls.triangles, placed(solid, trianglesOf(soup, patches, true)));
  return walls;
}

}  // namespace

template <std::floating_point T>
std::shared_ptr<const CutSurface> surfaceOf(const Solid<T>& solid, FluidSide side,
                                            const CutterOptions& options, HoleCaps& caps) {
  auto walls = options.baffles.empty() ? wallsOf(solid, meshOf(solid), options)
                                       : wallsAndBaffles(solid, options);
  auto& [triangles, meetings, ownCaps] = walls;
  caps = std::move(ownCaps);
  const auto open = patchesCalled(options.openPatches, triangles.patchNames, PatchRole::Open);
  const auto baffles = patchesCalled(options.baffles, triangles.patchNames, PatchRole::Baffle);
  for (const auto patch : open) {
    if (std::ranges::find(baffles, patch) == baffles.end()) continue;
    throw Error(ErrorKind::Argument, "cut cells: the patch \"" + triangles.patchNames[patch] +
                                         "\" cannot be open and a baffle");
  }
  const auto period = periodOf(triangles, options.period);
  if (imagesMayTouch(triangles, period)) meetings = MeetingsOf::All;
  if (period.isOnAny()) triangles = withImages(triangles, period);
  return std::make_shared<const CutSurface>(triangles, side, meetings, open, baffles, period);
}

template std::shared_ptr<const CutSurface> surfaceOf(const Solid<float>&, FluidSide,
                                                     const CutterOptions&, HoleCaps&);
template std::shared_ptr<const CutSurface> surfaceOf(const Solid<double>&, FluidSide,
                                                     const CutterOptions&, HoleCaps&);

}  // namespace cutwater
