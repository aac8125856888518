// SPDX-License-Identifier: Apache-2.0
// Shows models by all techniques side by side, with one camera for all, and saves that as a sheet.
#pragma once

#include <QDialog>
#include <QPointer>
#include <QTimer>
#include <vector>

#include "render/export/comparison/comparison.h"
#include "render/export/comparison/comparison_sheet.h"
#include "widgets/comparison/comparison_column.h"
#include "widgets/comparison/comparison_rows.h"
#include "widgets/session/background_queue.h"
#include "widgets/viewport/viewport.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QScrollArea;

namespace sline::widgets {

class ComparisonDialog : public QDialog {
  Q_OBJECT
 public:
  struct Subject {
    ComparisonRows::Model whole;               ///< all that is compared
    std::vector<ComparisonRows::Model> apart;  ///< and its parts, if there are several
    model::Camera camera;                      ///< whose direction is looked from
    QString folder;                            ///< where sheets are saved at first
  };
  /// The viewport's renderer draws the pictures. The queue draws sheets, also after the dialog has
  /// closed; it must outlive the dialog.
  ComparisonDialog(Subject subject, Viewport& viewport, BackgroundQueue& queue,
                   QWidget* parent = nullptr);
  ~ComparisonDialog() override;

  /// Returns the first row's camera.
  const model::Camera& camera() const { return m_rows.shown(0).camera; }
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
  void makeRows();
  QWidget* makeGrid();
  QWidget* makeBottom();
  void change();
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
  ComparisonRows m_rows;
  model::ThresholdValues m_thresholds;
  std::vector<ComparisonColumn*> m_columns;
  /// A picture, what it shows and the round in which it was drawn.
  struct Place {
    ComparisonPicture* picture;
    model::Technique technique;
    std::size_t row;
    int took = -1;
  };
  std::vector<Place> m_places;
  QScrollArea* m_scroll;
  QCheckBox* m_apart;
  QComboBox* m_surface;
  QLabel* m_told;
  QPushButton* m_save;
  QTimer m_soon;           ///< gathers changes that come at once
  int m_round = 0;         ///< counts what was asked for
  int m_made = 0;          ///< the first round of the pictures that there are
  std::size_t m_next = 0;  ///< the picture that is drawn first, so that each gets its turn
};

}  // namespace sline::widgets
