#include <Cutwater/Scene/Detail/SceneForm.hpp>
#include <Cutwater/Scene/Detail/SceneTypes.hpp>
#include <Cutwater/Scene/ReadScene.hpp>
#include <Cutwater/Text/Words.hpp>

namespace cutwater {

namespace {

std::string code(const std::string& text) {
  return '`' + text + '`';
}

std::string rowOf(const scene::SceneKey& key) {
  const std::string preset = !key.preset           ? "needed"
                             : key.preset->empty() ? "none"
                                                   : code(*key.preset);
  return "| " + code(key.name) + " | " + scene::typeText(key) + " | " + key.meaning + " | " +
         preset + " |\n";
}

/// The keys of the tables that a key takes. If there are several kinds, a row above each says what
/// it is.
std::string rowsOfParts(const scene::SceneKey& key) {
  std::string text;
  for (const auto& form : *key.forms) {
    const bool isFirst = &form == key.forms->data();
    if (key.forms->size() > 1) {
      text +=
          std::string("| ") + (isFirst ? "*either*" : "*or*") + " | | *" + form.meaning + "* | |\n";
    }
    for (auto part : form.keys) {
      part.name = key.name + "." + part.name;
      text += rowOf(part);
    }
  }
  return text;
}

std::string tableOf(const std::vector<scene::SceneKey>& keys) {
  std::string text = "| key | takes | meaning | default |\n|---|---|---|---|\n";
  for (const auto& key : keys) {
    text += rowOf(key);
    if (key.forms != nullptr) text += rowsOfParts(key);
  }
  return text;
}

std::string sectionOf(const scene::SceneForm& form) {
  const auto title = form.kindKey.empty() ? form.name : form.kindKey + " = \"" + form.name + '"';
  return "\n#### " + code(title) + "\n\n" + form.meaning + "\n\n" + tableOf(form.keys);
}

bool mentions(std::string_view text, std::string_view word) {
  for (std::size_t i = 0; i + word.size() <= text.size(); ++i) {
    if (text::equalIgnoringCase(text.substr(i, word.size()), word)) return true;
  }
  return false;
}

}  // namespace

std::string sceneKeys(std::string_view word) {
  std::string page = "### Every solid\n\n" + tableOf(scene::commonKeys());
  if (!mentions(page, word)) page.clear();
  for (const auto& [title, introduction, forms] : scene::allSceneForms()) {
    std::string sections;
    for (const auto& form : forms) {
      const auto section = sectionOf(form);
      if (mentions(section, word)) sections += section;
    }
    if (sections.empty()) continue;
    page += (page.empty() ? "### " : "\n### ") + title + "\n\n" + introduction + '\n' + sections;
  }
  return page;
}

}  // namespace cutwater
