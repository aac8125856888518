// SPDX-License-Identifier: Apache-2.0
// Draws small pictures of the selection, one for each of some values of Γ, as the camera sees it
// and in its own look, when nothing else is to be drawn.
#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <QTimer>
#include <vector>

#include "widgets/session/session.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

/// Returns the scene that small pictures of some structures show: the structures at or below the
/// ids, or only the largest of them where there are too many for small pictures. They stand at the
/// top, with inherited styles resolved.
model::Scene previewSubject(const model::Scene& scene, const NodeIds& ids);
/// Returns the subject at that Γ, with lines and hatching as coarse as a picture of so many pixels
/// needs.
model::Scene previewScene(const model::Scene& subject, Gamma gamma, int height, double ratio);
/// Tells how much wider the lines must be, and how many fewer strokes of hatching there must be,
/// for a small picture of so many pixels to be readable; `pen` is a line's width in pixels of the
/// window, and `ratio` pixels of the picture make one pixel of the window.
struct SmallLines {
  float pen = 1.0f;
  float hatchDensity = 1.0f;
};
SmallLines smallLines(int height, double ratio, double pen);
/// Returns the scene with all its structures' lines and hatching coarser by that.
model::Scene withSmallLines(const model::Scene& scene, const SmallLines& lines);
/// Returns a camera that looks as the other does, at the middle of the subject, which fills the
/// picture.
model::Camera previewCamera(const model::Scene& subject, const model::Camera& camera, float aspect);

class StageStrip;

/// Has the picture's renderer draw the strip's pictures from now on.
void drawStages(Session& session, Viewport& viewport, StageStrip& stages);

class StagePreviews : public QObject {
  Q_OBJECT
 public:
  StagePreviews(Session& session, Viewport& viewport, QObject* parent = nullptr);

  /// Asks for pictures of the stages; `size` is in screen pixels, of which `ratio` make one pixel
  /// of the window.
  void want(std::vector<Gamma> stages, QSize size, double ratio);

 signals:
  /// Tells that there is another subject, so that the pictures so far are out of date.
  void cleared();
  void made(int stage, const QImage& image);

 private:
  /// Holds everything that the pictures depend on.
  struct Key {
    model::Scene subject;
    model::CameraFrame frame{};
    model::Projection projection = model::Projection::perspective;
    render::Environment environment;
    QSize size;
    bool operator==(const Key& other) const;
  };
  Key keyNow() const;
  void restart();
  void ask();
  void took(PreviewsOf asker, int id, const QImage& image);

  Session& m_session;
  Viewport& m_viewport;
  std::vector<Gamma> m_stages;
  QSize m_size;
  double m_ratio = 1.0;
  QTimer m_rest;
  Key m_asked;
  int m_round = 0;  ///< counts the requests: older pictures may still be on their way
  NodeIds m_ids;    ///< of the last subject
};

}  // namespace sline::widgets
