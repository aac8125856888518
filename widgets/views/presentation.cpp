// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/presentation.h"

#include <QDockWidget>
#include <QKeyEvent>
#include <QLocale>
#include <QMainWindow>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>
#include <algorithm>

#include "model/edit/views.h"
#include "widgets/annotations/in_picture/presented_letters.h"
#include "widgets/views/view_list.h"

namespace sline::widgets {

namespace {

/// Returns by how many views the key goes on; 0 for other keys.
int stepOf(int key) {
  switch (key) {
    case Qt::Key_Right:
    case Qt::Key_Down:
    case Qt::Key_Space:
    case Qt::Key_PageDown:
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return 1;
    case Qt::Key_Left:
    case Qt::Key_Up:
    case Qt::Key_Backspace:
    case Qt::Key_PageUp:
      return -1;
    default:
      return 0;
  }
}

bool zooms(int key) {
  return key == Qt::Key_Plus || key == Qt::Key_Minus || key == Qt::Key_Equal;
}

}  // namespace

Presentation::Presentation(QMainWindow& window, Session& session, Viewport& viewport,
                           QObject* parent)
    : QObject(parent),
      m_window(window),
      m_session(session),
      m_viewport(viewport),
      m_name(new QLabel(&viewport)) {
  m_name->setObjectName(QStringLiteral("presentedView"));
  m_name->setTextFormat(Qt::PlainText);
  m_name->setWordWrap(true);
  m_name->setIndent(0);
  m_name->setAttribute(Qt::WA_TransparentForMouseEvents);
  m_name->hide();
  connect(&session, &Session::documentChanged, this, &Presentation::documentChange);
  window.installEventFilter(this);
  viewport.installEventFilter(this);
}

Presentation::~Presentation() {
  if (!m_name)
    return;  // the window is being destroyed, and the picture before it
  end();
  delete m_name;
}

void Presentation::showBars(bool shown) {
  m_window.menuBar()->setVisible(shown);
  m_window.statusBar()->setVisible(shown);
  if (shown)
    return;
  for (QDockWidget* dock : m_window.findChildren<QDockWidget*>())
    dock->hide();
  for (QToolBar* tools : m_window.findChildren<QToolBar*>(Qt::FindDirectChildrenOnly))
    tools->hide();
}

void Presentation::begin(int index) {
  const int count = int(m_session.scene().views().size());
  if (running() || count == 0)
    return;
  m_session.cancelPreview();
  m_before = Before{.docks = m_window.saveState(),
                    .states = m_window.windowState(),
                    .place = m_window.geometry(),
                    .focus = m_window.focusWidget(),
                    .marks = m_viewport.marks(),
                    .camera = m_viewport.camera(),
                    .pivot = m_viewport.pivot(),
                    .section = m_session.activeSection(),
                    .opening = m_session.document().opening};
  m_session.activateSection(std::nullopt);  // its handles would be in the picture
  m_viewport.chooseMarks({.cube = false, .scaleBar = false, .frameTime = false});
  showBars(false);
  m_window.showFullScreen();
  m_viewport.setFocus();
  show(std::clamp(index, 0, count - 1));
}

void Presentation::end() {
  if (!running())
    return;
  const Before before = *m_before;
  m_before.reset();
  m_name->hide();
  m_viewport.setPresented(false);
  m_viewport.showInstead(std::nullopt);
  m_viewport.setCamera(before.camera);
  m_viewport.setPivot(before.pivot);
  m_viewport.chooseMarks(before.marks);
  if (m_session.document().opening == before.opening)
    m_session.activateSection(before.section);
  m_window.setWindowState(before.states);
  if (!(before.states & (Qt::WindowMaximized | Qt::WindowFullScreen)))
    m_window.setGeometry(before.place);
  showBars(true);
  m_window.restoreState(before.docks);
  if (before.focus)
    before.focus->setFocus();
}

void Presentation::show(int index) {
  const std::vector<model::View>& views = m_session.scene().views();
  m_at = std::clamp(index, 0, int(views.size()) - 1);
  const model::View& view = views[std::size_t(m_at)];
  nameView(view);
  const model::Scene before = m_viewport.shownScene();
  model::Scene after = model::withViewApplied(m_session.scene(), view).scene;
  m_viewport.travelTo(view.camera, before, after);
  m_viewport.showInstead(std::move(after));
}

void Presentation::nameView(const model::View& view) {
  m_name->setText(tr("%1 / %2   %3", "number of the view, of so many, its name")
                      .arg(QLocale().toString(m_at + 1),
                           QLocale().toString(int(m_session.scene().views().size())),
                           shownName(view)));
  placeName();
}

/// Places the name in the corner, because the middle has the letter of the side that is below.
void Presentation::placeName() {
  constexpr int margin = 24;
  constexpr int least = 16;  // pixels
  constexpr int sides = 16;
  const int letters = std::max(least, m_viewport.height() / presentedLines);
  m_name->setStyleSheet(QStringLiteral("QLabel { color: #f4f4f2; background: rgba(28, 30, 34, 190);"
                                       " border-radius: 6px; padding: 6px %1px;"
                                       " font-size: %2px; }")
                            .arg(sides)
                            .arg(letters));
  m_name->ensurePolished();
  const int room = m_viewport.width() / 2 - 2 * margin - 2 * letters;
  const int words = m_name->fontMetrics().horizontalAdvance(m_name->text());
  const int width = std::min(words + 2 * sides + 2, room);
  const int height = std::min(m_name->heightForWidth(width), m_viewport.height() - 2 * margin);
  m_name->setGeometry(margin, m_viewport.height() - height - margin, width, height);
  m_viewport.setPresented(true, m_name->geometry());
  m_name->show();
  m_name->raise();
}

void Presentation::key(const QKeyEvent& event) {
  if (event.key() == Qt::Key_Escape)
    end();
  else if (event.key() == Qt::Key_Home)
    show(0);
  else if (event.key() == Qt::Key_End)
    show(int(m_session.scene().views().size()) - 1);
  else if (const int to = m_at + stepOf(event.key());
           to != m_at && to >= 0 && to < int(m_session.scene().views().size()))
    show(to);
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
  if (event->type() == QEvent::Resize) {
    placeName();
    return false;
  }
  const bool claimed = event->type() == QEvent::ShortcutOverride;
  if (!claimed && event->type() != QEvent::KeyPress)
    return false;
  const auto* press = static_cast<QKeyEvent*>(event);
  if (zooms(press->key()))
    return false;
  event->accept();  // all other keys edit
  if (!claimed)
    key(*press);
  return true;
}

void Presentation::documentChange() {
  if (!running())
    return;
  // A scene may have come in from the background.
  if (m_session.document().opening != m_before->opening || m_session.scene().views().empty())
    end();
  else
    show(m_at);
}

}  // namespace sline::widgets

#include "moc_presentation.cpp"
