// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/tools/picker.h"

#include <glm/geometric.hpp>

#include "model/camera/camera_moves.h"
#include "model/geometry/nearest_point.h"

namespace sline::widgets {

namespace {

render::Picks lookUp(render::PickIndex& index, const Picker::Question& question) {
  render::Picks picks = index.pick(question.scene, question.rays);
  if (!question.anchored || !picks.seen)
    return picks;
  constexpr float far = 0.015f;  // a share of the structure's size
  const model::Node& node = *question.scene.find(picks.seen->id);
  const auto nearest = model::nearestPoint(*node.mesh, picks.seen->position);
  const float away = nearest ? glm::length(nearest->place - picks.seen->position) : 0.0f;
  // A cut face is no part of the mesh, so a place on it is a point in space.
  if (!nearest || (away > far * glm::length(node.mesh->bounds().size()) &&
                   !question.scene.sectionsOf(node.id).empty()))
    picks.anchor = picks.seen->position;
  else
    picks.anchor = model::SurfacePoint{node.id, nearest->triangle, nearest->weights};
  return picks;
}

}  // namespace

Picker::Picker(QObject* parent) : QObject(parent) {
  m_threads.setMaxThreadCount(1);
}

Picker::~Picker() {
  forget();
  m_threads.clear();
  m_threads.waitForDone();
}

void Picker::ask(Question question, Answer answer) {
  // The first pick of a mesh sorts its triangles, which takes longer than a frame.
  m_threads.start(
      [this, index = m_index, question = std::move(question), answer = std::move(answer)] {
        render::Picks picks = lookUp(*index, question);
        QMetaObject::invokeMethod(this, [picks = std::move(picks), answer] { answer(picks); });
      });
}

void Picker::askBox(model::Scene scene, const render::PickIndex::Box& box,
                    std::function<void(const std::vector<model::NodeId>&)> answer) {
  m_threads.start(
      [this, index = m_index, scene = std::move(scene), box, answer = std::move(answer)] {
        std::vector<model::NodeId> found = index->inBox(scene, box);
        QMetaObject::invokeMethod(this, [found = std::move(found), answer] { answer(found); });
      });
}

void Picker::askLatest(Question question, Answer answer) {
  const int number = ++*m_latest;
  m_threads.start([this, index = m_index, latest = m_latest, number, question = std::move(question),
                   answer = std::move(answer)] {
    if (*latest != number)
      return;
    render::Picks picks = lookUp(*index, question);
    QMetaObject::invokeMethod(this, [picks = std::move(picks), latest, number, answer] {
      if (*latest == number)
        answer(picks);
    });
  });
}

}  // namespace sline::widgets

#include "moc_picker.cpp"
