#pragma once

#include <string>
#include <vector>

namespace cutwater::text {

/// The end of a message about an unknown word: `; is it "radius"?`, with the known word that has
/// nearly the same meaning ("cuboid" for "box"). Else with the only one that begins with the word;
/// else with the nearest by the number of characters to insert, remove, replace or swap with their
/// neighbour. Empty if none is nearer than a third of the word's length.
[[nodiscard]] std::string suggestion(const std::string& word,
                                     const std::vector<std::string>& words);

}  // namespace cutwater::text
