// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>

class QFocusFrame;
class QWidget;

namespace sline::widgets {

/// Draws a ring around the list or tree that has the keyboard; Fusion shows it for no list, and of
/// an empty one nothing else tells. Other controls show it themselves.
class FocusRing : public QObject {
  Q_OBJECT
 public:
  explicit FocusRing(QObject* parent);

 private:
  void follow(QWidget* focus);

  QPointer<QFocusFrame> m_ring;  ///< goes with the panel in which it is
};

}  // namespace sline::widgets
