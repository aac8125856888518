// SPDX-License-Identifier: Apache-2.0
// What keys and the mouse do in a presentation.
#include <QApplication>
#include <QKeyEvent>
#include <QMainWindow>
#include <QMouseEvent>
#include <algorithm>
#include <utility>
#include <vector>

#include "widgets/views/presentation.h"
#include "widgets/views/presentation_board.h"
#include "widgets/views/presented_links.h"
#include "widgets/views/presented_quiz.h"
#include "widgets/views/presenter_window.h"

namespace sline::widgets {

namespace {

bool zooms(int key) {
  return key == Qt::Key_Plus || key == Qt::Key_Minus || key == Qt::Key_Equal;
}

/// Returns the scene with those labels alone that point at what one sees: nobody is asked for
/// others.
model::Scene withoutHidden(const model::Scene& scene, const LabelSightsById& sights) {
  std::vector<model::Annotation> annotations = scene.annotations();
  for (model::Annotation& annotation : annotations)
    if (const auto sight = sights.find(annotation.id.value);
        sight != sights.end() && sight->second != LabelSight::withoutRoom)
      annotation.visible = false;
  model::Scene asked = scene;
  asked.setAnnotations(std::move(annotations));
  return asked;
}

}  // namespace

void Presentation::goOn() {
  if (m_revealed < labelCount()) {
    m_viewport.showInstead(seen(++m_revealed));
    return;
  }
  if (m_at + 1 < count())
    show(m_at + 1, m_revealing ? 0 : all);
}

void Presentation::goBack() {
  if (m_revealing && m_revealed > 0 && labelCount() > 0) {
    m_revealed = std::min(m_revealed, labelCount()) - 1;
    m_viewport.showInstead(seen(m_revealed));
    return;
  }
  if (m_at > 0)
    show(m_at - 1, all);
}

void Presentation::jump() {
  const int number = std::exchange(m_number, -1);
  if (number >= 1 && number <= count())
    show(number - 1, m_revealing ? 0 : all);
  else if (number < 0)
    goOn();
}

void Presentation::blank(bool black) {
  using Blank = PresentationBoard::Blank;
  const Blank wanted = black ? Blank::black : Blank::white;
  m_board->setBlank(m_board->blank() == wanted ? Blank::none : wanted);
}

void Presentation::toggleReveal() {
  m_revealing = !m_revealing;
  m_revealed = m_revealing ? 0 : all;
  m_viewport.showInstead(seen(m_revealed));
}

void Presentation::toggleQuiz() {
  if (m_quiz->running()) {
    m_quiz->end();
    quizChange();
    return;
  }
  // What is asked for depends on which labels one sees, so that all must have been laid out; the
  // picture may still be of another view, or without them.
  m_lit.reset();
  m_quizAwaited = !m_quizAwaited;
  const model::Scene wanted = seen(m_quizAwaited ? all : m_revealed);
  if (!(m_viewport.shownScene() == wanted))
    m_viewport.showInstead(wanted);
  beginQuiz();
}

void Presentation::beginQuiz() {
  if (!running() || !m_quizAwaited || !m_viewport.upToDate())
    return;
  m_quizAwaited = false;
  if (!(m_viewport.shownScene() == seen(all)))
    return;  // something else was asked for since
  m_board->wipe();
  m_board->setPointing(PresentationBoard::Pointing::mouse);
  laser(std::nullopt);
  const model::Scene asked = withoutHidden(seen(all), m_viewport.labels().sights());
  m_viewport.showInstead(seen(0));
  m_quiz->begin(asked, m_viewport.labels().style().language);
}

void Presentation::quizChange() {
  if (!running())
    return;
  if (!m_quiz->running())
    m_viewport.showInstead(seen(m_revealed));
  say();
}

void Presentation::go(PresentationWish wish) {
  using Pointing = PresentationBoard::Pointing;
  const auto toggle = [this](Pointing pointing) {
    m_board->setPointing(m_board->pointing() == pointing ? Pointing::mouse : pointing);
    laser(std::nullopt);
  };
  switch (wish) {
    case PresentationWish::next:
      return goOn();
    case PresentationWish::back:
      return goBack();
    case PresentationWish::first:
      return show(0, m_revealing ? 0 : all);
    case PresentationWish::last:
      return show(count() - 1, m_revealing ? 0 : all);
    case PresentationWish::enter:
      return jump();
    case PresentationWish::black:
    case PresentationWish::white:
      return blank(wish == PresentationWish::black);
    case PresentationWish::laser:
      return toggle(Pointing::laser);
    case PresentationWish::pen:
      return toggle(Pointing::pen);
    case PresentationWish::wipe:
      return m_board->wipe();
    case PresentationWish::notes:
      if (m_presenter->isVisible())
        return m_presenter->hide();
      openNotes();
      return tellPresenter();
    case PresentationWish::reveal:
      return toggleReveal();
    case PresentationWish::quiz:
      return toggleQuiz();
    case PresentationWish::end:
      return end();
  }
}

void Presentation::key(const QKeyEvent& event) {
  if (const std::optional<int> digit = digitOf(event.keyCombination())) {
    constexpr int most = 9999;
    m_number = std::min(std::max(m_number, 0) * 10 + *digit, most);
    return;
  }
  const std::optional<PresentationWish> wish = wishOf(event.keyCombination());
  if (wish != PresentationWish::enter)
    m_number = -1;
  if (!wish)
    return;
  const bool turns = *wish == PresentationWish::next || *wish == PresentationWish::back ||
                     (*wish == PresentationWish::enter && m_number < 0);
  // Nothing is passed over unseen: what would go on brings a blanked picture back.
  if (turns && m_board->blank() != PresentationBoard::Blank::none)
    return m_board->setBlank(PresentationBoard::Blank::none);
  if (m_quiz->running()) {
    if (*wish == PresentationWish::end || *wish == PresentationWish::quiz)
      return toggleQuiz();
    if (turns)
      return *wish == PresentationWish::back ? void() : m_quiz->goOn();
    if (*wish == PresentationWish::reveal)
      return;
    if (*wish == PresentationWish::first || *wish == PresentationWish::last ||
        *wish == PresentationWish::enter)
      m_quiz->end();
  }
  go(*wish);
}

void Presentation::laser(const std::optional<QPointF>& at) {
  m_board->point(at);
  const bool hidden = m_board->dot().has_value();
  if (std::exchange(m_hidden, hidden) == hidden)
    return;
  if (hidden)
    QApplication::setOverrideCursor(Qt::BlankCursor);
  else
    QApplication::restoreOverrideCursor();
}

bool Presentation::mouse(QEvent& event) {
  if (event.type() == QEvent::Leave) {
    laser(std::nullopt);
    return false;
  }
  const auto& mouse = static_cast<const QMouseEvent&>(event);
  if (event.type() == QEvent::MouseMove) {
    laser(mouse.position());
    const bool free = mouse.buttons() == Qt::NoButton && !m_quiz->running();
    if (free && m_links->at(mouse.position())) {
      m_viewport.setCursor(Qt::PointingHandCursor);
      return true;
    }
    // The name under the mouse would answer the quiz, or stand beside the laser's dot.
    return mouse.buttons() == Qt::NoButton && (m_quiz->running() || m_board->dot());
  }
  if (event.type() == QEvent::MouseButtonPress && mouse.button() == Qt::LeftButton)
    m_pressed = mouse.position();
  if (event.type() == QEvent::MouseButtonRelease && mouse.button() == Qt::LeftButton) {
    const std::optional<QPointF> pressed = std::exchange(m_pressed, std::nullopt);
    if (pressed &&
        (mouse.position() - *pressed).manhattanLength() < QApplication::startDragDistance())
      click(mouse.position());
  }
  return false;
}

void Presentation::click(const QPointF& at) {
  if (m_quiz->running())
    m_quiz->click(at);
  else if (const std::optional<model::LinkTarget> target = m_links->at(at))
    follow(*target);
}

bool Presentation::eventFilter(QObject* watched, QEvent* event) {
  if (!running())
    return false;
  if (watched == &m_window) {
    // Controls must be as they were when they are made anew or their places are saved.
    if (event->type() == QEvent::Close || event->type() == QEvent::LanguageChange)
      end();
    return false;
  }
  switch (event->type()) {
    case QEvent::Resize:
      place();
      return false;
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::Leave:
      return mouse(*event);
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
      break;
    default:
      return false;
  }
  const auto* press = static_cast<QKeyEvent*>(event);
  if (zooms(press->key()))
    return false;
  event->accept();  // all other keys edit
  if (event->type() == QEvent::KeyPress)
    key(*press);
  return true;
}

}  // namespace sline::widgets
