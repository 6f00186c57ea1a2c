#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "Arguments.hpp"

namespace cutwater::tool {

/// The words that an option takes, in the order in which help lists them, and what they stand for.
template <typename Value>
using Choices = std::vector<std::pair<std::string, Value>>;

/// Adds an option that takes one of the words. `value` must outlive the command.
template <typename Value>
CLI::Option* addChoice(CLI::App& command, const std::string& name, Value& value,
                       const Choices<Value>& choices, const std::string& meaning) {
  std::vector<std::string> words;
  std::string all;
  for (const auto& [word, meant] : choices) {
    words.push_back(word);
    all += (all.empty() ? "" : "|") + word;
  }
  return command
      .add_option_function<std::string>(
          name,
          [=, &value](const std::string& text) {
            value = choices[choiceOf(name, text, words)].second;
          },
          meaning)
      ->type_name(all);
}

}  // namespace cutwater::tool
