#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Moments/Monomials.hpp>

namespace cutwater {

namespace {

/// Of a row of so many monomials.
template <std::size_t kVariables>
int degreeOf(std::size_t size) {
  for (int degree = 0; degree <= CutCells::Moments::kHighest; ++degree) {
    if (Monomials<kVariables>::count(degree) == size) return degree;
  }
  require(false, "shifted: need all moments up to a degree", Named{"size", size});
  return 0;
}

template <std::size_t kVariables, typename Value>
std::vector<Value> shiftedRow(std::span<const Value> moments,
                              const std::array<double, kVariables>& by) {
  std::vector<Value> result(moments.begin(), moments.end());
  shift(std::span(result), degreeOf<kVariables>(result.size()), by);
  return result;
}

template <typename Value>
std::span<const Value> partOf(const std::vector<Value>& values, std::size_t row, std::size_t size) {
  return std::span(values).subspan(row * size, size);
}

}  // namespace

std::size_t CutCells::Moments::perPiece() const {
  return Monomials<3>::count(degree);
}

std::size_t CutCells::Moments::perArc() const {
  return Monomials<2>::count(degree);
}

std::span<const double> CutCells::Moments::ofVolume(std::size_t piece) const {
  return partOf(volume, piece, perPiece());
}

std::span<const double> CutCells::Moments::ofWall(std::size_t piece) const {
  return partOf(wall, piece, perPiece());
}

std::span<const Vec3<double>> CutCells::Moments::ofWallVector(std::size_t piece) const {
  return partOf(wallVector, piece, perPiece());
}

std::span<const double> CutCells::Moments::ofArc(std::size_t row) const {
  return partOf(arc, row, perArc());
}

std::vector<double> shifted(std::span<const double> moments, const Vec3<double>& from,
                            const Vec3<double>& to) {
  return shiftedRow(moments, asArray(from - to));
}

std::vector<Vec3<double>> shifted(std::span<const Vec3<double>> moments, const Vec3<double>& from,
                                  const Vec3<double>& to) {
  return shiftedRow(moments, asArray(from - to));
}

std::vector<double> shifted(std::span<const double> moments, int axis, const Vec3<double>& from,
                            const Vec3<double>& to) {
  require(axis >= 0 && axis <= 2, "shifted: need an axis from 0 to 2", Named{"axis", axis});
  return shiftedRow(moments, alongFace(from - to, axis));
}

}  // namespace cutwater
