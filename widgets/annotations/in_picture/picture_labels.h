// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>

#include "model/camera/free_sides.h"
#include "widgets/annotations/in_picture/label_editor.h"
#include "widgets/annotations/in_picture/label_tool.h"
#include "widgets/annotations/label_sights.h"
#include "widgets/viewport/tools/picker.h"

class QKeyEvent;

namespace sline::widgets {

/// Manages labels in the picture: shows them, lets the user drag them, makes them from a click on a
/// structure and a few letters, and edits them where they stand.
class PictureLabels : public QObject {
  Q_OBJECT
 public:
  /// Holds the parts of the picture that labels need.
  struct Context {
    QWidget& picture;
    Session& session;
    Picker& picker;
    std::function<Picker::Question(const QPointF&)> question;
    /// Returns the rectangles of other marks, in pixels, where no label may be.
    std::function<std::vector<QRectF>()> marks;
  };
  explicit PictureLabels(Context place);

  LabelTool& tool() { return *m_tool; }
  const LabelLayer& layer() const { return *m_layer; }
  LabelEditor& editor() { return *m_editor; }

  /// Returns how labels look; their ink depends on the picture's background.
  const render::LabelStyle& style() const { return m_style; }
  void setStyle(const render::LabelStyle& style);
  void setGround(render::Background ground);
  /// Makes labels as large as on a page of the picture's height, to be read from afar.
  void setPresented(bool presented) { m_presented = presented; }
  /// Returns the labels wanted for a picture of the widget as it is now; `moving` tells that its
  /// camera is on its way.
  LabelWish wish(bool moving = false) const;
  /// Notes that the camera has gone to another view, where labels stand as if there had been none
  /// before. Returns false where there are no labels.
  bool arrive();
  /// Tells whether the picture has grown or shrunk so much that labels must be laid out anew.
  bool outgrown() const;
  /// Tells whether some labels are left out, or not looked for anew, until the camera rests.
  bool waits() const;
  /// Returns how much a camera of that direction keeps free at the picture's sides when it is
  /// fitted, so that labels have their columns beside the anatomy.
  model::FreeSides sidesBeside(const model::Scene& scene, const model::Camera& camera) const;
  /// Takes over the labels of the picture that is shown from now on; null if they are not known
  /// yet.
  void took(const LabelSheetPtr& sheet, const model::Camera& camera);
  /// Tells whether all of the picture's labels are known.
  bool ready() const { return m_ready; }
  /// Returns which labels the picture lacked when its camera last rested, and why.
  const LabelSightsById& sights() const { return m_sights; }
  /// Prevents any change to labels while something other than the document is shown.
  void setShut(bool shut);

  /// Returns the kind of label that each click makes; empty if clicks make none.
  std::optional<model::AnnotationKind> making() const { return m_making; }
  void make(std::optional<model::AnnotationKind> kind);
  /// Sets the function that returns the current saved view, to which new labels belong, as its
  /// place among the scene's views, if there is one.
  void setCurrentView(std::function<std::optional<std::size_t>()> current);
  std::optional<std::size_t> currentView() const;
  /// Opens the editor for the label's words where the label stands.
  void edit(model::AnnotationId id);
  void remove(model::AnnotationId id);

  /// Tells whether labels take the click.
  bool click(const QPointF& at);
  bool doubleClick(const QPointF& at);
  bool wants(const QKeyEvent& key) const;
  bool press(const QKeyEvent& key);
  /// Notes where the mouse is while no button is held; empty if it is elsewhere.
  void hover(const std::optional<QPointF>& at);
  /// Returns the cursor that labels ask for, if any.
  std::optional<Qt::CursorShape> cursor() const;

 signals:
  /// Tells that the picture's labels must be drawn anew.
  void wishChanged();
  void makingChanged();
  /// Tells that a click found nothing that a label could be on.
  void missed();
  /// Tells that the labels of another picture, or of a changed scene, are known and at rest.
  void sighted();
  /// Tells that the label is in the scene.
  void made(sline::model::AnnotationId id);

 private:
  void clicked(const render::Picks& picks, const QPointF& at);
  void begin(model::Annotation annotation, const QString& offered, const QPointF& at);
  void accept(const QString& text);
  void add(const model::Annotation& annotation);
  void documentChange(const Document& before, const Document& now);
  void showMarks();
  std::optional<glm::vec2> begunAt() const;

  Context m_place;
  render::LabelStyle m_style;
  LabelLayer* m_layer;
  LabelTool* m_tool;
  LabelEditor* m_editor;
  std::function<std::optional<std::size_t>()> m_currentView;
  bool m_shut = false;
  bool m_presented = false;
  bool m_ready = true;
  LabelSightsById m_sights;
  int m_arrivals = 0;
  model::Camera m_camera;  ///< of the picture that is shown
  std::optional<QPointF> m_mouse;
  std::optional<model::AnnotationKind> m_making;
  std::vector<model::Anchor> m_begun;          ///< the places of a distance so far
  std::optional<model::Annotation> m_written;  ///< the label for which words are typed
  bool m_new = false;                          ///< it is not in the scene yet
  QString m_offered;                           ///< the words that were offered for it
};

}  // namespace sline::widgets
