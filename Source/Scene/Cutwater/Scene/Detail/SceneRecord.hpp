#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Core/Vec2.hpp>
#include <Cutwater/Scene/Detail/SceneForm.hpp>
#include <Cutwater/Scene/Detail/SceneValue.hpp>

#include <array>
#include <filesystem>
#include <map>
#include <variant>

namespace cutwater::scene {

/// Context shared by the tables of one file.
struct SceneContext {
  std::string file;                                       ///< its name in messages
  std::filesystem::path folder;                           ///< file names are relative to it
  std::uint64_t maxBeams = 0;                             ///< of conformal cells
  std::map<std::string, SceneSolid, std::less<>> solids;  ///< solids made so far
  std::map<std::string, const SceneRecord*, std::less<>> records;  ///< of all solids
};

/// A table with the keys of its form, each of the right type. Missing keys have their default
/// values. The value of a key is returned by the function for its type.
class SceneRecord {
 public:
  /// @throws Error(File) with the line, naming the key, for keys that the form does not have, that
  /// are missing, or whose values have the wrong type.
  SceneRecord(const SceneContext& context, const SceneForm& form, const SceneValue::Table& table,
              std::uint64_t line, const std::vector<SceneKey>& furtherKeys = {},
              std::string name = {});

  [[nodiscard]] const SceneForm& form() const { return *form_; }
  [[nodiscard]] std::uint64_t line() const { return line_; }
  /// The name of the table; empty for one within another.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// Whether the key has a value, given or by default.
  [[nodiscard]] bool has(std::string_view key) const { return !values_[indexOf(key)].isAbsent; }
  /// Whether the table contains the key.
  [[nodiscard]] bool isGiven(std::string_view key) const { return values_[indexOf(key)].isGiven; }

  /// Whether the value is a number, for keys that also take other values.
  [[nodiscard]] bool isNumber(std::string_view key) const;
  [[nodiscard]] double number(std::string_view key) const;
  [[nodiscard]] std::optional<double> optionalNumber(std::string_view key) const;
  [[nodiscard]] std::uint32_t whole(std::string_view key) const;
  [[nodiscard]] bool flag(std::string_view key) const;
  [[nodiscard]] const std::string& text(std::string_view key) const;
  [[nodiscard]] std::filesystem::path file(std::string_view key) const;
  /// The index of the value among the choices.
  [[nodiscard]] std::size_t choice(std::string_view key) const;
  [[nodiscard]] Vec3<double> point(std::string_view key) const;
  [[nodiscard]] std::vector<Vec3<double>> points(std::string_view key) const;
  [[nodiscard]] std::array<std::uint32_t, 3> counts(std::string_view key) const;
  /// A coordinate axis, or a direction.
  [[nodiscard]] std::variant<int, Vec3<double>> axis(std::string_view key) const;
  [[nodiscard]] std::array<Vec3<double>, 3> columns(std::string_view key) const;
  [[nodiscard]] std::vector<Vec2<double>> outline(std::string_view key) const;
  [[nodiscard]] std::vector<std::vector<Vec2<double>>> outlines(std::string_view key) const;
  [[nodiscard]] const SceneSolid& solid(std::string_view key) const;
  [[nodiscard]] std::vector<SceneSolid> solids(std::string_view key) const;
  /// The limit from the options of readScene().
  [[nodiscard]] std::uint64_t maxBeams() const { return context_->maxBeams; }
  /// The table of the solid that the key names.
  [[nodiscard]] const SceneRecord& record(std::string_view key) const;
  /// The tables of the key; empty if there is none.
  [[nodiscard]] std::vector<SceneRecord> parts(std::string_view key) const;

  /// Calls visit(name of a solid, line) for all solids that the table names, including those in
  /// parts.
  void forEachReference(FunctionRef<void(const std::string&, std::uint64_t)> visit) const;

  /// @throws Error(File), with the line.
  [[noreturn]] void fail(std::string_view key, const std::string& message) const;

 private:
  struct Value {
    const SceneKey* key;
    SceneValue value;
    bool isAbsent;
    bool isGiven;
  };
  void assign(Value& value, const SceneValue::Table& table) const;
  void check(const SceneKey& key, const SceneValue& value) const;
  void refuseUnknown(const SceneValue::Table& table) const;
  [[nodiscard]] std::size_t indexOf(std::string_view key) const;
  [[nodiscard]] const SceneValue& valueOf(std::string_view key) const {
    return values_[indexOf(key)].value;
  }
  [[nodiscard]] SceneRecord part(const SceneKey& key, const SceneValue& value) const;

  const SceneContext* context_;
  const SceneForm* form_;
  std::uint64_t line_;
  std::string name_;
  std::vector<Value> values_;
};

/// The form of a table, from the key that identifies it. `what` describes in messages what the
/// table should be.
/// @throws Error(File) with the line if it has none, or several.
[[nodiscard]] const SceneForm& formOf(const SceneContext& context, const SceneValue::Table& table,
                                      std::uint64_t line, const std::string& what,
                                      std::span<const SceneForm* const> forms);

}  // namespace cutwater::scene
