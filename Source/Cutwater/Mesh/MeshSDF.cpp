#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/Detail/GeometryHeader.hpp>
#include <Cutwater/Mesh/Detail/MeshIndex.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Detail/PatchNames.hpp>
#include <Cutwater/Surface/MeshReport.hpp>
#include <Cutwater/Text/MappedFile.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

/// Joins the names, each terminated by a zero.
std::string joined(std::span<const std::string> names) {
  std::string result;
  for (std::size_t i = 0; i < names.size(); ++i) {
    require(names[i].find('\0') == std::string::npos, "MeshSDF: a patch name contains a zero",
            Named{"patch", i});
    result += names[i] + '\0';
  }
  return result;
}

/// The surface's triangles between points in the mesh's own units.
template <std::floating_point T>
PolygonSoup trianglesOf(const TriangleSurface<T>& surface, std::span<const Vec3<T>> positions) {
  PolygonSoup soup;
  soup.points.reserve(positions.size());
  for (const auto& p : positions) soup.points.emplace_back(p);
  for (std::uint32_t id = 0; id < surface.triangles.size(); ++id) {
    soup.addPolygon(surface.triangles[id], surface.owner(id).patch);
  }
  return soup;
}

template <std::floating_point T>
using SharedIndex = std::shared_ptr<const MeshIndex<T>>;

/// `defects` describes a surface that is refused in more detail; `before`: see MeshIndex.
template <std::floating_point T>
SharedIndex<T> indexOf(const TriangleSurfaceArrays<T>& arrays, const TriangleTreeArrays& tree,
                       std::span<const char> patchNames, const MeshSDFOptions& options,
                       FunctionRef<std::string()> defects, const MeshIndex<T>* before = nullptr) {
  auto index = std::make_shared<const MeshIndex<T>>(arrays, tree, patchNames, options, before);
  if (options.requireWatertight && !index->signs().isSound()) {
    throw Error(ErrorKind::Topology, "the surface does not bound a solid: " +
                                         index->signs().summary() + "; " + defects());
  }
  return index;
}

template <std::floating_point T>
SharedIndex<T> indexOf(const PolygonSoup& soup, const MeshSDFOptions& options) {
  std::string names;
  const auto arrays = [&] {
    const DcelMesh<T> mesh(soup);  // needed only here
    names = joined(detail::patchNamesOf(mesh));
    return TriangleSurfaceArrays<T>(mesh);
  }();
  return indexOf(arrays, buildTriangleTree(arrays.positions(), arrays.triangles()), names, options,
                 [&] { return check(DcelMesh<T>(soup)).summary(); });
}

template <std::floating_point T>
SharedIndex<T> indexOf(const DcelMesh<T>& mesh, const MeshSDFOptions& options) {
  const TriangleSurfaceArrays<T> arrays(mesh);
  return indexOf(arrays, buildTriangleTree(arrays.positions(), arrays.triangles()),
                 joined(detail::patchNamesOf(mesh)), options,
                 [&] { return check(mesh).summary(); });
}

/// Of the same triangles between vertices that have moved.
template <std::floating_point T>
SharedIndex<T> refittedIndex(const MeshIndex<T>& before, std::span<const Vec3<T>> positions) {
  const auto& surface = before.surface();
  const auto& block = before.block();
  const auto insideOut = block.template array<std::uint32_t>(before.layout().insideOut);
  const TriangleSurfaceArrays<T> arrays(surface, before.signs(), insideOut, positions);
  return indexOf(
      arrays, refittedTriangleTree(before.tree(), arrays.positions(), arrays.triangles()),
      block.template array<char>(before.layout().patchNames), before.options(),
      [&] { return check(DcelMesh<T>(trianglesOf(surface, positions))).summary(); }, &before);
}

/// The header of a geometry file, which the index's block follows.
template <std::floating_point T>
std::vector<std::byte> headerOf(const MeshIndex<T>& index, const RigidTransform<T>& placement,
                                std::uint64_t source) {
  const auto& patches = index.surface().patches;
  const std::uint64_t highest = patches.empty() ? 0 : *std::ranges::max_element(patches);
  return detail::geometryHeader<T>({.layout = index.layout(),
                                    .options = index.options(),
                                    .signs = index.signs(),
                                    .placement = placement,
                                    .patches = highest + 1,
                                    .source = source},
                                   index.block().bytes());
}

}  // namespace

template <std::floating_point T>
MeshSDF<T>::MeshSDF(std::shared_ptr<const MeshIndex<T>> index)
    : MeshFunction<T, MeshIndex<T>>(std::move(index)) {}

template <std::floating_point T>
MeshSDF<T>::MeshSDF(const PolygonSoup& soup, const MeshSDFOptions& options)
    : MeshSDF(indexOf<T>(soup, options)) {}

template <std::floating_point T>
MeshSDF<T>::MeshSDF(const DcelMesh<T>& mesh, const MeshSDFOptions& options)
    : MeshSDF(indexOf<T>(mesh, options)) {}

template <std::floating_point T>
MeshSDF<T> MeshSDF<T>::refitted(std::span<const Vec3<T>> positions) const {
  const auto vertices = this->index().surface().positions.size();
  require(positions.size() == vertices, "refitted: need one position for each vertex",
          Named{"positions", positions.size()}, Named{"vertices", vertices});
  for (std::size_t i = 0; i < positions.size(); ++i) {
    require(std::isfinite(lengthSquared(Vec3<double>(positions[i]))),
            "refitted: need finite coordinates with finite squares", Named{"vertex", i},
            Named{"position", positions[i]});
  }
  MeshSDF result(refittedIndex<T>(this->index(), positions));
  result.setPlacement(this->placement());
  return result;
}

template <std::floating_point T>
MeshSDF<T> MeshSDF<T>::signedByNearest() const {
  auto signs = this->signReport();
  auto options = this->index().options();
  signs.scheme = options.signs = SignScheme::NearestFeature;
  MeshSDF result(std::make_shared<const MeshIndex<T>>(this->index().block(), this->index().layout(),
                                                      signs, options));
  result.setPlacement(this->placement());
  return result;
}

template <std::floating_point T>
Block MeshSDF<T>::toBytes(std::uint64_t source) const {
  const auto header = headerOf(this->index(), this->placement(), source);
  BlockWriter writer;
  writer.add(header);
  writer.add(this->index().block().bytes());
  return writer.finish();
}

template <std::floating_point T>
void MeshSDF<T>::save(const std::filesystem::path& path, std::uint64_t source) const {
  OutputFile file(path);
  file.write(headerOf(this->index(), this->placement(), source));
  file.write(this->index().block().bytes());
  file.commit();
}

template <std::floating_point T>
MeshSDF<T> MeshSDF<T>::view(const Block& bytes, const MeshViewOptions& options) {
  const auto misaligned =
      reinterpret_cast<std::uintptr_t>(bytes.bytes().data()) % BlockWriter::kAlignment;
  require(misaligned == 0, "MeshSDF::view: need bytes that begin at a multiple of 64",
          Named{"beyond one by", misaligned});
  const auto [record, block] = detail::readGeometry<T>(bytes, options);
  MeshSDF result(
      std::make_shared<const MeshIndex<T>>(block, record.layout, record.signs, record.options));
  result.setPlacement(record.placement);
  return result;
}

template <std::floating_point T>
MeshSDF<T> MeshSDF<T>::view(std::span<const std::byte> bytes, const MeshViewOptions& options) {
  return view(Block(nullptr, bytes), options);
}

template <std::floating_point T>
MeshSDF<T> MeshSDF<T>::open(const std::filesystem::path& path, const MeshViewOptions& options) {
  const auto bytes = text::mapFile(path);
  try {
    return view(bytes, options);
  } catch (const Error& error) {
    throw Error(error.kind(), path.string() + ": " + error.what());
  }
}

template <std::floating_point T>
PolygonSoup MeshSDF<T>::soup() const {
  const auto& surface = this->index().surface();
  std::vector<Vec3<T>> positions;
  positions.reserve(surface.positions.size());
  for (const auto& p : surface.positions) positions.push_back(p / surface.scale);
  auto soup = trianglesOf<T>(surface, positions);
  soup.patchNames = this->patchNames();
  return soup;
}

template <std::floating_point T>
std::size_t MeshSDF<T>::memoryBytes() const {
  return this->index().block().bytes().size();
}

template class MeshSDF<float>;
template class MeshSDF<double>;

}  // namespace cutwater
