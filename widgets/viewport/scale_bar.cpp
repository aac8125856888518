// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/scale_bar.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "render/lettering/mark_words.h"

namespace sline::widgets {

namespace {
constexpr int barMargin = 3;  ///< around the bar, so that nothing is cut off
constexpr int tick = 7;       ///< height of the bar's ends
}  // namespace

ScaleBarMark::ScaleBarMark(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("scaleBar"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
}

void ScaleBarMark::show(const std::optional<render::ScaleLength>& bar, const ScaleWords& words) {
  m_bar = bar;
  m_text = bar ? render::lengthText(bar->millimetres, QLocale(), words.unit) : QString();
  const render::MarkWords said(QLocale().bcp47Name().toStdString(), {});
  if (bar && words.atCutFace)
    m_text = said.atCutFace(m_text);
  else if (bar && words.atMidDepth)
    m_text = said.atMidDepth(m_text);
  setAccessibleName(bar ? tr("Scale: %1").arg(m_text) : QString());
  update();
}

void ScaleBarMark::setInk(const QColor& ink) {
  m_ink = ink;
  update();
}

QSize ScaleBarMark::sizeHint() const {
  const render::MarkWords said(QLocale().bcp47Name().toStdString(), {});
  const QString longest = QStringLiteral("500 mm?");
  const int words = std::max(fontMetrics().horizontalAdvance(said.atMidDepth(longest)),
                             fontMetrics().horizontalAdvance(said.atCutFace(longest))) +
                    8;
  return {std::max(most, words) + 2 * barMargin, fontMetrics().height() + tick + 2 * barMargin};
}

void ScaleBarMark::paintEvent(QPaintEvent*) {
  if (!m_bar)
    return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double left = barMargin + 0.5;
  const double right = left + m_bar->drawn;
  const double foot = height() - barMargin - 0.5;
  QPainterPath path(QPointF(left, foot - tick));
  path.lineTo(left, foot);
  path.lineTo(right, foot);
  path.lineTo(right, foot - tick);
  painter.setPen(QPen(m_ink, 1.2));
  painter.drawPath(path);
  painter.drawText(QRectF(left + 5.0, 0.0, width(), foot - 3.0), Qt::AlignLeft | Qt::AlignBottom,
                   m_text);
}

}  // namespace sline::widgets

#include "moc_scale_bar.cpp"
