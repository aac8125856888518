// SPDX-License-Identifier: Apache-2.0
// Writes files on a thread of its own, with progress and cancel.
#pragma once

#include <vector>

#include "widgets/export/export_files.h"
#include "widgets/session/background_job.h"

namespace sline::widgets {

class ExportJob : public BackgroundJob {
  Q_OBJECT
 public:
  /// Starts writing; the format lives as long as the program.
  ExportJob(const render::ExportFormat& format, std::vector<render::ExportPiece> files,
            QObject* parent = nullptr);
  ~ExportJob() override { end(); }
  const std::vector<render::ExportPiece>& files() const { return m_files; }
  /// Returns what the files lack once all are written.
  const render::ExportNotes& notes() const { return m_notes; }

 private:
  Status write(const Progress& progress);

  const render::ExportFormat& m_format;
  const std::vector<render::ExportPiece> m_files;
  render::ExportNotes m_notes;  ///< belongs to the thread until the job is done
};

}  // namespace sline::widgets
