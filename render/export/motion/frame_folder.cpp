// SPDX-License-Identifier: Apache-2.0
#include <QBuffer>
#include <QImage>
#include <algorithm>

#include "model/files/whole_file.h"
#include "render/export/motion/film_sink.h"

namespace sline::render {

namespace {

class FrameFolder : public FilmSink {
 public:
  FrameFolder(std::filesystem::path folder, const FilmShape& shape)
      : m_folder(std::move(folder)),
        m_digits(std::max<std::size_t>(std::to_string(shape.frames).size(), 4)) {}

  Status add(const Image& frame) override {
    // Not QImage::save: it would say no reason.
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    const QImage image(frame.rgba.data(), frame.width, frame.height, qsizetype(4) * frame.width,
                       QImage::Format_RGBA8888);
    const bool opaque = [&frame] {
      for (std::size_t i = 3; i < frame.rgba.size(); i += 4)
        if (frame.rgba[i] != 255)
          return false;
      return true;
    }();
    const bool encoded = opaque ? image.convertToFormat(QImage::Format_RGB888).save(&buffer, "PNG")
                                : image.save(&buffer, "PNG");
    std::string number = std::to_string(++m_added);
    number.insert(0, m_digits - std::min(m_digits, number.size()), '0');
    const std::filesystem::path file = m_folder / ("frame_" + number + ".png");
    if (!encoded)
      return Error{.file = file.string(),
                   .reason = "the picture cannot be made",
                   .remedy = "Make it smaller"};
    return model::writeText(file, std::string_view(png.constData(), std::size_t(png.size())));
  }

  Status finish() override { return Unit{}; }

 private:
  std::filesystem::path m_folder;
  std::size_t m_digits;
  int m_added = 0;
};

}  // namespace

NewSink frameSink(const std::filesystem::path& folder, const FilmShape& shape) {
  return std::unique_ptr<FilmSink>(std::make_unique<FrameFolder>(folder, shape));
}

}  // namespace sline::render
