// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

namespace sline::widgets {

/// Says which numbers can be set where a box refuses what is typed or pasted, or enters another
/// number in its place: the box itself does so without a word. Holds for all windows of the
/// program.
class NumberLimits : public QObject {
  Q_OBJECT
 public:
  explicit NumberLimits(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace sline::widgets
