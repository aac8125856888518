// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/screen_fit.h"

#include <QApplication>
#include <QDialog>
#include <QEvent>
#include <QMainWindow>
#include <QScreen>
#include <QStyle>
#include <algorithm>

namespace sline::widgets {

namespace {

constexpr double usualLetters = 17.0;  // height of a line, in pixels

void fit(QWidget& window) {
  const QScreen* screen = window.screen();
  if (!screen || (window.windowState() & (Qt::WindowMaximized | Qt::WindowFullScreen)))
    return;
  QSize size = window.size();
  // An explicit size is a wish; layouts know the letters already.
  if (qobject_cast<QDialog*>(&window) && window.testAttribute(Qt::WA_Resized))
    size *= std::max(1.0, double(window.fontMetrics().lineSpacing()) / usualLetters);
  const QSize room = roomOn(*screen);
  size = size.boundedTo(room);
  if (size != window.size())
    window.resize(size);
  if (!window.testAttribute(Qt::WA_Moved))
    return;
  const QRect whole = screen->availableGeometry();
  const QPoint last = whole.bottomRight() - QPoint(size.width(), size.height());
  const QPoint at = window.pos();
  const QPoint in(std::clamp(at.x(), whole.left(), std::max(whole.left(), last.x() + 1)),
                  std::clamp(at.y(), whole.top(), std::max(whole.top(), last.y() + 1)));
  if (in != at)
    window.move(in);
}

}  // namespace

QSize roomOn(const QScreen& screen) {
  // What a frame takes is known only when it is there.
  const int title = QApplication::style()->pixelMetric(QStyle::PM_TitleBarHeight);
  const int edge = QApplication::style()->pixelMetric(QStyle::PM_MdiSubWindowFrameWidth);
  return screen.availableGeometry().size() - QSize(2 * edge, title + edge);
}

ScreenFit::ScreenFit(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

bool ScreenFit::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Show && !event->spontaneous())
    if (auto* widget = qobject_cast<QWidget*>(watched);
        widget && (widget->windowType() == Qt::Window || widget->windowType() == Qt::Dialog))
      fit(*widget);
  return false;
}

}  // namespace sline::widgets

#include "moc_screen_fit.cpp"
