// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/page_facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "model/scene/in_focus.h"
#include "model/scene/known_frame.h"
#include "render/export/description/alt_text.h"
#include "render/export/order/view_orders.h"
#include "render/export/plate/source_credits.h"
#include "render/export/students/answer_hash.h"

namespace sline::render {

namespace {

constexpr double flightSeconds = 1.5;

constexpr std::array kindNames{"label", "callout", "pin", "distance"};

std::string hexColour(const Colour& colour) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t part : {colour.red, colour.green, colour.blue}) {
    text += digits[part >> 4];
    text += digits[part & 15];
  }
  return text;
}

/// Returns the number as it is read, not as it is held: 2.7, not 2.7000000477.
double rounded(float value) {
  return std::round(double(value) * 1000.0) / 1000.0;
}

template <class Ids>
Json numbersOf(const Ids& ids) {
  Json numbers = Json::array();
  for (const auto& id : ids)
    numbers.push_back(id.value);
  return numbers;
}

Json structuresOf(const model::Annotation& annotation) {
  std::set<model::NodeId> structures;
  for (const model::Anchor& anchor : annotation.anchors)
    if (const auto* point = std::get_if<model::SurfacePoint>(&anchor))
      structures.insert(point->structure);
  return numbersOf(structures);
}

class FactsMaker {
 public:
  FactsMaker(const ExportOrder& order, const StudentsOptions& own)
      : m_order(order), m_scene(order.scene), m_own(own), m_words(order, own) {}

  Json make(const FactsExtras& extras) {
    Json facts{{"schema", 1},
               {"title", m_words.title()},
               {"language", m_words.language()},
               {"languages", m_words.languages()},
               {"nodes", Json::array()},
               {"views", Json::array()},
               {"labels", Json::array()},
               {"credits", creditsOf(m_order)},
               {"alt", descriptionsOf(m_order, m_words)}};
    for (const model::Node& node : m_scene.nodes())
      facts["nodes"].push_back(nodeFacts(node));
    for (std::size_t i = 0; i < m_scene.views().size(); ++i)
      facts["views"].push_back(viewFacts(m_scene.views()[i], extras.views[i]));
    for (const model::Annotation& annotation : m_scene.annotations())
      facts["labels"].push_back({{"id", annotation.id.value},
                                 {"structures", structuresOf(annotation)},
                                 {"kind", kindNames[std::size_t(annotation.kind)]},
                                 {"words", m_words.linesOf(annotation)}});
    if (m_order.of<StudentsOptions>().foundLabels)
      facts["labelsFound"] = true;
    if (!hasSides(m_scene))
      facts["sideless"] = true;
    facts["quiz"] = quizFacts(extras.questions);
    if (!m_own.report.empty())
      facts["report"] = m_own.report;
    return facts;
  }

 private:
  Json nodeFacts(const model::Node& node) const {
    const model::ResolvedStyle style = m_scene.resolve(node.id);
    Json facts{{"id", node.id.value},
               {"parent", node.parent.value},
               {"group", node.isGroup()},
               {"names", m_words.ofName(node)},
               {"colour", hexColour(style.colour)},
               {"gamma", rounded(style.gamma.value())},
               {"visible", style.visible},
               {"focus", model::isInFocus(m_scene, node.id)}};
    if (Json note = noteOf(node.id); !note.empty())
      facts["note"] = std::move(note);
    return facts;
  }

  /// Returns what callouts say of the structure, one below the other.
  Json noteOf(model::NodeId id) const {
    Json note = Json::object();
    for (const model::Annotation& annotation : m_scene.annotations()) {
      const auto* point = annotation.anchors.empty()
                              ? nullptr
                              : std::get_if<model::SurfacePoint>(&annotation.anchors.front());
      if (annotation.kind != model::AnnotationKind::callout || !point || point->structure != id)
        continue;
      const Json said = m_words.linesOf(annotation);
      for (const auto& [tag, lines] : said.items())
        for (const Json& line : lines)
          note[tag].push_back(line);
    }
    return note;
  }

  Json viewFacts(const model::View& view, const WordsByLanguage& seen) const {
    return {{"title", m_words.titleOf(view)},
            {"words", m_words.linesOf(view.words.text)},
            {"alt", seen},
            {"seconds", flightSeconds}};
  }

  Json quizFacts(const std::vector<PageQuestion>& questions) const {
    std::string all = m_words.title();
    for (const PageQuestion& question : questions)
      for (const std::string& name : question.accepted)
        all += '\n' + name;
    const std::string salt = sha256Hex(all).substr(0, 16);
    constexpr std::array modes{"beside", "only", "off"};
    Json facts{{"mode", modes[std::size_t(m_own.quiz)]},
               {"counts", m_own.counts},
               {"lockCamera", m_own.lockCamera},
               {"lockLook", m_own.lockLook},
               {"salt", salt},
               {"questions", Json::array()}};
    for (const PageQuestion& question : questions)
      facts["questions"].push_back(questionFacts(question, salt));
    return facts;
  }

  Json questionFacts(const PageQuestion& question, const std::string& salt) const {
    std::set<std::string> answers;
    for (const std::string& name : question.accepted)
      if (!normalisedAnswer(name).empty())
        answers.insert(answerHash(salt, name));
    Json facts{{"id", question.id},
               {"kind", question.kind},
               {"structures", numbersOf(question.structures)},
               {"labels", numbersOf(question.labels)},
               {"answers", answers}};
    if (!m_words.silent())
      facts["words"] = question.words;
    if (!question.choices.empty())
      facts["choices"] = question.choices;
    if (question.right)
      facts["right"] = *question.right;
    if (question.view)
      facts["view"] = *question.view;
    return facts;
  }

  const ExportOrder& m_order;
  const model::Scene& m_scene;
  const StudentsOptions& m_own;
  PageWords m_words;
};

}  // namespace

std::string pageFacts(const ExportOrder& order, const StudentsOptions& own,
                      const FactsExtras& extras) {
  Json facts = FactsMaker(order, own).make(extras);
  if (extras.simplifiedMm > 0.0f)
    facts["simplifiedMm"] = rounded(extras.simplifiedMm);
  // What is no UTF-8 becomes U+FFFD.
  return facts.dump(-1, ' ', false, Json::error_handler_t::replace);
}

WordsByLanguage descriptionsOf(const ExportOrder& order, const PageWords& words) {
  WordsByLanguage said;
  if (order.altText == "off")
    return said;
  ExportOrder one = order;
  one.labels.mode = words.silent() ? LabelMode::numbers : LabelMode::on;
  for (const std::string& tag : words.languages()) {
    one.labels.language = tag;
    const bool byHand = !order.altText.empty() || !order.words.description.in(tag).empty();
    said[tag] = words.silent() || byHand ? altTextOf(one).text : describedPicture(one);
  }
  return said;
}

std::vector<WordsByLanguage> descriptionsOfViews(const ExportOrder& order, const PageWords& words) {
  std::vector<WordsByLanguage> all;
  for (const model::View& view : order.scene.views())
    all.push_back(descriptionsOf(orderOfView(order, view), words));
  return all;
}

std::vector<std::string> creditsOf(const ExportOrder& order) {
  std::vector<std::string> lines;
  if (const std::string own = order.credit.line(); !own.empty())
    lines.push_back(own);
  if (order.sources != SourceCredits::off)
    for (const SourceLine& source : sourceLines(order.scene))
      lines.push_back(source.text);
  return lines;
}

}  // namespace sline::render
