// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/shown_questions.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "model/scene/known_frame.h"
#include "model/scene/label_words.h"
#include "render/export/order/test_options.h"
#include "render/export/plate/figure_plate.h"
#include "render/labels/anchors.h"

namespace sline::render {

namespace {

/// Of a structure one sees at least so many cells of the picture's map (SeenMap), or it is a speck:
/// about a square of a hundredth of the picture's height.
constexpr float leastSeen = 12.0f;
/// And a larger part is a sliver, too, where others hide so much of the structure.
constexpr float mostHidden = 0.9f;
constexpr float sliver = 200.0f;  // cells

/// Knows of which structures one sees too little to say what they are.
class Slivers {
 public:
  explicit Slivers(const SeenMap& map) {
    for (const SeenShare& share : map.shares())
      m_cells[share.structure] = share.cells;
    for (const SeenCover& cover : map.covers())
      m_hidden[cover.behind] += cover.share;
  }
  bool has(model::NodeId structure) const {
    const auto cells = m_cells.find(structure);
    const auto hidden = m_hidden.find(structure);
    const float seen = cells == m_cells.end() ? 0.0f : cells->second;
    return seen < leastSeen ||
           (seen < sliver && hidden != m_hidden.end() && hidden->second > mostHidden);
  }

 private:
  std::map<model::NodeId, float> m_cells;
  std::map<model::NodeId, float> m_hidden;  ///< its share
};

/// Returns the labels of the questions that point at what one sees in the order's picture.
std::set<model::AnnotationId> seenLabels(const ExportOrder& order,
                                         const std::vector<model::Question>& questions,
                                         model::MeshTrees& trees) {
  const model::Scene asked = askedAlone(order, questions).scene;
  const Screen screen = pageScreen(order);
  const SeenMap map(asked, screen, &trees);
  const Slivers slivers(map);
  std::set<model::AnnotationId> seen;
  for (const ShownLabel& label : shownLabels(asked, screen, order.labels.language, trees))
    if (!label.item.hidden)
      seen.insert(label.item.id);
  for (const model::Annotation& annotation : asked.annotations()) {
    const auto* point = std::get_if<model::SurfacePoint>(&annotation.anchors.front());
    if (point && slivers.has(point->structure))
      seen.erase(annotation.id);
  }
  return seen;
}

}  // namespace

ShownQuestions shownQuestions(const ExportOrder& order, model::MeshTrees& trees) {
  ShownQuestions shown;
  ExportNote doubted{.kind = ExportNote::Kind::labelsDoubted, .names = {}, .detail = {}};
  for (const model::Annotation& annotation : order.scene.annotations())
    if (annotation.visible && namesInDoubt(order.scene, annotation))
      doubted.names.push_back(model::writtenIn(annotation, order.labels.language));
  if (!doubted.names.empty())
    addNote(shown.notes, std::move(doubted));
  std::vector<model::Question> all = questionsOf(order);
  if (all.empty())
    return shown;
  const std::set<model::AnnotationId> seen = seenLabels(order, all, trees);
  ExportNote note{.kind = ExportNote::Kind::labelsNotAsked, .names = {}, .detail = {}};
  for (model::Question& question : all) {
    std::erase_if(question.labels, [&seen](model::AnnotationId id) { return !seen.contains(id); });
    if (question.labels.empty())
      note.names.push_back(question.words);
    else
      shown.questions.push_back(std::move(question));
  }
  if (!note.names.empty())
    addNote(shown.notes, std::move(note));
  return shown;
}

void putInOrderOfNumbers(std::vector<model::Question>& questions, const LabelPlate& numbered) {
  std::map<model::AnnotationId, int> numbers;
  for (const ShownLabel& label : numbered.labels)
    if (numbered.layout.find(label.item.id))
      numbers[label.item.id] = label.number;
  const auto first = [&numbers](const model::Question& question) {
    int least = std::numeric_limits<int>::max();
    for (const model::AnnotationId id : question.labels)
      if (const auto number = numbers.find(id); number != numbers.end())
        least = std::min(least, number->second);
    return least;
  };
  std::stable_sort(questions.begin(), questions.end(),
                   [&first](const auto& a, const auto& b) { return first(a) < first(b); });
}

}  // namespace sline::render
