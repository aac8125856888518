// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/drawing_panel.h"

#include <QFontMetrics>
#include <QGridLayout>
#include <QIcon>
#include <QImage>
#include <QPixmap>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cassert>

#include "widgets/gamma/drawing_pictures.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {
constexpr const char* drawingsOpenKey = "gamma/drawings";
constexpr int drawingWidth = 76;
constexpr int drawingHeight = 62;
constexpr int drawingColumns = 3;
constexpr int aroundDrawing = 12;  // a button's margins, and between picture and name
}  // namespace

std::vector<DrawingText> drawingTexts() {
  return {
      {tr("Plate"),
       tr("What the scene is about shaded in colour, everything else as quiet context.")},
      {tr("Even Pen"),
       tr("Outlines and folds in black, all by one pen that never changes its width.")},
      {tr("Textbook"), tr("Two colours: black lines, and one colour with a pale tint for what the "
                          "scene is about.")},
      {tr("Woodcut"), tr("Heavy black lines and dense hatching on white.")},
      {tr("Pencil"), tr("Fine strokes of graphite on warm paper.")},
      {tr("Operating Note"),
       tr("A few long lines as a surgeon would sketch them, what matters in one colour.")},
      {tr("Lecture Hall"), tr("Bright colours on a dark ground, to be seen from the last row.")}};
}

DrawingPanel::DrawingPanel(Session& session, QSettings& settings, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_settings(settings),
      m_fold(new QToolButton),
      m_content(new QWidget) {
  makeButtons();
  m_fold->setObjectName(QStringLiteral("drawings"));
  m_fold->setText(tr("Drawing Styles"));
  m_fold->setToolTip(tr("Draws the whole scene in one manner"));
  m_fold->setAutoRaise(true);
  m_fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  QFont bold = m_fold->font();
  bold.setBold(true);
  m_fold->setFont(bold);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(m_fold);
  layout->addWidget(m_content);
  connect(m_fold, &QToolButton::clicked, this, [this] { unfold(!m_open); });
  connect(&session, &Session::documentChanged, this, &DrawingPanel::refresh);
  unfold(settings.value(QLatin1String(drawingsOpenKey), false).toBool());
  refresh();
}

void DrawingPanel::makeButtons() {
  auto* grid = new QGridLayout(m_content);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(2);
  QFont small = font();
  small.setPointSizeF(0.85 * small.pointSizeF());
  const std::vector<DrawingText> texts = drawingTexts();
  assert(texts.size() == model::drawingStyles().size());
  for (int style = 0; style < int(texts.size()); ++style) {
    const DrawingText& text = texts[std::size_t(style)];
    auto* button = new QToolButton;
    const std::string_view id = model::drawingStyles()[std::size_t(style)].id;
    button->setObjectName(QStringLiteral("drawing ") +
                          QString::fromUtf8(id.data(), qsizetype(id.size())));
    button->setText(text.name);
    button->setToolTip(text.description);
    button->setAccessibleName(text.name);
    button->setAccessibleDescription(text.description);
    button->setFont(small);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize({drawingWidth, drawingHeight});
    // As high without a picture as with one.
    button->setFixedHeight(drawingHeight + QFontMetrics(small).height() + aroundDrawing);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    grid->addWidget(button, style / drawingColumns, style % drawingColumns);
    connect(button, &QToolButton::clicked, this, [this, style] { emit chosen(style); });
    m_buttons.push_back(button);
    m_pictured.push_back(false);
  }
}

QSize DrawingPanel::pictureSize(double aspect) {
  const int width = std::min(drawingWidth, int(drawingHeight * aspect));
  return {std::max(1, width), std::max(1, std::min(drawingHeight, int(drawingWidth / aspect)))};
}

void DrawingPanel::showPicture(int style, const QImage& image) {
  m_buttons[std::size_t(style)]->setIcon(QPixmap::fromImage(image));
  m_pictured[std::size_t(style)] = true;
}

void DrawingPanel::unfold(bool open) {
  m_open = open;
  m_fold->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
  m_fold->setAccessibleDescription(open ? tr("Open") : tr("Folded away"));
  m_content->setVisible(open);
  m_settings.setValue(QLatin1String(drawingsOpenKey), open);
  emit picturesWanted(m_open && isVisible());
  if (open)
    emit opened();
}

void DrawingPanel::refresh() {
  m_content->setEnabled(!m_session.scene().visibleBounds().empty());
}

void DrawingPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  emit picturesWanted(m_open);
}

void DrawingPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  emit picturesWanted(false);
}

void offerDrawings(Session& session, Viewport& viewport, DrawingPanel& panel) {
  auto* pictures = new DrawingPictures(session, viewport, &panel);
  QObject::connect(&panel, &DrawingPanel::picturesWanted, pictures, &DrawingPictures::want);
  QObject::connect(pictures, &DrawingPictures::made, &panel, &DrawingPanel::showPicture);
  QObject::connect(&panel, &DrawingPanel::chosen, pictures, [pictures](int style) {
    pictures->choose(model::drawingStyles()[std::size_t(style)],
                     drawingTexts()[std::size_t(style)].name);
  });
  QObject::connect(
      pictures, &DrawingPictures::drawn, &panel, [&panel](const model::DrawingStyle& style) {
        emit panel.backgroundWanted(
            QString::fromUtf8(style.background.data(), qsizetype(style.background.size())));
      });
}

}  // namespace sline::widgets

#include "moc_drawing_panel.cpp"
