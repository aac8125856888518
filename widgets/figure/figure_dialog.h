// SPDX-License-Identifier: Apache-2.0
// Composes a figure of several panels: a list of panels, what can be set, and the page as it will
// be.
#pragma once

#include <QDialog>
#include <QFileSystemWatcher>
#include <QTimer>
#include <functional>
#include <memory>

#include "widgets/figure/figure_desk.h"
#include "widgets/figure/figure_fields.h"
#include "widgets/figure/figure_writing.h"
#include "widgets/session/background_queue.h"

class QFormLayout;
class QLabel;
class QListWidget;
class QMenu;
class QPushButton;
class QToolButton;

namespace sline::widgets {

class FigurePreview;

class FigureDialog : public QDialog {
  Q_OBJECT
 public:
  explicit FigureDialog(OpenScene open, QWidget* parent = nullptr);
  ~FigureDialog() override;

  const model::Figure& figure() const { return m_desk.figure(); }
  /// Takes the window's scene as it is now.
  void sceneChanged(std::shared_ptr<const model::Scene> scene);
  /// Tells whether the page on screen, or the problem told, is of the figure as it is.
  bool upToDate() const { return m_shown == m_round; }
  /// Opens a figure's file in the background.
  void openFile(const QString& path);
  /// Writes the figure's file; tells why where it cannot.
  bool saveFile(const QString& path);
  /// Writes the page in the background, unless it has what cannot be printed. Closing stops it.
  void exportFile(const QString& path);

  void reject() override;

 private:
  struct Composed;

  QWidget* makeSide();
  QWidget* makePanels();
  QWidget* makeBottom();
  void fillForm(QFormLayout& layout, const std::vector<FigureField>& fields);
  void fillAddMenu(QMenu& menu);
  void showAll();
  void showPanel();
  void change(model::Figure figure);
  /// Marks the page as of another state of the figure, and has it drawn anew.
  void redraw();
  void watchFiles();
  void readAgain(const QString& path);
  void optionsChanged();
  FigureWork work() const;
  void chooseRow(int row);
  void addInset(std::size_t panel, const model::FigureBox& part);
  void compose();
  void show(const Composed& composed);
  void tell(const Status& status, const QString& done);
  void chooseOpen();
  void chooseSave(const std::function<void()>& then = {});
  void chooseExport();
  void chooseScene();
  /// Asks whether what no file has may go, and goes on where it may.
  void askThen(const std::function<void()>& goOn);
  QString folder() const;

  OpenScene m_open;
  FigureDesk m_desk;
  std::vector<FigureField> m_page;
  FigurePreview* m_preview;
  QListWidget* m_list;
  QWidget* m_panelForm;
  QWidget* m_pageForm;
  QLabel* m_told;
  QToolButton* m_add;
  QToolButton* m_remove;
  QToolButton* m_up;
  QToolButton* m_down;
  QPushButton* m_export;
  render::ExportOrder m_options;  ///< of the file; must outlive their form
  render::ExportOrder m_planned;  ///< those of the page that is being drawn
  FigureWriting* m_writing;
  QFileSystemWatcher m_watcher;  ///< of scenes that the window has not open
  QTimer m_soon;                 ///< gathers changes that come at once
  QString m_said;                ///< of the page that is shown
  int m_round = 0;
  int m_shown = -1;
  std::shared_ptr<const render::ComposedFigure> m_drawn;
  bool m_printable = false;  ///< what is shown
  bool m_filling = false;    ///< controls are being filled, and nobody has typed
  BackgroundQueue m_queue;   ///< draws
};

}  // namespace sline::widgets
