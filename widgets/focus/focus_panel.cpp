// SPDX-License-Identifier: Apache-2.0
#include "widgets/focus/focus_panel.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/focus/amount_slider.h"
#include "widgets/focus/near_row.h"
#include "widgets/focus/role_texts.h"

namespace sline::widgets {

namespace {

constexpr int idRole = Qt::UserRole;
constexpr int roleRole = Qt::UserRole + 1;

QLabel* caption(const QString& text) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  return label;
}

/// Returns the role that the user chose, otherwise the one that the analysis found.
model::ContextRole roleOf(const FocusState& state, const model::Relation& relation) {
  const auto wish = state.wishes.roles.find(relation.structure);
  return wish == state.wishes.roles.end() ? relation.role : wish->second;
}

/// Says who decided how a structure is drawn.
struct Deciding {
  bool wished = false;  ///< its role was chosen
  bool byHand = false;  ///< it was set by hand since
};

bool isIn(const NodeIds& ids, model::NodeId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

QTreeWidgetItem* rowOf(Session& session, const model::Relation& relation, Deciding who) {
  auto* item = new QTreeWidgetItem;
  const QString reason = who.byHand   ? FocusPanel::tr("Set by hand since; the focus leaves it so")
                         : who.wished ? FocusPanel::tr("As you said")
                                      : reasonText(session, relation);
  const QString name = session.names().shown(session.scene().find(relation.structure)->name);
  item->setText(0, who.byHand ? FocusPanel::tr("%1 – by hand").arg(name) : name);
  item->setToolTip(0, reason.toHtmlEscaped());
  item->setData(0, Qt::AccessibleDescriptionRole, reason);
  item->setData(0, idRole, qulonglong(relation.structure.value));
  auto* why = new QTreeWidgetItem(item, {reason});
  why->setFlags(Qt::ItemIsEnabled);
  return item;
}

}  // namespace

FocusPanel::FocusPanel(Session& session, FocusContext& focus, NearTool& nearness, QWidget* parent)
    : QWidget(parent), m_session(session), m_focus(focus) {
  m_title = caption({});
  m_title->setObjectName(QStringLiteral("focusTitle"));
  m_title->setTextFormat(Qt::PlainText);
  m_title->setWordWrap(true);
  m_hint = new QLabel;
  m_hint->setObjectName(QStringLiteral("focusHint"));
  m_hint->setWordWrap(true);
  m_button = new QPushButton(tr("Focus on Selection"));
  m_button->setObjectName(QStringLiteral("focusOnSelection"));
  m_button->setToolTip(tr("These in detail, everything else by what it is to them"));

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(14, 12, 14, 14);
  layout->setSpacing(8);
  layout->addWidget(m_title);
  layout->addWidget(m_hint);
  layout->addWidget(m_button);
  layout->addWidget(new NearRow(session, nearness));
  layout->addSpacing(4);
  layout->addWidget(makeAmount());
  layout->addWidget(makeSides());
  layout->addWidget(makeRoles(), 1);
  connectControls();
  refresh();
}

QWidget* FocusPanel::makeAmount() {
  auto* box = new QWidget;
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(caption(tr("How much context")));
  m_amount = new AmountSlider;
  m_amount->setObjectName(QStringLiteral("contextAmount"));
  m_amount->setAccessibleName(tr("How much context"));
  layout->addWidget(m_amount);
  auto* ends = new QHBoxLayout;
  ends->addWidget(new QLabel(tr("Focus alone")));
  ends->addStretch();
  ends->addWidget(new QLabel(tr("Everything")));
  layout->addLayout(ends);
  m_needFocus.push_back(box);
  return box;
}

QWidget* FocusPanel::makeSides() {
  struct Choice {
    const char* name;
    QString text;
    QString tip;
  };
  const Choice choices[] = {
      {"fromAround", tr("All Round"), tr("Nothing hides the focus from whatever side it is seen")},
      {"fromView", tr("This View"),
       tr("Nothing hides the focus as it is seen now; what lies behind it may be solid")}};
  auto* box = new QWidget;
  auto* layout = new QHBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  m_sides = new QButtonGroup(this);
  for (const Choice& choice : choices) {
    auto* button = new QPushButton(choice.text);
    button->setObjectName(QLatin1String(choice.name));
    button->setToolTip(choice.tip);
    button->setCheckable(true);
    m_sides->addButton(button, int(m_sides->buttons().size()));
    layout->addWidget(button);
  }
  m_needFocus.push_back(box);
  return box;
}

QWidget* FocusPanel::makeRoles() {
  auto* box = new QWidget;
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->setSpacing(6);
  m_roles = new QTreeWidget;
  m_roles->setObjectName(QStringLiteral("focusRoles"));
  m_roles->setAccessibleName(tr("What each structure is to the focus"));
  m_roles->setHeaderHidden(true);
  m_roles->setColumnCount(1);
  m_roles->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_roles->setUniformRowHeights(true);
  m_roles->setIndentation(14);
  m_role = new QComboBox;
  m_role->setObjectName(QStringLiteral("focusRole"));
  m_role->setAccessibleName(tr("Treat as"));
  for (const RoleRow& row : roleRows())
    m_role->addItem(row.text, int(row.role));
  auto* treat = new QHBoxLayout;
  auto* label = new QLabel(tr("&Treat as"));
  label->setBuddy(m_role);
  treat->addWidget(label);
  treat->addWidget(m_role, 1);
  m_hidden = new QCheckBox;
  m_hidden->setObjectName(QStringLiteral("focusHiddenToo"));
  layout->addWidget(m_roles, 1);
  layout->addLayout(treat);
  m_giveBack = new QPushButton;
  m_giveBack->setObjectName(QStringLiteral("focusGiveBack"));
  m_giveBack->setToolTip(
      tr("Draws them as the focus would; only those chosen in the list, if any"));
  layout->addWidget(m_giveBack);
  layout->addWidget(m_hidden);
  m_needFocus.push_back(box);
  return box;
}

void FocusPanel::connectControls() {
  connect(m_button, &QPushButton::clicked, this, &FocusPanel::focusWanted);
  connect(m_amount, &AmountSlider::dragged, &m_focus, &FocusContext::dragTo);
  connect(m_amount, &AmountSlider::dragFinished, &m_focus, &FocusContext::finishDrag);
  connect(m_amount, &AmountSlider::dragCancelled, &m_focus, &FocusContext::cancelDrag);
  connect(m_amount, &AmountSlider::stepped, &m_focus, &FocusContext::stepTo);
  connect(m_sides, &QButtonGroup::idClicked, this,
          [this](int id) { m_focus.setFromCamera(id == 1); });
  connect(m_roles, &QTreeWidget::itemSelectionChanged, this, &FocusPanel::showChosenRole);
  connect(m_role, &QComboBox::activated, this, [this](int index) {
    m_focus.setRoles(chosen(), model::ContextRole(m_role->itemData(index).toInt()));
  });
  connect(m_hidden, &QCheckBox::clicked, &m_focus, &FocusContext::setHiddenToo);
  connect(m_giveBack, &QPushButton::clicked, this, [this] {
    NodeIds some = chosen();
    std::erase_if(some, [this](model::NodeId id) { return !isIn(m_byHand, id); });
    m_focus.giveBack(some.empty() ? m_byHand : some);
  });
  connect(&m_focus, &FocusContext::changed, this, &FocusPanel::refresh);
  connect(&m_focus, &FocusContext::busyChanged, this, &FocusPanel::showTitle);
  connect(&m_session, &Session::selectionChanged, this, &FocusPanel::showTitle);
  connect(&m_session.names(), &DisplayNames::changed, this, &FocusPanel::refresh);
  connect(&m_session, &Session::documentChanged, this,
          [this](const Document& before, const Document& now) {
            if (before.scene.nodes() == now.scene.nodes())
              return;
            showTitle();
            showHidden();
            showHand();
          });
}

void FocusPanel::refresh() {
  const FocusState& state = m_focus.state();
  for (QWidget* control : m_needFocus)
    control->setEnabled(state.analysis != nullptr);
  m_amount->showAmount(state.amount);
  m_sides->button(state.analysis && state.analysis->camera ? 1 : 0)->setChecked(true);
  showTitle();
  m_byHand = model::setByHand(m_session.scene());
  showRoles();
  showHand();
  showHidden();
}

void FocusPanel::showTitle() {
  const FocusState& state = m_focus.state();
  QStringList names;
  for (const model::NodeId id : state.targets)
    if (const model::Node* node = m_session.scene().find(id))
      names << m_session.names().shown(node->name);
  constexpr int few = 3;
  const auto& nearness = m_session.scene().focus().nearness;
  m_title->setText(nearness && nearness->place ? tr("Nearness to a place")
                   : names.isEmpty()           ? tr("Nothing in focus")
                   : names.size() <= few
                       ? names.join(QStringLiteral(", "))
                       : tr("%n structures in focus", nullptr, int(names.size())));
  const bool any = !m_session.selection().empty();
  m_button->setEnabled(any);
  m_hint->setText(m_focus.busy() ? tr("Looking at what surrounds it…")
                                 : tr("Select a structure in the list or in the picture."));
  m_hint->setVisible(m_focus.busy() || (!any && names.isEmpty() && !nearness));
}

void FocusPanel::showRoles() {
  const NodeIds before = chosen();
  std::vector<int> open;
  for (int i = 0; i < m_roles->topLevelItemCount(); ++i)
    if (m_roles->topLevelItem(i)->isExpanded())
      open.push_back(m_roles->topLevelItem(i)->data(0, roleRole).toInt());
  const QSignalBlocker quiet(m_roles);
  m_roles->clear();
  const FocusState& state = m_focus.state();
  if (!state.analysis)
    return;
  for (const RoleRow& row : roleRows()) {
    auto* heading = new QTreeWidgetItem;
    for (const model::Relation& relation : state.analysis->relations)
      if (roleOf(state, relation) == row.role && m_session.scene().find(relation.structure))
        heading->addChild(rowOf(
            m_session, relation,
            {.wished = row.role != relation.role, .byHand = isIn(m_byHand, relation.structure)}));
    if (heading->childCount() == 0) {
      delete heading;
      continue;
    }
    heading->setText(0, tr("%1 (%2)").arg(row.plural, QLocale().toString(heading->childCount())));
    heading->setData(0, roleRole, int(row.role));
    heading->setFlags(Qt::ItemIsEnabled);
    m_roles->addTopLevelItem(heading);
    heading->setExpanded(std::find(open.begin(), open.end(), int(row.role)) != open.end());
    for (int i = 0; i < heading->childCount(); ++i) {
      const model::NodeId id{heading->child(i)->data(0, idRole).toULongLong()};
      heading->child(i)->setSelected(std::find(before.begin(), before.end(), id) != before.end());
    }
  }
  showChosenRole();
}

NodeIds FocusPanel::chosen() const {
  NodeIds ids;
  for (const QTreeWidgetItem* item : m_roles->selectedItems())
    if (const qulonglong id = item->data(0, idRole).toULongLong())
      ids.push_back(model::NodeId{id});
  return ids;
}

void FocusPanel::showChosenRole() {
  const QList<QTreeWidgetItem*> items = m_roles->selectedItems();
  m_role->setEnabled(!items.isEmpty());
  if (items.isEmpty() || !items.front()->parent())
    return;
  m_role->setCurrentIndex(m_role->findData(items.front()->parent()->data(0, roleRole)));
}

void FocusPanel::showHand() {
  NodeIds now = model::setByHand(m_session.scene());
  if (now != m_byHand) {
    m_byHand = std::move(now);
    showRoles();
  }
  m_giveBack->setVisible(!m_byHand.empty());
  m_giveBack->setText(tr("%n by Hand: Back to the Focus", nullptr, int(m_byHand.size())));
}

void FocusPanel::showHidden() {
  const FocusState& state = m_focus.state();
  const auto hidden =
      state.analysis ? model::hiddenByHand(m_session.scene(), *state.analysis).size() : 0;
  m_hidden->setVisible(hidden > 0 || state.wishes.hiddenToo);
  m_hidden->setText(state.wishes.hiddenToo ? tr("Also what was hidden")
                                           : tr("Also %n hidden structures", nullptr, int(hidden)));
  m_hidden->setChecked(state.wishes.hiddenToo);
}

}  // namespace sline::widgets

#include "moc_focus_panel.cpp"
