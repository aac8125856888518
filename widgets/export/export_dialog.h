// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "widgets/export/export_files.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QRadioButton;
class QVBoxLayout;

namespace sline::widgets {

class AltTextHint;
class ExportPreview;
class FilePager;
class PagePanel;
class SizeGauge;
class OptionForm;
class Viewport;

/// Lets the user choose what is exported, in which format and where to, with a picture of the page
/// and a summary of what the files will contain. Writes nothing itself.
class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  /// Writes each choice into the draft at once; the draft and the viewport must outlive the dialog.
  ExportDialog(ExportDraft& draft, ExportSource source, Viewport& viewport,
               QWidget* parent = nullptr);
  ~ExportDialog() override;

  const ExportPreview& preview() const { return *m_preview; }
  const SizeGauge& gauge() const { return *m_gauge; }

 signals:
  /// Tells that the dialog has closed itself; existing files of the same names may be replaced.
  void exportWanted(const QString& kind, const std::vector<sline::render::ExportPiece>& files);

 private:
  QWidget* makeKinds();
  QWidget* makeOptions();
  QWidget* makePreviewColumn();
  QWidget* makeTarget();
  QWidget* makeButtons();
  void addSubject(QVBoxLayout& layout);
  void addForms(QVBoxLayout& layout);
  void connectControls();
  QLabel* heading(const QString& text);
  void chooseKind();
  void chooseSubject(render::ViewSubject subject);
  /// Shows what can be chosen as the subject of this kind, and what is.
  void showSubject();
  void browse();
  /// Returns the file that the preview shows.
  const render::ExportPiece& shown() const;
  /// Returns the file whose size is told: that of which the preview shows something.
  const render::ExportPiece& measured() const;
  /// Offers the files, or the pages of a sheet, one by one.
  void showPager();
  void showSummary();
  /// Tells in the fields of texts which language goes with them.
  void sayLanguage();
  /// Shows everything that follows from the draft.
  void refresh();
  /// Shows what the user should know beforehand: what prevents the export, or else what the files
  /// will lack.
  void showDoubt();
  /// Returns the target as it would be written, with its ending.
  QString target() const;
  void tryToExport();
  void give();

  ExportDraft& m_draft;
  const ExportSource m_source;
  std::vector<render::ExportPiece> m_files;
  std::vector<render::ExportPiece> m_pages;  ///< what the preview shows of them
  QListWidget* m_kinds;
  QLabel* m_help;
  QRadioButton* m_seen;
  QRadioButton* m_savedViews;
  QCheckBox* m_filled;
  PagePanel* m_page;
  struct OptionSection {
    QLabel* heading = nullptr;
    OptionForm* form = nullptr;
  };
  std::vector<OptionSection> m_parts;
  std::vector<QWidget*> m_subjectWidgets;
  QLabel* m_pageHeading = nullptr;
  ExportPreview* m_preview;
  SizeGauge* m_gauge;  ///< outlives the dialog while it measures
  AltTextHint* m_hint;
  FilePager* m_pager;
  QLabel* m_summary;
  QLabel* m_doubt;
  QLineEdit* m_target;
  QPushButton* m_export;
};

}  // namespace sline::widgets
