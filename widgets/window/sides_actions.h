// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <QObject>
#include <QPointer>
#include <array>

#include "model/edit/sides.h"
#include "widgets/session/session.h"
#include "widgets/shell/window_actions.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace sline::widgets {

/// Asks, in a bar under the picture, which side is which where import could only assume it, and
/// settles it: each answer is an undo step. It also says where structures lie on the other side
/// than their names say. The bar goes with the doubt; closed by hand, it comes back with the next
/// scene.
class SidesActions : public QObject {
  Q_OBJECT
 public:
  /// The bar takes a row of its own at the end of the layout.
  SidesActions(Session& session, const WindowActions& actions, QGridLayout& centre,
               QObject* parent);
  ~SidesActions() override;

 private:
  void makeBar(QGridLayout& centre);
  void settle(model::SideAnswer answer);
  void showState();
  QString question() const;

  Session& m_session;
  const WindowActions& m_actions;
  QPointer<QFrame> m_bar;  ///< the central widget may go first
  QLabel* m_question = nullptr;
  std::array<QPushButton*, 3> m_answers{};  ///< by SideAnswer
  int m_closedFor = 0;                      ///< the opening whose bar was closed by hand
};

}  // namespace sline::widgets
