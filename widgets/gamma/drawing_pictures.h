// SPDX-License-Identifier: Apache-2.0
// Works out what the scene looks like in each drawing style, in the background, and has small
// pictures of it drawn by the picture's renderer when that has nothing else to do.
#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <QThreadPool>
#include <QTimer>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "model/look/drawing_styles.h"
#include "widgets/session/session.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

class DrawingPictures : public QObject {
  Q_OBJECT
 public:
  DrawingPictures(Session& session, Viewport& viewport, QObject* parent = nullptr);
  ~DrawingPictures() override;

  /// Asks for pictures from now on, of the viewport's shape, or for none.
  void want(bool wanted);
  /// Gives the scene that style, as one undo step, once it is worked out; a later choice, or any
  /// other edit until then, counts more. A style replaces the one chosen just before.
  void choose(const model::DrawingStyle& style, const QString& step);

 signals:
  void made(int style, const QImage& image);
  /// Tells that the style was given to the scene, or that the scene had it.
  void drawn(const sline::model::DrawingStyle& style);

 private:
  /// Holds everything that the pictures depend on.
  struct Key {
    model::Scene base;
    model::Camera camera;
    QSize size;          ///< in screen pixels,
    double ratio = 1.0;  ///< of which so many make one pixel of the window
    bool keyLight = false;
    bool operator==(const Key&) const = default;
  };
  /// Returns the scene that styles are given to: the one before the last choice while that choice
  /// is what the document shows, so that no style builds upon another; else the document's with its
  /// structures' own colours.
  model::Scene base() const;
  Key keyNow() const;
  void restart();
  void ask();
  void workOut();
  void takeScene(int round, int style, const model::Scene& scene);
  void askPictures();
  void took(PreviewsOf asker, int id, const QImage& image);
  struct Choice {
    int number = 0;
    const model::DrawingStyle* style = nullptr;
    QString step;
    model::Scene asked;  ///< the document when it was made
  };
  void takeChoice(const Choice& choice, const model::Scene& scene);

  Session& m_session;
  Viewport& m_viewport;
  bool m_wanted = false;
  QTimer m_rest;
  std::optional<Key> m_asked;
  int m_round = 0;   ///< counts what was asked for: older answers may still be on their way
  int m_choice = 0;  ///< counts choices
  std::optional<model::Scene> m_before;             ///< the scene before the last choice
  model::Scene m_after;                             ///< and after it
  std::vector<PreviewRequest::Preview> m_previews;  ///< of the scene in m_asked, by style
  std::shared_ptr<model::FormIndex> m_forms = std::make_shared<model::FormIndex>();
  std::stop_source m_stop;
  QThreadPool m_pool;
};

}  // namespace sline::widgets
