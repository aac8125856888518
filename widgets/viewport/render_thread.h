// SPDX-License-Identifier: Apache-2.0
// Draws pictures on a thread with an OpenGL context of its own. The newest request wins; a request
// that is overtaken before it begins is never drawn.
#pragma once

#include <QImage>
#include <QOffscreenSurface>
#include <QThread>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "model/base/result.h"
#include "render/picture/motion_quality.h"
#include "render/picture/picture.h"
#include "widgets/annotations/in_picture/label_sheet.h"
#include "widgets/viewport/picture_screen.h"

class QOpenGLContext;

namespace sline::widgets {

struct PictureRequest {
  std::uint64_t number = 0;  ///< from 1 upwards
  model::Scene scene;
  model::Camera camera;
  render::PictureSettings settings;
  render::Fineness fineness;  ///< as in the settings; the picture is shown at the window's size
  bool moving = false;   ///< camera or section are moving; else they rest, and their picture is
                         ///< abandoned when they move on
  bool refined = false;  ///< once it is done, as fine as can be, and nothing else asked for a
                         ///< while, it is drawn again with more samples a pixel
  LabelWish labels;
  std::vector<render::Outline> outlines;  ///< over the picture, around what is selected or meant
};

/// The kinds of small pictures by their purpose; the first kind is drawn first.
enum class PreviewsOf { stages, views, exported, subjects, drawings, compared, presented };
inline constexpr std::size_t previewAskers = 7;

/// Asks for small pictures beside the large one; they are drawn only while no other large one has
/// been requested for a while. A newer request replaces those of the same asker that are not drawn
/// yet.
struct PreviewRequest {
  struct Preview {
    int id = 0;  ///< chosen by the asker
    model::Scene scene;
    model::Camera camera;
    render::PictureSettings settings;
    int samples = 1;  ///< per pixel in each direction; the picture is reduced by this factor
  };
  std::vector<Preview> previews;
  PreviewsOf asker = PreviewsOf::stages;
};

/// Draws requests; lives on the render thread with its context, if it has one, current.
class PicturePainter {
 public:
  virtual ~PicturePainter() = default;
  /// Draws the picture; returns false where it was abandoned because it is no longer wanted.
  virtual Result<bool> paint(const PictureRequest& request,
                             const render::Picture::TargetJob& job) = 0;
  /// Draws a small picture; returns none where it was abandoned. A painter need not support
  /// previews.
  virtual Result<std::optional<render::Image>> preview(const PreviewRequest::Preview&,
                                                       const std::atomic<bool>& /*unwanted*/) {
    return std::optional<render::Image>();
  }
  /// Draws the picture again with more samples for each pixel; returns false where it was
  /// abandoned. A painter need not.
  virtual Result<bool> refine(const PictureRequest&, const render::Picture::TargetJob&) {
    return false;
  }
  /// Makes ready what a moving camera's pictures need beside this one, which is done; stops early
  /// where `unwanted` is set.
  virtual void makeReady(const PictureRequest&, const std::atomic<bool>& /*unwanted*/) {}
  /// Returns the number of layers that the last picture drew, where it is known.
  virtual int layersDrawn() const { return 0; }
  /// Tells whether the last picture lacks something, as it was drawn in a hurry.
  virtual bool makeshift() const { return false; }
};
using PainterFactory = std::function<Result<std::unique_ptr<PicturePainter>>()>;
/// Makes a painter that uses the renderer itself: with the current context, or without OpenGL.
Result<std::unique_ptr<PicturePainter>> makePicturePainter();

/// Describes a picture that is done and waits to be shown.
struct PictureReport {
  std::uint64_t number = 0;
  double milliseconds = 0.0;
  render::Fineness fineness;  ///< as requested
  bool moving = false;        ///< as requested
  model::Camera camera;
  int layersDrawn = 0;     ///< the others were as in the picture before
  bool makeshift = false;  ///< lacks something, as it was drawn in a hurry
  LabelSheetPtr labels;    ///< null: they come later, by `labelled`
};

/// Sets whether pictures are refined, as they are from the beginning; for tests.
void chooseRefinement(bool on);

class RenderThread : public QThread {
  Q_OBJECT
 public:
  /// Starts at once. The screen must be started and outlive the thread. To be called on the GUI's
  /// thread.
  RenderThread(PictureScreen& screen, PainterFactory factory);
  /// Waits until the picture under way is done or abandoned.
  ~RenderThread() override;

  void ask(PictureRequest request);
  void ask(PreviewRequest request);

 signals:
  void drawn(const sline::widgets::PictureReport& report);
  /// Tells the labels of the newest picture, which came without them.
  void labelled(const sline::widgets::LabelSheetPtr& labels);
  /// Tells that the picture of that number, which was drawn before, has come with more samples.
  void refined(std::uint64_t number);
  void previewed(sline::widgets::PreviewsOf asker, int id, const QImage& image);
  /// Tells that a picture could not be drawn, or none can be any more.
  void failed(const sline::Error& error);
  /// Tells that the newest picture has no labels, and why.
  void labelsFailed(const sline::Error& error);

 protected:
  void run() override;

 private:
  /// The next thing to do, for which the thread waits; if it holds nothing, the thread must end.
  struct Work {
    std::optional<PictureRequest> picture;
    std::optional<PreviewRequest::Preview> preview;
    PreviewsOf asker = PreviewsOf::stages;
    bool labels = false;
    bool refinement = false;
  };
  Work next();
  /// Does what is asked for until the thread must end.
  void draw(PicturePainter& painter);
  /// Does one step towards the labels of a picture that lacks them.
  void drawLabels();
  void drawPicture(PicturePainter& painter, const PictureRequest& request);
  void makeReady(PicturePainter& painter, const PictureRequest& request);
  /// Draws the last picture again, finer; if something else is asked for, later.
  void refine(PicturePainter& painter);
  void drawPreview(PicturePainter& painter, const PreviewRequest::Preview& preview,
                   PreviewsOf asker);
  Result<bool> draw(PicturePainter& painter, const PictureRequest& request);

  // These members belong to the thread itself.
  LabelDrawer m_labels;
  LabelSheetPtr m_sheet;                       ///< of the picture that was drawn last
  std::optional<PictureRequest> m_unlabelled;  ///< its request, if it has no labels yet
  std::optional<PictureRequest> m_unrefined;   ///< its request, if it shall be refined

  PictureScreen& m_screen;
  PainterFactory m_factory;
  std::unique_ptr<QOffscreenSurface> m_surface;
  std::unique_ptr<QOpenGLContext> m_context;  ///< null: the screen's pictures are in memory
  std::mutex m_mutex;
  std::condition_variable m_wake;
  std::optional<PictureRequest> m_request;
  /// Holds what an asker still waits for.
  struct Waiting {
    std::vector<PreviewRequest::Preview> previews;  ///< the next one last
    std::uint64_t round = 0;                        ///< counts requests
  };
  bool previewsWait() const;
  std::array<Waiting, previewAskers> m_waiting;  ///< by PreviewsOf
  std::chrono::steady_clock::time_point m_pictureEnd;
  bool m_quit = false;
  std::optional<PreviewsOf> m_previewing;
  bool m_refining = false;
  /// The camera of the picture that is being drawn, if it rests.
  std::optional<model::Camera> m_resting;
  std::atomic<bool> m_unwanted = false;
};

}  // namespace sline::widgets
