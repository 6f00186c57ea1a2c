#pragma once

#include <Cutwater/Grid/CellPatches.hpp>
#include <Cutwater/Grid/OctreeFill.hpp>
#include <Cutwater/Io/VtkXml.hpp>

#include <array>
#include <string>
#include <vector>

namespace cutwater::tool {

/// The arrays that were asked for, one value per cell.
class MeshFields {
 public:
  MeshFields(const OctreeCells<double>& mesh, const std::vector<std::string>& names);

  /// All that can be asked for.
  static const std::vector<std::string>& names();

  /// Values at the cells' centres.
  [[nodiscard]] OctreeTargets<double> targets() { return {distance_, normal_, patch_}; }
  /// Whether setPatches() is needed.
  [[nodiscard]] bool hasPatches() const { return !patches_.empty(); }
  /// Patch n of the first 64 is bit n of a cell's number.
  void setPatches(const CellPatches& patches);
  /// Cells that are to be covered have a class of their own.
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

/// How many cells a mesh has on each level and of each kind: of BoxClass's numbers.
struct CellCounts {
  explicit CellCounts(const OctreeCells<double>& mesh);

  std::vector<std::uint64_t> onLevel;
  std::array<std::uint64_t, 4> ofKind{};
};

/// Tells the domain, and the counts.
void report(const CellCounts& counts, const OctreeDomain<double>& domain);

}  // namespace cutwater::tool
