// SPDX-License-Identifier: Apache-2.0
// Writes MP4 through ffmpeg, a separate program that is found where programs are: H.264 encoders
// come under licences and patents that Sline keeps out of.
#include <QProcess>
#include <QStandardPaths>
#include <array>
#include <cerrno>
#include <cstdio>

#include "render/export/motion/film_sink.h"

namespace sline::render {

namespace {

constexpr int patience = 60'000;  // milliseconds in which ffmpeg must take a frame

struct Encoder {
  const char* name;
  std::array<const char*, 4> options;
};
/// Encoders in the order of preference: the first that ffmpeg has is used.
constexpr std::array<Encoder, 3> encoders{{{"libx264", {"-crf", "16", "-preset", "medium"}},
                                           {"libopenh264", {"-b:v", "12M", "-maxrate", "24M"}},
                                           {"mpeg4", {"-q:v", "2", "-vtag", "mp4v"}}}};

Error withoutFfmpeg() {
  return {.reason = "MP4 films are made by the program ffmpeg, which is not installed",
          .remedy = "Install ffmpeg, or write an animated WebP or GIF"};
}

const Encoder* encoderOf(const QString& ffmpeg) {
  QProcess asked;
  asked.start(ffmpeg, {QStringLiteral("-hide_banner"), QStringLiteral("-encoders")},
              QIODevice::ReadOnly);
  if (!asked.waitForFinished(patience) || asked.exitCode() != 0)
    return nullptr;
  const QByteArray known = asked.readAllStandardOutput();
  for (const Encoder& encoder : encoders)
    if (known.contains(QByteArray(" ") + encoder.name + " "))
      return &encoder;
  return nullptr;
}

class Mp4Sink : public FilmSink {
 public:
  Mp4Sink(std::filesystem::path file, const FilmShape& shape)
      : m_file(std::move(file)), m_shape(shape) {}
  ~Mp4Sink() override {
    if (m_ffmpeg.state() == QProcess::NotRunning)
      return;
    m_ffmpeg.kill();
    m_ffmpeg.waitForFinished(patience);
  }

  Status begin() {
    const QString program = QStandardPaths::findExecutable(QStringLiteral("ffmpeg"));
    if (program.isEmpty())
      return withoutFfmpeg();
    // ffmpeg would report less clearly what is wrong with the place.
    if (std::FILE* file = std::fopen(m_file.c_str(), "wb"))
      std::fclose(file);
    else
      return filmNotWritten(m_file, errno);
    const Encoder* encoder = encoderOf(program);
    if (!encoder)
      return Error{.reason = "the ffmpeg that is installed has no encoder for MP4 films",
                   .remedy = "Install an ffmpeg with libx264, or write an animated WebP or GIF"};
    m_ffmpeg.setStandardOutputFile(QProcess::nullDevice());
    m_ffmpeg.start(program, argumentsFor(*encoder));
    return m_ffmpeg.waitForStarted(patience) ? Status(Unit{}) : failed();
  }

  Status add(const Image& frame) override {
    m_ffmpeg.write(pixelsOf(frame));
    // One frame at a time: frames that ffmpeg has not taken would pile up.
    while (m_ffmpeg.bytesToWrite() > 0)
      if (!m_ffmpeg.waitForBytesWritten(patience))
        return failed();
    return Unit{};
  }

  Status finish() override {
    m_ffmpeg.closeWriteChannel();
    // The last frames are encoded only now.
    const bool ended = m_ffmpeg.waitForFinished(10 * patience);
    return ended && m_ffmpeg.exitStatus() == QProcess::NormalExit && m_ffmpeg.exitCode() == 0
               ? Status(Unit{})
               : failed();
  }

 private:
  QStringList argumentsFor(const Encoder& encoder) const {
    const QString size = QString::number(m_shape.size.x) + 'x' + QString::number(m_shape.size.y);
    QStringList arguments{"-hide_banner",
                          "-loglevel",
                          "error",
                          "-nostdin",
                          "-y",
                          "-f",
                          "rawvideo",
                          "-pixel_format",
                          "rgb24",
                          "-video_size",
                          size,
                          "-framerate",
                          QString::number(m_shape.framesPerSecond),
                          "-i",
                          "pipe:0",
                          "-an"};
    // Converts sRGB to the colour space that players assume for films of that size.
    arguments << "-vf"
              << "scale=in_range=pc:out_range=tv:out_color_matrix=bt709,format=yuv420p"
              << "-color_range"
              << "tv"
              << "-colorspace"
              << "bt709"
              << "-color_primaries"
              << "bt709"
              << "-color_trc"
              << "bt709"
              << "-c:v" << encoder.name;
    for (const char* option : encoder.options)
      arguments << option;
    // Neither the program nor the day is written; playing may begin before everything is there.
    arguments << "-map_metadata"
              << "-1";
    for (const auto& [name, text] : {std::pair("artist=", m_shape.credit.author),
                                     std::pair("copyright=", m_shape.credit.copyright),
                                     std::pair("description=", m_shape.credit.description)})
      if (!text.empty())
        arguments << "-metadata" << name + QString::fromStdString(text);
    arguments << "-fflags"
              << "+bitexact"
              << "-flags:v"
              << "+bitexact"
              << "-movflags"
              << "+faststart"
              << "-f"
              << "mp4";
    // Starts with "file:", as a name may look like an option or an address.
    return arguments << "file:" +
                            QString::fromStdString(std::filesystem::absolute(m_file).string());
  }

  /// Returns RGB; clear pixels are white.
  static QByteArray pixelsOf(const Image& frame) {
    QByteArray pixels(qsizetype(frame.rgba.size() / 4 * 3), Qt::Uninitialized);
    char* to = pixels.data();
    for (std::size_t i = 0; i + 3 < frame.rgba.size(); i += 4)
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const int alpha = frame.rgba[i + 3];
        *to++ = char((frame.rgba[i + channel] * alpha + 255 * (255 - alpha) + 127) / 255);
      }
    return pixels;
  }

  Error failed() {
    m_ffmpeg.waitForFinished(1000);
    const QByteArray said = m_ffmpeg.readAllStandardError().trimmed();
    QByteArray reason = said.mid(said.lastIndexOf('\n') + 1);
    // The message contains a name of the file that the user did not give.
    if (const qsizetype place = reason.lastIndexOf(": "); place >= 0)
      reason = reason.mid(place + 2);
    return {.file = m_file.string(),
            .reason = "ffmpeg cannot make the film" +
                      (reason.isEmpty() ? "" : ": " + reason.toStdString()),
            .remedy = "Choose a folder with room that you may write to, or another kind of film"};
  }

  std::filesystem::path m_file;
  FilmShape m_shape;
  QProcess m_ffmpeg;
};

}  // namespace

NewSink mp4Sink(const std::filesystem::path& file, const FilmShape& shape) {
  auto sink = std::make_unique<Mp4Sink>(file, shape);
  if (Status begun = sink->begin(); !begun.ok()) {
    Error error = begun.error();
    error.file = file.string();
    return error;
  }
  return std::unique_ptr<FilmSink>(std::move(sink));
}

}  // namespace sline::render
