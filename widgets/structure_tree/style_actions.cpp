// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/style_actions.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QKeyEvent>
#include <QMimeData>
#include <algorithm>
#include <optional>
#include <utility>

#include "model/edit/locks.h"
#include "model/edit/look.h"

namespace sline::widgets {

namespace {

/// A style on the clipboard, for windows of this program.
class StyleMime : public QMimeData {
 public:
  explicit StyleMime(const model::Style& look) : m_look(look) {
    setData(QStringLiteral("application/x-sline-style"), QByteArrayLiteral("style"));
  }
  const model::Style& look() const { return m_look; }

 private:
  model::Style m_look;
};

std::optional<model::Style> copiedStyle() {
  const auto* mime = dynamic_cast<const StyleMime*>(QGuiApplication::clipboard()->mimeData());
  return mime ? std::optional(mime->look()) : std::nullopt;
}

}  // namespace

StyleActions::StyleActions(Session& session, const WindowActions& actions, QObject* parent)
    : QObject(parent), m_session(session), m_actions(actions) {
  const auto on = [this](const char* id, auto function) {
    connect(&m_actions[QLatin1String(id)], &QAction::triggered, this, function);
  };
  on("copyStyle", [this] { copy(); });
  on("pasteStyle", [this] { paste(true); });
  on("pasteStyleAlone", [this] { paste(false); });
  on("makeLike", [this](bool wanted) { wait(wanted); });
  m_actions[QStringLiteral("makeLike")].setCheckable(true);
  connect(&m_session, &Session::documentChanged, this, &StyleActions::showState);
  connect(&m_session, &Session::selectionChanged, this, &StyleActions::selected);
  connect(QGuiApplication::clipboard(), &QClipboard::dataChanged, this, &StyleActions::showState);
  showState();
}

void StyleActions::copy() {
  if (!m_session.selection().empty())
    QGuiApplication::clipboard()->setMimeData(
        new StyleMime(model::lookOf(m_session.scene(), m_session.selection().front())));
}

void StyleActions::paste(bool withColour) {
  if (const std::optional<model::Style> look = copiedStyle())
    give(m_session.selection(), *look, withColour,
         withColour ? tr("Paste Style") : tr("Paste Style, Keep Colour"));
}

void StyleActions::give(const NodeIds& ids, model::Style look, bool withColour,
                        const QString& name) {
  if (!withColour) {
    look.colour.reset();
    look.inkColour.reset();
  }
  model::Edited edited{m_session.scene(), false};
  // An ink that follows the background is no answer, so the nodes must lose theirs.
  if (withColour && !look.inkColour)
    edited = model::withLookInherited(edited.scene, ids, {.inkColour = Colour()});
  model::Edited given = model::withLook(edited.scene, ids, look);
  given.changed = given.changed || edited.changed;
  m_session.apply(name, std::move(given));
}

StyleActions::~StyleActions() {
  // The actions may be gone before.
  if (!m_waiting.empty())
    QGuiApplication::restoreOverrideCursor();
}

void StyleActions::wait(bool wanted) {
  const bool waited = !m_waiting.empty();
  m_waiting = wanted ? m_session.selection() : NodeIds();
  // In the picture as in the list the hand points at what it will take from.
  if (waited && m_waiting.empty()) {
    QGuiApplication::restoreOverrideCursor();
    qApp->removeEventFilter(this);
  } else if (!waited && !m_waiting.empty()) {
    QGuiApplication::setOverrideCursor(Qt::PointingHandCursor);
    qApp->installEventFilter(this);
  }
  showState();
}

bool StyleActions::eventFilter(QObject* watched, QEvent* event) {
  // A menu or a dialog that is open takes Escape for itself.
  if (event->type() != QEvent::KeyPress || !watched->isWidgetType() ||
      static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape ||
      QApplication::activePopupWidget() || QApplication::activeModalWidget())
    return false;
  wait(false);
  return true;
}

void StyleActions::selected() {
  showState();
  if (m_waiting.empty())
    return;
  const NodeIds ids = m_waiting;
  const NodeIds source = m_session.selection();
  wait(false);
  if (source.size() != 1 || !m_session.scene().find(source.front()))
    return;
  give(ids, model::lookOf(m_session.scene(), source.front()), false, tr("Make Like"));
  m_session.select(ids);
}

void StyleActions::showState() {
  const NodeIds& ids = m_session.selection();
  const model::Scene& scene = m_session.scene();
  // The session removes deleted nodes from the selection only after the document has changed.
  const bool any = !ids.empty() && std::all_of(ids.begin(), ids.end(), [&](model::NodeId id) {
    return scene.find(id) != nullptr;
  });
  const bool free = any && !model::editable(scene, ids).empty();
  m_actions[QStringLiteral("copyStyle")].setEnabled(any);
  for (const char* id : {"pasteStyle", "pasteStyleAlone"})
    m_actions[QLatin1String(id)].setEnabled(free && copiedStyle());
  QAction& like = m_actions[QStringLiteral("makeLike")];
  like.setEnabled(free || !m_waiting.empty());
  like.setChecked(!m_waiting.empty());
}

}  // namespace sline::widgets

#include "moc_style_actions.cpp"
