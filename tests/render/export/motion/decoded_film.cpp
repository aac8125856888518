// SPDX-License-Identifier: Apache-2.0
#include "tests/render/export/motion/decoded_film.h"

#include <gif_lib.h>
#include <webp/demux.h>

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>

namespace sline::test {

DecodedFilm decodedWebp(const QString& file) {
  DecodedFilm film;
  QFile source(file);
  if (!source.open(QIODevice::ReadOnly))
    return film;
  const QByteArray bytes = source.readAll();
  const WebPData data{reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                      std::size_t(bytes.size())};
  WebPAnimDecoder* decoder = WebPAnimDecoderNew(&data, nullptr);
  if (!decoder)
    return film;
  WebPAnimInfo info;
  WebPAnimDecoderGetInfo(decoder, &info);
  film.endless = info.loop_count == 0;
  while (WebPAnimDecoderHasMoreFrames(decoder)) {
    std::uint8_t* pixels = nullptr;
    if (!WebPAnimDecoderGetNext(decoder, &pixels, &film.milliseconds))
      break;
    film.frames.push_back(
        QImage(pixels, int(info.canvas_width), int(info.canvas_height), QImage::Format_RGBA8888)
            .copy());
  }
  WebPAnimDecoderDelete(decoder);
  return film;
}

namespace {

/// Paints the part of the canvas that a frame changes.
void paint(QImage& canvas, const SavedImage& image, const ColorMapObject& colours, int clear) {
  const GifImageDesc& place = image.ImageDesc;
  for (int y = 0; y < place.Height; ++y)
    for (int x = 0; x < place.Width; ++x) {
      const int index = image.RasterBits[y * place.Width + x];
      if (index == clear)
        continue;
      const GifColorType& c = colours.Colors[index];
      canvas.setPixelColor(place.Left + x, place.Top + y, QColor(c.Red, c.Green, c.Blue));
    }
}

bool saysForEver(const GifFileType& gif) {
  for (int i = 0; i < gif.ImageCount; ++i)
    for (int k = 0; k < gif.SavedImages[i].ExtensionBlockCount; ++k)
      if (const ExtensionBlock& block = gif.SavedImages[i].ExtensionBlocks[k];
          block.Function == APPLICATION_EXT_FUNC_CODE &&
          QByteArray(reinterpret_cast<const char*>(block.Bytes), block.ByteCount) == "NETSCAPE2.0")
        return true;
  return false;
}

}  // namespace

DecodedFilm decodedGif(const QString& file) {
  DecodedFilm film;
  GifFileType* gif = DGifOpenFileName(file.toLocal8Bit().constData(), nullptr);
  if (!gif)
    return film;
  if (DGifSlurp(gif) == GIF_OK) {
    QImage canvas(gif->SWidth, gif->SHeight, QImage::Format_RGBA8888);
    canvas.fill(Qt::transparent);
    film.endless = saysForEver(*gif);
    for (int i = 0; i < gif->ImageCount; ++i) {
      GraphicsControlBlock control{};
      DGifSavedExtensionToGCB(gif, i, &control);
      if (gif->SavedImages[i].ImageDesc.ColorMap)
        break;  // a palette of its own would flicker
      paint(canvas, gif->SavedImages[i], *gif->SColorMap, control.TransparentColor);
      film.frames.push_back(canvas.copy());
      film.milliseconds += 10 * control.DelayTime;
      if (control.DisposalMode == DISPOSE_BACKGROUND)
        canvas.fill(Qt::transparent);
    }
  }
  DGifCloseFile(gif, nullptr);
  return film;
}

DecodedFilm decodedMp4(const QString& file) {
  DecodedFilm film;
  const QTemporaryDir folder;
  QProcess decoder;
  decoder.start("ffmpeg", {"-hide_banner", "-nostdin", "-i", file, "-fps_mode", "passthrough",
                           folder.filePath("%04d.png")});
  if (!decoder.waitForFinished(60'000) || decoder.exitCode() != 0)
    return film;
  for (int i = 1;; ++i) {
    const QImage frame(folder.filePath(QString("%1.png").arg(i, 4, 10, QChar('0'))));
    if (frame.isNull())
      break;
    film.frames.push_back(frame.convertToFormat(QImage::Format_RGBA8888));
  }
  static const QRegularExpression duration("Duration: (\\d+):(\\d+):(\\d+)\\.(\\d+)");
  const auto match = duration.match(QString::fromUtf8(decoder.readAllStandardError()));
  film.milliseconds = 1000 * (60 * match.captured(2).toInt() + match.captured(3).toInt()) +
                      10 * match.captured(4).toInt();
  return film;
}

}  // namespace sline::test
