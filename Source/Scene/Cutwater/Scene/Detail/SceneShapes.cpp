#include <Cutwater/Scene/Detail/SceneRecord.hpp>
#include <Cutwater/Shapes/BoxFrame.hpp>
#include <Cutwater/Shapes/CappedCone.hpp>
#include <Cutwater/Shapes/CappedTorus.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Cone.hpp>
#include <Cutwater/Shapes/ConeSphere.hpp>
#include <Cutwater/Shapes/ConvexPolyhedron.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Ellipsoid.hpp>
#include <Cutwater/Shapes/Extrusion.hpp>
#include <Cutwater/Shapes/HexagonalPrism.hpp>
#include <Cutwater/Shapes/InfiniteCone.hpp>
#include <Cutwater/Shapes/InfiniteCylinder.hpp>
#include <Cutwater/Shapes/Link.hpp>
#include <Cutwater/Shapes/Octahedron.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Pyramid.hpp>
#include <Cutwater/Shapes/Revolution.hpp>
#include <Cutwater/Shapes/RoundedBox.hpp>
#include <Cutwater/Shapes/RoundedCylinder.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

namespace cutwater::scene {

namespace {

using enum KeyType;
using Record = SceneRecord;
using Keys = std::vector<SceneKey>;

const std::string kOrigin = "[0, 0, 0]";
const std::string kAlongZ = "[0, 0, 1]";

SceneForm shape(const char* name, const char* meaning, Keys keys,
                SceneSolid (*make)(const Record&)) {
  return {
      .name = name, .meaning = meaning, .keys = std::move(keys), .make = make, .kindKey = "shape"};
}

SceneKey positive(const char* name, const char* meaning) {
  return {name, Positive, meaning};
}
SceneKey point(const char* name, const char* meaning, std::optional<std::string> preset = {}) {
  return {name, Point, meaning, std::move(preset)};
}

/// Keys of two points, followed by `more`.
Keys betweenEnds(Keys more) {
  Keys keys{point("from", "the middle of one end"), point("to", "the middle of the other end")};
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}
/// Keys of two corners, followed by `more`.
Keys betweenCorners(Keys more) {
  Keys keys{point("lower", "the corner of the least coordinates"),
            point("upper", "the opposite corner")};
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}
const Keys kTwoRadii{{"start_radius", NotNegative, "the radius at `from`"},
                     {"end_radius", NotNegative, "the radius at `to`"}};

Keys ofPolygon(const char* plane, Keys more) {
  Keys keys{{"outline", Outline, std::string("corners of a loop; of each, ") + plane},
            {"loops", Outlines, "further loops: holes, and islands in them", "[]"}};
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}
Polygon<double> polygonOf(const Record& r) {
  return Polygon<double>(r.outline("outline"), r.outlines("loops"));
}

std::vector<SceneForm> roundShapes() {
  return {
      shape("sphere", "A ball.",
            {point("center", "its centre", kOrigin), positive("radius", "its radius")},
            [](const Record& r) -> SceneSolid {
              return Sphere<double>(r.point("center"), r.number("radius"));
            }),
      shape("ellipsoid", "An ellipsoid with its axes along x, y and z.",
            {point("center", "its centre", kOrigin),
             {"semi_axes", Sizes, "half its length along each axis"}},
            [](const Record& r) -> SceneSolid {
              return Ellipsoid<double>(r.point("center"), r.point("semi_axes"));
            }),
      shape("torus", "A ring: a tube about a circle.",
            {point("center", "the circle's centre", kOrigin),
             point("axis", "the direction across the circle", kAlongZ),
             positive("major", "the circle's radius"), positive("minor", "the tube's radius")},
            [](const Record& r) -> SceneSolid {
              return Torus<double>(r.point("center"), r.point("axis"), r.number("major"),
                                   r.number("minor"));
            }),
      shape("capped torus", "A piece of a ring about the z axis, with round ends.",
            {positive("major", "the arc's radius"), positive("minor", "the tube's radius"),
             positive("half_angle",
                      "half the angle of the arc in degrees, from the x axis to either side; at "
                      "most 180")},
            [](const Record& r) -> SceneSolid {
              return CappedTorus<double>(r.number("major"), r.number("minor"),
                                         r.number("half_angle"));
            }),
      shape("link",
            "A link of a chain: a ring about the z axis, lengthened along y by straight parts.",
            {{"length", NotNegative, "the length of its straight parts"},
             positive("major", "the radius of its bends"),
             positive("minor", "the tube's radius")},
            [](const Record& r) -> SceneSolid {
              return Link<double>(r.number("length"), r.number("major"), r.number("minor"));
            }),
      shape("capsule", "All points within a radius of a segment.",
            {point("from", "one end of the segment"), point("to", "the other end"),
             positive("radius", "its radius")},
            [](const Record& r) -> SceneSolid {
              return Capsule<double>(r.point("from"), r.point("to"), r.number("radius"));
            }),
      shape("cone-sphere", "The convex hull of two balls.",
            {point("from", "the centre of one ball"), point("to", "the centre of the other ball"),
             kTwoRadii[0], kTwoRadii[1]},
            [](const Record& r) -> SceneSolid {
              return ConeSphere<double>(r.point("from"), r.point("to"), r.number("start_radius"),
                                        r.number("end_radius"));
            }),
  };
}

std::vector<SceneForm> cylindersAndCones() {
  return {
      shape("cylinder", "A cylinder with flat ends.",
            betweenEnds({positive("radius", "its radius")}),
            [](const Record& r) -> SceneSolid {
              return Cylinder<double>(r.point("from"), r.point("to"), r.number("radius"));
            }),
      shape(
          "rounded cylinder", "A cylinder with rounded rims; ends and side stay in their places.",
          betweenEnds({positive("radius", "its radius"),
                       positive("rounding",
                                "the rims' radius, at most `radius` and at most half the length")}),
          [](const Record& r) -> SceneSolid {
            return RoundedCylinder<double>(r.point("from"), r.point("to"), r.number("radius"),
                                           r.number("rounding"));
          }),
      shape("infinite cylinder", "A cylinder without ends.",
            {point("point", "a point of its axis", kOrigin),
             point("axis", "the axis' direction", kAlongZ), positive("radius", "its radius")},
            [](const Record& r) -> SceneSolid {
              return InfiniteCylinder<double>(r.point("point"), r.point("axis"),
                                              r.number("radius"));
            }),
      shape("cone", "A cone with a flat base.",
            {point("apex", "its tip"), point("base", "the middle of its base"),
             positive("radius", "the base's radius")},
            [](const Record& r) -> SceneSolid {
              return Cone<double>(r.point("apex"), r.point("base"), r.number("radius"));
            }),
      shape("capped cone", "A cone cut off flat at both ends.", betweenEnds(kTwoRadii),
            [](const Record& r) -> SceneSolid {
              return CappedCone<double>(r.point("from"), r.point("to"), r.number("start_radius"),
                                        r.number("end_radius"));
            }),
      shape("infinite cone", "A cone without end.",
            {point("apex", "its tip", kOrigin),
             point("axis", "the direction from the tip into the solid", kAlongZ),
             positive("half_angle", "degrees between axis and flank, below 90")},
            [](const Record& r) -> SceneSolid {
              return InfiniteCone<double>(r.point("apex"), r.point("axis"), r.number("half_angle"));
            }),
  };
}

std::vector<SceneForm> boxes() {
  return {
      shape("plane", "All points behind a plane.",
            {point("point", "a point of the plane", kOrigin),
             point("normal", "the direction out of the solid", kAlongZ)},
            [](const Record& r) -> SceneSolid {
              return Plane<double>(r.point("point"), r.point("normal"));
            }),
      shape("cuboid", "A box along the axes.", betweenCorners({}),
            [](const Record& r) -> SceneSolid {
              return Cuboid<double>(r.point("lower"), r.point("upper"));
            }),
      shape("rounded box", "A box with rounded edges; its faces stay in their places.",
            betweenCorners({positive("radius", "the edges' radius, at most half a side")}),
            [](const Record& r) -> SceneSolid {
              return RoundedBox<double>(r.point("lower"), r.point("upper"), r.number("radius"));
            }),
      shape("box frame", "The edges of a box, as square bars.",
            betweenCorners({positive("thickness", "the bars' thickness, less than half a side")}),
            [](const Record& r) -> SceneSolid {
              return BoxFrame<double>({r.point("lower"), r.point("upper")}, r.number("thickness"));
            }),
      shape("hexagonal prism", "A regular hexagon about the z axis, with its middle at the origin.",
            {positive("inradius", "the distance from the axis to the sides"),
             positive("height", "its length along z")},
            [](const Record& r) -> SceneSolid {
              return HexagonalPrism<double>(r.number("inradius"), r.number("height"));
            }),
      shape("octahedron", "A regular octahedron about the origin.",
            {positive("radius",
                      "the distance from the origin to its corners, which are on the axes")},
            [](const Record& r) -> SceneSolid { return Octahedron<double>(r.number("radius")); }),
      shape(
          "pyramid", "A pyramid on a square about the origin, its tip on the z axis.",
          {positive("side", "the side of the square"), positive("height", "the height of the tip")},
          [](const Record& r) -> SceneSolid {
            return Pyramid<double>(r.number("side"), r.number("height"));
          }),
  };
}

const std::vector<SceneForm>& halfSpaceForms() {
  static const std::vector<SceneForm> kForms{
      {.name = "half-space",
       .meaning = "All points behind a plane.",
       .keys = {point("normal", "the direction out of the solid"),
                point("point", "a point of the plane", kOrigin)}}};
  return kForms;
}

SceneSolid convexPolyhedron(const Record& r) {
  std::vector<HalfSpace<double>> halfSpaces;
  for (const auto& part : r.parts("half_spaces")) {
    halfSpaces.push_back({part.point("point"), part.point("normal")});
  }
  return ConvexPolyhedron<double>(halfSpaces);
}

std::vector<SceneForm> polygonsAndPolyhedra() {
  return {
      shape("convex polyhedron", "The intersection of half-spaces.",
            {{.name = "half_spaces",
              .type = Parts,
              .meaning = "tables of `normal` and `point`",
              .forms = &halfSpaceForms()}},
            convexPolyhedron),
      shape("extrusion", "A polygon in the xy plane, extruded along z.",
            ofPolygon("x and y", {{"lower", Number, "the z where it begins"},
                                  {"upper", Number, "the z where it ends"}}),
            [](const Record& r) -> SceneSolid {
              return Extrusion<double>(polygonOf(r), r.number("lower"), r.number("upper"));
            }),
      shape("revolution", "A polygon turned about an axis.",
            ofPolygon("its distance from the axis and its position along the axis",
                      {point("origin", "the point of the axis with position 0", kOrigin),
                       point("axis", "the axis' direction", kAlongZ)}),
            [](const Record& r) -> SceneSolid {
              return Revolution<double>(polygonOf(r), r.point("origin"), r.point("axis"));
            }),
  };
}

}  // namespace

const std::vector<SceneForm>& shapeForms() {
  static const auto kForms = [] {
    std::vector<SceneForm> all;
    for (auto* group : {boxes, roundShapes, cylindersAndCones, polygonsAndPolyhedra}) {
      for (auto& form : group()) all.push_back(std::move(form));
    }
    return all;
  }();
  return kForms;
}

}  // namespace cutwater::scene
