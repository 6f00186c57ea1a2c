#include "Options/SampleGrid.hpp"

#include <Cutwater/Core/Error.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include "Options/Arguments.hpp"
#include "Report/Format.hpp"

namespace cutwater::tool {

namespace {

constexpr double kDefaultMargin = 0.1;  // of the diagonal
constexpr std::int32_t kDefaultCells = 128;
constexpr double kMostAlongAxis = 2147483646.0;  // so that nodes have indices, too
constexpr double kMostInAll = 1e12;              // far beyond any memory; keeps products finite

/// The side of cubic cells.
double cubeOf(const Vec3<double>& size, const GridRequest& request) {
  if (request.spacing.size() == 1) return request.spacing[0];
  if (request.total) return std::cbrt(size.x * size.y * size.z / *request.total);
  return maxComponent(size) / (request.cells.empty() ? kDefaultCells : request.cells[0]);
}

/// The number of cells that cover the length; rounding does not add one.
std::int32_t cellsAlong(double length, double spacing) {
  const double cells = std::max(std::ceil(length / spacing * (1 - 1e-12)), 1.0);
  if (!(cells <= kMostAlongAxis)) {
    throw Error(ErrorKind::Limit, "the grid would have more than 2^31 cells along an axis");
  }
  return static_cast<std::int32_t>(cells);
}

constexpr double kFits = 1e-9;  // of a length

/// The box to cover: of one period, along axes that have one.
Box<double> boxToCover(const Box<double>& surface, const GridRequest& request) {
  const double margin = request.margin.value_or(kDefaultMargin * surface.diagonal());
  auto box = request.box ? *request.box : surface.grown(margin);
  for (int axis = 0; axis < 3; ++axis) {
    const double period = request.period[axis];
    if (period == 0) continue;
    if (!request.box) box.lower[axis] = surface.center()[axis] - 0.5 * period;
    const double length = box.size()[axis];
    if (request.box && !(std::abs(length - period) <= kFits * period)) {
      throw Error(ErrorKind::Argument, "--box is " + number(length) + " long along " +
                                           std::string(1, "xyz"[axis]) + ", and --period " +
                                           number(period) + ": a grid covers one period");
    }
    box.upper[axis] = box.lower[axis] + period;
  }
  return box;
}

/// The number of cells of about this length in a period, two at least.
/// @throws Error(Argument) if they were to have this length, and do not fit.
std::int32_t cellsInPeriod(double period, double spacing, bool isGiven, int axis) {
  const double cells = std::max(std::round(period / spacing), 2.0);
  if (isGiven && !(std::abs(cells * spacing - period) <= kFits * period)) {
    throw Error(ErrorKind::Argument, "no whole number of cells from two on, " + number(spacing) +
                                         " long along " + std::string(1, "xyz"[axis]) +
                                         ", makes the period of " + number(period));
  }
  return cellsAlong(cells, 1);
}

}  // namespace

GridPatch<double> gridAround(const Box<double>& surface, const GridRequest& request) {
  auto box = boxToCover(surface, request);
  const auto size = box.size();
  if (!(size.x > 0 && size.y > 0 && size.z > 0) || !isFinite(size)) {
    throw Error(ErrorKind::Argument,
                "the box of the grid has no extent or no end: --box sets another");
  }
  std::array<std::int32_t, 3> count{};
  Vec3<double> spacing;
  if (request.cells.size() == 3) {
    count = {request.cells[0], request.cells[1], request.cells[2]};
    for (int i = 0; i < 3; ++i) spacing[i] = box.size()[i] / count[static_cast<std::size_t>(i)];
  } else {
    const double cube = cubeOf(box.size(), request);
    spacing = {cube, cube, cube};
    if (request.spacing.size() == 3) {
      spacing = {request.spacing[0], request.spacing[1], request.spacing[2]};
    }
    for (int i = 0; i < 3; ++i) {
      auto& cells = count[static_cast<std::size_t>(i)];
      if (const double period = request.period[i]; period > 0) {
        cells = cellsInPeriod(period, spacing[i], !request.spacing.empty(), i);
        spacing[i] = period / cells;
        continue;
      }
      cells = cellsAlong(box.size()[i], spacing[i]);
      box.lower[i] = box.center()[i] - 0.5 * cells * spacing[i];
    }
  }
  if (1.0 * count[0] * count[1] * count[2] > kMostInAll) {
    throw Error(ErrorKind::Limit, "the grid would have more than 10^12 cells");
  }
  const std::int32_t more = request.nodes ? 1 : 0;
  return {Level<double>(box.lower, spacing, request.nodes ? Centering::Node : Centering::Cell),
          IndexBox::ofSize(count[0] + more, count[1] + more, count[2] + more)};
}

std::string sizeThatFits(const GridPatch<double>& grid, double factor) {
  constexpr double kStep = 1.01;  // more than three digits round off
  const auto& n = grid.indices;
  // Of cells that are so many times as wide: the box grows to whole ones, and nodes are one more.
  const auto count = [&](double by) {
    double product = 1;
    for (int axis = 0; axis < 3; ++axis) {
      product *= std::ceil(static_cast<double>(n.length(axis)) / by) + 1;
    }
    return product;
  };
  const double most = static_cast<double>(n.count()) / (factor * factor * factor);
  double wider = kStep * factor;
  while (count(wider) > most && most > 27) wider *= kStep;
  const auto spacing = kStep * wider * grid.level.spacing();
  const bool isCube = spacing.x == spacing.y && spacing.y == spacing.z;
  const auto rest = "," + number(spacing.y, 3) + "," + number(spacing.z, 3);
  return "--spacing " + number(spacing.x, 3) + (isCube ? "" : rest) + " fits";
}

std::string numberThatFits(const GridPatch<double>& grid, double factor) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = std::floor(static_cast<double>(grid.indices.length(axis)) / factor);
    text += (axis > 0 ? "x" : "") + std::to_string(static_cast<int>(std::max(cells, 2.0)));
  }
  return "--cells " + text + " fits";
}

std::vector<IndexBox> blocksOf(const IndexBox& grid) {
  constexpr std::int32_t kSide = 8;
  constexpr std::int32_t kBlocks = 5;  // along each axis
  std::vector<IndexBox> blocks;
  const auto first = [](std::int32_t lo, std::int32_t hi, std::int32_t n) {
    const auto room = std::max(std::int64_t{hi} - lo + 1 - kSide, std::int64_t{0});
    return lo + static_cast<std::int32_t>(room * n / (kBlocks - 1));
  };
  const auto& [lo, hi] = grid;
  for (std::int32_t n = 0; n < kBlocks * kBlocks * kBlocks; ++n) {
    const Index3 begin{first(lo.i, hi.i, n % kBlocks), first(lo.j, hi.j, n / kBlocks % kBlocks),
                       first(lo.k, hi.k, n / (kBlocks * kBlocks))};
    blocks.push_back({begin,
                      {std::min(begin.i + kSide - 1, hi.i), std::min(begin.j + kSide - 1, hi.j),
                       std::min(begin.k + kSide - 1, hi.k)}});
  }
  return blocks;
}

void addSizeOptions(Command command, GridRequest& grid, const std::string& otherwise) {
  const auto cells = command.add(
      "--cells", "N|NXxNYxNZ",
      "Cubic cells, N along the longest side; or so many along each axis [default: " + otherwise +
          "]",
      [&](const std::string& text) {
        constexpr const char* kNeed = "one whole number above 0 or three: 200 or 200x80x40";
        grid.cells = sizes("--cells", text, kNeed);
        if (grid.cells.size() != 1 && grid.cells.size() != 3) refuse("--cells", text, kNeed);
      });
  const auto spacing =
      command.add("--spacing", "H|HX,HY,HZ", "Sides of a cell, instead of --cells",
                  [&](const std::string& text) {
                    constexpr const char* kNeed = "one number above 0 or three: 0.1 or 0.1,0.1,0.2";
                    grid.spacing = numbers("--spacing", text, kNeed);
                    if ((grid.spacing.size() != 1 && grid.spacing.size() != 3) ||
                        *std::min_element(grid.spacing.begin(), grid.spacing.end()) <= 0) {
                      refuse("--spacing", text, kNeed);
                    }
                  });
  spacing.excludes(cells);
  command
      .add("--total", "N", "Cubic cells, about so many in all, instead of --cells",
           [&](const std::string& text) { grid.total = positiveNumber("--total", text); })
      .excludes(cells)
      .excludes(spacing);
}

void addPlaceOptions(Command command, GridRequest& grid) {
  const auto box = command.add("--box", "X0,Y0,Z0,X1,Y1,Z1",
                               "The box to cover [default: the surface's, with a margin]",
                               [&](const std::string& text) { grid.box = boxOf("--box", text); });
  command
      .add("--margin", "LENGTH", "Room around the surface [default: a tenth of its diagonal]",
           [&](const std::string& text) {
             grid.margin = numbers("--margin", text, 1).front();
             if (*grid.margin < 0) refuse("--margin", text, "a number from 0");
           })
      .excludes(box);
}

}  // namespace cutwater::tool
