#pragma once

#include <cutwater.h>
#include <memory>

#include <gtest/gtest.h>

namespace cutwater::test {

using SolidHandle = std::unique_ptr<cw_solid, decltype(&cw_free)>;
using CellsHandle = std::unique_ptr<cw_cells, decltype(&cw_free_cells)>;
using CutterHandle = std::unique_ptr<cw_cutter, decltype(&cw_free_cutter)>;

/// What make(&handle) gives; expects that it succeeds.
template <typename Make>
SolidHandle made(Make make) {
  cw_solid* solid = nullptr;
  EXPECT_EQ(make(&solid), CW_OK) << cw_last_error();
  return {solid, &cw_free};
}
template <typename Make>
CellsHandle cellsOf(Make make) {
  cw_cells* cells = nullptr;
  EXPECT_EQ(make(&cells), CW_OK) << cw_last_error();
  return {cells, &cw_free_cells};
}

}  // namespace cutwater::test
