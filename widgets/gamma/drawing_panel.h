// SPDX-License-Identifier: Apache-2.0
// Shows the scene as each drawing style draws it; a click draws it so.
#pragma once

#include <QWidget>
#include <vector>

#include "model/look/drawing_styles.h"
#include "widgets/session/session.h"

class QImage;
class QSettings;
class QToolButton;

namespace sline::widgets {

class Viewport;

/// Holds what the user reads of a style.
struct DrawingText {
  QString name;
  QString description;
};
/// Returns the texts in the interface's language, in the order of `model::drawingStyles`.
std::vector<DrawingText> drawingTexts();

class DrawingPanel : public QWidget {
  Q_OBJECT
 public:
  /// Makes the panel; the settings remember whether it is open.
  DrawingPanel(Session& session, QSettings& settings, QWidget* parent = nullptr);

  void showPicture(int style, const QImage& image);
  bool hasPicture(int style) const { return m_pictured[std::size_t(style)]; }
  /// Returns the size of a picture of that shape in pixels of the window.
  static QSize pictureSize(double aspect);

 signals:
  void opened();
  void chosen(int style);
  /// Asks for the window's background: "white", "paper" or "dark".
  void backgroundWanted(const QString& background);
  /// Tells whether pictures can be seen.
  void picturesWanted(bool wanted);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void makeButtons();
  void unfold(bool open);
  void refresh();

  Session& m_session;
  QSettings& m_settings;
  QToolButton* m_fold;
  QWidget* m_content;
  bool m_open = false;
  std::vector<QToolButton*> m_buttons;
  std::vector<bool> m_pictured;
};

/// Has the picture's renderer draw the panel's pictures, and choices carried out, from now on.
void offerDrawings(Session& session, Viewport& viewport, DrawingPanel& panel);

}  // namespace sline::widgets
