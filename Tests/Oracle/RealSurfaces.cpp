// Every surface of some folders: read, checked, made closed, and asked for signs, which are held
// against exact predicates. Prints a table in Markdown; fails if a sign is wrong, or if a surface
// could not be closed. Usage: RealSurfaces FOLDER...
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/SelfIntersections.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "Oracle/CgalOracle.hpp"
#include "Oracle/Probes.hpp"
#include "Oracle/RealFiles.hpp"
#include "Oracle/SurfaceCure.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

struct SignCheck {
  int probes = 0;
  int wrong = 0;
  bool simple = false;  ///< bounds a solid, says CGAL
};

/// Signs at points about the surface and in its box, but for those that are on it within rounding.
SignCheck checkSigns(const PolygonSoup& soup, const MeshSDF<double>& solid) {
  const CgalOracle cgal(soup);
  SignCheck result{.simple = cgal.boundsSolid()};
  const WindingOracle winding(soup);
  // The latter looks at every triangle for every probe.
  const auto affordable = static_cast<int>(30'000'000 / (soup.polygonCount() + 1));
  const int count = result.simple ? scaled(2'000) : std::clamp(affordable, 50, scaled(2'000));
  Probes probes(soup, 31);
  for (int i = 0; i < count; ++i) {
    const auto p = i % 2 == 0 ? probes.next() : probes.nextHard();
    const double distance = solid.signedDistance(p);
    if (std::abs(distance) <= solid.guarantee().error(length(p))) continue;
    const auto side = result.simple ? cgal.side(p) : winding.side(p);
    if (side == Side::On) continue;
    ++result.probes;
    if ((distance < 0) != (side == Side::Inside)) ++result.wrong;
  }
  return result;
}

std::string stateOf(const MeshReport& report, const SelfIntersections& pairs) {
  std::string text = report.isClosed() ? "closed" : "open";
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) text += ", " + std::to_string(count) + what;
  };
  add(report.boundaryEdges.count, " open edges");
  add(report.nonManifoldEdges.count, " non-manifold");
  add(report.misorientedEdges.count, " mis-oriented");
  add(report.zeroAreaFaces.count, " without area");
  add(pairs.pairs.count, pairs.complete ? " pairs meet" : "+ pairs meet");
  if (report.isInsideOut()) text += ", inside out";
  return text;
}

/// A row of the table. Returns whether all is as it should be.
bool tellOf(const std::string& name, PolygonSoup soup, const Stopwatch& watch) {
  const DcelMesh<double> mesh(soup);
  const auto state = stateOf(check(mesh), findSelfIntersections(mesh));
  std::printf("| %s | %zu | %s | ", name.c_str(), soup.polygonCount(), state.c_str());
  const auto done = cure(soup);
  std::printf("%s | ", done.text().c_str());
  if (!done.failure.empty()) {
    std::printf("| | %.1f |\n", watch.seconds());
    return false;
  }
  soup = triangulated(soup);
  const MeshSDF<double> solid(soup, {.findSelfIntersections = true});
  const double seconds = watch.seconds();
  const auto signs = checkSigns(soup, solid);
  const bool isWinding = solid.signReport().scheme == SignScheme::WindingNumber;
  std::printf("%s%s | %d of %d | %.1f |\n", isWinding ? "winding" : "nearest",
              signs.simple ? "" : ", meets itself", signs.wrong, signs.probes, seconds);
  std::fflush(stdout);
  return signs.wrong == 0 && signs.probes > 0 && solid.signReport().isClosed();
}

bool tell(const std::filesystem::path& file) {
  const Stopwatch watch;
  const auto name = file.filename().string();
  try {
    return tellOf(name, triangulated(readSurface(file).soup), watch);
  } catch (const Error& error) {
    const std::string reason = error.what();
    const auto shown = reason.substr(reason.find(": ") + 2);
    std::printf("| %s | | refused: %s | | | | |\n", name.c_str(), shown.c_str());
    return isNoSurface(file);
  }
}

int run(int argc, char** argv) {
  int bad = 0;
  int count = 0;
  std::printf(
      "| surface | triangles | as it is | done | signs | wrong | seconds |\n"
      "|---|---|---|---|---|---|---|\n");
  for (int i = 1; i < argc; ++i) {
    for (const auto& file : surfacesIn(argv[i])) {
      ++count;
      if (!tell(file)) ++bad;
    }
  }
  std::printf("\n%d surfaces, %d of them with something wrong\n", count, bad);
  return bad == 0 && count > 0 ? 0 : 1;
}

}  // namespace
}  // namespace cutwater::test

int main(int argc, char** argv) {
  try {
    return cutwater::test::run(argc, argv);
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
  } catch (...) {
    std::printf("something that is no exception of ours was thrown\n");
  }
  return 1;
}
