// SPDX-License-Identifier: Apache-2.0
#include "render/export/labelled_image.h"

#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QLibraryInfo>
#include <algorithm>
#include <array>
#include <cstring>

#include "render/export/label_painter.h"

namespace sline::render {

struct Typesetting::Data {
  int count = 3;
  std::array<char, 6> name{"sline"};
  std::array<char, 10> flag{"-platform"};
  std::array<char, 10> platform{"offscreen"};
  std::array<char*, 4> arguments{name.data(), flag.data(), platform.data(), nullptr};
  std::unique_ptr<QGuiApplication> application;
};

Typesetting::Typesetting(std::unique_ptr<Data> data) : m_data(std::move(data)) {}
Typesetting::~Typesetting() = default;

Result<std::unique_ptr<Typesetting>> Typesetting::create() {
  auto data = std::make_unique<Data>();
  if (!qApp) {
    // Qt ends the program where it does not find its plugin.
    const QString plugin = QLibraryInfo::path(QLibraryInfo::PluginsPath) +
                           QStringLiteral("/platforms/libqoffscreen.so");
    if (!QFileInfo::exists(plugin))
      return Error{.file = plugin.toStdString(),
                   .reason = "the part of Qt that sets text without a display is not there",
                   .remedy = "Install Qt 6 Gui with its platform plugins"};
    // Of a run-time folder that it makes because none is named, nobody needs to know.
    const QtMessageHandler loud =
        qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
    data->application = std::make_unique<QGuiApplication>(data->count, data->arguments.data());
    qInstallMessageHandler(loud);
  }
  return std::unique_ptr<Typesetting>(new Typesetting(std::move(data)));
}

LabelReport drawLabels(Image& image, const LabelledPicture& picture, const Typesetting&) {
  LabelReport report;
  if (picture.style.mode == LabelMode::off || image.width < 1 || image.height < 1)
    return report;
  const float scale = float(image.height) / picture.heightMm;
  const Screen screen(picture.camera, {float(image.width) / scale, picture.heightMm});
  SightTrees trees;
  const LabelPlate plate = labelPlate(picture.scene, screen, picture.style, trees);
  // QPainter blends right only where colours are multiplied by their alpha.
  QImage canvas = QImage(image.rgba.data(), image.width, image.height, qsizetype(4) * image.width,
                         QImage::Format_RGBA8888)
                      .convertToFormat(QImage::Format_RGBA8888_Premultiplied);
  {
    QPainter painter(&canvas);
    painter.scale(qreal(scale), qreal(scale));
    paintLabels(painter, plate);
  }
  const QImage drawn = canvas.convertToFormat(QImage::Format_RGBA8888);
  for (int y = 0; y < image.height; ++y)
    std::memcpy(&image.rgba[std::size_t(4) * std::size_t(y) * std::size_t(image.width)],
                drawn.constScanLine(y), std::size_t(4) * std::size_t(image.width));
  for (const ShownLabel& label : plate.labels)
    if (plate.layout.find(label.item.id))
      report.key.push_back({label.number, label.text});
    else
      report.leftOut.push_back(label.text);
  return report;
}

float shareBesideLabels(const LabelledPicture& picture, float aspect, const Typesetting&) {
  if (picture.style.mode == LabelMode::off)
    return 1.0f;
  const float width = picture.heightMm * aspect;
  const float room = columnRoomMm(picture.scene, picture.style, width);
  constexpr float least = 0.4f;
  return std::max(least, 1.0f - 2.0f * room / width);
}

}  // namespace sline::render
