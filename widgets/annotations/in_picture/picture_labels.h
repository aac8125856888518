// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>

#include "widgets/annotations/in_picture/label_editor.h"
#include "widgets/annotations/in_picture/label_tool.h"
#include "widgets/viewport/tools/picker.h"

class QKeyEvent;

namespace sline::widgets {

/// Labels in the picture: shown, taken hold of, made by a click on a structure and a few letters,
/// edited where they stand.
class PictureLabels : public QObject {
  Q_OBJECT
 public:
  /// What it needs of the picture.
  struct Place {
    QWidget& picture;
    Session& session;
    Picker& picker;
    std::function<Picker::Question(const QPointF&)> question;
    /// Where other marks are, pixels: no label is there.
    std::function<std::vector<QRectF>()> marks;
  };
  explicit PictureLabels(Place place);

  LabelTool& tool() { return *m_tool; }
  const LabelLayer& layer() const { return *m_layer; }
  LabelEditor& editor() { return *m_editor; }

  /// How they look; their ink goes by the picture's background.
  const render::LabelStyle& style() const { return m_style; }
  void setStyle(const render::LabelStyle& style);
  void setDark(bool dark);
  /// As large as on a page of the picture's height, to be read from afar.
  void setPresented(bool presented) { m_presented = presented; }
  /// For a picture of the widget as it is now; `moving`: its camera is on its way.
  LabelWish wish(bool moving = false) const;
  /// The camera has gone to another view: labels stand there as if there had been none before.
  /// False where there are none.
  bool arrive();
  /// The picture has become so much larger or smaller that they are to be laid out anew.
  bool outgrown() const;
  /// Some are left out until the camera rests.
  bool waits() const;
  /// What labels beside the anatomy leave of the picture's width, 0 … 1, as that camera looks.
  float shareBeside(const model::Scene& scene, const model::Camera& camera) const;
  /// The labels of the picture that is shown from now on; null: they are not known yet.
  void took(const LabelSheetPtr& sheet, const model::Camera& camera);
  /// All of the picture's labels are known.
  bool ready() const { return m_ready; }
  /// Nothing can be done to them while something else than the document is shown.
  void setShut(bool shut);

  /// Each click makes one of that kind, until there is none.
  std::optional<model::AnnotationKind> making() const { return m_making; }
  void make(std::optional<model::AnnotationKind> kind);
  /// Asked for the saved view that one is in, which labels made now belong to: its place among the
  /// scene's, where there is one.
  void setCurrentView(std::function<std::optional<std::size_t>()> current);
  std::optional<std::size_t> currentView() const;
  /// Words for it are typed where it stands.
  void edit(model::AnnotationId id);
  void remove(model::AnnotationId id);

  /// True where that is for labels.
  bool click(const QPointF& at);
  bool doubleClick(const QPointF& at);
  bool wants(const QKeyEvent& key) const;
  bool press(const QKeyEvent& key);
  /// The mouse is there and nothing is held; nothing: it is elsewhere.
  void hover(const std::optional<QPointF>& at);
  /// Where labels want one.
  std::optional<Qt::CursorShape> cursor() const;

 signals:
  /// The picture's labels are to be drawn anew.
  void wishChanged();
  void makingChanged();
  /// A click found nothing that a label could be on.
  void missed();
  /// It is in the scene.
  void made(sline::model::AnnotationId id);

 private:
  void clicked(const Picks& picks, const QPointF& at);
  void begin(model::Annotation annotation, const QString& offered, const QPointF& at);
  void accept(const QString& text);
  void add(const model::Annotation& annotation);
  void documentChange(const Document& before, const Document& now);
  void showMarks();
  std::optional<glm::vec2> begunAt() const;

  Place m_place;
  render::LabelStyle m_style;
  LabelLayer* m_layer;
  LabelTool* m_tool;
  LabelEditor* m_editor;
  std::function<std::optional<std::size_t>()> m_currentView;
  bool m_shut = false;
  bool m_presented = false;
  bool m_ready = true;
  int m_arrivals = 0;
  model::Camera m_camera;  ///< of the picture that is shown
  std::optional<QPointF> m_mouse;
  std::optional<model::AnnotationKind> m_making;
  std::vector<model::Anchor> m_begun;          ///< places of a distance
  std::optional<model::Annotation> m_written;  ///< the one that words are typed for
  bool m_new = false;                          ///< it is not in the scene yet
};

}  // namespace sline::widgets
