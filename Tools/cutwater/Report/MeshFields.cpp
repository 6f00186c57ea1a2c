#include "Report/MeshFields.hpp"

#include <algorithm>
#include <iostream>

#include "Report/Format.hpp"

namespace cutwater::tool {

namespace {

constexpr std::uint8_t kCovered = 4;  // after those of BoxClass

}  // namespace

MeshFields::MeshFields(const OctreeCells<double>& mesh, const std::vector<std::string>& names) {
  const auto count = mesh.cells().size();
  for (const auto& name : names) {
    if (name == "distance") add(name, distance_, count);
    if (name == "normal") add(name, normal_, count);
    if (name == "patch") add(name, patch_, count);
    if (name == "patches") add(name, patches_, count);
    if (name == "class") add(name, class_, count);
    if (name == "level") add(name, level_, count);
  }
  const auto cells = mesh.cells();
  for (std::size_t n = 0; n < class_.size(); ++n) {
    class_[n] = static_cast<std::uint8_t>(cells[n].kind);
  }
  for (std::size_t n = 0; n < level_.size(); ++n) level_[n] = cells[n].level;
}

const std::vector<std::string>& MeshFields::names() {
  static const std::vector<std::string> all{"distance", "normal", "patch",
                                            "patches",  "class",  "level"};
  return all;
}

void MeshFields::setPatches(const CellPatches& patches) {
  for (std::size_t n = 0; n < patches_.size(); ++n) {
    for (const auto patch : patches.of(n)) {
      if (patch < 64) patches_[n] |= std::uint64_t{1} << patch;
    }
  }
}

std::vector<std::string> MeshFields::patchNamesOf(
    const SignedDistanceFunction<double>& solid) const {
  if (patch_.empty() && patches_.empty()) return {};
  return solid.patchNames();
}

void MeshFields::cover(std::span<const std::size_t> cells) {
  if (class_.empty()) return;
  for (const auto n : cells) class_[n] = kCovered;
}

template <typename Value>
void MeshFields::add(const std::string& name, std::vector<Value>& values, std::size_t count) {
  const bool isNamedTwice = std::ranges::find(arrays_, name, &VtkArray::name) != arrays_.end();
  if (isNamedTwice) return;
  values.resize(count);
  arrays_.push_back({name, std::span<const Value>(values)});
}

CellCounts::CellCounts(const OctreeCells<double>& mesh)
    : onLevel(static_cast<std::size_t>(mesh.deepest()) + 1) {
  for (const auto& cell : mesh.cells()) {
    ++onLevel[cell.level];
    ++ofKind[static_cast<std::size_t>(cell.kind)];
  }
}

void report(const CellCounts& counts, const OctreeDomain<double>& domain) {
  const auto& n = domain.roots();
  std::cout << "roots: " << n.i << " x " << n.j << " x " << n.k << ", from "
            << point(domain.box().lower) << " to " << point(domain.box().upper) << '\n';
  for (std::size_t level = 0; level < counts.onLevel.size(); ++level) {
    const double width = domain.level(static_cast<int>(level)).spacing().x;
    std::cout << "level " << rightAligned(grouped(level), 2) << ": "
              << rightAligned(grouped(counts.onLevel[level]), 13) << " cells of " << number(width)
              << '\n';
  }
  const auto of = [&](BoxClass kind) {
    return grouped(counts.ofKind[static_cast<std::size_t>(kind)]);
  };
  std::cout << "inside: " << of(BoxClass::Inside) << ", outside: " << of(BoxClass::Outside)
            << ", cut: " << of(BoxClass::Cut) << ", unknown: " << of(BoxClass::Unknown)
            << " cells\n";
  const bool isMet = counts.ofKind[static_cast<std::size_t>(BoxClass::Cut)] > 0 ||
                     counts.ofKind[static_cast<std::size_t>(BoxClass::Unknown)] > 0;
  if (!isMet) std::cout << "no cell is cut: the surface does not come into the box\n";
}

}  // namespace cutwater::tool
