// SPDX-License-Identifier: Apache-2.0
// Shows the stages beside the slider: a small picture of the selection as it looks there, and the
// stage's name. A click goes to that stage.
#pragma once

#include <QAbstractButton>
#include <QImage>
#include <QPointer>
#include <vector>

#include "widgets/gamma/stages.h"

namespace sline::widgets {

class GammaSlider;

class StageButton : public QAbstractButton {
  Q_OBJECT
 public:
  StageButton(const Stage& stage, QWidget* parent);

  Gamma gamma() const { return Gamma::clamped(m_stage.gamma); }
  const QImage& picture() const { return m_picture; }
  /// Shows the picture; a null image means none yet.
  void showPicture(const QImage& picture);
  void setPictureSize(QSize size);
  /// Marks the stage as the one that Γ is at.
  void setCurrent(bool current);
  QSize sizeHint() const override { return {120, 30}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintPicture(QPainter& painter, const QRectF& box) const;

  Stage m_stage;
  QImage m_picture;
  QSize m_size;
  bool m_current = false;
};

class StageStrip : public QWidget {
  Q_OBJECT
 public:
  /// Places the strip beside the slider, as high as it.
  explicit StageStrip(GammaSlider& slider, QWidget* parent = nullptr);

  /// Returns the Γ of the stages, in the order in which `showPicture` counts them.
  std::vector<Gamma> stages() const;
  void showPicture(int index, const QImage& image);
  void clearPictures();
  void setCurrent(std::optional<Gamma> gamma);
  QSize minimumSizeHint() const override { return {130, 244}; }

 signals:
  void chosen(sline::Gamma gamma);
  /// Asks for pictures of that size in screen pixels, of which `ratio` make one pixel of the
  /// window.
  void picturesWanted(QSize size, double ratio);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();

  GammaSlider& m_slider;
  std::vector<StageButton*> m_buttons;
  QSize m_pictureSize;
  double m_ratio = 0.0;
};

}  // namespace sline::widgets
