// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/stage_strip.h"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "widgets/gamma/gamma_slider.h"

namespace sline::widgets {

namespace {
constexpr int gap = 5;      // between neighbouring pictures
constexpr int textGap = 9;  // between a picture and its name
constexpr double round = 4.0;
constexpr int highest = 64;
constexpr int widest = 86;
}  // namespace

StageButton::StageButton(const Stage& stage, QWidget* parent)
    : QAbstractButton(parent), m_stage(stage) {
  setObjectName(QStringLiteral("stage%1").arg(int(stage.gamma)));
  setText(stage.name);
  setToolTip(stage.explanation);
  setAccessibleName(tr("%1, Γ %2").arg(stage.name, gammaText(Gamma::clamped(stage.gamma))));
  setFocusPolicy(Qt::TabFocus);
  setCursor(Qt::PointingHandCursor);
  setAttribute(Qt::WA_Hover);
}

void StageButton::showPicture(const QImage& picture) {
  m_picture = picture;
  update();
}

void StageButton::setPictureSize(QSize size) {
  m_size = size;
  update();
}

void StageButton::setCurrent(bool current) {
  if (current == m_current)
    return;
  m_current = current;
  update();
}

void StageButton::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  const QRectF box(1.0, 0.5 * (height() - m_size.height()), m_size.width(), m_size.height());
  paintPicture(painter, box);
  QFont bold = font();
  bold.setBold(m_current && isEnabled());
  painter.setFont(bold);
  painter.setPen(
      palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText));
  const QRect words = rect().adjusted(m_size.width() + textGap, 0, 0, 0);
  painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft | Qt::TextWordWrap, text());
  if (hasFocus()) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0));
    painter.drawRoundedRect(QRectF(words).adjusted(-4.0, 2.0, -1.0, -2.0), round, round);
  }
}

void StageButton::paintPicture(QPainter& painter, const QRectF& box) const {
  QPainterPath shape;
  shape.addRoundedRect(box, round, round);
  painter.fillPath(shape, palette().color(QPalette::Base));
  if (!m_picture.isNull() && isEnabled()) {
    painter.setClipPath(shape);
    painter.drawImage(box, m_picture);
    painter.setClipping(false);
  }
  QColor frame = palette().color(QPalette::WindowText);
  frame.setAlpha(underMouse() && isEnabled() ? 150 : 60);
  double width = 1.0;
  if (isEnabled() && m_current) {
    frame = palette().color(QPalette::Highlight);
    width = 2.0;
  }
  painter.setPen(QPen(frame, width));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(box, round, round);
}

StageStrip::StageStrip(GammaSlider& slider, QWidget* parent) : QWidget(parent), m_slider(slider) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  for (const Stage& stage : gammaStages()) {
    auto* button = new StageButton(stage, this);
    m_buttons.push_back(button);
    connect(button, &StageButton::clicked, this, [this, button] { emit chosen(button->gamma()); });
  }
  m_slider.installEventFilter(this);
  for (std::size_t i = 1; i < m_buttons.size(); ++i)
    setTabOrder(m_buttons[i - 1], m_buttons[i]);
}

std::vector<Gamma> StageStrip::stages() const {
  std::vector<Gamma> gammas;
  gammas.reserve(m_buttons.size());
  for (const StageButton* button : m_buttons)
    gammas.push_back(button->gamma());
  return gammas;
}

void StageStrip::showPicture(int index, const QImage& image) {
  m_buttons.at(std::size_t(index))->showPicture(image);
}

void StageStrip::clearPictures() {
  for (StageButton* button : m_buttons)
    button->showPicture({});
}

void StageStrip::setCurrent(std::optional<Gamma> gamma) {
  // Halfway between two stages the lower one counts, which is already reached.
  const float nearest = gamma ? std::ceil(gamma->value() - 0.5f) : -1.0f;
  for (StageButton* button : m_buttons)
    button->setCurrent(button->gamma().value() == nearest);
}

void StageStrip::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place();
}

bool StageStrip::event(QEvent* event) {
  // A screen with other pixels needs new pictures, too.
  if (event->type() == QEvent::Show || event->type() == QEvent::ScreenChangeInternal)
    place();
  return QWidget::event(event);
}

bool StageStrip::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &m_slider && event->type() == QEvent::Resize)
    place();
  return QWidget::eventFilter(watched, event);
}

void StageStrip::place() {
  const auto yOf = [this](float gamma) {
    return int(std::lround(m_slider.pointOf(Gamma::clamped(gamma)).y()));
  };
  const int apart = yOf(0.0f) - yOf(1.0f);
  const int high = std::clamp(apart - gap, 20, highest);
  const QSize size(std::min(high * 4 / 3, std::min(widest, width() / 2)), high);
  for (StageButton* button : m_buttons) {
    button->setGeometry(0, yOf(button->gamma().value()) - apart / 2, width(), apart);
    button->setPictureSize(size);
  }
  const double ratio = devicePixelRatioF();
  if (size == m_pictureSize && ratio == m_ratio)
    return;
  m_pictureSize = size;
  m_ratio = ratio;
  emit picturesWanted(size * ratio, ratio);
}

}  // namespace sline::widgets

#include "moc_stage_strip.cpp"
