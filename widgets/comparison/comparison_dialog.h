// SPDX-License-Identifier: Apache-2.0
// Shows a model by all techniques side by side, with one camera for all, and saves that as a sheet.
#pragma once

#include <QDialog>
#include <QPointer>
#include <QTimer>
#include <vector>

#include "render/export/comparison/comparison.h"
#include "render/export/comparison/comparison_sheet.h"
#include "widgets/comparison/comparison_cell.h"
#include "widgets/session/background_queue.h"
#include "widgets/viewport/viewport.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace sline::widgets {

class ComparisonDialog : public QDialog {
  Q_OBJECT
 public:
  struct Subject {
    QString name;
    model::Scene scene;    ///< its visible structures are compared
    model::Camera camera;  ///< whose direction is looked from
    QString folder;        ///< where sheets are saved at first
  };
  /// The viewport's renderer draws the pictures. The queue draws sheets, also after the dialog has
  /// closed; it must outlive the dialog.
  ComparisonDialog(Subject subject, Viewport& viewport, BackgroundQueue& queue,
                   QWidget* parent = nullptr);
  ~ComparisonDialog() override;

  const model::Camera& camera() const { return m_camera; }
  /// Returns what a sheet is made of: the model and, if its surface is roughened, that too.
  render::ComparisonOrder order() const;
  /// Writes the sheet in the background.
  void save(const QString& path);
  /// Tells whether every picture shows the camera and the thresholds as they are.
  bool upToDate() const;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makeGrid();
  QWidget* makeBottom();
  void turn(const model::Camera& camera);
  void setThreshold(const QString& name, double value);
  void resetThresholds();
  void roughen();
  void ask();
  void took(PreviewsOf asker, int id, const QImage& image);
  /// Returns the words of a sheet in the interface's language.
  static render::ComparisonWords words();
  void chooseFile();
  void savedAs(const QString& path, const Status& status);

  Subject m_subject;
  QPointer<Viewport> m_viewport;
  BackgroundQueue& m_queue;
  render::ComparedModel m_model;  ///< as it is
  render::ComparedModel m_shown;  ///< the same or roughened
  model::Camera m_camera;
  glm::vec3 m_pivot{0.0f};
  model::ThresholdValues m_thresholds;
  std::vector<ComparisonCell*> m_cells;
  std::vector<int> m_took;  ///< the round of each cell's picture
  QComboBox* m_surface;
  QLabel* m_told;
  QPushButton* m_save;
  QTimer m_soon;           ///< gathers changes that come at once
  int m_round = 0;         ///< counts what was asked for
  std::size_t m_next = 0;  ///< the cell that is drawn first, so that each gets its turn
};

}  // namespace sline::widgets
