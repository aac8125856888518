// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QImage>
#include <array>
#include <optional>

#include "render/measures/proof/print_proof.h"
#include "widgets/session/background_queue.h"
#include "widgets/session/display_names.h"
#include "widgets/viewport/viewport.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace sline::widgets {

/// Shows which neighbours in the picture a press without colours or some eyes cannot tell apart,
/// what would help, and how both look to them. Changes nothing itself.
class PrintProofDialog : public QDialog {
  Q_OBJECT
 public:
  /// Examines the order's picture; names and viewport must outlive the dialog.
  PrintProofDialog(render::ExportOrder order, const DisplayNames& names, Viewport& viewport,
                   QWidget* parent = nullptr);
  ~PrintProofDialog() override;

  /// Returns the proof; empty while the picture is being examined.
  const std::optional<render::PrintProof>& proof() const { return m_proof; }

 signals:
  /// Tells that the dialog has closed itself and the user wants these changes.
  void changesWanted(const std::vector<sline::render::ProofProposal>& proposals);

 private:
  QWidget* makeFindings();
  QWidget* makePreviewColumn();
  QWidget* makeButtons();
  void startProof();
  void took(const Result<render::PrintProof>& proof);
  void showFindings();
  void showProposals();
  void askPictures();
  void showPicture();

  const render::ExportOrder m_order;
  const DisplayNames& m_names;
  QPointer<Viewport> m_viewport;
  QLabel* m_told;
  QTreeWidget* m_pairs;
  QTreeWidget* m_changes;
  QCheckBox* m_all;
  QLabel* m_picture;
  QComboBox* m_vision;
  QCheckBox* m_changed;
  QPushButton* m_apply;
  int m_asked = 0;  ///< counts the examinations
  std::optional<render::PrintProof> m_proof;
  std::array<QImage, 2> m_pictures;  ///< as it is, and with the changes
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
