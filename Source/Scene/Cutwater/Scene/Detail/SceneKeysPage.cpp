#include <Cutwater/Scene/Detail/SceneForm.hpp>
#include <Cutwater/Scene/Detail/SceneTypes.hpp>
#include <Cutwater/Scene/ReadScene.hpp>

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

std::string tableOf(const std::vector<scene::SceneKey>& keys) {
  std::string text = "| key | takes | meaning | default |\n|---|---|---|---|\n";
  for (const auto& key : keys) {
    text += rowOf(key);
    if (key.forms == nullptr) continue;
    for (const auto& form : *key.forms) {
      for (auto part : form.keys) {
        part.name = key.name + "." + part.name;
        text += rowOf(part);
      }
    }
  }
  return text;
}

std::string sectionOf(const scene::SceneForm& form) {
  const auto title = form.kindKey.empty() ? form.name : form.kindKey + " = \"" + form.name + '"';
  return "\n#### " + code(title) + "\n\n" + form.meaning + "\n\n" + tableOf(form.keys);
}

}  // namespace

std::string sceneKeys() {
  std::string text = "### Every solid\n\n" + tableOf(scene::commonKeys());
  for (const auto& [title, introduction, forms] : scene::allSceneForms()) {
    text += "\n### " + title + "\n\n" + introduction + '\n';
    for (const auto& form : forms) text += sectionOf(form);
  }
  return text;
}

}  // namespace cutwater
