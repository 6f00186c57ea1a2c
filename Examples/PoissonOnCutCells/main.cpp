// Poisson's equation on cut cells: how fast errors fall, a plate with two temperatures, and a flow
// around a body. See README.md.
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "Poisson.hpp"

using namespace cutwater;
using Kind = Condition::Kind;

namespace {

/// The unit cube in n cells a side.
GridPatch<double> cube(int n) {
  const double width = 1.0 / n;
  return {Level<double>({0, 0, 0}, {width, width, width}), IndexBox::ofSize(n, n, n)};
}

double solution(const Vec3<double>& p) {
  return std::sin(3 * p.x) * std::cos(2 * p.y) + p.x * p.z * p.z;
}
Vec3<double> gradient(const Vec3<double>& p) {
  return {3 * std::cos(3 * p.x) * std::cos(2 * p.y) + p.z * p.z,
          -2 * std::sin(3 * p.x) * std::sin(2 * p.y), 2 * p.x * p.z};
}
double laplacian(const Vec3<double>& p) {
  return -13 * std::sin(3 * p.x) * std::cos(2 * p.y) + 2 * p.x;
}

struct Conditions {
  Kind atWalls;
  Kind atSides;
};

/// The largest error of a value around a body.
double errorAround(const Solid<double>& body, int n, const Conditions& kinds) {
  const ControlVolumes volumes(SolidCutter(body).cut(cube(n)));
  const Poisson poisson(
      volumes, {.source = laplacian, .condition = [&](const BoundaryPoint& point) {
                  const auto kind =
                      point.patch == BoundaryPoint::kSide ? kinds.atSides : kinds.atWalls;
                  const double value = kind == Kind::Value ? solution(point.at)
                                                           : dot(gradient(point.at), point.normal);
                  return Condition{kind, value};
                }});
  // With derivatives alone, the mean is free.
  double mean = 0;
  double fluid = 0;
  for (std::uint32_t v = 0; v < volumes.count(); ++v) {
    fluid += volumes.volume(v);
    mean += volumes.volume(v) * (poisson.values()[v] - solution(volumes.centroid(v)));
  }
  mean /= fluid;
  const bool isFree = kinds.atWalls == Kind::Derivative && kinds.atSides == Kind::Derivative;
  double largest = 0;
  for (std::uint32_t v = 0; v < volumes.count(); ++v) {
    const double error = poisson.values()[v] - solution(volumes.centroid(v));
    largest = std::max(largest, std::abs(error - (isFree ? mean : 0)));
  }
  return largest;
}

/// Prints how the error falls, up to so many cells a side. Whether it ends with order 1.9.
bool converges(const char* name, const Solid<double>& body, const Conditions& kinds, int finest) {
  std::printf("%s\n", name);
  double before = 0;
  double order = 0;
  for (int n = 8; n <= finest; n *= 2) {
    const double error = errorAround(body, n, kinds);
    order = std::log2(before / error);
    std::printf("  %3d cells: largest error %.2e", n, error);
    std::printf(before > 0 ? ", order %.2f\n" : "\n", order);
    before = error;
  }
  return order >= 1.9;
}

/// A plate of half a cell through the whole box, with a temperature on each side that is linear:
/// what codes with one value a cell cannot do. Returns the largest error.
double errorBesidePlate(int n) {
  const double width = 1.0 / n;
  const double at = 0.5 + 0.25 * width;
  const Solid<double> plate = Cuboid<double>({at, -1, -1}, {at + 0.5 * width, 2, 2});
  const auto cells = SolidCutter(plate).cut(cube(n));
  const ControlVolumes volumes(cells);
  const auto before = [](const Vec3<double>& p) { return 1 + 2 * p.x - p.y; };
  const auto behind = [](const Vec3<double>& p) { return 7 - 3 * p.x + p.z; };
  const auto exact = [&](const Vec3<double>& p) {
    return p.x < at + 0.2 * width ? before(p) : behind(p);
  };
  const Poisson poisson(volumes, {.source = [](const Vec3<double>&) { return 0.0; },
                                  .condition =
                                      [&](const BoundaryPoint& point) {
                                        return Condition{Kind::Value, exact(point.at)};
                                      }});
  double largest = 0;
  for (std::uint32_t v = 0; v < volumes.count(); ++v) {
    largest = std::max(largest, std::abs(poisson.values()[v] - exact(volumes.centroid(v))));
  }
  return largest;
}

/// Speeds in a plane across z, at the corners of squares of pixels.
class FlowPicture {
 public:
  FlowPicture(const Solid<double>& body, const ControlVolumes& volumes, const Poisson& flow,
              const Box<double>& shown)
      : body_(body),
        shown_(shown),
        scale_(kWidth / shown.size().x),
        image_(kWidth, static_cast<int>(scale_ * shown.size().y)) {
    columns_ = image_.width() / kStep + 2;
    for (int y = 0; y <= image_.height() + kStep; y += kStep) {
      for (int x = 0; x <= image_.width() + kStep; x += kStep) {
        velocities_.push_back(flow.gradient(inFluid(pointOf(x, y), volumes)));
      }
    }
  }

  [[nodiscard]] const Image& draw() {
    for (int y = 0; y < image_.height(); ++y) {
      for (int x = 0; x < image_.width(); ++x) image_.at(x, y) = colorAt(x, y);
    }
    std::vector<Stroke> lines;
    constexpr int kLines = 24;
    for (int n = 0; n < kLines; ++n) follow(0, (n + 0.5) * image_.height() / kLines, lines);
    image_.drawStrokes(lines, 1.6, {40, 40, 40});
    return image_;
  }

 private:
  static constexpr int kWidth = 1200;
  static constexpr int kStep = 6;

  [[nodiscard]] Vec3<double> pointOf(double x, double y) const {
    return {shown_.lower.x + x / scale_, shown_.upper.y - y / scale_, shown_.center().z};
  }
  /// The point itself, or for one in the body a point of the fluid before it: so that what lies
  /// between both is not slowed down.
  [[nodiscard]] Vec3<double> inFluid(Vec3<double> at, const ControlVolumes& volumes) const {
    if (volumes.at(at) != ControlVolumes::kNone) return at;
    const double distance = body_.signedDistance(at);
    return at + body_.gradient(at) * (0.5 * volumes.width() - std::min(distance, 0.0));
  }
  [[nodiscard]] bool isBody(double x, double y) const {
    return body_.signedDistance(pointOf(x, y)) <= 0;
  }
  [[nodiscard]] Vec3<double> velocityAt(double x, double y) const {
    const int column = std::clamp(static_cast<int>(x) / kStep, 0, columns_ - 2);
    const int rows = static_cast<int>(velocities_.size()) / columns_;
    const int row = std::clamp(static_cast<int>(y) / kStep, 0, rows - 2);
    const double u = x / kStep - column;
    const double v = y / kStep - row;
    const auto corner = [&](int i, int j) {
      const int number = (row + j) * columns_ + column + i;
      return velocities_[static_cast<std::size_t>(number)];
    };
    return (corner(0, 0) * (1 - u) + corner(1, 0) * u) * (1 - v) +
           (corner(0, 1) * (1 - u) + corner(1, 1) * u) * v;
  }
  /// From blue, at rest, through white, as fast as far away, to red.
  [[nodiscard]] Rgb colorAt(int x, int y) const {
    if (isBody(x + 0.5, y + 0.5)) return {120, 120, 120};
    const double speed = length(velocityAt(x + 0.5, y + 0.5));
    constexpr Rgb kWhite{248, 248, 248};
    return speed < 1 ? blended(kWhite, {40, 90, 190}, 1 - speed)
                     : blended(kWhite, {200, 50, 30}, std::min(1.0, (speed - 1) / 0.6));
  }
  void follow(double x, double y, std::vector<Stroke>& lines) const {
    constexpr double kLength = 3;  // of a step, in pixels
    for (int n = 0; n < 4 * kWidth && x < image_.width(); ++n) {
      const auto first = velocityAt(x, y);
      const auto middle = velocityAt(x + kLength / 2 * first.x, y - kLength / 2 * first.y);
      const double speed = length(middle);
      if (speed < 0.01) return;
      const double nextX = x + kLength * middle.x / speed;
      const double nextY = y - kLength * middle.y / speed;
      if (isBody(nextX, nextY)) return;
      lines.push_back({x, y, nextX, nextY});
      x = nextX;
      y = nextY;
    }
  }

  const Solid<double>& body_;
  Box<double> shown_;
  double scale_;
  Image image_;
  int columns_ = 0;
  std::vector<Vec3<double>> velocities_;
};

/// The potential flow along x around a body in a channel, in so many cells for its length, as a
/// picture. Returns by how much the flow through walls and sides does not add up: its largest speed
/// would tell.
double drawFlow(const Solid<double>& body, int cellsAlong, const std::string& path) {
  const auto box = body.boundingBox();
  const double width = box.size().x / cellsAlong;
  const auto room = box.size().x * 0.45;
  const auto count = [&](double size) { return static_cast<int>((size + 2 * room) / width) + 1; };
  const int nx = count(box.size().x);
  const int ny = count(box.size().y);
  const int nz = count(box.size().z);
  const auto indices = IndexBox::ofSize(nx, ny, nz);
  const Vec3<double> half{nx * width / 2, ny * width / 2, nz * width / 2};
  const GridPatch<double> patch{Level<double>(box.center() - half, {width, width, width}), indices};
  const ControlVolumes volumes(CellCutter(body).cut(patch));
  const Poisson flow(volumes,
                     {.source = [](const Vec3<double>&) { return 0.0; },
                      .condition =
                          [](const BoundaryPoint& point) {
                            const bool isSide = point.patch == BoundaryPoint::kSide;
                            return Condition{Kind::Derivative, isSide ? point.normal.x : 0};
                          }});
  std::printf("flow: %u volumes, %d iterations, residual %.1e\n", volumes.count(),
              flow.iterations(), flow.residual());
  FlowPicture picture(body, volumes, flow,
                      {box.center() - half * 0.98, box.center() + half * 0.98});
  writePng(path, picture.draw());
  return flow.residual();
}

/// Whether errors fall as they should, in up to so many cells a side.
bool isOfSecondOrder(int finest) {
  const Solid<double> ball = Sphere<double>({0.5012, 0.4987, 0.5031}, 0.3);
  const Solid<double> torus = Torus<double>({0.5, 0.49, 0.51}, {0.1, 0.3, 1}, 0.28, 0.11);
  constexpr auto kValue = Kind::Value;
  constexpr auto kDerivative = Kind::Derivative;
  bool isRight = converges("ball, values at walls", ball, {kValue, kValue}, finest);
  isRight &= converges("torus, values at walls", torus, {kValue, kValue}, finest);
  isRight &= converges("ball, derivatives at walls", ball, {kDerivative, kValue}, finest);
  isRight &= converges("ball, derivatives everywhere", ball, {kDerivative, kDerivative}, finest);
  const double plate = errorBesidePlate(16);
  std::printf("plate of half a cell, linear on each side: largest error %.1e\n", plate);
  return isRight && plate < 1e-9;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string picture = argc > 1 ? argv[1] : "PoissonOnCutCells.png";
  const int cells = argc > 2 ? std::stoi(argv[2]) : 32;
  const bool isOwn = argc > 3;
  const bool isRight = isOwn || isOfSecondOrder(cells);
  // A surface of yours; or, without one, a round hull. It lies across the flow a little.
  Solid<double> hull =
      MeshSDF<double>(isOwn ? readSurface(argv[3]).soup : tessellation::capsule(0.4, 3, 64, 24));
  if (!isOwn) hull.rotate(90, 1);
  hull.rotate(12, 2);
  return isRight && drawFlow(hull, cells, picture) < 1e-10 ? 0 : 1;
}
