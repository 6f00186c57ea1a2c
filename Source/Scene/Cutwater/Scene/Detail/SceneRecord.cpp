#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Scene/Detail/ParseToml.hpp>
#include <Cutwater/Scene/Detail/SceneRecord.hpp>
#include <Cutwater/Scene/Detail/SceneTypes.hpp>
#include <Cutwater/Text/Suggestion.hpp>
#include <Cutwater/Text/Words.hpp>

#include <algorithm>
#include <cassert>

namespace cutwater::scene {

namespace {

const SceneValue::Entry* find(const SceneValue::Table& table, const std::string& key) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.key == key; });
  return found == table.end() ? nullptr : &*found;
}

bool hasForm(const SceneValue::Table& table, const SceneForm& form) {
  const auto* const entry = find(table, form.identifyingKey());
  if (entry == nullptr || form.kindKey.empty()) return entry != nullptr;
  const auto* const name = entry->value.as<std::string>();
  return name != nullptr && *name == form.name;
}

/// Explains why a table has none of the forms.
[[noreturn]] void failWithoutForm(const SceneContext& context, const SceneValue::Table& table,
                                  std::uint64_t line, const std::string& what,
                                  std::span<const SceneForm* const> forms) {
  std::vector<std::string> keys;
  for (const auto* form : forms) {
    if (std::find(keys.begin(), keys.end(), form->identifyingKey()) == keys.end()) {
      keys.push_back(form->identifyingKey());
    }
  }
  for (const auto& entry : table) {
    if (std::find(keys.begin(), keys.end(), entry.key) == keys.end()) continue;
    std::vector<std::string> names;
    for (const auto* form : forms) {
      if (form->kindKey == entry.key) names.push_back(form->name);
    }
    const auto* const name = entry.value.as<std::string>();
    failAt(context.file, entry.line,
           what + ": there is no " + entry.key + " " + textOf(entry.value) +
               (name == nullptr ? "" : text::suggestion(*name, names)));
  }
  for (const auto& entry : table) {
    const auto near = text::suggestion(entry.key, keys);
    if (near.empty()) continue;
    failAt(context.file, entry.line, what + " has no key " + text::inQuotes(entry.key) + near);
  }
  std::string all;
  for (const auto& key : keys) all += (all.empty() ? "\"" : ", \"") + key + '"';
  failAt(context.file, line, what + " needs a key that tells what it is: one of " + all);
}

}  // namespace

const SceneForm& formOf(const SceneContext& context, const SceneValue::Table& table,
                        std::uint64_t line, const std::string& what,
                        std::span<const SceneForm* const> forms) {
  const SceneForm* found = nullptr;
  for (const auto* form : forms) {
    if (!hasForm(table, *form)) continue;
    if (found != nullptr) {
      failAt(context.file, find(table, form->identifyingKey())->line,
             what + R"( cannot have both ")" + found->identifyingKey() + R"(" and ")" +
                 form->identifyingKey() + '"');
    }
    found = form;
  }
  if (found == nullptr) failWithoutForm(context, table, line, what, forms);
  return *found;
}

SceneRecord::SceneRecord(const SceneContext& context, const SceneForm& form,
                         const SceneValue::Table& table, std::uint64_t line,
                         const std::vector<SceneKey>& furtherKeys, std::string name)
    : context_(&context), form_(&form), line_(line), name_(std::move(name)) {
  for (const auto* keys : {&form.keys, &furtherKeys}) {
    for (const auto& key : *keys) values_.push_back({&key, {}, true, false});
  }
  refuseUnknown(table);
  for (auto& value : values_) assign(value, table);
}

void SceneRecord::refuseUnknown(const SceneValue::Table& table) const {
  std::vector<std::string> names;
  if (!form_->kindKey.empty()) names.push_back(form_->kindKey);
  for (const auto& value : values_) names.push_back(value.key->name);
  for (const auto& entry : table) {
    if (std::find(names.begin(), names.end(), entry.key) != names.end()) continue;
    failAt(context_->file, entry.line,
           form_->name + " has no key " + text::inQuotes(entry.key) +
               text::suggestion(entry.key, names));
  }
}

void SceneRecord::assign(Value& value, const SceneValue::Table& table) const {
  const auto& key = *value.key;
  if (const auto* const entry = find(table, key.name)) {
    value.value = entry->value;
    value.value.line = entry->line;
    value.isAbsent = false;
    value.isGiven = true;
    check(key, value.value);
    return;
  }
  if (!key.preset) {
    failAt(context_->file, line_, form_->name + " needs \"" + key.name + "\", " + typeText(key));
  }
  value.value.line = line_;
  if (key.preset->empty()) return;
  value.value.content = parseToml("preset = " + *key.preset, key.name).front().value.content;
  value.isAbsent = false;
  assert(hasType(value.value, key));
}

void SceneRecord::check(const SceneKey& key, const SceneValue& value) const {
  if (!hasType(value, key)) {
    const auto* const name = value.as<std::string>();
    failAt(context_->file, value.line,
           '"' + key.name + "\" of " + form_->name + ": need " + typeText(key) + ", found " +
               textOf(value) + (name == nullptr ? "" : text::suggestion(*name, key.choices)));
  }
  if (value.as<SceneValue::Table>() != nullptr) static_cast<void>(part(key, value));
  if (key.type != KeyType::Parts) return;
  for (const auto& element : *value.as<SceneValue::List>()) static_cast<void>(part(key, element));
}

SceneRecord SceneRecord::part(const SceneKey& key, const SceneValue& value) const {
  std::vector<const SceneForm*> forms;
  for (const auto& form : *key.forms) forms.push_back(&form);
  const auto& table = *value.as<SceneValue::Table>();
  const auto& form = formOf(*context_, table, value.line, "a table of \"" + key.name + '"', forms);
  return {*context_, form, table, value.line};
}

std::size_t SceneRecord::indexOf(std::string_view key) const {
  const auto found = std::find_if(values_.begin(), values_.end(),
                                  [&](const auto& value) { return value.key->name == key; });
  assert(found != values_.end());
  return static_cast<std::size_t>(found - values_.begin());
}

bool SceneRecord::isNumber(std::string_view key) const {
  return valueOf(key).as<double>() != nullptr;
}

double SceneRecord::number(std::string_view key) const {
  return *valueOf(key).as<double>();
}

std::optional<double> SceneRecord::optionalNumber(std::string_view key) const {
  return has(key) ? std::optional(number(key)) : std::nullopt;
}

std::uint32_t SceneRecord::whole(std::string_view key) const {
  return static_cast<std::uint32_t>(number(key));
}

bool SceneRecord::flag(std::string_view key) const {
  return *valueOf(key).as<bool>();
}

const std::string& SceneRecord::text(std::string_view key) const {
  return *valueOf(key).as<std::string>();
}

std::filesystem::path SceneRecord::file(std::string_view key) const {
  return context_->folder / text(key);
}

std::size_t SceneRecord::choice(std::string_view key) const {
  const auto index = indexOf(key);
  const auto& choices = values_[index].key->choices;
  return static_cast<std::size_t>(std::find(choices.begin(), choices.end(), text(key)) -
                                  choices.begin());
}

Vec3<double> SceneRecord::point(std::string_view key) const {
  return pointOf(valueOf(key));
}

std::vector<Vec3<double>> SceneRecord::points(std::string_view key) const {
  std::vector<Vec3<double>> result;
  for (const auto& one : *valueOf(key).as<SceneValue::List>()) result.push_back(pointOf(one));
  return result;
}

std::array<std::uint32_t, 3> SceneRecord::counts(std::string_view key) const {
  const auto p = point(key);
  return {static_cast<std::uint32_t>(p.x), static_cast<std::uint32_t>(p.y),
          static_cast<std::uint32_t>(p.z)};
}

std::variant<int, Vec3<double>> SceneRecord::axis(std::string_view key) const {
  if (const auto* const name = valueOf(key).as<std::string>()) return axisNamed(*name);
  return point(key);
}

std::array<Vec3<double>, 3> SceneRecord::columns(std::string_view key) const {
  const auto& list = *valueOf(key).as<SceneValue::List>();
  return {pointOf(list[0]), pointOf(list[1]), pointOf(list[2])};
}

namespace {

std::vector<Vec2<double>> outlineOf(const SceneValue& value) {
  std::vector<Vec2<double>> points;
  for (const auto& point : *value.as<SceneValue::List>()) {
    const auto& numbers = *point.as<SceneValue::List>();
    points.push_back({*numbers[0].as<double>(), *numbers[1].as<double>()});
  }
  return points;
}

}  // namespace

std::vector<Vec2<double>> SceneRecord::outline(std::string_view key) const {
  return outlineOf(valueOf(key));
}

std::vector<std::vector<Vec2<double>>> SceneRecord::outlines(std::string_view key) const {
  std::vector<std::vector<Vec2<double>>> result;
  for (const auto& one : *valueOf(key).as<SceneValue::List>()) result.push_back(outlineOf(one));
  return result;
}

const SceneSolid& SceneRecord::solid(std::string_view key) const {
  return context_->solids.find(text(key))->second;
}

std::vector<SceneSolid> SceneRecord::solids(std::string_view key) const {
  std::vector<SceneSolid> result;
  for (const auto& name : *valueOf(key).as<SceneValue::List>()) {
    result.push_back(context_->solids.find(*name.as<std::string>())->second);
  }
  return result;
}

const SceneRecord& SceneRecord::record(std::string_view key) const {
  return *context_->records.find(text(key))->second;
}

std::vector<SceneRecord> SceneRecord::parts(std::string_view key) const {
  const auto& [declared, value, isAbsent, isGiven] = values_[indexOf(key)];
  std::vector<SceneRecord> result;
  if (value.as<SceneValue::Table>() != nullptr) result.push_back(part(*declared, value));
  if (declared->type == KeyType::Parts) {
    for (const auto& element : *value.as<SceneValue::List>())
      result.push_back(part(*declared, element));
  }
  return result;
}

void SceneRecord::forEachReference(
    FunctionRef<void(const std::string&, std::uint64_t)> visit) const {
  for (const auto& [key, value, isAbsent, isGiven] : values_) {
    if (isAbsent) continue;
    if (key->type == KeyType::Solid) visit(*value.as<std::string>(), value.line);
    if (key->type == KeyType::Solids) {
      for (const auto& name : *value.as<SceneValue::List>()) {
        visit(*name.as<std::string>(), name.line);
      }
    }
    if (key->forms == nullptr) continue;
    for (const auto& one : parts(key->name)) one.forEachReference(visit);
  }
}

void SceneRecord::fail(std::string_view key, const std::string& message) const {
  failAt(context_->file, valueOf(key).line, form_->name + ": " + message);
}

}  // namespace cutwater::scene
