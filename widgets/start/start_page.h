// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

#include "model/scene_file/journal.h"
#include "widgets/session/demo_scenes.h"
#include "widgets/start/demo_pictures.h"
#include "widgets/start/drawing_choice.h"
#include "widgets/start/scene_thumbnails.h"

class QMainWindow;
class QVBoxLayout;

namespace sline::widgets {

class CardGrid;
class RecentFiles;
class RecoveryList;

/// Says where small pictures are: those of the demos that came with the program, and those that it
/// remembers.
struct PictureFolders {
  std::filesystem::path built;
  std::filesystem::path cache;
};

/// Shows, while nothing is open, what a crash has left, what was open last, the demos, and in which
/// style what is opened next is drawn. It lies over the whole window below the toolbar; panels keep
/// their places beneath it.
class StartPage : public QWidget {
  Q_OBJECT
 public:
  /// Makes the page. Window and list must outlive it.
  StartPage(QMainWindow& window, RecentFiles& recent, const PictureFolders& folders);

  void setRecoverable(const std::vector<model::Recoverable>& found);
  /// Sets whether demos are drawn; otherwise their cards show only remembered pictures.
  void setDrawing(bool drawing) { m_drawing = drawing; }
  /// Returns the styles that it offers, none until they are set.
  DrawingChoice& drawings() { return *m_drawings; }
  /// Returns a place at its upper edge, for a message.
  QVBoxLayout& messagePlace() { return *m_messagePlace; }

 signals:
  void filesWanted();
  void folderWanted();
  void demoChosen(const sline::widgets::DemoScene& demo);
  void recentChosen(const QString& path);
  void recoverWanted(const sline::model::Recoverable& found);
  void forgetWanted(const sline::model::Recoverable& found);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makeHead();
  QWidget* makeRecovery();
  QWidget* makeDrawings();
  void makeDemos();
  void listRecent();
  void cover();
  void askForPictures();

  QMainWindow& m_window;
  RecentFiles& m_recent;
  std::vector<DemoScene> m_demos = demoScenes();
  SceneThumbnails m_thumbnails;
  DemoPictures m_demoPictures;
  bool m_drawing = true;
  QVBoxLayout* m_messagePlace;
  QWidget* m_recovery;
  RecoveryList* m_recoveryList;
  QWidget* m_recentTitle;
  CardGrid* m_recentCards;
  CardGrid* m_demoCards;
  DrawingChoice* m_drawings;
};

}  // namespace sline::widgets
