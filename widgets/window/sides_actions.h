// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <QObject>
#include <QPointer>
#include <array>
#include <string>
#include <utility>
#include <vector>

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
  /// Returns what contradicts names of sides, empty where nothing does.
  const std::string& otherSides();

  Session& m_session;
  const WindowActions& m_actions;
  QPointer<QFrame> m_bar;  ///< the central widget may go first
  QLabel* m_question = nullptr;
  std::array<QPushButton*, 3> m_answers{};  ///< by SideAnswer
  /// Names and surfaces for which `m_otherSides` holds.
  std::vector<std::pair<std::string, model::MeshPtr>> m_comparedOf;
  std::string m_otherSides;
  int m_closedFor = 0;  ///< the opening whose bar was closed by hand
};

}  // namespace sline::widgets
