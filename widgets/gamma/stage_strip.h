// SPDX-License-Identifier: Apache-2.0
// The stages beside the slider: a small picture of what is selected, as it looks there, and the
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
  bool hasPicture() const { return m_stage.pictured; }
  const QImage& picture() const { return m_picture; }
  /// A null image: none yet.
  void showPicture(const QImage& picture);
  void setPictureSize(QSize size);
  /// The stage that Γ is at.
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
  /// Stands beside the slider, as high as it.
  explicit StageStrip(GammaSlider& slider, QWidget* parent = nullptr);

  /// Γ of the stages that have pictures, in the order in which `showPicture` counts them.
  std::vector<Gamma> pictured() const;
  void showPicture(int index, const QImage& image);
  void clearPictures();
  void setCurrent(std::optional<Gamma> gamma);
  QSize minimumSizeHint() const override { return {130, 244}; }

 signals:
  void chosen(sline::Gamma gamma);
  /// Pictures of that size (of the screen's pixels, of which `ratio` make one of the window's) are
  /// wanted.
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
