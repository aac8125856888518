// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractButton>
#include <QImage>

namespace sline::widgets {

/// Shows a picture with a title and a line below it, to be clicked; where it is checkable, a mark
/// tells that it is checked. While there is no picture a plain drawing takes its place.
class ThumbnailCard : public QAbstractButton {
  Q_OBJECT
 public:
  explicit ThumbnailCard(const QString& title, QWidget* parent = nullptr);
  /// Sets the line below the title, shortened in the middle where it is too long.
  void setLine(const QString& line);
  QString line() const { return m_line; }
  void setPicture(const QImage& picture);
  bool hasPicture() const { return !m_picture.isNull(); }
  /// Sets the drawing, one of widgets/theme/icons.h, that is shown while there is no picture.
  void setStandIn(const QString& icon);
  /// Draws the card as if its file were missing; it can still be clicked.
  void setFaded(bool faded);

  QSize sizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void paintPicture(QPainter& painter, const QRectF& area);
  void paintTexts(QPainter& painter, const QRect& area);
  void paintCheckMark(QPainter& painter) const;

  QString m_line;
  QString m_standIn;
  QImage m_picture;
  bool m_faded = false;
};

}  // namespace sline::widgets
