// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/presenter_window.h"

#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QTextCursor>
#include <QTime>
#include <algorithm>

namespace sline::widgets {

namespace {

constexpr int letterShare = 34;  // heights of letters in the window's height
constexpr int leastLetters = 12;
constexpr QRgb noteLinkInk = 0xff8cc2ff;  // on the window's dark ground

QLabel* plainLabel(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  return label;
}

/// Returns "1:02:03", or "2:03" within the first hour.
QString spanText(qint64 milliseconds) {
  const qint64 seconds = milliseconds / 1000;
  const QString rest = QStringLiteral("%1:%2")
                           .arg(seconds / 60 % 60, seconds >= 3600 ? 2 : 1, 10, QLatin1Char('0'))
                           .arg(seconds % 60, 2, 10, QLatin1Char('0'));
  return seconds >= 3600 ? QStringLiteral("%1:%2").arg(seconds / 3600).arg(rest) : rest;
}

}  // namespace

PresenterWindow::PresenterWindow(QWidget* parent)
    : QWidget(parent, Qt::Window | Qt::WindowDoesNotAcceptFocus),
      m_place(plainLabel("presenterPlace")),
      m_title(plainLabel("presenterTitle")),
      m_notes(new QPlainTextEdit),
      m_nextTitle(plainLabel("presenterNext")),
      m_nextPicture(plainLabel("presenterPicture")),
      m_clock(plainLabel("presenterClock")) {
  setObjectName(QStringLiteral("presenterWindow"));
  setWindowTitle(tr("Notes"));
  setAttribute(Qt::WA_ShowWithoutActivating);
  m_notes->setObjectName(QStringLiteral("presenterNotes"));
  m_notes->setAccessibleName(tr("Notes"));
  m_notes->setReadOnly(true);
  m_notes->setFocusPolicy(Qt::NoFocus);
  m_notes->setFrameShape(QFrame::NoFrame);
  m_notes->viewport()->setMouseTracking(true);
  m_notes->viewport()->installEventFilter(this);
  m_nextPicture->setAlignment(Qt::AlignCenter);
  m_nextPicture->setAccessibleName(tr("The next view"));
  m_clock->setAlignment(Qt::AlignRight | Qt::AlignBottom);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(20, 16, 20, 16);
  grid->setSpacing(12);
  grid->addWidget(m_title, 0, 0);
  grid->addWidget(m_notes, 1, 0, 2, 1);
  grid->addWidget(m_place, 3, 0);
  grid->addWidget(m_nextTitle, 0, 1);
  grid->addWidget(m_nextPicture, 1, 1);
  grid->addWidget(m_clock, 3, 1);
  grid->setColumnStretch(0, 3);
  grid->setColumnStretch(1, 2);
  grid->setRowStretch(2, 1);
  setStyleSheet(QStringLiteral("QWidget { background: #1c1e22; color: #f4f4f2; }"));
  m_tick.setInterval(500);
  connect(&m_tick, &QTimer::timeout, this, &PresenterWindow::showTime);
}

void PresenterWindow::tell(const Told& told) {
  m_place->setText(told.place);
  m_title->setText(told.title);
  showNotes(told.notes);
  m_nextTitle->setText(told.next.isEmpty() ? tr("This is the last view")
                                           : tr("Next: %1").arg(told.next));
  m_nextPicture->clear();
}

void PresenterWindow::showNotes(const std::vector<Note>& notes) {
  if (m_told == notes)
    return;
  m_told = notes;
  m_notes->clear();
  QTextCursor cursor(m_notes->document());
  for (std::size_t i = 0; i < notes.size(); ++i) {
    QTextCharFormat format;
    if (notes[i].target) {
      format.setAnchor(true);
      format.setAnchorHref(QString::number(i));
      format.setFontUnderline(true);
      format.setForeground(QColor(noteLinkInk));
    }
    cursor.insertText(notes[i].text, format);
  }
  m_notes->moveCursor(QTextCursor::Start);
}

bool PresenterWindow::eventFilter(QObject*, QEvent* event) {
  const bool moves = event->type() == QEvent::MouseMove;
  if (!moves && event->type() != QEvent::MouseButtonRelease)
    return false;
  const auto& mouse = static_cast<const QMouseEvent&>(*event);
  bool isLink = false;
  const std::size_t link = m_notes->anchorAt(mouse.position().toPoint()).toULongLong(&isLink);
  const bool leads = isLink && link < m_told.size() && m_told[link].target;
  if (moves)
    m_notes->viewport()->setCursor(leads ? Qt::PointingHandCursor : Qt::IBeamCursor);
  else if (leads && mouse.button() == Qt::LeftButton && !m_notes->textCursor().hasSelection())
    emit followed(model::LinkTarget(*m_told[link].target));
  return false;
}

void PresenterWindow::setNextPicture(const QImage& picture) {
  QPixmap pixmap = QPixmap::fromImage(picture);
  pixmap.setDevicePixelRatio(devicePixelRatioF());
  m_nextPicture->setPixmap(pixmap);
}

QSize PresenterWindow::pictureSize() const {
  const int wide = std::max(120, width() * 2 / 5 - 40);
  return QSizeF(wide, 0.62 * wide).toSize() * devicePixelRatioF();
}

void PresenterWindow::startClock() {
  m_elapsed.start();
  m_tick.start();
  showTime();
}

void PresenterWindow::showTime() {
  m_clock->setText(tr("%1   %2", "the time of day, how long the presentation has taken")
                       .arg(QLocale().toString(QTime::currentTime(), QLocale::ShortFormat),
                            spanText(m_elapsed.isValid() ? m_elapsed.elapsed() : 0)));
}

void PresenterWindow::open(const QRect& place, bool ownScreen) {
  setWindowFlag(Qt::FramelessWindowHint, ownScreen);
  setWindowFlag(Qt::WindowStaysOnTopHint, !ownScreen);
  setGeometry(place);
  if (ownScreen)
    showFullScreen();
  else
    show();
  setLetters();
}

void PresenterWindow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  setLetters();
}

void PresenterWindow::setLetters() {
  const int letters = std::max(leastLetters, height() / letterShare);
  const auto size = [letters](QWidget& widget, double times, bool bold) {
    QFont font = widget.font();
    font.setPixelSize(int(letters * times));
    font.setBold(bold);
    widget.setFont(font);
  };
  size(*m_title, 1.2, true);
  size(*m_notes, 1.2, false);
  size(*m_place, 1.0, false);
  size(*m_nextTitle, 1.0, false);
  size(*m_clock, 1.6, true);
}

PresentationPlaces presentationPlaces(const QList<QRect>& screens, const QPoint& window) {
  PresentationPlaces places;
  for (int i = 0; i < int(screens.size()); ++i)
    if (screens[i].contains(window)) {
      places.picture = i;
      break;
    }
  for (int i = 0; i < int(screens.size()); ++i)
    // A screen that shows the same as the window's is a copy of it.
    if (i != places.picture && !screens[i].intersects(screens[places.picture])) {
      places.presenter = places.picture;
      places.picture = i;
      break;
    }
  return places;
}

}  // namespace sline::widgets

#include "moc_presenter_window.cpp"
