// SPDX-License-Identifier: Apache-2.0
// Small pictures of what is selected, one for each of some values of Γ: seen as the camera sees
// it, in its own look, drawn when nothing else is to be drawn.
#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <QTimer>
#include <vector>

#include "widgets/session/session.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

/// What small pictures of some structures show: those at or below the ids, or where these are too
/// many for small pictures the largest of them alone. The structures stand at the top, with what
/// they inherit answered.
model::Scene previewSubject(const model::Scene& scene, const NodeIds& ids);
/// The subject at that Γ, with lines and hatching as coarse as a picture of so many pixels needs.
model::Scene previewScene(const model::Scene& subject, Gamma gamma, int height, double ratio);
/// How much wider lines, and how much fewer strokes of hatching, a small picture of so many pixels
/// needs to be read; `pen` is a line's width in pixels of the window, of which `ratio` of the
/// picture's make one.
struct SmallLines {
  float pen = 1.0f;
  float hatchDensity = 1.0f;
};
SmallLines smallLines(int height, double ratio, double pen);
/// Looks as the other camera does, at the middle of the subject, which fills the picture.
model::Camera previewCamera(const model::Scene& subject, const model::Camera& camera, float aspect);

class StageStrip;

/// The strip's pictures come from the picture's renderer from now on.
void drawStages(Session& session, Viewport& viewport, StageStrip& stages);

class StagePreviews : public QObject {
  Q_OBJECT
 public:
  StagePreviews(Session& session, Viewport& viewport, QObject* parent = nullptr);

  /// What is wanted; `size` in pixels of the screen, of which `ratio` make one of the window's.
  void want(std::vector<Gamma> stages, QSize size, double ratio);

 signals:
  /// Another subject: the pictures so far are of something else.
  void cleared();
  void made(int stage, const QImage& image);

 private:
  /// All that the pictures depend on.
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
  int m_round = 0;  ///< of what was asked for: older pictures may still be on their way
  NodeIds m_ids;    ///< of the last subject
};

}  // namespace sline::widgets
