// SPDX-License-Identifier: Apache-2.0
// Films read again, each with a reader of its kind.
#pragma once

#include <QImage>
#include <QString>
#include <vector>

namespace sline::test {

struct DecodedFilm {
  std::vector<QImage> frames;  ///< RGBA, as they are shown
  int milliseconds = 0;        ///< of the whole
  bool endless = false;
};

/// Without frames where the file cannot be read.
DecodedFilm decodedWebp(const QString& file);
DecodedFilm decodedGif(const QString& file);
/// Through ffmpeg.
DecodedFilm decodedMp4(const QString& file);

}  // namespace sline::test
