#include "Options/Command.hpp"

#include <CLI/CLI.hpp>

#include "Options/Arguments.hpp"

namespace cutwater::tool {

Option Option::required() const {
  option_->required();
  return *this;
}

Option Option::excludes(Option other) const {
  option_->excludes(other.option_);
  return *this;
}

Option Option::needs(Option other) const {
  option_->needs(other.option_);
  return *this;
}

Option Command::add(const std::string& names, const std::string& value, const std::string& meaning,
                    const Read& read) {
  return Option(*app_->add_option_function<std::string>(names, read, meaning)->type_name(value));
}

Option Command::addInOrder(const std::string& names, const std::string& value,
                           const std::string& meaning, const Read& read) {
  return Option(*app_->add_option_function<std::string>(names, read, meaning)
                     ->type_name(value)
                     ->trigger_on_parse());
}

Option Command::addRepeated(const std::string& names, const std::string& value,
                            const std::string& meaning, const Read& read, Values values) {
  const auto readAll = [read](const std::vector<std::string>& texts) {
    for (const auto& text : texts) read(text);
  };
  auto* option = app_->add_option_function<std::vector<std::string>>(names, readAll, meaning);
  if (values == Values::One) option->allow_extra_args(false);
  return Option(*option->type_name(value));
}

Option Command::addText(const std::string& names, const std::string& meaning, std::string& text) {
  return Option(*app_->add_option(names, text, meaning));
}

Option Command::addOptional(const std::string& names, const std::string& value,
                            const std::string& meaning, const Read& read) {
  return Option(*app_->add_option_function<std::string>(names, read, meaning)
                     ->type_name("[" + value + "]")
                     ->expected(0, 1));
}

Option Command::addWords(const std::string& names, const std::string& value,
                         const std::string& meaning, std::vector<std::string>& chosen,
                         const std::vector<std::string>& words, Values values) {
  auto* option = app_->add_option(names, chosen, meaning)->delimiter(',');
  if (values == Values::One) option->allow_extra_args(false);
  const auto refusal = [names, words](const std::string& text) {
    static_cast<void>(choiceOf(names, text, words));
    return std::string();
  };
  return Option(*option->check(refusal, "", names)->type_name(value));
}

Option Command::addNumber(const std::string& names, const std::string& value,
                          const std::string& meaning, int& number, Range<int> range) {
  return Option(*app_->add_option(names, number, meaning)
                     ->check(CLI::Range(range.least, range.most))
                     ->type_name(value));
}

Option Command::addNumber(const std::string& names, const std::string& value,
                          const std::string& meaning, double& number, Range<double> range) {
  return Option(*app_->add_option(names, number, meaning)
                     ->check(CLI::Range(range.least, range.most))
                     ->type_name(value));
}

void Command::addFlag(const std::string& names, const std::string& meaning, bool& isGiven) {
  app_->add_flag(names, isGiven, meaning);
}

void Command::addFlag(const std::string& names, const std::string& meaning,
                      const std::function<void()>& given) {
  app_->add_flag_function(
      names, [given](std::int64_t) { given(); }, meaning);
}

Option Command::option(const std::string& name) const {
  return Option(*app_->get_option(name));
}

bool Command::isGiven(const std::string& option) const {
  return app_->count(option) > 0;
}

void Command::setFooter(const std::string& text) {
  app_->footer(text);
}

void Command::setAction(const std::function<void()>& run) {
  app_->callback(run);
}

}  // namespace cutwater::tool
