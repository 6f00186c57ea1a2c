#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Scene/Detail/ParseToml.hpp>
#include <Cutwater/Scene/Detail/SceneGraph.hpp>
#include <Cutwater/Text/Suggestion.hpp>
#include <Cutwater/Text/Words.hpp>

#include <algorithm>

namespace cutwater::scene {

namespace {

constexpr const char* kSelectionKey = "solid";
// Queries descend an expression by recursive calls, and a solid that is named twice is queried
// twice: after 50 unions, each of the one before with itself, that makes 2^50 queries.
constexpr std::size_t kMostSolidLevels = 100;
constexpr std::size_t kMostPieces = 65536;

std::vector<const SceneForm*> formsOfSolids() {
  std::vector<const SceneForm*> forms;
  for (const auto& group : allSceneForms()) {
    for (const auto& form : group.forms) forms.push_back(&form);
  }
  return forms;
}

}  // namespace

SceneGraph::SceneGraph(const SceneValue::Table& top, SceneContext context)
    : context_(std::move(context)) {
  const SceneValue::Entry* selection = nullptr;
  for (const auto& entry : top) {
    if (entry.key == kSelectionKey && entry.value.as<std::string>() != nullptr) {
      selection = &entry;
    } else {
      add(entry);
    }
  }
  if (items_.empty()) throw Error(ErrorKind::File, context_.file + ": there is no solid in it");
  for (auto& item : items_) {
    context_.records.emplace(item.record.name(), &item.record);
    item.record.forEachReference([&](const std::string& name, std::uint64_t line) {
      item.references.push_back({indexOf(name, line), line});
    });
  }
  std::vector<std::size_t> path;
  for (std::size_t i = 0; i < items_.size(); ++i) measure(i, path);
  selected_ = items_.size() - 1;
  if (selection != nullptr)
    selected_ = indexOf(*selection->value.as<std::string>(), selection->line);
}

void SceneGraph::add(const SceneValue::Entry& entry) {
  const auto* const table = entry.value.as<SceneValue::Table>();
  if (table == nullptr) {
    failAt(context_.file, entry.line,
           text::inQuotes(entry.key) + " is not a key of a scene, which has \"" + kSelectionKey +
               "\", a text, and a table [name] for each solid");
  }
  static const auto kForms = formsOfSolids();
  const auto& form =
      formOf(context_, *table, entry.line, "[" + text::shortened(entry.key) + "]", kForms);
  indices_.emplace(entry.key, items_.size());
  items_.push_back({{context_, form, *table, entry.line, commonKeys(), entry.key}});
}

std::vector<std::string> SceneGraph::names() const {
  std::vector<std::string> names;
  for (const auto& item : items_) names.push_back(item.record.name());
  return names;
}

std::size_t SceneGraph::indexOf(const std::string& name, std::uint64_t line) const {
  const auto found = indices_.find(name);
  if (found != indices_.end()) return found->second;
  failAt(context_.file, line,
         "there is no solid " + text::inQuotes(name) + text::suggestion(name, names()));
}

void SceneGraph::measure(std::size_t index, std::vector<std::size_t>& path) {
  auto& item = items_[index];
  if (item.depth > 0) return;
  if (path.size() == kMostSolidLevels) failLimit(item, "solids are nested more than 100 deep");
  path.push_back(index);
  std::size_t depth = 1;
  std::size_t pieces = item.references.empty() ? 1 : 0;
  for (const auto& reference : item.references) {
    if (std::find(path.begin(), path.end(), reference.item) != path.end()) {
      failCycle(path, reference);
    }
    measure(reference.item, path);
    const auto& operand = items_[reference.item];
    depth = std::max(depth, operand.depth + 1);
    pieces += operand.pieces * item.record.form().operandCopies;
    if (depth > kMostSolidLevels) failLimit(item, "solids are nested more than 100 deep");
    if (pieces > kMostPieces) failLimit(item, "it is made of more than 65536 solids");
  }
  path.pop_back();
  item.depth = depth;
  item.pieces = pieces;
}

void SceneGraph::failLimit(const Item& item, const std::string& message) const {
  throw Error(ErrorKind::Limit, at(item) + message);
}

void SceneGraph::failCycle(const std::vector<std::size_t>& path, const Reference& back) const {
  constexpr auto kMost = 6;
  const auto first = std::find(path.begin(), path.end(), back.item);
  std::string chain;
  for (auto i = first; i != path.end() && i != first + kMost; ++i) {
    chain += text::inQuotes(items_[*i].record.name()) + " -> ";
  }
  if (path.end() - first > kMost) chain += "... -> ";
  const auto name = text::inQuotes(items_[back.item].record.name());
  failAt(context_.file, back.line, name + " is made of itself: " + chain + name);
}

std::string SceneGraph::at(const Item& item) const {
  return context_.file + ": line " + std::to_string(item.record.line()) + ": [" +
         text::shortened(item.record.name()) + "]: ";
}

SceneSolid SceneGraph::make(const std::string& name) {
  const auto found = indices_.find(name);
  if (!name.empty() && found == indices_.end()) {
    throw Error(ErrorKind::Argument, context_.file + ": there is no solid " + text::inQuotes(name) +
                                         text::suggestion(name, names()));
  }
  const auto& item = items_[name.empty() ? selected_ : found->second];
  make(item);
  return context_.solids.find(item.record.name())->second;
}

void SceneGraph::make(const Item& item) {
  if (context_.solids.contains(item.record.name())) return;
  for (const auto& reference : item.references) make(items_[reference.item]);
  try {
    const auto& record = item.record;
    auto solid = placed(record.form().make(record), record);
    const bool isNameless = solid.patchNames() == std::vector<std::string>{"surface"};
    if (isNameless && !record.has("patch") && !record.name().empty()) {
      solid = named(solid, record.name());
    }
    context_.solids.emplace(record.name(), std::move(solid));
  } catch (const SceneError&) {
    throw;  // it already has a line
  } catch (const Error& error) {
    throw Error(error.kind(), at(item) + error.what());
  }
}

}  // namespace cutwater::scene
