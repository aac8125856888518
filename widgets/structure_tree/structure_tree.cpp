// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/structure_tree.h"

#include <QColorDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QVBoxLayout>

#include "model/edit/emphasis.h"
#include "model/edit/look.h"
#include "widgets/gamma/look_drag.h"
#include "widgets/session/colour_dialog.h"
#include "widgets/session/typed_wishes.h"
#include "widgets/shell/filter_line.h"
#include "widgets/structure_tree/structure_properties.h"
#include "widgets/structure_tree/structure_tree_view.h"

namespace sline::widgets {

StructureTree::StructureTree(Session& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_filter(makeFilterLine(QStringLiteral("structureFilter"), tr("Filter structures by name"),
                              tr("Filter by name"))),
      m_count(new QLabel),
      m_view(new StructureTreeView(session)) {
  m_filter->setToolTip(
      tr("Words in any order; “%1” or a comma between them finds either. Enter selects all that "
         "match, Down goes to the list, Escape shows all again.")
          .arg(orWord()));
  m_filter->installEventFilter(this);
  m_count->setObjectName(QStringLiteral("filterCount"));
  m_count->setContentsMargins(10, 0, 10, 6);
  m_count->setForegroundRole(QPalette::PlaceholderText);
  m_count->hide();
  auto* filter = new QVBoxLayout;
  filter->setContentsMargins(8, 8, 8, 8);
  filter->addWidget(m_filter);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(filter);
  layout->addWidget(m_count);
  layout->addWidget(m_view, 1);
  connect(m_filter, &QLineEdit::textChanged, m_view, &StructureTreeView::setFilter);
  connect(m_view, &StructureTreeView::filtered, this, &StructureTree::showCount);
  connect(&session, &Session::documentChanged, this,
          [this](const Document& before, const Document& now) {
            // A filter that was typed for one scene would hide parts of the next.
            if (before.opening != now.opening)
              m_filter->clear();
            showCount();
          });
  connect(m_view, &StructureTreeView::colourWanted, this, &StructureTree::chooseColour);
}

void StructureTree::find() {
  m_filter->setFocus(Qt::ShortcutFocusReason);
  m_filter->selectAll();
}

void StructureTree::showCount() {
  const bool filtering = !m_filter->text().trimmed().isEmpty();
  m_count->setVisible(filtering);
  if (!filtering)
    return;
  const int found = int(m_view->matches().size());
  m_count->setText(found == 0 ? tr("No structure is called so")
                              : tr("%n structures – Enter selects them", nullptr, found));
}

bool StructureTree::filterKey(int key) {
  switch (key) {
    case Qt::Key_Escape:
      m_filter->clear();
      m_view->setFocus();
      return true;
    case Qt::Key_Down:
      m_view->enter();
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (!m_view->matches().empty())
        m_session.select(m_view->matches());
      m_view->setFocus();
      return true;
    default:
      return false;
  }
}

bool StructureTree::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress && filterKey(static_cast<QKeyEvent*>(event)->key()))
    return true;
  return QWidget::eventFilter(watched, event);
}

void StructureTree::chooseColour(const NodeIds& ids) {
  if (ids.empty())
    return;
  const NodeIds structures = m_session.scene().structuresBelow(ids.front());
  const model::NodeId first = structures.empty() ? ids.front() : structures.front();
  const Colour now = m_session.scene().resolve(first).colour;
  auto* dialog = makeColourDialog(m_session.names(), QColor(now.red, now.green, now.blue), this);
  dialog->setObjectName(QStringLiteral("colourDialog"));
  dialog->setWindowTitle(lookStepName(tr("Colour"), m_session, ids));
  // While it is open each colour shows at once; accepting makes the one undo step.
  const auto show = [this, ids](const QColor& c) {
    const Colour colour{std::uint8_t(c.red()), std::uint8_t(c.green()), std::uint8_t(c.blue())};
    m_session.preview(
        model::withLook(m_session.sceneBeforePreview(), ids, {.colour = colour}).scene);
  };
  connect(dialog, &QColorDialog::currentColorChanged, this, show);
  connect(dialog, &QColorDialog::accepted, this, [this] { m_session.commitPreview(tr("Colour")); });
  connect(dialog, &QColorDialog::rejected, this, [this] { m_session.cancelPreview(); });
  dialog->open();
}

void StructureTree::showProperties(const NodeIds& ids) {
  if (ids.empty())
    return;
  const QString explanation = ids.size() == 1 && m_explain ? m_explain(ids.front()) : QString();
  (new StructureProperties(m_session, ids, explanation, this))->show();
}

}  // namespace sline::widgets

#include "moc_structure_tree.cpp"
