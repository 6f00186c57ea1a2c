#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/Tessellation.hpp>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <map>
#include <memory>

#include "Arguments.hpp"
#include "Commands.hpp"
#include "Format.hpp"
#include "Surface.hpp"
#include "SurfaceOutput.hpp"

namespace cutwater::tool {

namespace {

struct Options {
  std::string shape;
  std::string output;
  double radius = 1;
  double minor = 0.35;
  double height = 2;
  Vec3<double> size{1, 1, 1};
  int parts = 96;
  bool quiet = false;
  WriteOptions write;
};

using Maker = PolygonSoup (*)(const Options&);

PolygonSoup makeBall(double radius, int parts) {
  int subdivisions = 0;  // an edge of the icosahedron is about a sixth of the circumference
  while (5 << subdivisions < parts && subdivisions < 12) ++subdivisions;
  return tessellation::icosphere(radius, subdivisions);
}
PolygonSoup makeSphere(const Options& o) {
  return makeBall(o.radius, o.parts);
}
PolygonSoup makeEllipsoid(const Options& o) {
  require(isFinite(o.size) && o.size.x > 0 && o.size.y > 0 && o.size.z > 0,
          "ellipsoid: need finite sizes above 0", Named{"size", o.size});
  auto soup = makeBall(0.5, o.parts);
  soup.patchNames = {"ellipsoid"};
  for (auto& p : soup.points) p = {o.size.x * p.x, o.size.y * p.y, o.size.z * p.z};
  return soup;
}
PolygonSoup makeBox(const Options& o) {
  return tessellation::box(-0.5 * o.size, 0.5 * o.size);
}
PolygonSoup makeTorus(const Options& o) {
  return tessellation::torus(o.radius, o.minor, o.parts, std::max(o.parts / 2, 3));
}
PolygonSoup makeCylinder(const Options& o) {
  return tessellation::cylinder(o.radius, o.height, o.parts);
}
PolygonSoup makeCone(const Options& o) {
  return tessellation::cone(o.radius, o.height, o.parts);
}
PolygonSoup makeCapsule(const Options& o) {
  return tessellation::capsule(o.radius, o.height, o.parts, std::max(o.parts / 4, 2));
}

const std::map<std::string, Maker>& makers() {
  static const std::map<std::string, Maker> all{
      {"sphere", makeSphere},  {"ellipsoid", makeEllipsoid}, {"box", makeBox},
      {"torus", makeTorus},    {"cylinder", makeCylinder},   {"cone", makeCone},
      {"capsule", makeCapsule}};
  return all;
}

void run(const Options& options) {
  const auto surface =
      asWritten(options.output, makers().at(options.shape)(options), options.write);
  writeSurface(options.output, surface.soup, options.write);
  if (options.quiet) return;
  std::cout << "wrote " << options.output << ": a " << options.shape << " of "
            << counted(surface.soup.polygonCount(), "polygon") << '\n'
            << lossesOf(surface);
}

}  // namespace

void addMake(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  auto& command = *program.add_subcommand(
      "make", "Make the surface of a simple solid about the origin or the z axis, closed");
  command
      .add_option("SHAPE", options->shape,
                  "sphere, ellipsoid, box, torus, cylinder, cone or capsule")
      ->required()
      ->check(CLI::IsMember(makers()))
      ->type_name("");
  auto& output = *command.add_option("-o,--output", options->output)->required()->type_name("FILE");
  const auto length = [&](const char* name, double& value, const char* meaning) {
    command
        .add_option_function<std::string>(
            name, [name, &value](const std::string& text) { value = positiveNumber(name, text); },
            meaning)
        ->type_name("LENGTH");
  };
  length("--radius", options->radius, "Of the solid, or of the torus's centre line [1]");
  length("--minor", options->minor, "Radius of the torus's tube [0.35]");
  length("--height", options->height, "Of a cylinder or cone, or of the capsule's axis [2]");
  command
      .add_option_function<std::string>(
          "--size", [=](const std::string& text) { options->size = vectorOf("--size", text); },
          "Of the box, or from end to end of the ellipsoid [1,1,1]")
      ->type_name("X,Y,Z");
  command.add_option("--parts", options->parts, "Parts around the axis [96]")
      ->check(CLI::Range(3, 100000))
      ->type_name("N");
  addOutputOptions(command, output, options->write);
  addQuiet(command, options->quiet);
  command.footer(
      "Examples:\n"
      "  cutwater make torus -o torus.stl\n"
      "  cutwater make box --size 2,1,0.5 -o box.obj");
  command.callback([=] { run(*options); });
}

}  // namespace cutwater::tool
