#pragma once

#include <Cutwater/Scene/Detail/SceneForm.hpp>
#include <Cutwater/Scene/Detail/SceneValue.hpp>

namespace cutwater::scene {

/// Whether a value is of the key's type: numbers must be finite, lists of the right length. Parts
/// are only checked to be tables.
[[nodiscard]] bool hasType(const SceneValue& value, const SceneKey& key);

/// A description of the values that a key takes: "a number above 0".
[[nodiscard]] std::string typeText(const SceneKey& key);

/// A value as it appears in messages: `the text "abc"`.
[[nodiscard]] std::string textOf(const SceneValue& value);

/// The point in a value that has three numbers.
[[nodiscard]] Vec3<double> pointOf(const SceneValue& value);
/// The coordinate axis of this name; -1 if there is none.
[[nodiscard]] int axisNamed(const std::string& name);

}  // namespace cutwater::scene
