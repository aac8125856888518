// SPDX-License-Identifier: Apache-2.0
#include "render/labels/anchors.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "model/lengths/shortest_distance.h"
#include "model/scene/cut_place.h"
#include "model/scene/in_focus.h"
#include "model/scene/label_words.h"
#include "model/scene/markup.h"
#include "render/labels/seen/seen_map.h"

namespace sline::render {

namespace {

/// Finds the labels of one picture.
class Finder {
 public:
  Finder(const model::Scene& scene, const Screen& screen, model::MeshTrees& trees,
         const LabelsBefore& before)
      : m_scene(scene),
        m_screen(screen),
        m_trees(trees),
        m_sights(scene, trees),
        m_before(before),
        m_unit(drawnUnit(scene)) {}

  LabelsInPicture find(const std::string& language) {
    int number = 0;
    for (const model::Annotation& annotation : m_scene.annotations()) {
      if (!annotation.visible)
        continue;
      ++number;
      m_choices.clear();
      if (std::optional<LabelItem> item = itemOf(annotation)) {
        const auto* point = std::get_if<model::SurfacePoint>(&annotation.anchors.front());
        m_named.push_back(point ? point->structure : model::NodeId());
        m_labels.shown.push_back({*std::move(item), model::writtenIn(m_scene, annotation, language),
                                  number, annotation.colour, drawnLength(m_scene, annotation),
                                  std::move(m_choices), m_unit});
      }
    }
    weigh();
    return std::move(m_labels);
  }

  void addPlaces(PlacePool& pool) {
    for (const model::Annotation& annotation : m_scene.annotations()) {
      const auto* point = std::get_if<model::SurfacePoint>(&annotation.anchors.front());
      if (!annotation.visible || !annotation.found || !point || !m_sights.draws(point->structure))
        continue;
      const std::optional<SeenPlace> place = map().find(point->structure);
      if (place && !place->hidden)
        add(pool[annotation.id].anchors, place->anchor);
    }
  }

 private:
  /// Returns the item; where there is none, notes why.
  std::optional<LabelItem> itemOf(const model::Annotation& annotation) {
    LabelItem item{.id = annotation.id, .kind = annotation.kind};
    const auto* point = std::get_if<model::SurfacePoint>(&annotation.anchors.front());
    item.focus = point && model::isInFocus(m_scene, point->structure);
    const bool one = annotation.kind != model::AnnotationKind::distance && point;
    if (!(one ? pointAt(item, annotation, *point) : pointAtAll(item, annotation)))
      return std::nullopt;
    if (item.hidden)
      m_labels.unseen.hidden.push_back(annotation.id);
    if (one && item.found)
      item.base = m_screen.place(*m_scene.placeOf(model::pointedAt(annotation).front()));
    if (annotation.offset)
      item.offset = m_screen.size().y * *annotation.offset;
    return item;
  }

  bool pointAtAll(LabelItem& item, const model::Annotation& annotation) {
    for (const model::Anchor& anchor : annotation.anchors) {
      if (!m_sights.shows(anchor))
        return leaveOut(m_labels.unseen.notDrawn, annotation.id);
      const std::optional<glm::vec2> place = placeOf(anchor);
      if (!place)
        return leaveOut(m_labels.unseen.offPicture, annotation.id);
      item.places.push_back(*place);
      item.hidden = item.hidden || m_sights.hidden(anchor, m_screen.sight(*place));
    }
    return true;
  }

  bool pointAt(LabelItem& item, const model::Annotation& annotation,
               const model::SurfacePoint& point) {
    if (!m_sights.draws(point.structure))
      return leaveOut(m_labels.unseen.notDrawn, annotation.id);
    if (const glm::vec3* cut = model::cutPlaceOf(annotation)) {
      const bool there = model::cutsThrough(m_scene, point.structure, *cut);
      if (there && (!annotation.found || !hides(point.structure, *cut)))
        return stayAt(item, annotation, point.structure, *cut);
      if (!annotation.found && !isNameOf(annotation, point.structure))
        return pointInto(item, annotation, point.structure, *cut);
    }
    const bool cutAway = !m_sights.shows(point);
    if (!annotation.found && !cutAway)
      return stayAt(item, annotation, point.structure, point);
    // Another word than the structure's name was meant for that very place.
    if (!annotation.found && !isNameOf(annotation, point.structure))
      return leaveOut(m_labels.unseen.notDrawn, annotation.id);
    if (m_before.pool)
      return pointAtChoice(item, annotation, point);
    const PlacedLabel* was = m_before.layout ? m_before.layout->find(annotation.id) : nullptr;
    std::optional<model::Anchor> before = was ? was->found : std::nullopt;
    if (m_before.hurried && before && m_sights.shows(*before) && placeOf(*before)) {
      item.found = before;
      item.places = {*placeOf(*before)};
      item.hidden = was->hidden || m_sights.hidden(*before, m_screen.sight(item.places.front()));
      return true;
    }
    if (!before && !cutAway)
      before = point;
    const std::optional<SeenPlace> place = map().find(point.structure, before);
    if (!place)
      return leaveOut(
          map().draws(point.structure) ? m_labels.unseen.offPicture : m_labels.unseen.notDrawn,
          annotation.id);
    item.found = place->anchor;
    item.places = {place->place};
    item.hidden = place->hidden;
    return true;
  }

  bool isNameOf(const model::Annotation& annotation, model::NodeId structure) const {
    const model::Node* node = m_scene.find(structure);
    const bool wordless = annotation.text.empty() && annotation.kind != model::AnnotationKind::pin;
    return wordless ||
           (node && model::normalisedName(annotation.text) == model::normalisedName(node->name));
  }

  /// Tells which of the places that the label has had there are in this picture.
  bool pointAtChoice(LabelItem& item, const model::Annotation& annotation,
                     const model::SurfacePoint& point) {
    std::optional<model::Anchor>& last = (*m_before.pool)[annotation.id].last;
    std::vector<model::Anchor>& pool = (*m_before.pool)[annotation.id].anchors;
    bool seen = false;
    const auto choose = [&](std::size_t index) {
      const std::optional<glm::vec2> place =
          m_sights.shows(pool[index]) ? placeOf(pool[index]) : std::nullopt;
      if (!place)
        return;
      m_choices.push_back(
          {index, *place, map().showsDot(point.structure, *m_scene.placeOf(pool[index]))});
      seen = seen || m_choices.back().seen;
    };
    for (std::size_t k = 0; k < pool.size(); ++k)
      choose(k);
    if (!seen) {
      const std::optional<SeenPlace> place = map().find(point.structure, last, true);
      if (place && (!place->hidden || m_choices.empty())) {
        m_choices.push_back({add(pool, place->anchor), place->place, !place->hidden});
      } else if (!place && m_choices.empty()) {
        return leaveOut(
            map().draws(point.structure) ? m_labels.unseen.offPicture : m_labels.unseen.notDrawn,
            annotation.id);
      }
    }
    // The nearest to that of the picture before.
    const std::optional<glm::vec2> was =
        last ? m_screen.place(*m_scene.placeOf(*last)) : std::optional<glm::vec2>();
    const auto away = [&](const PlaceChoice& choice) {
      return std::pair(!choice.seen, was ? glm::distance(*was, choice.place) : 0.0f);
    };
    const PlaceChoice& best = *std::min_element(
        m_choices.begin(), m_choices.end(),
        [&](const PlaceChoice& a, const PlaceChoice& b) { return away(a) < away(b); });
    item.found = last = pool[best.index];
    item.places = {best.place};
    item.hidden = !best.seen;
    return true;
  }

  static std::size_t add(std::vector<model::Anchor>& pool, const model::Anchor& anchor) {
    const auto known = std::find(pool.begin(), pool.end(), anchor);
    if (known != pool.end())
      return std::size_t(known - pool.begin());
    pool.push_back(anchor);
    return pool.size() - 1;
  }

  /// Takes a place of the structure that was set by hand.
  bool stayAt(LabelItem& item, const model::Annotation& annotation, model::NodeId structure,
              const model::Anchor& anchor) {
    const std::optional<glm::vec2> place = placeOf(anchor);
    if (!place)
      return leaveOut(m_labels.unseen.offPicture, annotation.id);
    item.places = {*place};
    item.hidden = m_before.hurried ? m_sights.hidden(anchor, m_screen.sight(*place))
                                   : map().hides(structure, *m_scene.placeOf(anchor));
    return true;
  }

  /// Takes a place within the structure, of a cut that this picture has not: its surface hides it.
  bool pointInto(LabelItem& item, const model::Annotation& annotation, model::NodeId structure,
                 const glm::vec3& inside) {
    if (!model::keptByAll(model::planesOf(m_scene.sectionsOf(structure)), inside))
      return leaveOut(m_labels.unseen.notDrawn, annotation.id);
    const std::optional<glm::vec2> place = placeOf(inside);
    if (!place)
      return leaveOut(m_labels.unseen.offPicture, annotation.id);
    item.places = {*place};
    item.hidden = true;
    return true;
  }

  bool hides(model::NodeId structure, const glm::vec3& p) {
    return !m_before.hurried && map().hides(structure, p);
  }

  std::optional<glm::vec2> placeOf(const model::Anchor& anchor) const {
    const std::optional<glm::vec2> place = m_screen.place(*m_scene.placeOf(anchor));
    return place && m_screen.inside(*place) ? place : std::nullopt;
  }

  static bool leaveOut(std::vector<model::AnnotationId>& ids, model::AnnotationId id) {
    ids.push_back(id);
    return false;
  }

  /// Notes how much one sees of what labels name, where that is known.
  void weigh() {
    if (!m_map)
      return;
    std::map<std::uint64_t, float> cells;
    for (const SeenShare& share : m_map->shares())
      cells[share.structure.value] = share.cells;
    for (std::size_t i = 0; i < m_labels.shown.size(); ++i) {
      const auto seen = cells.find(m_named[i].value);
      m_labels.shown[i].item.seen = seen != cells.end() ? seen->second : 0.0f;
    }
  }

  /// Made when it is first needed.
  const SeenMap& map() {
    if (!m_map)
      m_map.emplace(m_scene, m_screen, &m_trees);
    return *m_map;
  }

  const model::Scene& m_scene;
  const Screen& m_screen;
  model::MeshTrees& m_trees;
  Sights m_sights;
  LabelsBefore m_before;
  model::DrawnUnit m_unit;
  std::optional<SeenMap> m_map;
  LabelsInPicture m_labels;
  std::vector<model::NodeId> m_named;  ///< the structure that each of the shown labels is on
  std::vector<PlaceChoice> m_choices;  ///< of the label that is being looked at
};

}  // namespace

std::string plainText(const ShownLabel& label) {
  return model::plainText(label.item.kind, label.text);
}

LabelsInPicture labelsInPicture(const model::Scene& scene, const Screen& screen,
                                const std::string& language, model::MeshTrees& trees,
                                const LabelsBefore& before) {
  return Finder(scene, screen, trees, before).find(language);
}

void addPlaces(PlacePool& pool, const model::Scene& scene, const Screen& screen,
               model::MeshTrees& trees) {
  Finder(scene, screen, trees, {}).addPlaces(pool);
}

std::vector<ShownLabel> shownLabels(const model::Scene& scene, const Screen& screen,
                                    const std::string& language, model::MeshTrees& trees) {
  return labelsInPicture(scene, screen, language, trees).shown;
}

}  // namespace sline::render
