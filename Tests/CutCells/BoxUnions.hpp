#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <random>
#include <vector>

#include "Support/Shells.hpp"

namespace cutwater::test {

/// Sums up, with its sign, `sizeOf(common)` of what each choice of boxes has in common within a
/// box: inclusion and exclusion.
template <typename SizeOf>
double covered(const Box<double>& within, const std::vector<Box<double>>& boxes,
               const SizeOf& sizeOf) {
  double sum = 0;
  for (unsigned some = 1; some < 1U << boxes.size(); ++some) {
    auto common = within;
    int sign = -1;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if ((some >> i & 1U) == 0) continue;
      common = common.intersection(boxes[i]);
      sign = -sign;
    }
    if (!common.empty()) sum += sign * sizeOf(common);
  }
  return sum;
}
/// The volume or, between equal planes, the area of what boxes cover of a box.
inline double covered(const Box<double>& within, const std::vector<Box<double>>& boxes,
                      int across = -1) {
  return covered(within, boxes, [&](const Box<double>& common) {
    double size = 1;
    for (int axis = 0; axis < 3; ++axis) size *= axis == across ? 1 : common.size()[axis];
    return size;
  });
}

/// Whether two of some boxes touch along a line or in a point alone.
inline bool touchInLines(const std::vector<Box<double>>& boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto common = boxes[i].intersection(boxes[j]);
      if (common.empty()) continue;
      int flat = 0;
      for (int axis = 0; axis < 3; ++axis) flat += common.size()[axis] == 0 ? 1 : 0;
      if (flat > 1) return true;
    }
  }
  return false;
}

inline PolygonSoup soupOf(const std::vector<Box<double>>& boxes) {
  PolygonSoup soup;
  for (const auto& box : boxes) {
    soup = joined({soup, tessellation::box(box.lower, box.upper)});
  }
  return soup;
}

/// With these heights.
inline std::vector<Box<double>> asPrisms(std::vector<Box<double>> boxes, double lower,
                                         double upper) {
  for (auto& box : boxes) box.lower.z = lower, box.upper.z = upper;
  return boxes;
}

/// Boxes in the unit cube, anywhere.
inline std::vector<Box<double>> randomBoxes(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> number(0.03, 0.97);
  std::vector<Box<double>> boxes;
  for (int k = 0; k < count; ++k) {
    const auto corner = [&] {
      return Vec3<double>{number(random), number(random), number(random)};
    };
    const auto p = corner();
    const auto q = corner();
    boxes.push_back({min(p, q), max(p, q)});
  }
  return boxes;
}
/// The same, in planes that are a multiple of 1 / parts apart.
inline std::vector<Box<double>> randomBoxesInPlanes(std::mt19937& random, int count, int parts) {
  std::vector<Box<double>> boxes;
  for (int k = 0; k < count; ++k) {
    Box<double> box;
    for (int axis = 0; axis < 3; ++axis) {
      const int lower = static_cast<int>(random() % static_cast<unsigned>(parts - 2)) + 1;
      const int upper =
          lower + 1 + static_cast<int>(random() % static_cast<unsigned>(parts - 1 - lower));
      box.lower[axis] = lower / static_cast<double>(parts);
      box.upper[axis] = upper / static_cast<double>(parts);
    }
    boxes.push_back(box);
  }
  return boxes;
}

/// Boxes with corners in whole numbers from 1 to parts - 1, of which no two have more than lines or
/// points in common, and some have these.
inline std::vector<Box<double>> boxesInContact(std::mt19937& random, int count, int parts) {
  while (true) {
    auto boxes = randomBoxesInPlanes(random, count, parts);
    for (auto& box : boxes) box = {double(parts) * box.lower, double(parts) * box.upper};
    bool isApart = true;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const auto common = boxes[i].intersection(boxes[j]);
        isApart = isApart && (common.empty() || touchInLines({boxes[i], boxes[j]}));
      }
    }
    if (isApart && touchInLines(boxes)) return boxes;
  }
}

}  // namespace cutwater::test
