// SPDX-License-Identifier: Apache-2.0
// Reads films again, each with a reader of its kind.
#pragma once

#include <QImage>
#include <QString>
#include <vector>

namespace sline::test {

struct DecodedFilm {
  std::vector<QImage> frames;  ///< RGBA, as they are shown
  int milliseconds = 0;        ///< of the whole film
  bool endless = false;
};

/// Reads a WebP; without frames if the file cannot be read.
DecodedFilm decodedWebp(const QString& file);
DecodedFilm decodedGif(const QString& file);
/// Reads an MP4 through ffmpeg.
DecodedFilm decodedMp4(const QString& file);

}  // namespace sline::test
