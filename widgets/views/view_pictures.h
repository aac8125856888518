// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>
#include <deque>
#include <map>
#include <vector>

#include "widgets/session/session.h"
#include "widgets/viewport/viewport.h"
#include "widgets/views/view_list.h"

namespace sline::widgets {

/// Provides small pictures of the views that are on screen, drawn by the picture's renderer when it
/// has nothing else to do. A picture is kept until what the view shows has changed, so that undo
/// and reordering cost nothing.
class ViewPictures : public QObject {
  Q_OBJECT
 public:
  ViewPictures(Session& session, Viewport& viewport, ViewList& list, QObject* parent = nullptr);

  /// Asks for pictures of the rows that are on screen; `size` is in screen pixels, of which `ratio`
  /// make one pixel of the window.
  void want(std::vector<int> rows, QSize size, double ratio);
  /// Returns how many were drawn so far.
  int drawn() const { return m_drawn; }

 private:
  /// Holds everything that a picture depends on.
  struct Key {
    model::Scene scene;
    model::Camera camera;
    render::Environment environment;
    QSize size;
    bool operator==(const Key&) const = default;
  };
  struct Kept {
    Key key;
    QImage image;
  };
  Key keyOf(int row) const;
  const QImage* kept(const Key& key) const;
  PreviewRequest::Preview previewOf(int id, const Key& key) const;
  void ask();
  void took(PreviewsOf asker, int id, const QImage& image);

  Session& m_session;
  Viewport& m_viewport;
  ViewList& m_list;
  std::vector<int> m_rows;
  QSize m_size;
  double m_ratio = 1.0;
  QTimer m_rest;
  std::map<int, Key> m_asked;  ///< by the preview's id
  int m_lastId = 0;
  std::deque<Kept> m_kept;  ///< the newest last
  int m_drawn = 0;
};

}  // namespace sline::widgets
