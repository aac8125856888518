// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/views_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/theme/icons.h"
#include "widgets/views/view_card.h"
#include "widgets/views/view_list.h"
#include "widgets/views/view_pictures.h"
#include "widgets/views/view_row.h"
#include "widgets/views/view_tour.h"
#include "widgets/views/view_words_editor.h"

namespace sline::widgets {

ViewsPanel::ViewsPanel(Session& session, Viewport& viewport, ViewTour& tour,
                       Preferences& preferences)
    : m_session(session),
      m_tour(tour),
      m_cards(new QHBoxLayout),
      m_list(new ViewList(session, tour, this)),
      m_row(new ViewRow),
      m_pictures(new ViewPictures(session, viewport, *m_list, this)),
      m_words(new ViewWordsEditor(session, viewport, preferences)) {
  setObjectName(QStringLiteral("views"));
  m_row->setModel(m_list);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 2);
  layout->setSpacing(4);
  m_cards->setSpacing(6);
  m_cards->addWidget(m_row, 1);
  layout->addLayout(m_cards);
  layout->addWidget(m_words);
  m_words->hide();
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  connect(m_row, &ViewRow::goWanted, &tour, &ViewTour::goTo);
  connect(m_row, &ViewRow::moveWanted, &tour, &ViewTour::move);
  connect(m_row, &ViewRow::removeWanted, &tour, &ViewTour::remove);
  connect(m_row, &ViewRow::visibleRowsChanged, this, &ViewsPanel::wantPictures);
  connect(&tour, &ViewTour::arrived, this, &ViewsPanel::choose);
  connect(m_row->selectionModel(), &QItemSelectionModel::currentChanged, this,
          &ViewsPanel::showState);
  for (const auto changed : {&ViewList::rowsInserted, &ViewList::rowsRemoved})
    connect(m_list, changed, this, [this] {
      wantPictures();
      showState();
    });
  connect(m_list, &ViewList::rowsMoved, this, &ViewsPanel::showState);
  connect(m_list, &ViewList::modelReset, this, [this] {
    wantPictures();
    showState();
  });
}

QToolButton* ViewsPanel::button(const QString& text, const char* name, const char* icon,
                                const QString& tip) {
  auto* made = new QToolButton;
  made->setObjectName(QLatin1String(name));
  made->setText(text);
  made->setIcon(lineIcon(QLatin1String(icon)));
  made->setToolTip(tip);
  return made;
}

void ViewsPanel::addButtons(QAction& add, QAction& present) {
  auto* addButton = new QToolButton;
  addButton->setObjectName(QStringLiteral("viewAdd"));
  addButton->setDefaultAction(&add);
  m_update = button(tr("Update View"), "viewUpdate", "view_update",
                    tr("The chosen view shows from now on what is seen now"));
  m_remove = button(tr("Delete"), "viewDelete", "remove", tr("Take the chosen view away"));
  m_wordsButton = button(tr("Text, Notes"), "viewWords", "callout",
                         tr("Show what the chosen view says, to be typed below"));
  m_wordsButton->setCheckable(true);
  auto* presentButton = new QToolButton;
  presentButton->setObjectName(QStringLiteral("viewPresent"));
  presentButton->setDefaultAction(&present);
  connect(m_update, &QToolButton::clicked, this, [this] { m_tour.update(current()); });
  connect(m_remove, &QToolButton::clicked, this, [this] { m_tour.remove(current()); });
  connect(m_wordsButton, &QToolButton::toggled, this, &ViewsPanel::showWords);
  auto* column = new QVBoxLayout;
  column->setSpacing(0);
  for (QToolButton* each : {addButton, m_update, m_remove, m_wordsButton, presentButton}) {
    each->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    each->setIconSize({16, 16});
    each->setAutoRaise(true);
    each->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    column->addWidget(each);
  }
  column->addStretch(1);
  m_cards->addLayout(column);
  showState();
}

int ViewsPanel::current() const {
  return m_row->currentIndex().row();
}

void ViewsPanel::choose(int index) {
  m_row->setCurrentIndex(m_list->index(index));
}

void ViewsPanel::showWords(bool shown) {
  if (shown == !m_words->isHidden())
    return;
  m_words->setVisible(shown);
  if (m_wordsButton)
    m_wordsButton->setChecked(shown);
  emit wordsShown(shown);
}

void ViewsPanel::wantPictures() {
  const double ratio = devicePixelRatioF();
  m_pictures->want(m_row->visibleRows(), ViewCard::pictureSize() * ratio, ratio);
}

void ViewsPanel::showState() {
  if (!m_update)
    return;
  m_words->setView(current());
  m_update->setEnabled(current() >= 0);
  m_remove->setEnabled(current() >= 0);
}

}  // namespace sline::widgets

#include "moc_views_panel.cpp"
