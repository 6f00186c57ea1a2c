// Replaces Mending.cpp where the program is built without Cutwater::Repair.
#include "Mending.hpp"

namespace cutwater::tool {

bool canMend() {
  return false;
}

void addMendingOptions(CLI::App&, MendingOptions&) {}

std::string commandLine(const MendingOptions&) {
  return {};
}

void addMendingSteps(const MendingOptions&, std::vector<RepairStep>&) {}

}  // namespace cutwater::tool
