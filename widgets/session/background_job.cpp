// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/background_job.h"

#include <chrono>
#include <exception>
#include <new>
#include <utility>

#include "model/disk/process.h"

namespace sline::widgets {

BackgroundJob::BackgroundJob(Work work, QObject* parent)
    : QObject(parent), m_work(std::move(work)) {}

BackgroundJob::~BackgroundJob() {
  end();
}

void BackgroundJob::end() {
  cancel();
  if (m_thread.joinable())
    m_thread.join();
}

void BackgroundJob::start() {
  m_thread = std::thread([this] {
    model::standBack();
    std::optional<Error> error;
    const Status over =
        m_work([this](double share, std::string_view what) { return report(share, what); });
    if (!over.ok())
      error = over.error();
    QMetaObject::invokeMethod(
        this, [this, error] { finish(error); }, Qt::QueuedConnection);
  });
}

void BackgroundJob::cancel() {
  m_stop.request_stop();
}

bool BackgroundJob::report(double share, std::string_view what) {
  using namespace std::chrono;
  constexpr std::int64_t pause = 100;  // milliseconds: as often as an eye follows a repaint
  const std::int64_t now =
      duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
  std::int64_t last = m_lastReport;
  if (now - last >= pause && m_lastReport.compare_exchange_strong(last, now))
    emit progressed(share, QString::fromUtf8(what.data(), qsizetype(what.size())));
  return !stopped();
}

void BackgroundJob::finish(const std::optional<Error>& error) {
  if (!error)
    emit done();
  else if (stopped())
    emit cancelled();
  else
    emit failed(*error);
}

Status caught(const std::function<Status()>& work, const JobAdvice& advice) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return Error{.reason = "there is not enough memory", .remedy = advice.memory};
  } catch (const std::exception& failure) {
    return Error{.reason = std::string("a library failed: ") + failure.what(),
                 .remedy = advice.library};
  }
}

}  // namespace sline::widgets

#include "moc_background_job.cpp"
