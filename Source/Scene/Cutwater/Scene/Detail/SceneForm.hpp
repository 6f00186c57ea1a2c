#pragma once

#include <Cutwater/Sdf/Solid.hpp>

#include <optional>

namespace cutwater::scene {

using SceneSolid = Solid<double>;

class SceneRecord;
struct SceneForm;

enum class KeyType : std::uint8_t {
  Number,
  Positive,
  NotNegative,
  Whole,  ///< from 0
  Flag,
  Text,
  File,
  Choice,
  Point,  ///< three numbers
  Points,
  Sizes,     ///< three, above 0
  Counts,    ///< three, whole, from 0
  Axis,      ///< "x", "y", "z" or a direction
  Columns,   ///< of a matrix
  Outline,   ///< points in a plane
  Outlines,  ///< lists of them
  Solid,
  Solids,
  Parts,           ///< a list of tables, each of one of the key's forms
  Part,            ///< one such table
  NumberOrPart,    ///< a number, or such a table
  PositiveOrPart,  ///< a number above 0, or such a table
  SizesOrPart,     ///< a number above 0, three of them, or such a table
  SizesByPlace,    ///< a number above 0, or a list of places with a size for each
};

inline const std::string kOptional;  ///< the default of a key that may be left out

/// A key that a table of a scene file may have.
struct SceneKey {
  std::string name;
  KeyType type;
  std::string meaning;
  /// The default value, in TOML; none: the key is required.
  std::optional<std::string> preset = {};
  std::vector<std::string> choices = {};
  const std::vector<SceneForm>* forms = nullptr;
};

/// A kind of table in a scene file: a shape, an operator, a mesh, a step of a motion.
struct SceneForm {
  std::string name;
  std::string meaning;
  std::vector<SceneKey> keys;
  SceneSolid (*make)(const SceneRecord&) = nullptr;
  /// The key whose value, the form's name, identifies the form: shape = "torus". If empty, the form
  /// is identified by its first key.
  std::string kindKey = {};
  std::size_t operandCopies = 1;  ///< how often its expression contains each of its operands

  [[nodiscard]] const std::string& identifyingKey() const {
    return kindKey.empty() ? keys.front().name : kindKey;
  }
};

/// Forms listed under one heading.
struct SceneForms {
  std::string title;
  std::string introduction;
  const std::vector<SceneForm>& forms;
};

// A new kind of solid is a row of one of these, or one more list.
const std::vector<SceneForm>& shapeForms();
const std::vector<SceneForm>& surfaceForms();
const std::vector<SceneForm>& latticeForms();
const std::vector<SceneForm>& tpmsForms();
const std::vector<SceneForm>& operatorForms();

/// All of the above, in the order of the page.
const std::vector<SceneForms>& allSceneForms();
/// The keys that every solid takes, ...
const std::vector<SceneKey>& commonKeys();
/// ... and their effect.
SceneSolid placed(SceneSolid solid, const SceneRecord& record);

}  // namespace cutwater::scene
