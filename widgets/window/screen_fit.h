// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QScreen;
class QWidget;

namespace sline::widgets {

/// Sees to it that every window of the program lies on its screen as a whole: one that is shown is
/// made no larger than the screen has room for, and moved in from beyond its edge. Sizes that
/// dialogs wish for are meant for letters of usual height; larger letters make them larger.
class ScreenFit : public QObject {
  Q_OBJECT
 public:
  explicit ScreenFit(QObject* parent);
  bool eventFilter(QObject* watched, QEvent* event) override;
};

/// Returns the size that a window may have inside its frame on that screen.
QSize roomOn(const QScreen& screen);

}  // namespace sline::widgets
