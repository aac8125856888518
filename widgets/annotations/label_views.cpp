// SPDX-License-Identifier: Apache-2.0
#include "widgets/annotations/label_views.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>
#include <algorithm>

#include "model/edit/annotations.h"

namespace sline::widgets {

namespace {

// These values of the list's rows stand for something other than a view's place.
constexpr int allViews = -1;
constexpr int asItIs = -2;

}  // namespace

LabelViews::LabelViews(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_list(new QComboBox), m_ticks(new QToolButton) {
  m_list->setObjectName(QStringLiteral("annotationViews"));
  m_list->setAccessibleName(tr("Views that show it"));
  m_list->setToolTip(tr("Which of the saved views show it"));
  m_list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_list->setMinimumContentsLength(5);
  connect(m_list, &QComboBox::activated, this, &LabelViews::choose);
  m_ticks->setObjectName(QStringLiteral("annotationViewTicks"));
  m_ticks->setText(tr("Views"));
  m_ticks->setToolTip(tr("A tick for each saved view that shows what is chosen in the list"));
  m_ticks->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(m_ticks);
  menu->setObjectName(QStringLiteral("annotationViewMenu"));
  connect(menu, &QMenu::aboutToShow, this, &LabelViews::fillTicks);
  m_ticks->setMenu(menu);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  row->addWidget(m_list, 1);
  row->addWidget(m_ticks);
}

void LabelViews::setLabels(std::vector<model::AnnotationId> labels) {
  m_labels = std::move(labels);
  const std::vector<model::View>& views = m_session.scene().views();
  setEnabled(!views.empty());
  m_list->setEnabled(!views.empty());
  if (m_labels.empty())
    return;
  const auto viewsOf = [this](model::AnnotationId id) {
    return model::viewsShowing(m_session.scene(), id);
  };
  const std::vector<std::size_t> showing = viewsOf(m_labels.front());
  const bool alike = std::all_of(m_labels.begin(), m_labels.end(),
                                 [&](model::AnnotationId id) { return viewsOf(id) == showing; });
  m_list->clear();
  m_list->addItem(tr("In all views"), allViews);
  for (std::size_t i = 0; i < views.size(); ++i)
    m_list->addItem(tr("Only in %1").arg(QString::fromStdString(views[i].name)), int(i));
  int row = 0;
  if (alike && showing.size() == 1 && views.size() > 1) {
    row = 1 + int(showing.front());
  } else if (!alike || showing.size() != views.size()) {
    QString as = tr("In different views");
    if (alike)
      as = showing.empty() ? tr("In no view") : tr("In %n views", nullptr, int(showing.size()));
    m_list->addItem(as, asItIs);
    row = m_list->count() - 1;
  }
  m_list->setCurrentIndex(row);
}

void LabelViews::choose(int row) {
  const int view = m_list->itemData(row).toInt();
  if (view == asItIs)
    return;
  const auto only = view == allViews ? std::nullopt : std::optional(std::size_t(view));
  model::Scene scene = m_session.scene();
  for (const model::AnnotationId id : m_labels)
    scene = model::withAnnotationShownIn(scene, id, only).scene;
  const bool changed = scene.views() != m_session.scene().views();
  m_session.apply(tr("Views of a Label"), {std::move(scene), changed});
}

void LabelViews::tick(const std::vector<std::size_t>& views, bool shown) {
  m_session.apply(tr("Views of a Label"),
                  model::withAnnotationsTicked(m_session.scene(), m_labels, views, shown));
}

void LabelViews::fillTicks() {
  QMenu& menu = *m_ticks->menu();
  menu.clear();
  const std::vector<model::View>& views = m_session.scene().views();
  std::vector<std::size_t> showing(views.size());
  for (const model::AnnotationId id : m_labels)
    for (const std::size_t place : model::viewsShowing(m_session.scene(), id))
      ++showing[place];
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < views.size(); ++i) {
    QString name = QString::fromStdString(views[i].name);
    name.replace(QLatin1Char('&'), QLatin1String("&&"));
    if (showing[i] > 0 && showing[i] < m_labels.size())
      name = tr("%1 (some of them)", "a saved view that shows some of the labels").arg(name);
    QAction* action = menu.addAction(name);
    action->setCheckable(true);
    action->setChecked(!m_labels.empty() && showing[i] == m_labels.size());
    connect(action, &QAction::triggered, this, [this, i](bool on) { tick({i}, on); });
    all.push_back(i);
  }
  menu.addSeparator();
  menu.addAction(tr("In All Views"), this, [this, all] { tick(all, true); });
  menu.addAction(tr("In No View"), this, [this, all] { tick(all, false); });
}

}  // namespace sline::widgets

#include "moc_label_views.cpp"
