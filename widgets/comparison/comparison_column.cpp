// SPDX-License-Identifier: Apache-2.0
#include "widgets/comparison/comparison_column.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "render/lines/techniques/technique_list.h"
#include "widgets/gamma/technique_texts.h"

namespace sline::widgets {

namespace {

constexpr float turnByKey = 10.0f;  // degrees
constexpr float zoomByKey = 1.2f;
constexpr float zoomByNotch = 1.15f;
constexpr double unitsOfNotch = 120.0;
constexpr int leastSide = 110;
constexpr int margin = 4;

std::optional<model::CameraDrag::Kind> dragOf(const QMouseEvent& event) {
  if (event.button() == Qt::MiddleButton ||
      (event.button() == Qt::LeftButton && event.modifiers().testFlag(Qt::ShiftModifier)))
    return model::CameraDrag::Kind::pan;
  if (event.button() == Qt::LeftButton)
    return model::CameraDrag::Kind::orbit;
  return std::nullopt;
}

}  // namespace

ComparisonPicture::ComparisonPicture(QString caption, QWidget* parent)
    : QWidget(parent), m_caption(std::move(caption)) {
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(leastSide, leastSide);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setCursor(Qt::OpenHandCursor);
}

void ComparisonPicture::setCamera(const model::Camera& camera, const glm::vec3& pivot,
                                  const model::ZoomEnds& ends) {
  m_camera = camera;
  m_pivot = pivot;
  m_ends = ends;
}

void ComparisonPicture::setImage(const QImage& image) {
  m_image = image;
  update();
}

void ComparisonPicture::zoom(float factor) {
  emit turned(zoomedWithin(m_camera, m_pivot, factor, m_ends));
}

int ComparisonPicture::room() const {
  return std::max(16, std::min(width(), height()));
}

void ComparisonPicture::setSide(int side) {
  m_side = side;
  update();
}

QRect ComparisonPicture::square() const {
  return {(width() - m_side) / 2, (height() - m_side) / 2, m_side, m_side};
}

glm::vec2 ComparisonPicture::within(const QPointF& at) const {
  const QPointF place = at - QPointF(square().topLeft());
  return {float(place.x()), float(place.y())};
}

void ComparisonPicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::white);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  if (!m_image.isNull())
    painter.drawImage(square(), m_image);
  if (!m_caption.isEmpty()) {
    const QRect line = rect().adjusted(margin, margin, -margin, -margin);
    painter.setPen(Qt::black);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignTop,
                     fontMetrics().elidedText(m_caption, Qt::ElideRight, line.width()));
  }
  painter.setPen(QPen(palette().color(hasFocus() ? QPalette::Highlight : QPalette::Mid),
                      hasFocus() ? 2.0 : 1.0));
  painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

void ComparisonPicture::mousePressEvent(QMouseEvent* event) {
  if (const auto kind = dragOf(*event))
    m_drag.emplace(model::CameraDrag::Start{.kind = *kind,
                                            .pixel = within(event->position()),
                                            .camera = m_camera,
                                            .pivot = m_pivot,
                                            .ends = m_ends});
}

void ComparisonPicture::mouseMoveEvent(QMouseEvent* event) {
  if (m_drag)
    emit turned(m_drag->at(within(event->position()), glm::vec2(float(m_side))));
}

void ComparisonPicture::mouseReleaseEvent(QMouseEvent*) {
  m_drag.reset();
}

void ComparisonPicture::wheelEvent(QWheelEvent* event) {
  const double notches = double(event->angleDelta().y()) / unitsOfNotch;
  if (notches != 0.0)
    zoom(std::pow(zoomByNotch, float(notches)));
}

void ComparisonPicture::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      return emit turned(orbited(m_camera, m_pivot, -turnByKey, 0.0f));
    case Qt::Key_Right:
      return emit turned(orbited(m_camera, m_pivot, turnByKey, 0.0f));
    case Qt::Key_Up:
      return emit turned(orbited(m_camera, m_pivot, 0.0f, -turnByKey));
    case Qt::Key_Down:
      return emit turned(orbited(m_camera, m_pivot, 0.0f, turnByKey));
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(zoomByKey);
    case Qt::Key_Minus:
      return zoom(1.0f / zoomByKey);
    default:
      QWidget::keyPressEvent(event);
  }
}

ComparisonColumn::ComparisonColumn(model::Technique technique, const QStringList& models,
                                   QWidget* parent)
    : QWidget(parent), m_technique(technique), m_below(new QWidget) {
  const render::TechniqueFacts& facts = render::factsOf(technique);
  const QString id = QString::fromUtf8(facts.id.data(), qsizetype(facts.id.size()));
  auto* head = new QLabel(linesName(technique));
  QFont bold = head->font();
  bold.setBold(true);
  head->setFont(bold);
  auto* source = new QLabel(QString::fromStdString(facts.citation()));
  source->setForegroundRole(QPalette::PlaceholderText);
  for (QLabel* label : {head, source}) {
    label->setTextFormat(Qt::PlainText);
    label->setMinimumWidth(1);
    label->setToolTip(label->text().toHtmlEscaped());
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(head);
  layout->addWidget(source);
  for (const QString& model : models) {
    const bool single = models.size() == 1;
    auto* picture = new ComparisonPicture(single ? QString() : model);
    picture->setObjectName(QStringLiteral("compared_") + id);
    picture->setAccessibleName(single ? linesName(technique)
                                      : linesName(technique) + QStringLiteral(": ") + model);
    layout->addWidget(picture, 1);
    m_pictures.push_back(picture);
  }
  layout->addWidget(m_below);
  addThresholds();
}

void ComparisonColumn::addThresholds() {
  auto* layout = new QVBoxLayout(m_below);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  for (const render::TechniqueThreshold& threshold : render::factsOf(m_technique).thresholds) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(QString::fromStdString(threshold.name));
    box->setAccessibleName(linesName(m_technique) + QStringLiteral(": ") +
                           QString::fromUtf8(threshold.id));
    box->setAccessibleDescription(thresholdMeaning(threshold.meaning));
    box->setToolTip(thresholdMeaning(threshold.meaning));
    box->setDecimals(3);
    box->setRange(double(threshold.limits.low), double(threshold.limits.high));
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    auto* label = new QLabel(QString::fromUtf8(threshold.id));
    label->setBuddy(box);
    label->setToolTip(box->toolTip());
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(box, 1);
    layout->addLayout(row);
    connect(box, &QDoubleSpinBox::valueChanged, this,
            [this, name = box->objectName()](double value) { emit thresholdChanged(name, value); });
    m_boxes.push_back(box);
  }
  layout->addStretch(1);
}

void ComparisonColumn::showThresholds(const model::ThresholdValues& values) {
  const auto& thresholds = render::factsOf(m_technique).thresholds;
  for (std::size_t i = 0; i < m_boxes.size(); ++i) {
    const QSignalBlocker quiet(m_boxes[i]);
    m_boxes[i]->setValue(double(render::valueOf(thresholds[i], values)));
  }
}

}  // namespace sline::widgets

#include "moc_comparison_column.cpp"
