#pragma once

#include <string>
#include <utility>
#include <vector>

#include "Options/Arguments.hpp"
#include "Options/Command.hpp"

namespace cutwater::tool {

/// The words that an option takes, in the order in which help lists them, and what they stand for.
template <typename Value>
using Choices = std::vector<std::pair<std::string, Value>>;

/// Adds an option that takes one of the words. `value` must outlive the program.
template <typename Value>
Option addChoice(Command command, const std::string& name, Value& value,
                 const Choices<Value>& choices, const std::string& meaning) {
  std::vector<std::string> words;
  std::string all;
  for (const auto& [word, meant] : choices) {
    words.push_back(word);
    all += (all.empty() ? "" : "|") + word;
  }
  return command.add(name, all, meaning, [=, &value](const std::string& text) {
    value = choices[choiceOf(name, text, words)].second;
  });
}

}  // namespace cutwater::tool
