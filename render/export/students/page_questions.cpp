// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/page_questions.h"

#include <algorithm>

#include "model/edit/views.h"
#include "model/scene/known_frame.h"
#include "model/scene/visible_structures.h"
#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"
#include "render/export/students/answer_hash.h"
#include "render/export/students/asked_things.h"
#include "render/export/students/page_order.h"
#include "render/export/students/vessel_chains.h"

namespace sline::render {

namespace {

constexpr std::size_t wrongChoices = 3;
/// So many labels can still be told apart on a telephone.
constexpr std::size_t mostDragged = 8;

class QuestionMaker {
 public:
  QuestionMaker(const ExportOrder& order, const StudentsOptions& own, const PageWords& words)
      : m_order(pictured(order)),
        m_own(own),
        m_words(words),
        m_things(askedThings(m_order, words)),
        m_distractors(m_order, words, m_things) {}

  std::vector<PageQuestion> make() {
    for (const AskedThing& thing : m_things) {
      ++m_number;
      if (m_own.find && !m_words.silent() && !thing.structures.empty())
        add("find", thing);
      if (m_own.name)
        add("name", thing).accepted = thing.accepted;
      if (m_own.choose && !m_words.silent())
        addChoice(thing);
    }
    if (m_own.drag && !m_words.silent())
      addDragging();
    if (m_own.order && !m_words.silent())
      addChains();
    return std::move(m_questions);
  }

 private:
  PageQuestion& add(const std::string& kind, const AskedThing& thing) {
    PageQuestion& question = m_questions.emplace_back();
    question.id = kind + "-" + std::to_string(m_number);
    question.kind = kind;
    question.words = thing.words;
    question.structures = thing.structures;
    question.labels = thing.labels;
    question.view = thing.view;
    return question;
  }

  void addChoice(const AskedThing& thing) {
    std::vector<WordsByLanguage> choices = m_distractors.of(thing, wrongChoices);
    if (choices.empty())
      return;
    // By chance, but the same each time.
    const std::string chance = sha256Hex(thing.words.at(m_words.language()));
    const std::size_t right = std::stoul(chance.substr(0, 6), nullptr, 16) % (choices.size() + 1);
    choices.insert(choices.begin() + std::ptrdiff_t(right), thing.words);
    PageQuestion& question = add("choose", thing);
    question.choices = std::move(choices);
    question.right = int(right);
  }

  /// Adds questions that ask for several labels at once, those that one view shows.
  void addDragging() {
    std::vector<const AskedThing*> together;
    const auto flush = [&] {
      constexpr std::size_t least = 2;
      if (together.size() >= least) {
        ++m_number;
        PageQuestion& question = m_questions.emplace_back();
        question.id = "drag-" + std::to_string(m_number);
        question.kind = "drag";
        question.view = together.front()->view;
        for (const AskedThing* thing : together) {
          question.structures.push_back(thing->structures.front());
          question.labels.push_back(thing->labels.front());
          question.choices.push_back(thing->words);
        }
      }
      together.clear();
    };
    for (const AskedThing& thing : m_things) {
      if (thing.structures.empty() || thing.labels.empty())
        continue;
      if (together.size() == mostDragged ||
          (!together.empty() && together.front()->view != thing.view))
        flush();
      const bool taken = std::any_of(together.begin(), together.end(), [&](const auto* other) {
        return other->structures.front() == thing.structures.front();
      });
      if (!taken)
        together.push_back(&thing);
    }
    flush();
  }

  /// Returns the first view in which all of them are shown.
  std::optional<int> viewShowing(const std::vector<model::NodeId>& structures) const {
    const std::vector<model::View>& views = m_order.scene.views();
    for (std::size_t i = 0; i < views.size(); ++i) {
      const model::Scene shown = model::withViewApplied(m_order.scene, views[i]).scene;
      if (std::all_of(structures.begin(), structures.end(),
                      [&](model::NodeId id) { return shown.resolve(id).visible; }))
        return int(i) + 1;
    }
    return std::nullopt;
  }

  void addChains() {
    for (const VesselChain& chain : vesselChains(m_order.scene)) {
      const std::optional<int> view = viewShowing(chain.vessels);
      const bool doubted = std::any_of(
          chain.vessels.begin(), chain.vessels.end(),
          [this](model::NodeId id) { return model::isNameDoubted(*m_order.scene.find(id)); });
      if (!view || doubted)
        continue;
      ++m_number;
      PageQuestion& question = m_questions.emplace_back();
      question.id = "order-" + std::to_string(m_number);
      question.kind = "order";
      question.view = view;
      question.words = m_words.ofName(*m_order.scene.find(chain.group));
      question.structures = chain.vessels;
      for (const model::NodeId id : chain.vessels)
        question.choices.push_back(m_words.ofName(*m_order.scene.find(id)));
    }
  }

  /// Returns the order on a page of the picture's shape.
  static ExportOrder pictured(const ExportOrder& order) {
    ExportOrder one = order;
    one.page.sizeMm = pagePictureMm;
    return one;
  }

  ExportOrder m_order;
  const StudentsOptions& m_own;
  const PageWords& m_words;
  std::vector<AskedThing> m_things;
  Distractors m_distractors;
  std::vector<PageQuestion> m_questions;
  int m_number = 0;
};

}  // namespace

std::vector<PageQuestion> pageQuestions(const ExportOrder& order, const StudentsOptions& own,
                                        const PageWords& words) {
  return own.quiz == QuizMode::off ? std::vector<PageQuestion>()
                                   : QuestionMaker(order, own, words).make();
}

bool hasQuestions(const ExportOrder& order) {
  if (order.scene.annotations().empty())
    return !model::visibleStructures(order.scene).empty();
  if (!questionsOf(order).empty())
    return true;
  const std::vector<model::View>& views = order.scene.views();
  return std::any_of(views.begin(), views.end(), [&order](const model::View& view) {
    return !questionsOf(orderOfView(order, view)).empty();
  });
}

}  // namespace sline::render
