// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/page_words.h"

#include <algorithm>

#include "model/anatomy/anatomical_names.h"
#include "model/anatomy/laterality_words.h"
#include "model/anatomy/shown_names.h"
#include "model/lengths/shortest_distance.h"
#include "model/scene/known_frame.h"
#include "model/scene/label_words.h"
#include "model/scene/markup.h"
#include "render/export/order/view_orders.h"
#include "render/export/plate/legend.h"
#include "render/lettering/label_texts.h"
#include "render/lettering/mark_words.h"

namespace sline::render {

namespace {

void addTag(std::vector<std::string>& tags, const std::string& tag) {
  if (!tag.empty() && std::find(tags.begin(), tags.end(), tag) == tags.end())
    tags.push_back(tag);
}

std::vector<std::string> typedTags(const std::string& text) {
  std::vector<std::string> tags;
  std::string tag;
  for (const char each : text + ",")
    if (each == ',' || each == '+' || each == ' ') {
      addTag(tags, tag);
      tag.clear();
    } else {
      tag += each;
    }
  return tags;
}

void addTags(std::vector<std::string>& tags, const model::Wording& wording) {
  for (const auto& [tag, text] : wording.texts)
    addTag(tags, tag);
}

std::vector<std::string> languagesOf(const ExportOrder& order, const StudentsOptions& own) {
  std::vector<std::string> tags;
  const std::vector<std::string> typed = typedTags(own.languages);
  const std::string opening = model::firstLanguage(order.labels.language);
  addTag(tags, !opening.empty() ? opening : typed.empty() ? "en" : typed.front());
  for (const std::string& tag : typed)
    addTag(tags, tag);
  if (!typed.empty())
    return tags;
  for (const std::string_view tag : model::nameLanguageTags)
    addTag(tags, std::string(tag));
  for (const model::Annotation& annotation : order.scene.annotations())
    for (const auto& [tag, text] : annotation.texts)
      addTag(tags, tag);
  for (const model::View& view : order.scene.views()) {
    addTags(tags, view.words.title);
    addTags(tags, view.words.text);
  }
  return tags;
}

Json runOf(std::string text, const model::LetterStyle& style) {
  Json run{{"text", std::move(text)}};
  if (style.bold)
    run["bold"] = true;
  if (style.italic)
    run["italic"] = true;
  return run;
}

std::vector<std::string> linesIn(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return lines;
}

}  // namespace

PageWords::PageWords(const ExportOrder& order, const StudentsOptions& own)
    : m_scene(order.scene),
      m_title(own.title),
      m_fileTitle(own.fileTitle),
      m_languages(languagesOf(order, own)),
      m_silent(own.quiz == QuizMode::only) {}

WordsByLanguage PageWords::ofName(const model::Node& node) const {
  WordsByLanguage words;
  if (!m_silent)
    for (const std::string& tag : m_languages)
      words[tag] = structureName(node, tag);
  return words;
}

WordsByLanguage PageWords::ofLabel(const model::Annotation& annotation) const {
  WordsByLanguage words = unmarked(annotation);
  if (namesInDoubt(m_scene, annotation))
    for (auto& [tag, text] : words)
      text += model::doubtMark;
  return words;
}

WordsByLanguage PageWords::unmarked(const model::Annotation& annotation) const {
  WordsByLanguage words;
  for (const std::string& tag : m_languages) {
    if (annotation.kind == model::AnnotationKind::distance) {
      ShownLabel label;
      label.item.kind = annotation.kind;
      label.text = model::textIn(annotation, tag);
      label.length = drawnLength(m_scene, annotation);
      label.unit = drawnUnit(m_scene);
      words[tag] = keyText(label, {.language = tag});
      continue;
    }
    const std::string text = model::plainText(annotation.kind, model::textIn(annotation, tag));
    const bool kept = m_kept || annotation.texts.contains(tag) ||
                      annotation.kind == model::AnnotationKind::callout;
    words[tag] = kept ? text : structureName(text, tag);
  }
  return words;
}

Json PageWords::plainLines(const std::string& text) const {
  Json lines = Json::array();
  for (const std::string& line : linesIn(text))
    lines.push_back(Json::array({runOf(line, {})}));
  return lines;
}

Json PageWords::markedLines(const std::string& text) const {
  Json lines = Json::array();
  for (const model::MarkedLine& line : model::markedLines(text)) {
    Json runs = Json::array();
    if (line.bullet)
      runs.push_back(runOf(std::string(model::bulletSign), {}));
    for (const model::MarkedRun& marked : line.runs) {
      Json run = runOf(marked.text, marked.style);
      if (const auto target = marked.link ? targetOf(*marked.link) : std::nullopt) {
        if (const auto* structure = std::get_if<model::NodeId>(&*target))
          run["structure"] = structure->value;
        else
          run["view"] = std::get<std::size_t>(*target) + 1;
      }
      runs.push_back(std::move(run));
    }
    lines.push_back(std::move(runs));
  }
  return lines;
}

Json PageWords::linesOf(const model::Annotation& annotation) const {
  Json lines = Json::object();
  if (m_silent)
    return lines;
  if (annotation.kind == model::AnnotationKind::callout) {
    const std::string_view mark = namesInDoubt(m_scene, annotation) ? model::doubtMark : "";
    for (const std::string& tag : m_languages)
      lines[tag] = markedLines(model::textIn(annotation, tag) + std::string(mark));
    return lines;
  }
  for (const auto& [tag, text] : ofLabel(annotation))
    lines[tag] = plainLines(text);
  return lines;
}

Json PageWords::linesOf(const model::Wording& wording) const {
  Json lines = Json::object();
  if (!m_silent && !wording.empty())
    for (const std::string& tag : m_languages)
      lines[tag] = markedLines(wording.in(tag));
  return lines;
}

WordsByLanguage PageWords::titleOf(const model::View& view) const {
  WordsByLanguage words;
  const model::KnownSides sides = knownSides(m_scene);
  for (const std::string& tag : m_languages) {
    if (!m_silent) {
      words[tag] = render::titleOfView(view, tag, sides);
      continue;
    }
    const auto side = model::anatomicalViewOf(view.camera);
    if (side && sides.any)
      words[tag] =
          MarkWords(tag, sides)
              .view(std::string(model::anatomicalViewNames[std::size_t(*side)]), view.camera)
              .toStdString();
  }
  return words;
}

std::optional<model::LinkTarget> PageWords::targetOf(const model::MarkupLink& link) const {
  static const model::AnatomicalNames table;
  return model::linkTarget(link, m_scene,
                           [](const std::string& name) { return table.searchWords(name); });
}

std::string PageWords::title() const {
  if (!m_title.empty())
    return m_title;
  if (m_silent)
    return structureName("Anatomy", language());
  const std::vector<model::NodeId> top = m_scene.children(model::rootId);
  if (top.size() == 1 && m_scene.find(top.front())->isGroup())
    return structureName(m_scene.find(top.front())->name, language());
  const std::string shown = model::shownName(m_fileTitle);
  return shown.empty() ? structureName("Anatomy", language()) : shown;
}

}  // namespace sline::render
