#pragma once

#include <Cutwater/Scene/Detail/SceneRecord.hpp>

namespace cutwater::scene {

/// The solids of a scene file and how they depend on each other. Solids are made only on request,
/// but the whole file is checked.
class SceneGraph {
 public:
  /// @throws Error(File) with the line for tables that are not solids, names of solids that do not
  /// exist, and solids that contain themselves; Error(Limit) for solids that are nested too deeply
  /// or contain too many others.
  SceneGraph(const SceneValue::Table& top, SceneContext context);
  SceneGraph(const SceneGraph&) = delete;  // its records refer to its context
  SceneGraph& operator=(const SceneGraph&) = delete;
  ~SceneGraph() = default;

  /// Makes the solid of this name; if the name is empty, the one that the file selects, or else its
  /// last.
  /// @throws Error(Argument) if there is no solid of this name; whatever the solid's own
  /// constructor throws, with the line.
  [[nodiscard]] SceneSolid make(const std::string& name);

 private:
  struct Reference {
    std::size_t item;
    std::uint64_t line;
  };
  struct Item {
    SceneRecord record;
    std::vector<Reference> references = {};
    // Sizes of the expression, once measured:
    std::size_t depth = 0;
    std::size_t pieces = 0;  ///< shapes, meshes and lattices, with repetitions
  };

  void add(const SceneValue::Entry& entry);
  [[nodiscard]] std::size_t indexOf(const std::string& name, std::uint64_t line) const;
  /// Computes depth and pieces. `path`: the items that lead to this one.
  void measure(std::size_t index, std::vector<std::size_t>& path);
  [[noreturn]] void failLimit(const Item& item, const std::string& message) const;
  [[noreturn]] void failCycle(const std::vector<std::size_t>& path, const Reference& back) const;
  void make(const Item& item);
  /// The beginning of messages about a solid.
  [[nodiscard]] std::string at(const Item& item) const;
  [[nodiscard]] std::vector<std::string> names() const;

  SceneContext context_;
  std::vector<Item> items_;
  std::map<std::string, std::size_t, std::less<>> indices_;
  std::size_t selected_ = 0;
};

}  // namespace cutwater::scene
