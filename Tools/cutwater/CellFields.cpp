#include "CellFields.hpp"

namespace cutwater::tool {

namespace {

constexpr std::uint8_t kCovered = 4;  // after those of BoxClass

}  // namespace

CellFields::CellFields(const Octree<double>& mesh, const std::vector<std::string>& names) {
  const auto cells = mesh.cells();
  for (const auto& name : names) {
    if (name == "distance") add(name, distance_, cells.size());
    if (name == "normal") add(name, normal_, cells.size());
    if (name == "patch") add(name, patch_, cells.size());
    if (name == "patches") add(name, patches_, cells.size());
    if (name == "class") add(name, class_, cells.size());
    if (name == "level") add(name, level_, cells.size());
  }
  for (std::size_t n = 0; n < class_.size(); ++n) {
    class_[n] = static_cast<std::uint8_t>(cells[n].kind);
  }
  for (std::size_t n = 0; n < level_.size(); ++n) level_[n] = cells[n].level;
}

const std::vector<std::string>& CellFields::names() {
  static const std::vector<std::string> all{"distance", "normal", "patch",
                                            "patches",  "class",  "level"};
  return all;
}

template <typename Value>
void CellFields::add(const std::string& name, std::vector<Value>& values, std::size_t count) {
  if (!values.empty()) return;  // named twice
  values.resize(count);
  arrays_.push_back({name, std::span<const Value>(values)});
}

void CellFields::setPatches(const CellPatches& patches) {
  for (std::size_t n = 0; n < patches_.size(); ++n) {
    for (const auto patch : patches.of(n)) {
      if (patch < 64) patches_[n] |= std::uint64_t{1} << patch;
    }
  }
}

void CellFields::cover(std::span<const std::size_t> cells) {
  if (class_.empty()) return;
  for (const auto n : cells) class_[n] = kCovered;
}

}  // namespace cutwater::tool
