// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/presented_quiz.h"

#include <QLocale>
#include <QRandomGenerator>

namespace sline::widgets {

PresentedQuiz::PresentedQuiz(Session& session, Viewport& viewport, QObject* parent)
    : QObject(parent), m_session(session), m_viewport(viewport) {}

void PresentedQuiz::begin(const model::Scene& scene, const std::string& language) {
  m_quiz.emplace(model::questionsOf(scene, language), QRandomGenerator::global()->generate());
  ask();
}

void PresentedQuiz::end() {
  m_quiz.reset();
  m_text.clear();
  m_viewport.light(std::nullopt);
}

void PresentedQuiz::say(const QString& text) {
  m_text = text;
  emit changed();
}

void PresentedQuiz::ask() {
  m_viewport.light(std::nullopt);
  const QLocale locale;
  if (m_quiz->size() == 0)
    return say(tr("No label here names anything to ask for"));
  if (m_quiz->done())
    return say(
        tr("%1 of %2 right", "answers of a quiz")
            .arg(locale.toString(int(m_quiz->right())), locale.toString(int(m_quiz->size()))));
  say(tr("%1 / %2   Point at: %3", "number of the question, of so many, what to point at")
          .arg(locale.toString(int(m_quiz->at()) + 1), locale.toString(int(m_quiz->size())),
               QString::fromStdString(m_quiz->question().words).simplified()));
}

void PresentedQuiz::click(const QPointF& at) {
  if (!m_quiz)
    return;
  if (m_quiz->done() || m_quiz->answered())
    return goOn();
  m_viewport.askAt(
      at, [this, asked = m_quiz->at()](const render::Picks& picks) { answer(asked, picks); });
}

void PresentedQuiz::answer(std::size_t asked, const render::Picks& picks) {
  // The answer may come when another question is asked, or none.
  if (!m_quiz || m_quiz->done() || m_quiz->at() != asked || m_quiz->answered() || !picks.seen)
    return;
  const model::Question& question = m_quiz->question();
  const QString wanted = QString::fromStdString(question.words).simplified();
  const bool right = m_quiz->answer(picks.seen->id);
  m_viewport.light(right ? picks.seen->id : question.structures.front());
  if (right)
    return say(tr("Right: %1", "answer of a quiz").arg(wanted));
  const model::Node* node = m_viewport.shownScene().find(picks.seen->id);
  say(tr("No, that is: %1. Outlined is: %2", "answer of a quiz")
          .arg(node ? m_session.names().shown(node->name) : QString(), wanted));
}

void PresentedQuiz::goOn() {
  if (!m_quiz)
    return;
  if (m_quiz->done()) {
    end();
    emit changed();
    return;
  }
  m_quiz->next();
  ask();
}

}  // namespace sline::widgets

#include "moc_presented_quiz.cpp"
