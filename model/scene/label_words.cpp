// SPDX-License-Identifier: Apache-2.0
#include "model/scene/label_words.h"

#include <algorithm>

#include "model/scene/known_frame.h"

namespace sline::model {

std::vector<std::string> languagesIn(const std::string& tags) {
  std::vector<std::string> all;
  std::size_t from = 0;
  for (std::size_t plus = tags.find('+'); plus != std::string::npos; plus = tags.find('+', from)) {
    all.push_back(tags.substr(from, plus - from));
    from = plus + 1;
  }
  all.push_back(tags.substr(from));
  return all;
}

std::string firstLanguage(const std::string& tags) {
  return tags.substr(0, tags.find('+'));
}

std::string writtenIn(const Annotation& annotation, const std::string& tags) {
  const char* between = annotation.kind == AnnotationKind::callout ? "\n" : " / ";
  std::vector<std::string> said;
  for (const std::string& tag : languagesIn(tags)) {
    if (!said.empty() && !annotation.texts.contains(tag))
      continue;
    const std::string& text = textIn(annotation, tag);
    if (said.empty() || std::find(said.begin(), said.end(), text) == said.end())
      said.push_back(text);
  }
  std::string words = said.front();
  for (std::size_t i = 1; i < said.size(); ++i)
    words += (words.empty() ? "" : between) + said[i];
  return words;
}

std::string writtenIn(const Scene& scene, const Annotation& annotation, const std::string& tags) {
  const std::string words = writtenIn(annotation, tags);
  const bool marked = !words.empty() && namesInDoubt(scene, annotation);
  return marked ? words + std::string(doubtMark) : words;
}

}  // namespace sline::model
