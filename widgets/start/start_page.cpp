// SPDX-License-Identifier: Apache-2.0
#include "widgets/start/start_page.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollArea>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/session/recent_files.h"
#include "widgets/start/card_grid.h"
#include "widgets/start/recovery_list.h"
#include "widgets/start/thumbnail_card.h"
#include "widgets/theme/icons.h"

namespace sline::widgets {

namespace {

constexpr int margin = 32;
constexpr int largestPageWidth = 1240;

QLabel* text(const QString& words, double size, QFont::Weight weight) {
  auto* label = new QLabel(words);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * size);
  font.setWeight(weight);
  label->setFont(font);
  return label;
}

QLabel* section(const QString& words) {
  return text(words, 1.15, QFont::DemiBold);
}

QPushButton* button(const QString& words, const char* name, const QString& icon) {
  auto* made = new QPushButton(lineIcon(icon), words);
  made->setObjectName(QLatin1String(name));
  made->setIconSize({20, 20});
  made->setMinimumHeight(36);
  return made;
}

}  // namespace

StartPage::StartPage(QMainWindow& window, RecentFiles& recent, const PictureFolders& folders)
    : QWidget(&window),
      m_window(window),
      m_recent(recent),
      m_thumbnails(PictureCache(folders.cache)),
      m_demoPictures(PictureCache(folders.built), PictureCache(folders.cache)),
      m_messagePlace(new QVBoxLayout),
      m_recentTitle(section(tr("Opened Last"))),
      m_recentCards(new CardGrid),
      m_demoCards(new CardGrid),
      m_drawings(new DrawingChoice(PictureCache(folders.built))) {
  setObjectName(QStringLiteral("startPage"));
  setAccessibleName(tr("Start"));
  setAutoFillBackground(true);
  auto* content = new QWidget;
  content->setMaximumWidth(largestPageWidth);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(margin, 24, margin, 24);
  column->setSpacing(10);
  column->addWidget(makeHead());
  column->addSpacing(12);
  column->addWidget(m_recovery = makeRecovery());
  m_recentCards->setObjectName(QStringLiteral("recentCards"));
  m_recentCards->setMostRows(1);
  column->addWidget(m_recentTitle);
  column->addWidget(m_recentCards);
  column->addSpacing(12);
  column->addWidget(section(tr("Demos, Modelled by the Program")));
  column->addWidget(m_demoCards);
  column->addSpacing(12);
  column->addWidget(makeDrawings());
  column->addStretch(1);
  auto* centred = new QWidget;
  auto* row = new QHBoxLayout(centred);
  row->setContentsMargins(0, 0, 0, 0);
  row->addStretch(1);
  row->addWidget(content, 1000);
  row->addStretch(1);
  auto* scroll = new QScrollArea;
  scroll->setObjectName(QStringLiteral("startScroll"));
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidgetResizable(true);
  scroll->setWidget(centred);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(m_messagePlace);
  layout->addWidget(scroll, 1);
  makeDemos();
  setRecoverable({});
  listRecent();
  connect(&m_recent, &RecentFiles::changed, this, &StartPage::listRecent);
  window.installEventFilter(this);
  hide();
}

QWidget* StartPage::makeHead() {
  auto* head = new QWidget;
  auto* layout = new QGridLayout(head);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(12);
  layout->setVerticalSpacing(4);
  layout->addWidget(text(tr("Sline"), 2.2, QFont::DemiBold), 0, 0);
  layout->addWidget(text(tr("Focus-and-context line drawings of anatomy"), 1.0, QFont::Normal), 1,
                    0);
  layout->setColumnStretch(0, 1);
  QPushButton* files = button(tr("Open Files…"), "startFiles", QStringLiteral("open_files"));
  QPushButton* folder = button(tr("Open Folder…"), "startFolder", QStringLiteral("open_folder"));
  layout->addWidget(files, 0, 1, Qt::AlignBottom);
  layout->addWidget(folder, 0, 2, Qt::AlignBottom);
  QLabel* hint = text(tr("or drop files and folders into this window"), 1.0, QFont::Normal);
  hint->setForegroundRole(QPalette::PlaceholderText);
  layout->addWidget(hint, 1, 1, 1, 2, Qt::AlignRight);
  setFocusProxy(files);
  connect(files, &QPushButton::clicked, this, &StartPage::filesWanted);
  connect(folder, &QPushButton::clicked, this, &StartPage::folderWanted);
  return head;
}

QWidget* StartPage::makeDrawings() {
  auto* part = new QWidget;
  auto* layout = new QVBoxLayout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(10);
  auto* head = new QHBoxLayout;
  head->setSpacing(12);
  QLabel* title = section(tr("Drawing Style for What Is Opened Next"));
  QLabel* hint = text(tr("Demos and scene files keep their own"), 1.0, QFont::Normal);
  hint->setForegroundRole(QPalette::PlaceholderText);
  m_drawings->setAccessibleName(title->text());
  m_drawings->setAccessibleDescription(hint->text());
  head->addWidget(title);
  head->addWidget(hint, 1, Qt::AlignBottom);
  layout->addLayout(head);
  layout->addWidget(m_drawings);
  return part;
}

QWidget* StartPage::makeRecovery() {
  auto* panel = new QWidget;
  auto* below = new QVBoxLayout(panel);
  below->setContentsMargins(0, 0, 0, 14);
  auto* frame = new QFrame;
  below->addWidget(frame);
  panel->setObjectName(QStringLiteral("recoveryPanel"));
  frame->setFrameShape(QFrame::StyledPanel);
  auto* layout = new QVBoxLayout(frame);
  layout->setContentsMargins(16, 12, 16, 12);
  layout->setSpacing(10);
  layout->addWidget(section(tr("The program did not end as it should. It had kept:")));
  m_recoveryList = new RecoveryList;
  layout->addWidget(m_recoveryList);
  connect(m_recoveryList, &RecoveryList::recoverWanted, this, &StartPage::recoverWanted);
  connect(m_recoveryList, &RecoveryList::forgetWanted, this, &StartPage::forgetWanted);
  return panel;
}

void StartPage::setRecoverable(const std::vector<model::Recoverable>& found) {
  m_recoveryList->setFound(found);
  m_recovery->setVisible(!found.empty());
  const QWidget* focus = m_window.focusWidget();
  const bool untouched = !focus || !isAncestorOf(focus) || focus == focusProxy();
  if (!found.empty() && isVisible() && untouched)
    m_recoveryList->setFocus();
}

void StartPage::makeDemos() {
  std::vector<ThumbnailCard*> cards;
  for (const DemoScene& demo : m_demos) {
    auto* card = new ThumbnailCard(demo.title);
    card->setObjectName(QStringLiteral("startDemo-") + demo.id);
    card->setStandIn(QStringLiteral("focus"));
    connect(card, &ThumbnailCard::clicked, this, [this, demo] { emit demoChosen(demo); });
    connect(&m_demoPictures, &DemoPictures::drawn, card,
            [card, id = demo.id](const QString& drawn, const QImage& picture) {
              if (drawn == id)
                card->setPicture(picture);
            });
    cards.push_back(card);
  }
  m_demoCards->setCards(std::move(cards));
}

void StartPage::listRecent() {
  std::vector<ThumbnailCard*> cards;
  m_thumbnails.drop();
  const QStringList paths = m_recent.paths();
  for (qsizetype i = 0; i < paths.size(); ++i) {
    const QFileInfo file(paths[i]);
    auto* card = new ThumbnailCard(file.fileName());
    card->setObjectName(QStringLiteral("startRecent-%1").arg(i));
    card->setToolTip(QDir::toNativeSeparators(paths[i]));
    card->setLine(QDir::toNativeSeparators(file.path()));
    card->setStandIn(file.suffix().isEmpty() ? QStringLiteral("open_folder")
                                             : QStringLiteral("open_files"));
    connect(card, &ThumbnailCard::clicked, this,
            [this, path = paths[i]] { emit recentChosen(path); });
    connect(&m_thumbnails, &SceneThumbnails::found, card,
            [card, path = paths[i]](const QString& found, const QImage& picture) {
              if (found == path)
                card->setPicture(picture);
            });
    connect(&m_thumbnails, &SceneThumbnails::missing, card,
            [card, path = paths[i]](const QString& missing) {
              if (missing != path)
                return;
              card->setFaded(true);
              card->setLine(tr("no longer there"));
            });
    cards.push_back(card);
  }
  m_recentTitle->setVisible(!cards.empty());
  m_recentCards->setVisible(!cards.empty());
  m_recentCards->setCards(std::move(cards));
  if (isVisible())
    askForPictures();
}

void StartPage::askForPictures() {
  for (const QString& path : m_recent.paths())
    m_thumbnails.ask(path);
}

void StartPage::cover() {
  int top = m_window.menuBar()->geometry().bottom() + 1;
  for (const QToolBar* tools :
       m_window.findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly))
    if (tools->isVisible() && m_window.toolBarArea(tools) == Qt::TopToolBarArea)
      top = std::max(top, tools->geometry().bottom() + 1);
  const QStatusBar* status = m_window.statusBar();
  const int bottom = status->isVisible() ? status->geometry().top() : m_window.height();
  setGeometry(0, top, m_window.width(), bottom - top);
  raise();
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
  const bool moved = event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest ||
                     event->type() == QEvent::Show;
  if (watched == &m_window && moved && isVisibleTo(&m_window))
    QMetaObject::invokeMethod(this, &StartPage::cover, Qt::QueuedConnection);
  return QWidget::eventFilter(watched, event);
}

void StartPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  cover();
  askForPictures();
  std::vector<DemoScene> unseen;
  for (std::size_t i = 0; i < m_demos.size(); ++i)
    if (!m_demoCards->cards()[i]->hasPicture())
      unseen.push_back(m_demos[i]);
  m_demoPictures.ask(unseen,
                     m_drawing ? DemoPictures::Missing::draw : DemoPictures::Missing::leave);
}

void StartPage::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  m_thumbnails.drop();
  m_demoPictures.stop();
}

/// Skips what lies beneath, which cannot be seen; the order is that of reading.
bool StartPage::focusNextPrevChild(bool next) {
  std::vector<QWidget*> stops;
  for (QWidget* child : findChildren<QWidget*>())
    if (child->isVisible() && child->isEnabled() && (child->focusPolicy() & Qt::TabFocus) != 0)
      stops.push_back(child);
  if (stops.empty())
    return false;
  const auto place = [this](const QWidget* widget) {
    const QPoint at = widget->mapTo(this, QPoint());
    return std::pair(at.y(), at.x());
  };
  std::sort(stops.begin(), stops.end(),
            [&](const QWidget* a, const QWidget* b) { return place(a) < place(b); });
  const auto now = std::find(stops.begin(), stops.end(), m_window.focusWidget());
  const std::size_t count = stops.size();
  const std::size_t at =
      now == stops.end() ? (next ? count - 1 : 0) : std::size_t(now - stops.begin());
  QWidget* stop = stops[(at + (next ? 1 : count - 1)) % count];
  stop->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
  findChild<QScrollArea*>(QStringLiteral("startScroll"))->ensureWidgetVisible(stop);
  return true;
}

}  // namespace sline::widgets

#include "moc_start_page.cpp"
