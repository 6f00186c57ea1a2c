#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Scene/Detail/SceneTypes.hpp>
#include <Cutwater/Text/Words.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace cutwater::scene {

namespace {

bool isFinite(double x) {
  return std::isfinite(x);
}
bool isPositive(double x) {
  return x > 0 && std::isfinite(x);
}
bool isNotNegative(double x) {
  return x >= 0 && std::isfinite(x);
}
bool isWhole(double x) {
  constexpr double kMost = 4294967294;  // 2^32 - 2
  return x >= 0 && x <= kMost && std::floor(x) == x;
}

using NumberTest = bool (*)(double);
using ValueTest = bool (*)(const SceneValue&);

template <NumberTest kTest>
bool isNumber(const SceneValue& value) {
  const auto* const number = value.as<double>();
  return number != nullptr && kTest(*number);
}

template <ValueTest kTest>
bool isListOf(const SceneValue& value) {
  const auto* const list = value.as<SceneValue::List>();
  return list != nullptr && std::all_of(list->begin(), list->end(), kTest);
}

template <std::size_t kCount, ValueTest kTest>
bool isListOf(const SceneValue& value) {
  return isListOf<kTest>(value) && value.as<SceneValue::List>()->size() == kCount;
}

template <ValueTest... kTests>
bool isAnyOf(const SceneValue& value) {
  return (kTests(value) || ...);
}

bool isFlag(const SceneValue& value) {
  return value.as<bool>() != nullptr;
}

bool isText(const SceneValue& value) {
  const auto* const text = value.as<std::string>();
  return text != nullptr && !text->empty();
}

/// Without control characters: errors that name the file stay on one line.
bool isFileName(const SceneValue& value) {
  return isText(value) && std::ranges::all_of(*value.as<std::string>(), text::isPrintable);
}

bool isNameOfAxis(const SceneValue& value) {
  const auto* const name = value.as<std::string>();
  return name != nullptr && axisNamed(*name) >= 0;
}

bool areNames(const SceneValue& value) {
  return isListOf<isText>(value) && !value.as<SceneValue::List>()->empty();
}

bool isTable(const SceneValue& value) {
  return value.as<SceneValue::Table>() != nullptr;
}

constexpr ValueTest kIsPoint = isListOf<3, isNumber<isFinite>>;
constexpr ValueTest kIsSizes = isListOf<3, isNumber<isPositive>>;
constexpr ValueTest kIsOutline = isListOf<isListOf<2, isNumber<isFinite>>>;

/// What the keys of a type take: in words, and as a test.
struct TypeRule {
  KeyType type;
  const char* words;
  ValueTest accepts;
};

using enum KeyType;

/// In the order of KeyType.
constexpr std::array kRules{
    TypeRule{Number, "a number", isNumber<isFinite>},
    TypeRule{Positive, "a number above 0", isNumber<isPositive>},
    TypeRule{NotNegative, "a number, 0 or more", isNumber<isNotNegative>},
    TypeRule{Whole, "a whole number, 0 or more", isNumber<isWhole>},
    TypeRule{Flag, "true or false", isFlag},
    TypeRule{Text, "a text", isText},
    TypeRule{File, "the name of a file", isFileName},
    TypeRule{Choice, "one of", isText},  // the key's choices; see below
    TypeRule{Point, "three numbers", kIsPoint},
    TypeRule{Points, "a list of points, three numbers each", isListOf<kIsPoint>},
    TypeRule{Sizes, "three numbers above 0", kIsSizes},
    TypeRule{Counts, "three whole numbers, 0 or more", isListOf<3, isNumber<isWhole>>},
    TypeRule{Axis, R"("x", "y", "z" or three numbers)", isAnyOf<isNameOfAxis, kIsPoint>},
    TypeRule{Columns, "three columns of three numbers", isListOf<3, kIsPoint>},
    TypeRule{Outline, "a list of points, two numbers each", kIsOutline},
    TypeRule{Outlines, "lists of points, two numbers each", isListOf<kIsOutline>},
    TypeRule{KeyType::Solid, "the name of a solid", isText},
    TypeRule{Solids, "a list of names of solids", areNames},
    TypeRule{Parts, "a list of tables", isListOf<isTable>},
    TypeRule{Part, "a table", isTable},
    TypeRule{NumberOrPart, "a number, or a table", isAnyOf<isNumber<isFinite>, isTable>},
    TypeRule{PositiveOrPart, "a number above 0, or a table",
             isAnyOf<isNumber<isPositive>, isTable>},
    TypeRule{SizesOrPart, "a number above 0, three of them, or a table",
             isAnyOf<isNumber<isPositive>, kIsSizes, isTable>},
    TypeRule{SizesByPlace, "a number above 0, or a list of points, two numbers each",
             isAnyOf<isNumber<isPositive>, kIsOutline>},
};

constexpr bool isInOrder() {
  for (std::size_t i = 0; i < kRules.size(); ++i) {
    if (kRules[i].type != static_cast<KeyType>(i)) return false;
  }
  return kRules.back().type == SizesByPlace;
}
static_assert(isInOrder());

const TypeRule& ruleOf(const SceneKey& key) {
  return kRules[static_cast<std::size_t>(key.type)];
}

}  // namespace

bool hasType(const SceneValue& value, const SceneKey& key) {
  if (!ruleOf(key).accepts(value)) return false;
  return key.type != Choice || std::ranges::count(key.choices, *value.as<std::string>()) > 0;
}

std::string typeText(const SceneKey& key) {
  std::string words = ruleOf(key).words;
  for (const auto& choice : key.choices) {
    words += (&choice == key.choices.data() ? " \"" : ", \"") + choice + '"';
  }
  return words;
}

std::string textOf(const SceneValue& value) {
  if (const auto* flag = value.as<bool>()) return *flag ? "true" : "false";
  if (const auto* number = value.as<double>()) return cutwater::detail::toText(*number);
  if (const auto* text = value.as<std::string>()) return text::inQuotes(*text);
  if (const auto* list = value.as<SceneValue::List>()) {
    return "a list of " + std::to_string(list->size());
  }
  return "a table";
}

Vec3<double> pointOf(const SceneValue& value) {
  const auto& list = *value.as<SceneValue::List>();
  return {*list[0].as<double>(), *list[1].as<double>(), *list[2].as<double>()};
}

int axisNamed(const std::string& name) {
  if (name.size() != 1 || name < "x" || "z" < name) return -1;
  return name[0] - 'x';
}

}  // namespace cutwater::scene
