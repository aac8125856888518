// SPDX-License-Identifier: Apache-2.0
// Makes the controls of the panel of labels.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QTreeView>

#include "widgets/annotations/annotation_list.h"
#include "widgets/annotations/annotations_panel.h"
#include "widgets/annotations/label_field.h"
#include "widgets/annotations/label_preferences.h"
#include "widgets/annotations/label_views.h"
#include "widgets/preferences/preference_control.h"

namespace sline::widgets {

namespace {

void makeNarrow(QComboBox& box) {
  box.setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box.setMinimumContentsLength(5);
}

QComboBox* narrowBox(const char* name, const QString& says) {
  auto* box = new QComboBox;
  box->setObjectName(QLatin1String(name));
  box->setAccessibleName(says);
  makeNarrow(*box);
  return box;
}

}  // namespace

QWidget* AnnotationsPanel::makeButtons() {
  m_remove = new QToolButton;
  m_remove->setObjectName(QStringLiteral("annotationDelete"));
  m_remove->setText(tr("Delete"));
  m_remove->setToolTip(tr("Take this label away"));
  connect(m_remove, &QToolButton::clicked, this, &AnnotationsPanel::remove);
  auto* row = new QWidget;
  m_buttons = new QHBoxLayout(row);
  m_buttons->setContentsMargins(0, 0, 0, 0);
  m_buttons->setSpacing(2);
  m_buttons->addStretch(1);
  m_buttons->addWidget(m_remove);
  return row;
}

void AnnotationsPanel::addButtons(const std::vector<QAction*>& actions) {
  int at = 0;
  for (QAction* action : actions) {
    auto* button = new QToolButton;
    button->setObjectName(action->objectName() + QStringLiteral("Button"));
    button->setDefaultAction(action);
    button->setAccessibleName(action->text().remove(QLatin1Char('&')));
    button->setIconSize({18, 18});
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    if (action->icon().isNull())
      button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_buttons->insertWidget(at++, button);
  }
}

QWidget* AnnotationsPanel::makePreferencesRow() {
  const auto control = [this](const char* name, const char* id) {
    QWidget* made = makePreferenceControl(m_preferences, QLatin1String(id));
    made->setObjectName(QLatin1String(name));
    if (auto* box = qobject_cast<QComboBox*>(made))
      makeNarrow(*box);
    return made;
  };
  auto* look = new QWidget;
  auto* layout = new QHBoxLayout(look);
  layout->setContentsMargins(0, 0, 0, 0);
  // As long as each one's words are in the language where they are longest.
  layout->addWidget(control("annotationMode", labelModeKey), 21);
  layout->addWidget(control("annotationLanguage", labelLanguageKey), 33);
  layout->addWidget(control("annotationPoints", labelPointsKey), 14);
  return look;
}

void AnnotationsPanel::makeList() {
  m_list = new QTreeView;
  m_list->setObjectName(QStringLiteral("annotationList"));
  m_list->setAccessibleName(tr("Labels"));
  m_list->setModel(m_annotations);
  m_list->setRootIsDecorated(false);
  m_list->setAllColumnsShowFocus(true);
  m_list->setUniformRowHeights(true);
  m_list->setTextElideMode(Qt::ElideMiddle);
  m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
  // The list is as high as there is room, but takes no height from the other panels.
  m_list->setMinimumHeight(64);
  m_list->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
  m_list->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  m_list->installEventFilter(this);
  QHeaderView* columns = m_list->header();
  columns->setStretchLastSection(false);
  columns->setSectionsMovable(false);
  columns->setSectionResizeMode(AnnotationList::number, QHeaderView::ResizeToContents);
  columns->setSectionResizeMode(AnnotationList::text, QHeaderView::Stretch);
  columns->setSectionResizeMode(AnnotationList::kind, QHeaderView::ResizeToContents);
  columns->setSectionResizeMode(AnnotationList::place, QHeaderView::Stretch);
  const auto activate = [this](const QModelIndex& now) {
    const model::Annotation* annotation = m_annotations->at(now.row());
    if (!m_following && annotation)
      m_session.activateAnnotation(annotation->id);
  };
  connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, activate);
  connect(m_list, &QTreeView::clicked, this, activate);
  connect(m_list->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    if (!m_following)
      m_views->setLabels(chosen());
  });
}

void AnnotationsPanel::makeSight() {
  m_sight = new QLabel;
  m_sight->setObjectName(QStringLiteral("annotationSight"));
  m_sight->setTextFormat(Qt::PlainText);
  m_sight->setWordWrap(true);
  m_sight->hide();
}

void AnnotationsPanel::makeText() {
  m_text = new LabelField;
  m_text->setObjectName(QStringLiteral("annotationText"));
  m_text->setAccessibleName(tr("What the label says"));
  m_text->setTabChangesFocus(true);
  m_text->installEventFilter(this);
  connect(m_text, &QPlainTextEdit::textChanged, this, &AnnotationsPanel::write);
}

void AnnotationsPanel::makeChoices() {
  m_kind = narrowBox("annotationKind", tr("Kind of label"));
  connect(m_kind, &QComboBox::activated, this, &AnnotationsPanel::kindChosen);
  m_colour = new QToolButton;
  m_colour->setObjectName(QStringLiteral("annotationColour"));
  m_colour->setText(tr("Colour"));
  m_colour->setToolTip(tr("Of the dot at its place"));
  m_colour->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_colour->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(m_colour);
  menu->setObjectName(QStringLiteral("annotationColourMenu"));
  menu->addAction(tr("As the &Ink"), this,
                  [this] { setColour(tr("Colour of a Label"), std::nullopt); });
  menu->addAction(tr("&Colour…"), this, &AnnotationsPanel::chooseColour);
  m_colour->setMenu(menu);
  m_views = new LabelViews(m_session);
  m_locked = new QCheckBox(tr("Locked"));
  m_locked->setObjectName(QStringLiteral("annotationLocked"));
  m_locked->setToolTip(tr("The mouse does not move it"));
  connect(m_locked, &QCheckBox::clicked, this, [this](bool on) {
    if (const model::Annotation* there = active()) {
      model::Annotation annotation = *there;
      annotation.locked = on;
      change(on ? tr("Lock Label") : tr("Unlock Label"), annotation);
    }
  });
  m_release = new QToolButton;
  m_release->setObjectName(QStringLiteral("annotationRelease"));
  m_release->setText(tr("Place by Itself"));
  m_release->setToolTip(tr("It finds its place again, after it was moved by hand"));
  connect(m_release, &QToolButton::clicked, this, [this] {
    if (const model::Annotation* there = active()) {
      model::Annotation annotation = *there;
      annotation.offset.reset();
      change(tr("Place Label by Itself"), annotation);
    }
  });
}

QWidget* AnnotationsPanel::makeDetails() {
  makeText();
  makeChoices();
  m_details = new QWidget;
  auto* grid = new QGridLayout(m_details);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(0, 3);
  grid->setColumnStretch(1, 2);
  grid->addWidget(m_text, 0, 0, 1, 3);
  grid->addWidget(m_kind, 1, 0);
  grid->addWidget(m_colour, 1, 1);
  grid->addWidget(m_locked, 1, 2);
  grid->addWidget(m_views, 2, 0);
  grid->addWidget(m_release, 2, 1, 1, 2);
  return m_details;
}

}  // namespace sline::widgets
