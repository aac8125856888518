// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <vector>

#include "widgets/preferences/preferences.h"
#include "widgets/session/session.h"

namespace sline::widgets {

/// Sets the background that a drawing style goes with, and brings the one before back where the
/// style is undone: the background is a preference, but chalk on white would be no step back.
class DrawingGrounds : public QObject {
  Q_OBJECT
 public:
  DrawingGrounds(Session& session, Preferences& preferences, QObject* parent);

  /// Takes the background of the drawing style that the last change of the document has brought.
  void take(const QString& background);

 private:
  struct Step {
    model::Scene before, after;
    QString from, to;
  };
  void follow(const Document& before, const Document& now);

  Preferences& m_preferences;
  Step m_last;  ///< the last change of the document, without backgrounds
  std::vector<Step> m_steps;
};

}  // namespace sline::widgets
