// SPDX-License-Identifier: Apache-2.0
#include "render/export/anki/anki_cards.h"
#include "render/export/anki/anki_options.h"

#include <QImage>
#include <QPainterPath>
#include <algorithm>
#include <cstring>

#include "render/export/description/alt_text.h"
#include "render/export/encoding/png_image.h"
#include "render/export/plate/figure_plate.h"
#include "render/lettering/typesetting.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::render {

namespace {

/// Pixels: no screen for cards shows more, and collections are sent over networks.
constexpr int widestCard = 1600;

/// Returns the picture without any text, drawn as pictures are: averaged where pixels are not fine
/// enough.
Result<Image> groundOf(const ExportOrder& order) {
  const Result<HeadlessPicture> picture = HeadlessPicture::create();
  if (!picture.ok())
    return picture.error();
  glm::ivec2 size = pixelsOf(order.page);
  if (size.x > widestCard)
    size = glm::max(size * widestCard / size.x, glm::ivec2(1));
  return (*picture)->render(order.scene, order.camera,
                            {.width = size.x, .height = size.y, .environment = order.environment},
                            samplesAtOnce(size));
}

/// Returns the plate with those labels alone.
LabelPlate onlyThose(const LabelPlate& plate, std::size_t asked, bool others) {
  LabelPlate some{.style = plate.style, .labels = {}, .texts = {}, .layout = plate.layout};
  for (std::size_t i = 0; i < plate.labels.size(); ++i)
    if (others || i == asked) {
      some.labels.push_back(plate.labels[i]);
      some.texts.push_back(plate.texts[i]);
    }
  return some;
}

/// Paints cards over the same ground.
class Cards {
 public:
  Cards(const ExportOrder& order, const Image& ground, const FigurePlate& plate)
      : m_order(order),
        m_ground(QImage(ground.rgba.data(), ground.width, ground.height,
                        qsizetype(4) * ground.width, QImage::Format_RGBA8888)
                     .convertToFormat(QImage::Format_RGBA8888_Premultiplied)),
        m_plate(*plate.labels),
        m_marks(plate.marks) {}

  Result<std::string> answer(std::size_t i) const {
    return painted(onlyThose(m_plate, i, m_order.of<AnkiOptions>().othersShown), nullptr);
  }

  /// Returns the picture of a question. Only the leader tells the text's place: a box as long as
  /// the text would give much away.
  Result<std::string> question(std::size_t i) const {
    LabelPlate plate = m_plate;
    plate.texts[i].lines.clear();
    plate.labels[i].item.kind = plate.labels[i].item.kind == model::AnnotationKind::callout
                                    ? model::AnnotationKind::label
                                    : plate.labels[i].item.kind;
    const PlacedLabel* placed = plate.layout.find(plate.labels[i].item.id);
    const LabelBox box = boxFor(*placed, plate.labels[i].item.places.front());
    return painted(onlyThose(plate, i, m_order.of<AnkiOptions>().othersShown), &box);
  }

 private:
  /// Returns a box at the side of the label's own box that faces the place.
  LabelBox boxFor(const PlacedLabel& placed, const glm::vec2& place) const {
    const float height = 1.3f * lineHeightMm(m_plate.style);
    const float width = 2.0f * height;
    const float middle = placed.box.middle().y;
    const bool before = placed.post == LabelPost::left ||
                        (placed.post != LabelPost::right && placed.box.middle().x < place.x);
    const float left = before ? placed.box.high.x - width : placed.box.low.x;
    return {{left, middle - 0.5f * height}, {left + width, middle + 0.5f * height}};
  }

  void paintBox(QPainter& painter, const LabelBox& box) const {
    constexpr qreal line = 0.25;
    const QColor ink(17, 17, 17);
    const QRectF place(QPointF(qreal(box.low.x), qreal(box.low.y)),
                       QPointF(qreal(box.high.x), qreal(box.high.y)));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(ink, line));
    painter.setBrush(QColor(255, 222, 120));
    painter.drawRoundedRect(place, 0.8, 0.8);
    const QFont font = labelFont();
    const QFontMetricsF metrics(font);
    const qreal scale =
        1.15 * qreal(m_plate.style.points * millimetresPerPoint) / qreal(labelFontPixels);
    QPainterPath letter;
    letter.addText(0.0, 0.0, font, QStringLiteral("?"));
    const QPointF middle = letter.boundingRect().center();
    painter.fillPath(QTransform(scale, 0.0, 0.0, scale, place.center().x() - scale * middle.x(),
                                place.center().y() - scale * middle.y())
                         .map(letter),
                     ink);
  }

  Result<std::string> painted(const LabelPlate& plate, const LabelBox* asked) const {
    QImage canvas = m_ground;
    {
      QPainter painter(&canvas);
      painter.scale(qreal(canvas.width()) / qreal(m_order.page.sizeMm.x),
                    qreal(canvas.height()) / qreal(m_order.page.sizeMm.y));
      paintLabels(painter, plate);
      paintMarks(painter, m_marks);
      if (asked)
        paintBox(painter, *asked);
    }
    const QImage drawn = canvas.convertToFormat(QImage::Format_RGBA8888);
    Image image{.width = drawn.width(), .height = drawn.height(), .rgba = {}};
    const std::size_t row = std::size_t(4) * std::size_t(drawn.width());
    image.rgba.resize(row * std::size_t(drawn.height()));
    for (int y = 0; y < drawn.height(); ++y)
      std::memcpy(&image.rgba[row * std::size_t(y)], drawn.constScanLine(y), row);
    return pngOf(image, fileCredit(m_order, {}));
  }

  const ExportOrder& m_order;
  QImage m_ground;
  const LabelPlate& m_plate;
  const Marks& m_marks;
};

/// Adds a picture; its name is derived from its bytes.
std::string addPicture(AnkiDeck& deck, std::string png) {
  std::string name = "sline-" + hexOf(fingerprintOf(png)) + ".png";
  const bool known = std::any_of(deck.media.begin(), deck.media.end(),
                                 [&name](const auto& member) { return member.name == name; });
  if (!known)
    deck.media.push_back({name, std::move(png)});
  return name;
}

AnkiDeck emptyDeck(const ExportOrder& order) {
  AnkiDeck deck;
  const std::string& name = order.of<AnkiOptions>().deck;
  deck.name = !name.empty() ? name : !order.viewName.empty() ? order.viewName : "Anatomy";
  deck.description = fileCredit(order, {}).line();
  deck.tags = {"Sline"};
  if (!order.viewName.empty())
    deck.tags.push_back(ankiTag(order.viewName));
  return deck;
}

}  // namespace

Result<AnkiDeck> ankiCards(const ExportOrder& order, const ExportProgress& progress) {
  const auto goesOn = [&progress](double share, std::string_view what) {
    return !progress || progress(share, what);
  };
  if (!goesOn(0.0, "preparing surfaces"))
    return givenUp({});
  const auto typesetting = Typesetting::create();
  if (!typesetting.ok())
    return typesetting.error();
  ExportOrder labelled = order;
  labelled.labels.mode = LabelMode::on;
  const FigurePlate whole = figurePlate(labelled);
  const LabelPlate& plate = *whole.labels;
  for (ExportNote note : whole.notes) {
    if (note.kind == ExportNote::Kind::labelsWithoutRoom)
      note.kind = ExportNote::Kind::cardsWithoutRoom;
    progress.note(std::move(note));
  }
  const auto isAsked = [&](const ShownLabel& label) {
    return plate.layout.find(label.item.id) && (label.item.kind != model::AnnotationKind::callout ||
                                                order.of<AnkiOptions>().calloutsAsked);
  };
  if (std::none_of(plate.labels.begin(), plate.labels.end(), isAsked))
    return Error{.reason = "the picture has no labels to ask for",
                 .remedy = "Label structures, or choose a view that shows some"};
  const Result<Image> ground = groundOf(order);
  if (!ground.ok())
    return ground.error();
  const Cards cards(order, *ground, whole);
  AnkiDeck deck = emptyDeck(order);
  labelled.labels.mode = LabelMode::numbers;  // a question names nothing
  const std::string questionShows = altTextOf(labelled).text;
  for (std::size_t i = 0; i < plate.labels.size(); ++i) {
    const ShownLabel& label = plate.labels[i];
    if (!isAsked(label))
      continue;
    const double share = 0.2 + 0.7 * double(i) / double(plate.labels.size());
    if (!goesOn(share, "drawing card " + std::to_string(i + 1)))
      return givenUp({});
    Result<std::string> question = cards.question(i);
    Result<std::string> answer = cards.answer(i);
    if (!question.ok() || !answer.ok())
      return question.ok() ? answer.error() : question.error();
    AnkiNote note;
    note.id = hexOf(fingerprintOf(deck.name + '\n' + order.viewName + '\n' +
                                  std::to_string(label.item.id.value) + '\n' + label.text));
    note.question = addPicture(deck, std::move(*question));
    note.answer = addPicture(deck, std::move(*answer));
    note.label = plainText(plate.texts[i].lines).toStdString();
    note.questionShows = questionShows;
    // Answers name what they answer alone: others are asked for later.
    if (!questionShows.empty())
      note.answerShows = questionShows + ' ' + note.label;
    deck.notes.push_back(std::move(note));
  }
  return deck;
}

}  // namespace sline::render
