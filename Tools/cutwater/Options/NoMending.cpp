// Replaces Mending.cpp where the program is built without Cutwater::Repair.
#include "Options/Mending.hpp"

namespace cutwater::tool {

bool canMend() {
  return false;
}

HoleFilling holeFilling() {
  return {};
}

void addMendingOptions(Command, MendingOptions&) {}

std::string commandLine(const MendingOptions&) {
  return {};
}

void addMendingSteps(const MendingOptions&, std::vector<RepairStep>&) {}

}  // namespace cutwater::tool
