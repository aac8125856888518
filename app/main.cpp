// SPDX-License-Identifier: Apache-2.0
// The `sline-workstation` program: opens the window on what the command line names, else on a demo.
#include <QApplication>
#include <QCommandLineParser>
#include <QSettings>

#include "widgets/session/demo_scenes.h"
#include "widgets/theme/theme.h"
#include "widgets/window/main_window.h"

namespace {

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
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setApplicationName(QStringLiteral("Sline"));
  QApplication::setOrganizationName(QStringLiteral("Sline"));
  QApplication::setApplicationVersion(QStringLiteral(SLINE_VERSION));
  QCommandLineParser parser;
  declare(parser);
  parser.process(application);

  using namespace sline::widgets;
  Session session;
  QSettings settings;
  MainWindow window(session, settings);
  const ThemeFollower theme(application, window.preferences());
  window.show();
  std::vector<std::filesystem::path> paths;
  for (const QString& path : parser.positionalArguments())
    paths.emplace_back(path.toStdString());
  const std::vector<DemoScene> demos = demoScenes();
  if (paths.empty())
    session.openMade(demos.front().title, demos.front().make);
  else
    session.openPaths(std::move(paths));
  return QApplication::exec();
}
