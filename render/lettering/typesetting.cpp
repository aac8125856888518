// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/typesetting.h"

#include <QFileInfo>
#include <QGuiApplication>
#include <QLibraryInfo>
#include <array>

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
    // Hides Qt's message about a run-time folder that it makes because none is named.
    const QtMessageHandler loud =
        qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
    data->application = std::make_unique<QGuiApplication>(data->count, data->arguments.data());
    qInstallMessageHandler(loud);
  }
  return std::unique_ptr<Typesetting>(new Typesetting(std::move(data)));
}

}  // namespace sline::render
