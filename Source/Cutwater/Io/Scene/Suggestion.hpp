#pragma once

#include <string>
#include <vector>

// Private: not installed.

namespace cutwater::scene {

/// `; is it "radius"?` with the nearest of the words, by the number of characters to insert,
/// remove, replace or exchange with their neighbour, at most a third of the word's; else nothing.
[[nodiscard]] std::string suggestion(const std::string& word,
                                     const std::vector<std::string>& words);

}  // namespace cutwater::scene
