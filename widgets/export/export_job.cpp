// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/export_job.h"

#include <utility>

namespace sline::widgets {

ExportJob::ExportJob(const render::ExportFormat& format, std::vector<render::ExportPiece> files,
                     QObject* parent)
    : BackgroundJob([this](const Progress& progress) { return write(progress); }, parent),
      m_format(format),
      m_files(std::move(files)) {}

Status ExportJob::write(const Progress& progress) {
  const auto count = double(m_files.size());
  for (std::size_t i = 0; i < m_files.size(); ++i) {
    const std::filesystem::path& target = m_files[i].target;
    if (stopped())
      return render::givenUp(target);
    const auto tell = [&](double share, std::string_view what) {
      return progress((double(i) + share) / count, what);
    };
    const Status written = caught(
        [&] {
          return m_format.write(render::readyOrder(m_files[i]), target, {tell, &m_notes});
        },
        {.memory = "Take a smaller size, or close other programs",
         .library = "Export another kind of file"});
    if (!written.ok()) {
      Error error = written.error();
      if (error.file.empty())
        error.file = target.string();
      return error;
    }
  }
  return Unit{};
}

}  // namespace sline::widgets

#include "moc_export_job.cpp"
