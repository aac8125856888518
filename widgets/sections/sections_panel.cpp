// SPDX-License-Identifier: Apache-2.0
#include "widgets/sections/sections_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "model/scene/known_frame.h"
#include "widgets/sections/new_section.h"
#include "widgets/sections/section_list.h"
#include "widgets/sections/section_position.h"
#include "widgets/session/length_texts.h"

namespace sline::widgets {

namespace {

QToolButton* button(const QString& text, const char* name, const QString& tip) {
  auto* made = new QToolButton;
  made->setObjectName(QLatin1String(name));
  made->setText(text);
  made->setToolTip(tip);
  made->setToolButtonStyle(Qt::ToolButtonTextOnly);
  return made;
}

}  // namespace

SectionsPanel::SectionsPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_sections(new SectionList(session, this)) {
  setObjectName(QStringLiteral("sections"));
  makeList();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(makeButtons());
  layout->addWidget(m_list, 1);
  layout->addWidget(makeDetails());
  connect(&session, &Session::documentChanged, this, &SectionsPanel::showActive);
  connect(&session, &Session::activeSectionChanged, this, &SectionsPanel::showActive);
  connect(&session, &Session::selectionChanged, this, &SectionsPanel::showActive);
  connect(&session.names(), &DisplayNames::changed, this, &SectionsPanel::showActive);
  showActive();
}

void SectionsPanel::makeList() {
  m_list = new QTreeView;
  m_list->setObjectName(QStringLiteral("sectionList"));
  m_list->setAccessibleName(tr("Sections"));
  m_list->setModel(m_sections);
  m_list->setRootIsDecorated(false);
  m_list->setAllColumnsShowFocus(true);
  m_list->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  m_list->installEventFilter(this);
  QHeaderView* columns = m_list->header();
  columns->setStretchLastSection(false);
  columns->setSectionsMovable(false);
  columns->setSectionResizeMode(SectionList::name, QHeaderView::Stretch);
  columns->setSectionResizeMode(SectionList::position, QHeaderView::ResizeToContents);
  columns->setSectionResizeMode(SectionList::scope, QHeaderView::ResizeToContents);
  const auto activate = [this](const QModelIndex& now) {
    const model::Section* section = m_sections->at(now.row());
    if (!m_following && section)
      m_session.activateSection(section->id);
  };
  connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, activate);
}

QWidget* SectionsPanel::makeButtons() {
  m_add = button(tr("Add"), "sectionAdd", tr("Add a section plane"));
  m_add->setPopupMode(QToolButton::InstantPopup);
  m_flip = button(tr("Flip"), "sectionFlipOne", tr("Keep the other side of this section"));
  m_remove = button(tr("Delete"), "sectionDelete", tr("Take this section away"));
  connect(m_flip, &QToolButton::clicked, this, [this] {
    if (const model::Section* there = active()) {
      model::Section section = *there;
      section.plane = flipped(section.plane);
      change(tr("Flip Section"), section);
    }
  });
  connect(m_remove, &QToolButton::clicked, this, &SectionsPanel::remove);
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_add);
  layout->addStretch(1);
  layout->addWidget(m_flip);
  layout->addWidget(m_remove);
  return row;
}

QWidget* SectionsPanel::makeDetails() {
  m_position = new QDoubleSpinBox;
  m_position->setObjectName(QStringLiteral("sectionPosition"));
  m_position->setDecimals(1);
  m_position->setRange(-1e5, 1e5);
  m_scope = new QComboBox;
  m_scope->setObjectName(QStringLiteral("sectionScope"));
  m_scope->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_scope->setMinimumContentsLength(8);
  m_faces = new QComboBox;
  m_faces->setObjectName(QStringLiteral("sectionFaces"));
  m_faces->addItems({tr("Paper"), tr("Tint"), tr("Tissue")});
  m_faces->setToolTip(
      tr("Cut faces as white as the paper, in a tint of the structure's colour, or with the "
         "pattern of its tissue as in printed atlases"));
  m_hatched = new QCheckBox(tr("Hatched cut faces"));
  m_hatched->setObjectName(QStringLiteral("sectionHatched"));
  connect(m_position, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    const model::Section* there = active();
    if (m_following || !there)
      return;
    model::Section section = *there;
    section.plane = movedTo(section.plane, value);
    change(tr("Move Section"), section,
           QStringLiteral("section-position-%1").arg(section.id.value));
  });
  connect(m_scope, &QComboBox::activated, this, &SectionsPanel::scopeChosen);
  connect(m_faces, &QComboBox::activated, this, &SectionsPanel::facesChosen);
  connect(m_hatched, &QCheckBox::clicked, this, [this](bool on) {
    if (const model::Section* there = active()) {
      model::Section section = *there;
      section.hatched = on;
      change(tr("Hatched Cut Faces"), section);
    }
  });
  m_details = new QWidget;
  auto* form = new QFormLayout(m_details);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("&Position"), m_position);
  form->addRow(tr("&Cuts"), m_scope);
  form->addRow(tr("Cut faces"), m_faces);
  form->addRow(QString(), m_hatched);
  return m_details;
}

const model::Section* SectionsPanel::active() const {
  return m_sections->at(m_sections->rowOf(m_session.activeSection()));
}

void SectionsPanel::change(const QString& step, const model::Section& section,
                           const QString& series) {
  m_session.apply(step, model::withSectionChanged(m_session.scene(), section.id, section), series);
}

void SectionsPanel::remove() {
  const int row = m_sections->rowOf(m_session.activeSection());
  const model::Section* section = m_sections->at(row);
  if (!section)
    return;
  const std::array<model::SectionId, 1> ids{section->id};
  m_session.apply(tr("Delete Section"), model::withoutSections(m_session.scene(), ids));
  // The next section takes its place, so that a key held down deletes one after the other.
  const model::Section* next = m_sections->at(std::min(row, m_sections->rowCount() - 1));
  m_session.activateSection(next ? std::optional(next->id) : std::nullopt);
}

bool SectionsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_list && event->type() == QEvent::ShortcutOverride) {
    // Elsewhere in the window Del removes structures.
    if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete)
      event->accept();
  } else if (watched == m_list && event->type() == QEvent::KeyPress &&
             static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
    remove();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void SectionsPanel::listScopes(const model::Section& section) {
  m_scope->clear();
  const auto add = [&](model::NodeId id, const QString& text) {
    if (m_scope->findData(qulonglong(id.value)) < 0)
      m_scope->addItem(text, qulonglong(id.value));
  };
  add(model::rootId, scopeText(m_session, model::rootId));
  add(section.scope, scopeText(m_session, section.scope));
  const model::NodeId selected = commonNode(m_session.scene(), m_session.selection());
  if (selected != model::rootId)
    add(selected, tr("Selected: %1").arg(scopeText(m_session, selected)));
  m_scope->setCurrentIndex(m_scope->findData(qulonglong(section.scope.value)));
}

void SectionsPanel::scopeChosen(int row) {
  if (const model::Section* there = active()) {
    model::Section section = *there;
    section.scope = model::NodeId{m_scope->itemData(row).toULongLong()};
    change(tr("What a Section Cuts"), section);
  }
}

void SectionsPanel::facesChosen(int row) {
  if (const model::Section* there = active()) {
    model::Section section = *there;
    section.faces = model::CutFaces(row);
    change(tr("Cut Faces"), section);
  }
}

void SectionsPanel::showActive() {
  const QScopedValueRollback following(m_following, true);
  const int row = m_sections->rowOf(m_session.activeSection());
  const model::Section* section = m_sections->at(row);
  if (row != m_list->currentIndex().row())
    m_list->setCurrentIndex(m_sections->index(row, 0));
  // Names get the room of this column, unless some section cuts less than the whole scene.
  const auto& all = m_session.scene().sections();
  m_list->setColumnHidden(SectionList::scope,
                          std::all_of(all.begin(), all.end(), [](const model::Section& each) {
                            return each.scope == model::rootId;
                          }));
  m_flip->setEnabled(section);
  m_remove->setEnabled(section);
  m_details->setVisible(section);
  m_add->setEnabled(!m_session.scene().nodes().empty());
  if (!section)
    return;
  m_position->setSuffix(unitSuffix(m_session.scene()));
  m_position->setToolTip(
      hasSides(m_session.scene())
          ? tr("Towards the left, the back or the head; of an oblique section along its normal")
          : tr("Along the X, the Y or the Z axis; of an oblique section along its normal"));
  m_position->setValue(positionOf(section->plane));
  m_faces->setCurrentIndex(int(section->faces));
  m_hatched->setChecked(section->hatched);
  listScopes(*section);
}

}  // namespace sline::widgets

#include "moc_sections_panel.cpp"
