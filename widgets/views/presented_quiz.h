// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "model/scene/quiz.h"
#include "widgets/session/session.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

/// Asks in a presented picture where structures are: a click answers, and what was asked for is
/// then outlined; the next click, or key, goes on. At the end it tells the score.
class PresentedQuiz : public QObject {
  Q_OBJECT
 public:
  PresentedQuiz(Session& session, Viewport& viewport, QObject* parent);

  /// Begins with what the labels of the scene name, in that language. Without labels it only says
  /// so, and ends with the next key.
  void begin(const model::Scene& scene, const std::string& language);
  void end();
  bool running() const { return m_quiz.has_value(); }
  /// Returns what is to be read now: the question, whether the answer was right, or the score.
  const QString& text() const { return m_text; }
  /// Takes a click there as the answer or, where there is one, goes on.
  void click(const QPointF& at);
  /// Goes on to the next question, after the last to the score, and after that ends.
  void goOn();

 signals:
  /// Tells that another text is to be read, or that the quiz has ended.
  void changed();

 private:
  void ask();
  void answer(std::size_t asked, const render::Picks& picks);
  void say(const QString& text);

  Session& m_session;
  Viewport& m_viewport;
  std::optional<model::Quiz> m_quiz;
  QString m_text;
};

}  // namespace sline::widgets
