// SPDX-License-Identifier: Apache-2.0
#include "widgets/pockets/pocket_search.h"

#include <stop_token>

#include "model/pockets/pocket_focus.h"
#include "widgets/text/told.h"

namespace sline::widgets {

namespace {

QString faultText(const Error& error) {
  QString text = told(error.reason);
  if (!text.isEmpty())
    text[0] = text[0].toUpper();
  return error.remedy.empty() ? text + QLatin1Char('.')
                              : text + QStringLiteral(". ") + told(error.remedy) + QLatin1Char('.');
}

}  // namespace

PocketSearch::PocketSearch(Session& session, QObject* parent)
    : QObject(parent), m_session(session), m_chains(chainsOf(session.scene())) {
  connect(&session, &Session::documentChanged, this, &PocketSearch::follow);
}

PocketSearch::Chains PocketSearch::chainsOf(const model::Scene& scene) {
  Chains chains;
  for (const model::Node& node : scene.nodes())
    if (node.mesh && node.atoms.set && node.style.visible.value_or(true))
      chains.emplace_back(node.id, node.atoms.set);
  return chains;
}

void PocketSearch::follow() {
  Chains now = chainsOf(m_session.scene());
  if (now == m_chains)
    return;
  m_chains = std::move(now);
  m_found.reset();
  m_fault.clear();
  m_cancelled = false;
  search();
}

void PocketSearch::setWanted(bool wanted) {
  m_wanted = wanted;
  if (wanted && !m_found && !m_busy && !m_cancelled && m_fault.isEmpty())
    search();
}

void PocketSearch::setOptions(const model::PocketOptions& options) {
  if (options == m_options)
    return;
  m_options = options;
  m_found.reset();
  m_cancelled = false;
  search();
}

void PocketSearch::cancel() {
  if (!m_busy)
    return;
  m_queue.drop();
  ++m_question;
  m_busy = false;
  m_cancelled = true;
  emit changed();
}

void PocketSearch::search() {
  m_queue.drop();
  ++m_question;
  m_fault.clear();
  m_busy = m_wanted && hasMolecules();
  if (m_busy)
    m_queue.add([this, question = m_question, scene = m_session.scene(),
                 options = m_options](const std::stop_token& stop) -> BackgroundQueue::Sequel {
      auto answer = std::make_shared<Result<model::ScenePockets>>(
          model::pocketsIn(scene, options, [&stop] { return !stop.stop_requested(); }));
      return [this, question, answer] { take(question, std::move(*answer)); };
    });
  emit changed();
}

void PocketSearch::take(int question, Result<model::ScenePockets> answer) {
  if (question != m_question)
    return;
  m_busy = false;
  if (answer)
    m_found = std::make_shared<const model::ScenePockets>(std::move(*answer));
  else
    m_fault = faultText(answer.error());
  emit changed();
}

void PocketSearch::makeRoom(std::size_t pocket) {
  if (!m_found || pocket >= m_found->pockets.size())
    return;
  m_queue.add([this, found = m_found, pocket](const std::stop_token&) -> BackgroundQueue::Sequel {
    const model::ScenePocket& chosen = found->pockets[pocket];
    model::MeshPtr room = model::pocketBody(found->molecules[chosen.molecule].grid, chosen.pocket);
    return [this, found, pocket, room] { emit roomMade(found, pocket, room); };
  });
}

}  // namespace sline::widgets

#include "moc_pocket_search.cpp"
