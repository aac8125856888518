// SPDX-License-Identifier: Apache-2.0
// Writing files on a thread of its own, with progress and cancel.
#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <optional>
#include <thread>

#include "widgets/export/export_files.h"

namespace sline::widgets {

class ExportJob : public QObject {
  Q_OBJECT
 public:
  /// The format lives as long as the program.
  ExportJob(const render::ExportFormat& format, std::vector<ExportFile> files,
            QObject* parent = nullptr);
  /// Cancels, and waits until the writer has noticed.
  ~ExportJob() override;

  /// Once, when all that listen are connected.
  void start();
  /// The writer is asked to give up; nothing but `cancelled` follows.
  void cancel();
  const std::vector<ExportFile>& files() const { return m_files; }
  /// What the files lack, when all are there.
  const render::ExportNotes& notes() const { return m_notes; }

 signals:
  /// `share` of all files in [0, 1]; at most ten in a second.
  void progressed(double share, const QString& what);
  /// All are there.
  void done();
  /// One could not be written; those before it are there.
  void failed(const sline::Error& error);
  void cancelled();

 private:
  Status write(const std::stop_token& stop);
  void report(double share, std::string_view what);
  void finish(const std::optional<Error>& error);

  const render::ExportFormat& m_format;
  const std::vector<ExportFile> m_files;
  render::ExportNotes m_notes;                 ///< of the thread, until it is done
  std::atomic<std::int64_t> m_lastReport = 0;  ///< milliseconds of the steady clock
  std::jthread m_thread;
};

}  // namespace sline::widgets
