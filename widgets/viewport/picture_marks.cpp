// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/picture_marks.h"

#include <QLabel>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>

#include "render/labels/orientation_letters.h"
#include "widgets/annotations/in_picture/presented_letters.h"

namespace sline::widgets {

namespace {

constexpr int marksMargin = 10;

QLabel* label(QWidget& picture, const char* name) {
  auto* made = new QLabel(&picture);
  made->setObjectName(QLatin1String(name));
  made->setAttribute(Qt::WA_TransparentForMouseEvents);
  made->setAlignment(Qt::AlignCenter);
  made->setTextFormat(Qt::PlainText);
  made->hide();
  return made;
}

}  // namespace

PictureMarks::PictureMarks(QWidget& picture) : QObject(&picture), m_picture(picture) {
  static constexpr std::array<const char*, 4> names{"letterLeft", "letterRight", "letterTop",
                                                    "letterBottom"};
  for (std::size_t i = 0; i < names.size(); ++i)
    m_letters[i] = label(picture, names[i]);
  m_cube = new CubeMark(&picture);
  m_scaleBar = new ScaleBarMark(&picture);
  m_time = label(picture, "frameTime");
  m_name = label(picture, "nameUnderMouse");
  m_cube->hide();
  m_scaleBar->hide();
}

MarkedScene markedScene(const model::Scene& scene) {
  return {.any = !scene.nodes().empty(),
          .sides = knownSides(scene),
          .unit = drawnUnit(scene),
          .scale = render::scalePlaces(scene)};
}

void PictureMarks::choose(const MarkChoice& choice) {
  m_choice = choice;
  m_cube->setVisible(m_scene && choice.cube);
  m_scaleBar->setVisible(m_scene && choice.scaleBar);
  m_time->setVisible(m_scene && choice.frameTime);
}

void PictureMarks::setBackground(render::Background background) {
  m_dark = background == render::Background::dark;
  dress();
}

void PictureMarks::setPresented(bool presented, const QRect& covered) {
  m_presented = presented;
  m_covered = covered;
}

void PictureMarks::dress() {
  const bool dark = m_dark;
  const QString ink = dark ? QStringLiteral("#a2a2a2") : QStringLiteral("#736e66");
  const QString size =
      m_letterPixels > 0 ? QStringLiteral(" font-size: %1px;").arg(m_letterPixels) : QString();
  for (QLabel* letter : m_letters)
    letter->setStyleSheet(QStringLiteral("color: %1; font-weight: 600;%2").arg(ink, size));
  m_time->setStyleSheet(QStringLiteral("color: %1;").arg(ink));
  m_name->setStyleSheet(dark
                            ? QStringLiteral("color: #141416; background: rgba(236, 236, 236, 235);"
                                             "border-radius: 4px; padding: 2px 7px;")
                            : QStringLiteral("color: #ffffff; background: rgba(38, 38, 40, 225);"
                                             "border-radius: 4px; padding: 2px 7px;"));
  m_scaleBar->setInk(QColor(ink));
  m_cube->setDark(dark);
}

QRect PictureMarks::cornerBox(const QSize& size, Qt::Corner corner) const {
  QRect box(QPoint(), size);
  const QRect room =
      m_picture.rect().adjusted(marksMargin, marksMargin, -marksMargin, -marksMargin);
  if (corner == Qt::TopRightCorner)
    box.moveTopRight(room.topRight());
  else if (corner == Qt::BottomRightCorner)
    box.moveBottomRight(room.bottomRight());
  else
    box.moveBottomLeft(room.bottomLeft());
  return box;
}

void PictureMarks::placeCorner(QWidget& mark, Qt::Corner corner) {
  mark.setGeometry(cornerBox(mark.sizeHint(), corner));
}

std::vector<QRectF> PictureMarks::places() const {
  std::vector<QRectF> places;
  const auto add = [&places](const QRect& box) {
    constexpr qreal air = 4.0;
    places.push_back(QRectF(box).adjusted(-air, -air, air, air));
  };
  if (!m_covered.isEmpty())
    add(m_covered);
  if (m_choice.cube)
    add(cornerBox(m_cube->sizeHint(), Qt::TopRightCorner));
  if (m_choice.scaleBar)
    add(cornerBox(m_scaleBar->sizeHint(), Qt::BottomLeftCorner));
  // Words and letters change while the camera turns; labels must not give way each time.
  const auto sizeOf = [](const QLabel& label, const QString& text) {
    return label.fontMetrics().boundingRect(text).size() + QSize(4, 2);
  };
  if (m_choice.frameTime)
    add(cornerBox(sizeOf(*m_time, timeText(9999.0, 0.5f)), Qt::BottomRightCorner));
  const QSize letters = sizeOf(*m_letters[0], QStringLiteral("SL?A?"));
  const QPoint middle = m_picture.rect().center();
  for (std::size_t i = 0; i < m_letters.size(); ++i) {
    QRect box(QPoint(), letters);
    box.moveCenter(middle);
    placeAtEdge(box, i);
    add(box);
  }
  return places;
}

void PictureMarks::placeAtEdge(QRect& box, std::size_t edge) const {
  if (edge == 0)
    box.moveLeft(marksMargin);
  else if (edge == 1)
    box.moveRight(m_picture.width() - marksMargin);
  else if (edge == 2)
    box.moveTop(marksMargin);
  else
    box.moveBottom(m_picture.height() - marksMargin);
}

void PictureMarks::place(const model::Camera& camera, const MarkedScene& scene) {
  m_scene = scene.any;
  const int letters = m_presented ? m_picture.height() / presentedLines : 0;
  if (std::exchange(m_letterPixels, letters) != letters)
    dress();
  placeLetters(camera, scene.sides);
  m_cube->setCamera(camera, scene.sides);
  placeCorner(*m_cube, Qt::TopRightCorner);
  const std::optional<render::ScalePlace> scale = scene.scale.in(camera);
  const bool perspective = camera.projection == model::Projection::perspective;
  m_scaleBar->show(
      scale ? render::scaleLength(camera, scale->at, m_picture.height(), ScaleBarMark::most)
            : std::nullopt,
      {.unit = scene.unit,
       .atMidDepth = perspective,
       .atCutFace = perspective && scale && scale->onCutFace});
  placeCorner(*m_scaleBar, Qt::BottomLeftCorner);
  placeCorner(*m_time, Qt::BottomRightCorner);
  choose(m_choice);
}

void PictureMarks::placeLetters(const model::Camera& camera, const model::KnownSides& sides) {
  const render::EdgeLetters letters = render::edgeLetters(camera, sides);
  const std::array<const std::string*, 4> texts{&letters.left, &letters.right, &letters.top,
                                                &letters.bottom};
  const QPoint middle = m_picture.rect().center();
  for (std::size_t i = 0; i < m_letters.size(); ++i) {
    QLabel& label = *m_letters[i];
    label.setText(QString::fromStdString(*texts[i]));
    label.adjustSize();
    QRect box = label.rect();
    box.moveCenter(middle);
    placeAtEdge(box, i);
    label.setGeometry(box);
    label.setVisible(m_scene && sides.any);
  }
}

QString PictureMarks::timeText(double milliseconds, float scale) {
  const QString time = tr("%1 ms").arg(QLocale().toString(milliseconds, 'f', 0));
  const QString size = QLocale().toString(int(std::lround(100.0f * scale)));
  return scale < 1.0f ? tr("%1 at %2 % size").arg(time, size) : time;
}

void PictureMarks::showTime(double milliseconds, float scale) {
  m_time->setText(timeText(milliseconds, scale));
  m_time->adjustSize();
  placeCorner(*m_time, Qt::BottomRightCorner);
}

void PictureMarks::showName(const QString& name, const QPoint& mouse) {
  constexpr QPoint beside(14, 20);  // below the arrow of the mouse
  m_name->setText(
      m_name->fontMetrics().elidedText(name, Qt::ElideMiddle, std::max(60, m_picture.width() / 2)));
  m_name->adjustSize();
  QRect box = m_name->rect();
  box.moveTopLeft(mouse + beside);
  if (box.right() > m_picture.width() - 4)
    box.moveRight(m_picture.width() - 4);
  if (box.bottom() > m_picture.height() - 4)
    box.moveBottom(mouse.y() - 6);
  m_name->setGeometry(box);
  m_name->raise();
  m_name->show();
}

void PictureMarks::hideName() {
  m_name->hide();
}

}  // namespace sline::widgets

#include "moc_picture_marks.cpp"
