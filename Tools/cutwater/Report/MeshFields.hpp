#pragma once

#include <Cutwater/Grid/CellPatches.hpp>
#include <Cutwater/Grid/OctreeFill.hpp>
#include <Cutwater/Io/VtkFiles.hpp>

#include <array>
#include <string>
#include <vector>

namespace cutwater::tool {

/// The requested arrays, one value per cell.
class MeshFields {
 public:
  MeshFields(const OctreeCells<double>& mesh, const std::vector<std::string>& names);

  /// The names of all arrays that can be requested.
  static const std::vector<std::string>& names();

  /// Values at the cells' centres.
  [[nodiscard]] OctreeTargets<double> targets() { return {distance_, normal_, patch_}; }
  /// Whether setPatches() is needed.
  [[nodiscard]] bool hasPatches() const { return !patches_.empty(); }
  /// Patch n, of the first 64, is bit n of a cell's number.
  void setPatches(const CellPatches& patches);
  /// The names of the solid's patches if an array refers to them, for the file; otherwise none.
  [[nodiscard]] std::vector<std::string> patchNamesOf(
      const SignedDistanceFunction<double>& solid) const;
  /// Gives the cells to be covered a class of their own.
  void cover(std::span<const std::size_t> cells);
  [[nodiscard]] std::span<const VtkArray> arrays() const { return arrays_; }

 private:
  template <typename Value>
  void add(const std::string& name, std::vector<Value>& values, std::size_t count);

  std::vector<double> distance_;
  std::vector<Vec3<double>> normal_;
  std::vector<std::uint32_t> patch_;
  std::vector<std::uint64_t> patches_;
  std::vector<std::uint8_t> class_;
  std::vector<std::uint8_t> level_;
  std::vector<VtkArray> arrays_;
};

/// Number of cells of a mesh on each level and of each kind, indexed by the values of BoxClass.
struct CellCounts {
  explicit CellCounts(const OctreeCells<double>& mesh);

  std::vector<std::uint64_t> onLevel;
  std::array<std::uint64_t, 4> ofKind{};
};

/// Prints the domain and the counts.
void report(const CellCounts& counts, const OctreeDomain<double>& domain);

}  // namespace cutwater::tool
