// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/focus_ring.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QFocusFrame>
#include <QPainter>

namespace sline::widgets {

namespace {

class Ring : public QFocusFrame {
 public:
  using QFocusFrame::QFocusFrame;

 protected:
  void paintEvent(QPaintEvent*) override {
    constexpr double pen = 2.0;
    QPainter painter(this);
    painter.setPen(QPen(palette().color(QPalette::Highlight), pen));
    painter.drawRect(QRectF(rect()).adjusted(pen, pen, -pen, -pen));
  }
};

}  // namespace

FocusRing::FocusRing(QObject* parent) : QObject(parent) {
  connect(qApp, &QApplication::focusChanged, this,
          [this](QWidget*, QWidget* focus) { follow(focus); });
}

void FocusRing::follow(QWidget* focus) {
  // The list of a box that drops down is a window of its own.
  if (!qobject_cast<QAbstractItemView*>(focus) || focus->window()->windowType() == Qt::Popup) {
    delete m_ring;
    return;
  }
  if (!m_ring)
    m_ring = new Ring(focus->parentWidget());
  m_ring->setWidget(focus);
}

}  // namespace sline::widgets

#include "moc_focus_ring.cpp"
