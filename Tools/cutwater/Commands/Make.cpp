#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "Commands/Commands.hpp"
#include "Options/Arguments.hpp"
#include "Options/SurfaceOptions.hpp"
#include "Options/SurfaceOutput.hpp"
#include "Options/UsageError.hpp"
#include "Report/Format.hpp"

namespace cutwater::tool {

namespace {

struct MakeSettings {
  std::string shape;
  std::string output;
  double radius = 1;
  double major = 1;
  double minor = 0.35;
  double height = 2;
  Vec3<double> size{1, 1, 1};
  int parts = 96;
  bool quiet = false;
  WriteOptions write;
};

/// Subdivisions of an icosahedron, whose edges are about a sixth of the circumference.
int subdivisionsFor(int parts) {
  int subdivisions = 0;
  while (5 << subdivisions < parts) ++subdivisions;
  return subdivisions;
}
int partsOfTube(int parts) {
  return std::max(parts / 2, 3);
}
int partsOfCap(int parts) {
  return std::max(parts / 4, 2);
}

PolygonSoup makeSphere(const MakeSettings& o) {
  return tessellation::icosphere(o.radius, subdivisionsFor(o.parts));
}
PolygonSoup makeEllipsoid(const MakeSettings& o) {
  auto soup = tessellation::icosphere(0.5, subdivisionsFor(o.parts));
  soup.patchNames = {"ellipsoid"};
  for (auto& p : soup.points) p = {o.size.x * p.x, o.size.y * p.y, o.size.z * p.z};
  return soup;
}
PolygonSoup makeCuboid(const MakeSettings& o) {
  return tessellation::box(-0.5 * o.size, 0.5 * o.size);
}
PolygonSoup makeTorus(const MakeSettings& o) {
  return tessellation::torus(o.major, o.minor, o.parts, partsOfTube(o.parts));
}
PolygonSoup makeCylinder(const MakeSettings& o) {
  return tessellation::cylinder(o.radius, o.height, o.parts);
}
PolygonSoup makeCone(const MakeSettings& o) {
  return tessellation::cone(o.radius, o.height, o.parts);
}
PolygonSoup makeCapsule(const MakeSettings& o) {
  return tessellation::capsule(o.radius, o.height, o.parts, partsOfCap(o.parts));
}

// The number of triangles, with polygons cut as STL needs it.
double ballTriangles(int parts) {
  return std::ldexp(20, 2 * subdivisionsFor(parts));
}
double torusTriangles(int parts) {
  return 2.0 * parts * partsOfTube(parts);
}
double capsuleTriangles(int parts) {
  return 4.0 * parts * partsOfCap(parts);
}
double fewTriangles(int parts) {
  return 4.0 * parts;
}

struct Shape {
  PolygonSoup (*make)(const MakeSettings&);
  double (*triangles)(int parts);
  std::vector<std::string> options;  ///< that it has, of those for shapes
};

const std::map<std::string, Shape>& shapes() {
  static const std::map<std::string, Shape> all{
      {"sphere", {makeSphere, ballTriangles, {"--radius", "--parts"}}},
      {"ellipsoid", {makeEllipsoid, ballTriangles, {"--size", "--parts"}}},
      {"cuboid", {makeCuboid, fewTriangles, {"--size"}}},
      {"torus", {makeTorus, torusTriangles, {"--major", "--minor", "--parts"}}},
      {"cylinder", {makeCylinder, fewTriangles, {"--radius", "--height", "--parts"}}},
      {"cone", {makeCone, fewTriangles, {"--radius", "--height", "--parts"}}},
      {"capsule", {makeCapsule, capsuleTriangles, {"--radius", "--height", "--parts"}}}};
  return all;
}

std::vector<std::string> shapeNames() {
  std::vector<std::string> names;
  for (const auto& [name, shape] : shapes()) names.push_back(name);
  return names;
}

std::string withArticle(const std::string& noun) {
  return (noun.front() == 'e' ? "an " : "a ") + noun;
}

void requireOptionsOf(const MakeSettings& options, Command command) {
  const auto& shape = shapes().at(options.shape);
  for (const char* name : {"--radius", "--major", "--minor", "--height", "--size", "--parts"}) {
    if (!command.isGiven(name) || std::ranges::count(shape.options, name) > 0) continue;
    throw UsageError(
        name, withArticle(options.shape) + " has no such option; it has " + listed(shape.options));
  }
  if (options.shape == "torus" && options.minor >= options.major) {
    refuse("--minor", number(options.minor), "less than --major, here " + number(options.major));
  }
  const double triangles = shape.triangles(options.parts);
  constexpr double kMost = 1U << 30U;  // corners, three for each, are counted with 32 bits
  if (triangles > kMost) {
    refuse("--parts", std::to_string(options.parts),
           "fewer: " + grouped(static_cast<std::size_t>(triangles)) +
               " triangles are too many for one surface");
  }
}

void run(const MakeSettings& options) {
  const auto surface =
      asWritten(options.output, shapes().at(options.shape).make(options), options.write);
  writeSurface(options.output, surface.soup, options.write);
  if (options.quiet) return;
  std::cout << "wrote " << onOneLine(options.output) << ": " << withArticle(options.shape) << " of "
            << grouped(surface.soup.polygonCount(), "polygon") << '\n'
            << lossesOf(surface);
}

}  // namespace

void addMake(Program& program) {
  const auto options = std::make_shared<MakeSettings>();
  auto command = program.addCommand(
      "make", "Make the surface of a simple solid about the origin or the z axis, closed");
  command
      .add("SHAPE", "", listed(shapeNames()),
           [=](const std::string& text) {
             static_cast<void>(choiceOf("SHAPE", text, shapeNames()));
             options->shape = text;
           })
      .required();
  addSurfaceOutput(command, "-o,--output", options->output, options->write);
  const auto length = [&](const char* name, double& value, const char* meaning) {
    command.add(name, "LENGTH", meaning,
                [name, &value](const std::string& text) { value = positiveNumber(name, text); });
  };
  length("--radius", options->radius,
         "Radius of a sphere, cylinder, capsule or of a cone's base [default: 1]");
  length("--major", options->major, "Radius of the torus's centre line [default: 1]");
  length("--minor", options->minor, "Radius of the torus's tube [default: 0.35]");
  length("--height", options->height,
         "Height of a cylinder or cone, or length of the capsule's axis [default: 2]");
  command.add("--size", "X,Y,Z",
              "Size of the cuboid, or of the ellipsoid from end to end [default: 1,1,1]",
              [=](const std::string& text) {
                options->size = vectorOf("--size", text);
                if (!(options->size.x > 0 && options->size.y > 0 && options->size.z > 0))
                  refuse("--size", text, "three numbers above 0");
              });
  command.addNumber("--parts", "N", "Number of parts around the axis [default: 96]", options->parts,
                    {3, 100000});
  addQuiet(command, options->quiet);
  command.setFooter(
      "Examples:\n"
      "  cutwater make torus -o torus.stl\n"
      "  cutwater make cuboid --size 2,1,0.5 -o cuboid.obj");
  command.setAction([=] {
    requireOptionsOf(*options, command);
    run(*options);
  });
}

}  // namespace cutwater::tool
