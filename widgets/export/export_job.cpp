// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/export_job.h"

#include <chrono>
#include <exception>
#include <new>

#include "widgets/session/background_thread.h"

namespace sline::widgets {

ExportJob::ExportJob(const render::ExportFormat& format, std::vector<ExportFile> files,
                     QObject* parent)
    : QObject(parent), m_format(format), m_files(std::move(files)) {}

ExportJob::~ExportJob() {
  cancel();
  if (m_thread.joinable())
    m_thread.join();
}

void ExportJob::cancel() {
  m_thread.request_stop();
}

void ExportJob::start() {
  m_thread = std::jthread([this](const std::stop_token& stop) {
    standBack();
    std::optional<Error> error;
    if (const Status written = write(stop); !written.ok())
      error = written.error();
    QMetaObject::invokeMethod(
        this, [this, error] { finish(error); }, Qt::QueuedConnection);
  });
}

Status ExportJob::write(const std::stop_token& stop) {
  const auto count = double(m_files.size());
  for (std::size_t i = 0; i < m_files.size(); ++i) {
    const std::filesystem::path& target = m_files[i].target;
    if (stop.stop_requested())
      return render::givenUp(target);
    try {
      const auto tell = [&](double share, std::string_view what) {
        report((double(i) + share) / count, what);
        return !stop.stop_requested();
      };
      const Status written = m_format.write(readyOrder(m_files[i]), target, {tell, &m_notes});
      if (!written.ok())
        return written;
    } catch (const std::bad_alloc&) {
      return Error{.file = target.string(),
                   .reason = "there is not enough memory",
                   .remedy = "Take a smaller size, or close other programs"};
    } catch (const std::exception& failure) {
      return Error{.file = target.string(),
                   .reason = std::string("a library failed: ") + failure.what(),
                   .remedy = "Export another kind of file"};
    }
  }
  return Unit{};
}

void ExportJob::report(double share, std::string_view what) {
  using namespace std::chrono;
  constexpr std::int64_t pause = 100;  // as often as an eye can follow; whoever shows it repaints
  const std::int64_t now =
      duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
  std::int64_t last = m_lastReport;
  if (now - last >= pause && m_lastReport.compare_exchange_strong(last, now))
    emit progressed(share, QString::fromUtf8(what.data(), qsizetype(what.size())));
}

void ExportJob::finish(const std::optional<Error>& error) {
  if (!error)
    emit done();
  else if (m_thread.get_stop_token().stop_requested())
    emit cancelled();
  else
    emit failed(*error);
}

}  // namespace sline::widgets

#include "moc_export_job.cpp"
