// What cells lose that look at the signs at their corners only: trailing edges, plates, wires. See
// README.md.
#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Core/Vec2.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Image.hpp>
#include <Cutwater/Render/Png.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

using namespace cutwater;

namespace {

enum class CellKind { Outside, Inside, Seen, Missed };

/// A mesh of the prism over an outline that runs counterclockwise, as if read from a file.
Solid<double> prism(const std::vector<Vec2<double>>& outline) {
  PolygonSoup soup;
  const auto count = static_cast<std::uint32_t>(outline.size());
  std::vector<std::uint32_t> bottom;
  std::vector<std::uint32_t> top;
  for (std::uint32_t i = 0; i < count; ++i) {
    soup.points.push_back({outline[i].x, outline[i].y, -1});
    soup.points.push_back({outline[i].x, outline[i].y, 1});
    const std::uint32_t next = (i + 1) % count;
    soup.addPolygon(std::array{2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    bottom.insert(bottom.begin(), 2 * i);
    top.push_back(2 * i + 1);
  }
  soup.addPolygon(bottom);
  soup.addPolygon(top);
  soup.patchNames = {"prism"};
  return MeshSDF<double>(soup);
}

/// A NACA 0012 foil of chord 1 with a closed trailing edge (Abbott and von Doenhoff 1959).
Solid<double> foil() {
  constexpr int kPoints = 400;
  std::vector<Vec2<double>> outline;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / kPoints;
    const double x = 0.5 * (1 + std::cos(angle));
    const double half =
        0.6 * (0.2969 * std::sqrt(x) + x * (-0.1260 + x * (-0.3516 + x * (0.2843 - x * 0.1036))));
    outline.push_back({x, i == 0 ? 0 : std::copysign(half, std::sin(angle))});
  }
  return prism(outline);
}

Solid<double> wire(double radius) {
  constexpr int kPoints = 48;
  std::vector<Vec2<double>> outline;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / kPoints;
    outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return prism(outline);
}

Solid<double> plate(double width, double thickness) {
  const double x = width / 2;
  const double y = thickness / 2;
  return prism({{-x, -y}, {x, -y}, {x, y}, {-x, y}});
}

/// Whether the signs at the corners of the cell differ: all that many codes look at.
bool isSeenFromCorners(const Solid<double>& solid, const Box<double>& cell) {
  int inside = 0;
  for (int i = 0; i < 8; ++i) inside += solid.signedDistance(cell.corner(i)) < 0 ? 1 : 0;
  return inside != 0 && inside != 8;
}

/// How much of a square of the plane z = 0 is inside, by so many samples along each side.
double share(const Solid<double>& solid, double x, double y, double side, int samples) {
  int inside = 0;
  for (int row = 0; row < samples; ++row) {
    for (int column = 0; column < samples; ++column) {
      const Vec3<double> p{x + (column + 0.5) / samples * side, y + (row + 0.5) / samples * side,
                           0};
      inside += solid.signedDistance(p) < 0 ? 1 : 0;
    }
  }
  return static_cast<double>(inside) / (samples * samples);
}

/// Whether some of many points of the cell's middle are inside, and some outside.
bool isCutByPoints(const Solid<double>& solid, const Box<double>& cell) {
  const double inside = share(solid, cell.lower.x, cell.lower.y, cell.size().x, 60);
  return 0 < inside && inside < 1;
}

CellKind kindOf(const Solid<double>& solid, const Box<double>& cell) {
  switch (solid.classify(cell)) {
    case BoxClass::Outside:
      return CellKind::Outside;
    case BoxClass::Inside:
      return CellKind::Inside;
    default:
      return isSeenFromCorners(solid, cell) ? CellKind::Seen : CellKind::Missed;
  }
}

/// A square of the picture, in pixels.
struct Square {
  int left, top, side;
};

void fill(Image& image, const Square& square, CellKind kind) {
  constexpr Rgb kColors[]{{255, 255, 255}, {221, 224, 228}, {150, 190, 226}, {240, 150, 70}};
  const auto& [left, top, side] = square;
  image.fillRectangle(left, top, left + side - 1, top + side - 1,
                      kColors[static_cast<std::size_t>(kind)]);
}

/// The solid's section in a cell.
void drawSection(Image& image, const Square& square, const Solid<double>& solid,
                 const Box<double>& cell) {
  const double pixel = cell.size().x / square.side;
  for (int y = 0; y < square.side; ++y) {
    for (int x = 0; x < square.side; ++x) {
      const double inside =
          share(solid, cell.lower.x + x * pixel, cell.upper.y - (y + 1) * pixel, pixel, 3);
      image.paint(square.left + x, square.top + y, {40, 48, 58}, 0.75 * inside);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int pixels = argc > 2 ? std::stoi(argv[2]) : 40;  // a side of a cell
  // [DOCS
  // A foil at an angle of attack, a slat before it as thin as sheet metal, and a wire behind.
  const auto wing = rotated(foil(), -8, 2);
  const auto slat = translated(rotated(plate(0.28, 0.004), 30, 2), {-0.13, 0.02, 0});
  const auto solid = wing | slat | translated(wire(0.012), {1.17, -0.13, 0});
  const Level<double> level({-0.365, -0.3, -0.025}, {0.05, 0.05, 0.05});
  // DOCS]

  constexpr int kColumns = 34;
  constexpr int kRows = 11;
  Image image(kColumns * pixels, kRows * pixels, {205, 209, 214});
  int seen = 0;
  int missed = 0;
  bool isRight = true;
  for (int j = 0; j < kRows; ++j) {
    for (int i = 0; i < kColumns; ++i) {
      const auto cell = level.cell({i, j, 0});
      const auto kind = kindOf(solid, cell);
      seen += kind == CellKind::Seen ? 1 : 0;
      missed += kind == CellKind::Missed ? 1 : 0;
      const bool isCut = kind == CellKind::Seen || kind == CellKind::Missed;
      isRight = isRight && isCut == isCutByPoints(solid, cell);
      const Square square{i * pixels, (kRows - 1 - j) * pixels, pixels};
      fill(image, square, kind);
      if (argc > 1) drawSection(image, square, solid, cell);
    }
  }
  std::printf("%d cells are cut; the signs at their corners show %d of them\n", seen + missed,
              seen);
  if (argc > 1) writePng(argv[1], image);
  return isRight && missed > 0 ? 0 : 1;
}
