// SPDX-License-Identifier: Apache-2.0
// The `sline-workstation` program: opens the window on what the command line names, or else on its
// start page.
#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QSettings>
#include <algorithm>
#include <iostream>

#include "widgets/instance/window_server.h"
#include "widgets/language/language_switch.h"
#include "widgets/session/demo_scenes.h"
#include "widgets/theme/theme.h"
#include "widgets/window/main_window.h"

namespace {

constexpr const char* demoOption = "demo";
constexpr const char* newWindowOption = "new-window";

void declare(QCommandLineParser& parser) {
  parser.setApplicationDescription(QApplication::translate(
      "main", "Turns segmented anatomy into focus-and-context line illustrations."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(
      QStringLiteral("paths"),
      QApplication::translate("main",
                              "Meshes, label volumes, DICOM segmentations, molecules, folders of "
                              "them, 3D Slicer scenes, scene files."),
      QStringLiteral("[paths…]"));
  QStringList names;
  for (const sline::widgets::DemoScene& demo : sline::widgets::demoScenes())
    names << demo.id;
  parser.addOption(
      {QLatin1String(demoOption),
       QApplication::translate("main", "Opens a scene that the program models itself: %1.")
           .arg(names.join(QStringLiteral(", "))),
       QStringLiteral("scene")});
  parser.addOption({QLatin1String(newWindowOption),
                    QApplication::translate("main",
                                            "Opens a window of its own, whatever the preferences "
                                            "say of files from outside.")});
}

/// Hands the files to a window that is already open; returns false if none takes them.
bool wereHandedOver(const QStringList& named, const QString& token) {
  QStringList paths;
  for (const QString& path : named)
    paths << QDir::cleanPath(QDir::current().absoluteFilePath(path));
  using namespace sline::widgets;
  return !paths.isEmpty() && handOver(windowSocket(), {paths, token});
}

}  // namespace

int main(int argc, char** argv) {
  const QString token = sline::widgets::takenActivationToken();
  QApplication application(argc, argv);
  QApplication::setApplicationName(QStringLiteral("Sline"));
  QApplication::setOrganizationName(QStringLiteral("Sline"));
  QApplication::setApplicationVersion(QStringLiteral(SLINE_VERSION));
  // This name lets a desktop find the installed icon (app/packaging).
  QGuiApplication::setDesktopFileName(QStringLiteral("org.sline.Sline"));
  QCommandLineParser parser;
  using namespace sline::widgets;
  QSettings settings;
  LanguageSwitch language;
  language.use(Preferences(settings).choice(QStringLiteral("language/interface")));
  declare(parser);
  parser.process(application);

  const std::vector<DemoScene> demos = demoScenes();
  const QString wanted = parser.value(QLatin1String(demoOption));
  // The beginning of an id is enough: "pelvis" gives the first demo that begins with it.
  const auto demo = std::find_if(demos.begin(), demos.end(), [&wanted](const DemoScene& each) {
    return !wanted.isEmpty() && each.id.startsWith(wanted);
  });
  if (!wanted.isEmpty() && demo == demos.end()) {
    std::cerr << "sline-workstation: there is no demo called " << wanted.toStdString() << '\n';
    return EXIT_FAILURE;
  }
  std::vector<std::filesystem::path> paths;
  for (const QString& path : parser.positionalArguments())
    paths.emplace_back(path.toStdString());

  if (!parser.isSet(QLatin1String(newWindowOption)) &&
      Preferences(settings).choice(QStringLiteral("files/outside")) == QLatin1String("running") &&
      wereHandedOver(parser.positionalArguments(), token))
    return EXIT_SUCCESS;

  Session session;
  MainWindow window(session, settings);
  language.follow(window.preferences());
  const ThemeFollower theme(application, window.preferences());
  if (!paths.empty())
    session.openPaths(std::move(paths));
  else if (demo != demos.end())
    session.openMade(demo->title, demo->make);
  window.show();
  WindowServer server(windowSocket(), [&window] { return window.isFree(); });
  server.listen();
  QObject::connect(&server, &WindowServer::handed, &window, &MainWindow::take);
  // When the window that listened is closed, the window that is used next takes its place.
  QObject::connect(&application, &QGuiApplication::applicationStateChanged, &server,
                   [&server] { server.listen(); });
  return QApplication::exec();
}
