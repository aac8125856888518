// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "model/disk/whole_file.h"
#include "render/export/encoding/png_image.h"
#include "render/export/motion/film_sink.h"

namespace sline::render {

namespace {

class FrameFolder : public FilmSink {
 public:
  FrameFolder(std::filesystem::path folder, const FilmShape& shape)
      : m_folder(std::move(folder)),
        m_credit(shape.credit),
        m_digits(std::max<std::size_t>(std::to_string(shape.frames).size(), 4)) {
    m_credit.description.clear();  // it is that of the first
  }

  Status add(const Image& frame) override {
    std::string number = std::to_string(++m_added);
    number.insert(0, m_digits - std::min(m_digits, number.size()), '0');
    const std::filesystem::path file = m_folder / ("frame_" + number + ".png");
    const Result<std::string> png = pngOf(frame, m_credit);
    return png.ok() ? model::writeText(file, *png) : Status(png.error());
  }

  Status finish() override { return Unit{}; }

 private:
  std::filesystem::path m_folder;
  ExportCredit m_credit;
  std::size_t m_digits;
  int m_added = 0;
};

}  // namespace

NewSink frameSink(const std::filesystem::path& folder, const FilmShape& shape) {
  return std::unique_ptr<FilmSink>(std::make_unique<FrameFolder>(folder, shape));
}

}  // namespace sline::render
