#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/Detail/CellMirrors.hpp>
#include <Cutwater/Lattice/UnitCell.hpp>

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

struct Facts {
  std::size_t closed;  // struts of the closed cell
  std::size_t unique;  // per period
  double length;
  CellFold fold;                 // at equal sizes
  std::vector<CellStrut> parts;  // in the chamber
};

const double kG = 1 - std::sqrt(0.5);
constexpr double kH = 0.7;

/// Counts, lengths and segments as given in the literature, or worked out by hand.
const std::map<std::string, Facts>& table() {
  using enum CellFold;
  const CellStrut edge{{0, 0, 0}, {0.5, 0, 0}};
  const CellStrut body{{0, 0, 0}, {0.5, 0.5, 0.5}};
  const CellStrut face{{0, 0, 0}, {0.5, 0.5, 0}};
  const CellStrut upright{{0, 0, 0}, {0, 0, 0.5}};
  const CellStrut inner{{0.5, 0.25, 0.25}, {0.5, 0.5, 0}};
  const double e = 0.5 * kH;
  static const std::map<std::string, Facts> facts{
      {"simple cubic", {12, 3, 3, Sort, {edge}}},
      {"BCC", {8, 8, 6.92820, Sort, {body}}},
      {"FCC", {24, 12, 8.48528, Sort, {face}}},
      {"BCCz", {12, 9, 7.92820, SortXY, {body, upright}}},
      {"FCCz", {28, 13, 9.48528, SortXY, {face, {{0, 0, 0}, {0.5, 0, 0.5}}, upright}}},
      {"SC+BCC", {20, 11, 9.92820, Sort, {edge, body}}},
      {"FBCC", {32, 20, 15.41348, Sort, {face, body}}},
      {"SC+FCC", {36, 15, 11.48528, Sort, {edge, face}}},
      {"octahedron", {12, 12, 8.48528, Sort, {inner}}},
      {"octet", {36, 24, 16.97056, Sort, {face, inner}}},
      {"cuboctahedron", {24, 12, 8.48528, Sort, {{{0.5, 0, 0}, {0.25, 0.25, 0}}}}},
      {"Kelvin",
       {36,
        24,
        8.48528,
        Sort,
        {{{0.375, 0.375, 0}, {0.5, 0.25, 0}}, {{0.5, 0.125, 0.125}, {0.5, 0.25, 0}}}}},
      {"rhombic dodecahedron",
       {32,
        32,
        13.85641,
        Sort,
        {{{0.25, 0.25, 0.25}, {0, 0, 0}}, {{0.25, 0.25, 0.25}, {0.5, 0.5, 0}}}}},
      {"truncated cube",
       {36, 15, 6.21320, Sort, {{{kG, 0, 0}, {0.5, 0, 0}}, {{kG, 0, 0}, {0.5 * kG, 0.5 * kG, 0}}}}},
      {"diamond", {16, 16, 6.92820, Fcc, {{{0, 0, 0}, {0.25, 0.25, 0.25}}}}},
      {"re-entrant",
       {17,
        10,
        7.278775,
        SortXY,
        {{{0, 0, 0}, {0, 0, e}},
         {{0.5, 0.5, 0.5 - e}, {0.5, 0.5, 0.5}},
         {{0, 0, e}, {0.5, 0.5, 0.5 - e}}}}},
      // 6 cross faces of the cell, in their middles.
      {"srs", {18, 12, 4.24264, None, {}}},
      // 12 lie in faces of the cell, 6 across its edges.
      {"Weaire-Phelan", {122, 92, 21.392293, Octant, {}}},
  };
  return facts;
}

const std::set<std::string> kFaceCentred{"octet", "rhombic dodecahedron", "diamond"};

bool isSame(const CellStrut& s, const CellStrut& t) {
  const auto isNear = [](const Vec3<double>& a, const Vec3<double>& b) {
    return length(a - b) < 1e-15;
  };
  return (isNear(s.a, t.a) && isNear(s.b, t.b)) || (isNear(s.a, t.b) && isNear(s.b, t.a));
}

TEST(UnitCellTest, KnownCellsHaveTheCountsAndLengthsOfTheTable) {
  EXPECT_EQ(UnitCell::all().size(), table().size());
  for (const auto& cell : UnitCell::all()) {
    SCOPED_TRACE(cell.name());
    const auto& facts = table().at(cell.name());
    EXPECT_EQ(cell.struts().size(), facts.unique);
    EXPECT_EQ(cell.closedStruts().size(), facts.closed);
    EXPECT_NEAR(cell.lengthPerCell(), facts.length, 6e-6);
    EXPECT_EQ(cell.foldAt({2, 2, 2}), facts.fold);
    using enum CellFold;
    const bool sortsXY = facts.fold == SortXY || facts.fold == Sort;
    EXPECT_EQ(cell.has(Octant), sortsXY || facts.fold == Octant);
    EXPECT_EQ(cell.has(SortXY), sortsXY);
    EXPECT_EQ(cell.has(Sort), facts.fold == Sort);
    EXPECT_EQ(cell.has(Fcc), kFaceCentred.contains(cell.name()));
  }
}

TEST(UnitCellTest, ChambersHoldTheSegmentsOfTheTable) {
  for (const auto& cell : UnitCell::all()) {
    SCOPED_TRACE(cell.name());
    const auto& facts = table().at(cell.name());
    if (facts.parts.empty()) continue;
    const auto parts = detail::strutsInChamber(cell.struts(), facts.fold);
    EXPECT_EQ(parts.size(), facts.parts.size());
    for (const auto& wanted : facts.parts) {
      EXPECT_TRUE(std::ranges::any_of(parts, [&](auto& p) { return isSame(p.part, wanted); }))
          << wanted.a << wanted.b;
    }
    for (const auto& part : parts) EXPECT_LT(part.strut, cell.struts().size());
  }
}

TEST(UnitCellTest, FoamHasItsFortySixNodesAndFourLengths) {
  const auto cell = UnitCell::weairePhelan();
  std::map<long, int> lengths;
  std::vector<Vec3<double>> nodes;
  for (const auto& [a, b] : cell.struts()) {
    ++lengths[std::lround(1e6 * length(b - a))];
    for (auto end : {a, b}) {
      for (int axis = 0; axis < 3; ++axis) end[axis] -= std::floor(end[axis] + 1e-9);
      const auto isHere = [&](const auto& node) { return length(node - end) < 1e-9; };
      if (std::ranges::none_of(nodes, isHere)) nodes.push_back(end);
    }
  }
  EXPECT_EQ(nodes.size(), 46U);
  EXPECT_EQ(lengths, (std::map<long, int>{{144338, 8}, {209631, 24}, {238676, 48}, {312500, 12}}));
  // 7 segments, and their cyclic permutations but for those along a diagonal.
  EXPECT_EQ(detail::strutsInChamber(cell.struts(), CellFold::Octant).size(), 19U);
}

TEST(UnitCellTest, StretchedCellsKeepTheMirrorsThatTheyCan) {
  using enum CellFold;
  EXPECT_EQ(UnitCell::octet().foldAt({1, 1, 2}), SortXY);
  EXPECT_EQ(UnitCell::octet().foldAt({1, 2, 2}), Octant);
  EXPECT_EQ(UnitCell::bccz().foldAt({1, 2, 1}), Octant);
  EXPECT_EQ(UnitCell::diamond().foldAt({1, 1, 2}), None);
  EXPECT_EQ(UnitCell::srs().foldAt({1, 1, 1}), None);
  EXPECT_TRUE(UnitCell::octet().has(Fcc));
  EXPECT_FALSE(UnitCell::simpleCubic().has(Fcc));
}

TEST(UnitCellTest, MirrorsMatchToRounding) {
  const auto cellWith = [](double end) {
    return UnitCell("mine", std::vector<CellStrut>{{{0.3, 0.5, 0.5}, {end, 0.5, 0.5}}});
  };
  EXPECT_TRUE(cellWith(0.7).has(CellFold::Octant));
  EXPECT_TRUE(cellWith(std::nextafter(0.7, 1)).has(CellFold::Octant));
  EXPECT_FALSE(cellWith(0.7 - 8e-10).has(CellFold::Octant));
}

TEST(UnitCellTest, OnesOwnCountCopiesOnce) {
  const std::vector<Vec3<double>> nodes{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}, {1, 1, 1}, {0.25, 0, 0}};
  const std::vector<std::array<std::uint32_t, 2>> struts{{0, 1}, {3, 2}, {1, 0}, {4, 2}};
  const UnitCell cell("mine", nodes, struts);
  EXPECT_EQ(cell.name(), "mine");
  EXPECT_EQ(cell.struts().size(), 2U);
  EXPECT_EQ(cell.closedStruts().size(), 4U + 1U);
  EXPECT_EQ(cell.foldAt({1, 1, 1}), CellFold::None);
  EXPECT_DOUBLE_EQ(cell.lengthPerCell(), 1 + std::sqrt(0.0625 + 2));
}

TEST(UnitCellTest, RefusesWhatIsNoCell) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Struts = std::vector<CellStrut>;
  EXPECT_THROW(UnitCell("none", Struts{}), Error);
  EXPECT_THROW(UnitCell("point", Struts{{{0, 0, 0}, {0, 0, 0}}}), Error);
  EXPECT_THROW(UnitCell("nan", Struts{{{0, 0, 0}, {0, nan, 1}}}), Error);
  EXPECT_THROW(UnitCell("far", Struts{{{0, 0, 0}, {0, 0, 2.5}}}), Error);
  EXPECT_THROW(UnitCell::reentrant(0.5), Error);
  EXPECT_THROW(UnitCell::reentrant(1), Error);
  EXPECT_THROW(UnitCell::reentrant(nan), Error);
  const std::vector<Vec3<double>> nodes{{0, 0, 0}};
  EXPECT_THROW(UnitCell("loose", nodes, std::vector<std::array<std::uint32_t, 2>>{{0, 1}}), Error);
}

}  // namespace
}  // namespace cutwater::test
