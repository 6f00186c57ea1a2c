#pragma once

#include <Cutwater/Io/Scene/SceneRecord.hpp>

// Private: not installed.

namespace cutwater::scene {

/// The solids of a scene file and what they are made of. Nothing is made before it is asked for,
/// but all of the file is checked.
class SceneGraph {
 public:
  /// @throws Error(File) with the line for tables that are no solids, names of solids that there
  /// are not, and solids that are made of themselves; Error(Limit) for those that are nested too
  /// deeply, or are made of too many.
  SceneGraph(const SceneValue::Table& top, SceneContext context);
  SceneGraph(const SceneGraph&) = delete;  // its records know its context
  SceneGraph& operator=(const SceneGraph&) = delete;
  ~SceneGraph() = default;

  /// The solid of this name; without one, that which the file says, or else its last.
  /// @throws Error(Argument) if there is none of this name; what the solid's own constructor
  /// throws, with the line.
  [[nodiscard]] Solid<double> make(const std::string& name);

 private:
  struct Reference {
    std::size_t item;
    std::uint64_t line;
  };
  struct Item {
    std::string name;
    SceneRecord record;
    std::vector<Reference> references = {};
    // Of the expression, once it is measured:
    std::size_t depth = 0;
    std::size_t pieces = 0;  ///< shapes, meshes and lattices, as often as they are in it
  };

  void add(const SceneValue::Entry& entry);
  [[nodiscard]] std::size_t indexOf(const std::string& name, std::uint64_t line) const;
  /// Finds depth and pieces. `path`: the items that lead to this one.
  void measure(std::size_t index, std::vector<std::size_t>& path);
  [[noreturn]] void failLimit(const Item& item, const std::string& message) const;
  [[noreturn]] void failCycle(const std::vector<std::size_t>& path, const Reference& back) const;
  void make(const Item& item);
  /// What messages about a solid begin with.
  [[nodiscard]] std::string at(const Item& item) const;
  [[nodiscard]] std::vector<std::string> names() const;

  SceneContext context_;
  std::vector<Item> items_;
  std::map<std::string, std::size_t, std::less<>> indices_;
  std::size_t meant_ = 0;
};

}  // namespace cutwater::scene
