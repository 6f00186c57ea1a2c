#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Scene/Detail/SceneTypes.hpp>
#include <Cutwater/Text/Cursor.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::scene {

namespace {

using Test = bool (*)(double);

bool isAny(double x) {
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

bool isNumber(const SceneValue& value, Test test) {
  const auto* const number = value.as<double>();
  return number != nullptr && test(*number);
}

bool isText(const SceneValue& value) {
  const auto* const text = value.as<std::string>();
  return text != nullptr && !text->empty();
}

template <typename Test>
bool isListOf(const SceneValue& value, const Test& test) {
  const auto* const list = value.as<SceneValue::List>();
  return list != nullptr && std::all_of(list->begin(), list->end(), test);
}

bool areNumbers(const SceneValue& value, std::size_t count, Test test) {
  return isListOf(value, [&](const auto& element) { return isNumber(element, test); }) &&
         value.as<SceneValue::List>()->size() == count;
}

bool isAxis(const SceneValue& value) {
  const auto* const name = value.as<std::string>();
  return name != nullptr ? axisNamed(*name) >= 0 : areNumbers(value, 3, isAny);
}

bool isChoice(const SceneValue& value, const std::vector<std::string>& choices) {
  const auto* const text = value.as<std::string>();
  return text != nullptr && std::find(choices.begin(), choices.end(), *text) != choices.end();
}

bool arePoints(const SceneValue& value) {
  return isListOf(value, [](const auto& point) { return areNumbers(point, 3, isAny); });
}

bool isOutline(const SceneValue& value) {
  return isListOf(value, [](const auto& point) { return areNumbers(point, 2, isAny); });
}

/// Without control characters: errors that name the file stay on one line.
bool isFileName(const SceneValue& value) {
  return isText(value) && std::ranges::all_of(*value.as<std::string>(), formats::isPrintable);
}

bool areNames(const SceneValue& value) {
  return isListOf(value, isText) && !value.as<SceneValue::List>()->empty();
}

bool isTable(const SceneValue& value) {
  return value.as<SceneValue::Table>() != nullptr;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text = "one of ";
  for (const auto& word : words) text += (&word == words.data() ? "\"" : ", \"") + word + '"';
  return text;
}

}  // namespace

bool hasType(const SceneValue& value, const SceneKey& key) {
  switch (key.type) {
    case KeyType::Number:
      return isNumber(value, isAny);
    case KeyType::Positive:
      return isNumber(value, isPositive);
    case KeyType::NotNegative:
      return isNumber(value, isNotNegative);
    case KeyType::Whole:
      return isNumber(value, isWhole);
    case KeyType::Flag:
      return value.as<bool>() != nullptr;
    case KeyType::Text:
    case KeyType::Solid:
      return isText(value);
    case KeyType::File:
      return isFileName(value);
    case KeyType::Choice:
      return isChoice(value, key.choices);
    case KeyType::Point:
      return areNumbers(value, 3, isAny);
    case KeyType::Points:
      return arePoints(value);
    case KeyType::Sizes:
      return areNumbers(value, 3, isPositive);
    case KeyType::Counts:
      return areNumbers(value, 3, isWhole);
    case KeyType::Axis:
      return isAxis(value);
    case KeyType::Columns:
      return arePoints(value) && value.as<SceneValue::List>()->size() == 3;
    case KeyType::Outline:
      return isOutline(value);
    case KeyType::Outlines:
      return isListOf(value, isOutline);
    case KeyType::Solids:
      return areNames(value);
    case KeyType::Parts:
      return isListOf(value, isTable);
    case KeyType::Part:
      return isTable(value);
    case KeyType::NumberOrPart:
      return isNumber(value, isAny) || isTable(value);
    case KeyType::PositiveOrPart:
      return isNumber(value, isPositive) || isTable(value);
    case KeyType::SizesOrPart:
      return isNumber(value, isPositive) || areNumbers(value, 3, isPositive) || isTable(value);
    case KeyType::SizesByPlace:
      return isNumber(value, isPositive) || isOutline(value);
  }
  return false;
}

std::string typeText(const SceneKey& key) {
  switch (key.type) {
    case KeyType::Number:
      return "a number";
    case KeyType::Positive:
      return "a number above 0";
    case KeyType::NotNegative:
      return "a number from 0";
    case KeyType::Whole:
      return "a whole number from 0";
    case KeyType::Flag:
      return "true or false";
    case KeyType::Text:
      return "a text";
    case KeyType::File:
      return "the name of a file";
    case KeyType::Choice:
      return listed(key.choices);
    case KeyType::Point:
      return "three numbers";
    case KeyType::Points:
      return "a list of points, three numbers each";
    case KeyType::Sizes:
      return "three numbers above 0";
    case KeyType::Counts:
      return "three whole numbers from 0";
    case KeyType::Axis:
      return "\"x\", \"y\", \"z\" or three numbers";
    case KeyType::Columns:
      return "three columns of three numbers";
    case KeyType::Outline:
      return "a list of points, two numbers each";
    case KeyType::Outlines:
      return "lists of points, two numbers each";
    case KeyType::Solid:
      return "the name of a solid";
    case KeyType::Solids:
      return "a list of names of solids";
    case KeyType::Parts:
      return "a list of tables";
    case KeyType::Part:
      return "a table";
    case KeyType::NumberOrPart:
      return "a number, or a table";
    case KeyType::PositiveOrPart:
      return "a number above 0, or a table";
    case KeyType::SizesOrPart:
      return "a number above 0, three of them, or a table";
    case KeyType::SizesByPlace:
      return "a number above 0, or a list of points, two numbers each";
  }
  return {};
}

std::string textOf(const SceneValue& value) {
  if (const auto* flag = value.as<bool>()) return *flag ? "true" : "false";
  if (const auto* number = value.as<double>()) return cutwater::detail::toText(*number);
  if (const auto* text = value.as<std::string>()) return formats::quoted(*text);
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
