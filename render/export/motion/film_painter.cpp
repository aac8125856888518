// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/film_painter.h"

#include <QImage>
#include <cstring>
#include <map>
#include <new>
#include <set>

#include "model/scene/label_words.h"
#include "render/export/motion/film_labels.h"
#include "render/export/plate/plate_image.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::render {

namespace {

/// Knows what was in any of a film's frames, and what should have been.
class Sightings {
 public:
  void add(const FilmFrame& frame, const FigurePlate& plate, const std::string& language) {
    for (const LetteringItem& mark : plate.marks.lettering.items)
      m_marks.insert(mark.name);
    for (const ExportNote& note : plate.marks.notes)
      addNote(m_notes, note);
    if (!plate.labels)
      return;
    for (const model::Annotation& annotation : frame.scene.annotations())
      if (annotation.visible)
        m_wanted.try_emplace(annotation.id, model::writtenIn(frame.scene, annotation, language));
    for (const ShownLabel& label : plate.labels->labels)
      m_met.insert(label.item.id);
    for (const model::AnnotationId id : plate.labels->layout.leftOut)
      m_met.insert(id);
    for (const PlacedLabel& placed : plate.labels->layout.labels)
      m_placed.insert(placed.id);
  }

  ExportNotes notes() const {
    using Kind = ExportNote::Kind;
    ExportNotes all = m_notes;
    for (ExportNote& note : all)
      if (note.kind == Kind::marksWithoutRoom)
        std::erase_if(note.names, [this](const auto& name) { return m_marks.contains(name); });
    std::erase_if(all, [](const ExportNote& note) {
      return note.kind == Kind::marksWithoutRoom && note.names.empty();
    });
    ExportNote without{.kind = Kind::labelsWithoutRoom, .names = {}, .detail = {}};
    ExportNote unseen{.kind = Kind::labelsOfHidden, .names = {}, .detail = {}};
    for (const auto& [id, text] : m_wanted)
      if (!m_placed.contains(id))
        (m_met.contains(id) ? without : unseen).names.push_back(text);
    for (ExportNote* note : {&without, &unseen})
      if (!note->names.empty())
        addNote(all, std::move(*note));
    return all;
  }

 private:
  std::map<model::AnnotationId, std::string> m_wanted;
  std::set<model::AnnotationId> m_met;
  std::set<model::AnnotationId> m_placed;
  std::set<std::string> m_marks;
  ExportNotes m_notes;
};

}  // namespace

struct FilmPainter::Data {
  const ExportOrder& order;
  std::unique_ptr<Typesetting> typesetting;
  HeadlessPicture picture;
  FilmLabels labels;
  Sightings sightings;

  bool labelled() const { return order.labels.mode != LabelMode::off; }
  bool bare() const { return order.bare(); }
  Result<Image> drawFrame(const FilmFrame& frame, const glm::ivec2& size);
  void paint(Image& image, const FigurePlate& plate) const;
};

FilmPainter::FilmPainter(std::unique_ptr<Data> data) : m_data(std::move(data)) {}
FilmPainter::~FilmPainter() = default;

Result<std::unique_ptr<FilmPainter>> FilmPainter::create(const ExportOrder& order) {
  HeadlessPicture picture = TRY(HeadlessPicture::create());
  std::unique_ptr<Data> data(new Data{order, nullptr, std::move(picture), FilmLabels(order), {}});
  if (!data->bare()) {
    data->typesetting = TRY(Typesetting::create());
  }
  return std::unique_ptr<FilmPainter>(new FilmPainter(std::move(data)));
}

glm::vec2 FilmPainter::anatomyShare() const {
  return m_data->bare() ? glm::vec2(1.0f) : shareBesidePlate(m_data->order, *m_data->typesetting);
}

bool FilmPainter::settle(const Film& film, const std::function<bool(double)>& go) {
  return m_data->labels.settle(film, go);
}

Result<Image> FilmPainter::Data::drawFrame(const FilmFrame& frame, const glm::ivec2& size) {
  // Draws as pictures are drawn: averaged where pixels are not fine enough by themselves.
  return picture->render(frame.scene, frame.camera,
                         {.width = size.x, .height = size.y, .environment = order.environment},
                         samplesAtOnce(size));
}

void FilmPainter::Data::paint(Image& image, const FigurePlate& plate) const {
  // QPainter blends correctly only where colours are multiplied by their alpha.
  QImage canvas = QImage(image.rgba.data(), image.width, image.height, qsizetype(4) * image.width,
                         QImage::Format_RGBA8888)
                      .convertToFormat(QImage::Format_RGBA8888_Premultiplied);
  {
    QPainter painter(&canvas);
    painter.scale(qreal(image.width) / qreal(order.page.sizeMm.x),
                  qreal(image.height) / qreal(order.page.sizeMm.y));
    paintPlate(painter, plate);
  }
  const QImage straight = canvas.convertToFormat(QImage::Format_RGBA8888);
  if (straight.height() != image.height)  // as where memory did not suffice
    throw std::bad_alloc();
  const std::size_t row = std::size_t(4) * std::size_t(image.width);
  for (int y = 0; y < image.height; ++y)
    std::memcpy(&image.rgba[row * std::size_t(y)], straight.constScanLine(y), row);
}

Result<Image> FilmPainter::draw(const Film& film, int frame) {
  const FilmFrame shown = film.at(frame);
  Result<Image> image = m_data->drawFrame(shown, film.size());
  if (!image.ok() || m_data->bare())
    return image;
  const FigurePlate plate = m_data->labels.plateOf(film, frame);
  m_data->sightings.add(shown, plate, m_data->order.labels.language);
  m_data->paint(*image, plate);
  return image;
}

Result<Image> FilmPainter::drawAlone(const Film& film, int frame) {
  const FilmFrame shown = film.at(frame);
  Result<Image> image = m_data->drawFrame(shown, film.size());
  if (image.ok() && !m_data->bare())
    m_data->paint(*image, m_data->labels.alone(film, frame));
  return image;
}

ExportNotes FilmPainter::notes() const {
  return m_data->sightings.notes();
}

}  // namespace sline::render
