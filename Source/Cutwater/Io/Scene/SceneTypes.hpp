#pragma once

#include <Cutwater/Io/Scene/SceneForm.hpp>
#include <Cutwater/Io/Scene/SceneValue.hpp>

// Private: not installed.

namespace cutwater::scene {

/// Whether a value is of the key's type: numbers are finite then, lists have their lengths. Of
/// parts, only that they are tables.
[[nodiscard]] bool hasType(const SceneValue& value, const SceneKey& key);

/// What a key takes, in words: "a number above 0".
[[nodiscard]] std::string typeText(const SceneKey& key);

/// A value as messages tell it: `the text "abc"`.
[[nodiscard]] std::string textOf(const SceneValue& value);

/// Three numbers, from a value that has them.
[[nodiscard]] Vec3<double> pointOf(const SceneValue& value);
/// The coordinate axis of this name; -1: none.
[[nodiscard]] int axisNamed(const std::string& name);

}  // namespace cutwater::scene
