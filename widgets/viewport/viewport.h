// SPDX-License-Identifier: Apache-2.0
// Shows the document as a picture. It shows the newest picture that the render thread has finished
// and never waits for one; while the camera or a section moves pictures may be coarser.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "model/camera/camera_flight.h"
#include "model/edit/blend.h"
#include "render/picture/motion_quality.h"
#include "widgets/annotations/in_picture/picture_labels.h"
#include "widgets/session/session.h"
#include "widgets/viewport/picture_marks.h"
#include "widgets/viewport/picture_outlines.h"
#include "widgets/viewport/picture_screen.h"
#include "widgets/viewport/render_thread.h"
#include "widgets/viewport/tools/box_tool.h"
#include "widgets/viewport/tools/picker.h"

class QNativeGestureEvent;

namespace sline::widgets {

class Viewport : public QWidget, public ViewControl {
  Q_OBJECT
 public:
  explicit Viewport(Session& session, QWidget* parent = nullptr);
  ~Viewport() override;

  /// Sets what draws; for tests, before the window is shown.
  void setPainter(PainterFactory factory) { m_factory = std::move(factory); }

  /// Adds a tool that gets mouse events from now on, after the tools added before and before labels
  /// and the camera.
  void addTool(std::unique_ptr<Tool> tool);

  const model::Camera& camera() const override { return m_camera; }
  /// Returns the point that the camera turns around.
  glm::vec3 pivot() const override { return m_pivot; }
  model::ZoomEnds zoomEnds() const override;
  void setPivot(const glm::vec3& pivot);
  /// Sets the camera at once.
  void setCamera(const model::Camera& camera);
  /// Moves the camera in a short flight if flights are wanted; any move by the user takes over.
  void flyTo(const model::Camera& camera);
  void setFlights(bool wanted) { m_flights = wanted; }
  /// Moves the camera in a longer flight together with the looks, from those of one scene to those
  /// of the scene that is shown or about to be; a move by the user ends it there.
  void travelTo(const model::Camera& camera, const model::Scene& from, const model::Scene& to);
  /// Shows this scene in place of the document's, which stays unchanged; nothing can be selected in
  /// it. With none, the document's is shown again.
  void showInstead(std::optional<model::Scene> scene);
  /// Returns the scene of the picture when no flight is under way.
  const model::Scene& shownScene() const;
  void showFrom(model::AnatomicalView view);
  /// Turns around the pivot until that side of the orientation cube faces the eye.
  void viewFrom(const CubeDirection& from);
  /// Fits all that is visible without turning the camera, and makes its middle the pivot.
  void fitAll();
  /// Does the same as `fitAll`, but for what is visible at or below the nodes.
  void fitTo(const NodeIds& ids);
  /// Returns how much of each side a camera of that direction leaves to labels when it is fitted.
  model::FreeSides freeSides(const model::Scene& scene, const model::Camera& camera) const;

  render::Background background() const { return m_background; }
  /// Returns what surrounds the anatomy in this picture.
  render::Environment environment() const {
    return {.background = m_background, .light = {}, .keyLight = keyLight()};
  }
  void setBackground(render::Background background);
  /// Tells whether shaded surfaces have the key light besides the headlight: as the scene says,
  /// else as it was set here.
  bool keyLight() const;
  void setKeyLight(bool on);
  MousePreset mousePreset() const { return m_cameraTool.preset(); }
  void setMousePreset(MousePreset preset) { m_cameraTool.setPreset(preset); }
  const MarkChoice& marks() const { return m_marks->choice(); }
  void chooseMarks(const MarkChoice& choice);
  /// Makes labels and letters grow with the picture's height, to be read from afar. `covered`:
  /// pixels that something else takes; labels keep clear of them.
  void setPresented(bool presented, const QRect& covered = {});
  void setNamesWanted(bool wanted);
  PictureLabels& labels() { return *m_labels; }
  /// Asks what is seen at that pixel of the picture; the answer comes later.
  void askAt(const QPointF& at, Picker::Answer answer);
  /// Makes the next drag of the left button select by a box.
  void drawBox();
  /// Draws a strong line around the structure until told otherwise, for a menu that tells of it.
  void light(std::optional<model::NodeId> id);

  /// Returns true where the picture on screen is of the document and the camera as they are, in
  /// full size.
  bool upToDate() const;
  /// Returns OpenGL's own name for itself; empty until the window was first shown.
  QString driver() const { return m_screen->driver(); }
  bool isBlank() const { return m_marksAwait != 0; }  ///< no picture of the document is there yet
  /// Returns the newest picture, without what lies over it, in its own pixels.
  QImage picture() const { return m_screen->picture(); }
  /// Returns the time that the last picture took to draw, and how fine it was.
  double lastMilliseconds() const { return m_last.milliseconds; }
  const render::Fineness& lastFineness() const { return m_last.fineness; }
  /// Returns how many of its layers had to be drawn; the others were kept.
  int lastLayersDrawn() const { return m_last.layersDrawn; }
  /// Asks for small pictures by the same renderer, whenever the picture itself is done; `previewed`
  /// follows for each. They replace those asked for before.
  void askPreviews(PreviewRequest request);

 signals:
  void cameraChanged();
  void backgroundChanged();
  void pictureShown();  ///< another one is on screen
  /// Tells that the camera turns around this point of a structure from now on.
  void pivotChosen(const QString& structure);
  /// Asks for a menu of what can be done with the structure that is seen there, or with the picture
  /// where there is none.
  void menuWanted(const QPoint& onScreen, const sline::render::Picks& picks);
  void previewed(sline::widgets::PreviewsOf asker, int id, const QImage& image);
  void failed(const sline::Error& error);
  void mended(const sline::Error& error);  ///< pictures are drawn again, after that failure

 protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  enum class ClickFor { selection, addition, deeper, nearer, pivot, menu };
  void openGraphics();
  void closeGraphics();
  /// Rebuilds them once the events under way are done, however often it is asked for until then.
  void rebuildSoon();
  void rebuildGraphics();
  void refresh();
  void refresh(model::Scene scene);
  void move(const model::Camera& camera) override;
  void keepMoving();
  void rest();
  void flyOn();
  void stopFlight();
  double flownPart() const;
  void startFlight(const model::Camera& camera, int milliseconds);
  void took(const PictureReport& report);
  void failure(const Error& error);
  void documentChange(const Document& before, const Document& now);
  Pointer pointer(const QPointF& at, Qt::MouseButton button, Qt::KeyboardModifiers keys) const;
  void click(const QPointF& at, ClickFor purpose);
  void clicked(const render::Picks& picks, const QPoint& at, ClickFor purpose);
  Picker::Question question(const QPointF& at) const;
  void select(const BoxTool::Box& box);
  void point(std::optional<model::NodeId> id);
  std::vector<render::Outline> outlines() const;
  void zoomAt(const QPointF& at, float factor);
  bool nativeGesture(const QNativeGestureEvent& event);
  void cancelDrag();
  void dragOn();
  void showCursor();
  void wantName();
  void forgetName();
  void hideName();
  void turnByCube(const glm::vec2& way);
  void placeMarks();
  /// Returns the tools that get mouse events, in this order.
  std::vector<Tool*> tools();
  void showTools();
  /// Makes the middle of what is shown the point that the camera turns around.
  void pivotToMiddle();
  void shown(std::uint64_t number);
  QColor paper() const;
  glm::vec2 size2() const { return {float(width()), float(height())}; }
  float aspect() const { return size2().x / size2().y; }
  /// Returns the camera that shows all that is visible of the scene from that side.
  model::Camera fittedFrom(const model::Scene& scene, model::AnatomicalView view) const;
  /// Returns the camera from which the scene is first seen: its view "Overview", else the body from
  /// the front.
  model::Camera firstCamera(const model::Scene& scene) const;
  /// Redraws the labels, which give way to marks that have moved.
  void labelsGiveWay();

  Session& m_session;
  PainterFactory m_factory = makePicturePainter;
  std::unique_ptr<PictureScreen> m_screen;
  std::unique_ptr<RenderThread> m_thread;
  bool m_toRebuild = false;            ///< was asked for and is about to happen
  std::uint64_t m_askedAtOpening = 0;  ///< the first picture of the thread that draws
  bool m_rebuilt = false;              ///< since the last picture that was drawn
  std::optional<Error> m_failure;      ///< why the last one was not, as it was told
  model::Camera m_camera;
  glm::vec3 m_pivot{0.0f};
  render::Background m_background = render::Background::paper;
  bool m_keyLight = false;

  std::vector<std::unique_ptr<Tool>> m_added;
  CameraTool m_cameraTool;
  BoxTool m_boxTool;
  PictureOutlines m_outlines;
  Tool* m_held = nullptr;             ///< has the mouse
  std::optional<Pointer> m_heldBack;  ///< the newest move that it has not been told of
  QElapsedTimer m_lastHeard;
  Qt::MouseButton m_button = Qt::NoButton;
  QPointF m_pressed;
  bool m_dragged = false;  ///< the mouse went far enough that the release is no click
  model::Camera m_beforeTurn;
  std::optional<model::CameraFlight> m_flight;
  std::optional<model::SceneBlend> m_blend;  ///< the change of looks in the flight, if any
  std::optional<model::Scene> m_instead;
  QElapsedTimer m_flown;
  int m_flightTime = 0;  ///< milliseconds
  QTimer m_flightTick;
  bool m_flights = false;

  render::MotionQuality m_quality;
  bool m_cutting = false;  ///< a section is what moves
  QTimer m_rest;
  bool m_moving = false;
  bool m_arrived = false;     ///< at the end of a flight, before its last picture has come
  std::uint64_t m_asked = 0;  ///< the newest request
  render::Fineness m_askedFineness;
  std::uint64_t m_took = 0;   ///< the newest that was drawn
  std::uint64_t m_shown = 0;  ///< on screen
  PictureReport m_last;
  std::optional<model::Camera> m_drawnCamera;  ///< of the newest picture
  /// Holds what the marks show.
  struct Marked {
    model::Camera camera;
    MarkedScene scene;
  };
  Marked m_marked;
  std::uint64_t m_marksAwait = 1;  ///< picture before which nothing is on screen; 0: it is there

  Picker m_picker;
  QTimer m_nameRest;
  bool m_namesWanted = true;
  QPointF m_mouse;
  PictureLabels* m_labels;
  PictureMarks* m_marks;
};

}  // namespace sline::widgets
