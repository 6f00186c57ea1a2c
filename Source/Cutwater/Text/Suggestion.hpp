#pragma once

#include <string>
#include <vector>

namespace cutwater::scene {

/// Returns `; is it "radius"?` with the nearest of the words, by the number of characters to
/// insert, remove, replace or swap with their neighbour. Returns nothing if that exceeds a third of
/// the word's length.
[[nodiscard]] std::string suggestion(const std::string& word,
                                     const std::vector<std::string>& words);

}  // namespace cutwater::scene
