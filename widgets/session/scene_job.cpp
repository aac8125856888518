// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/scene_job.h"

#include <chrono>
#include <exception>
#include <new>

#include "widgets/session/background_thread.h"

namespace sline::widgets {

namespace {

/// What a library threw ends here as an error a person can read.
Result<Loaded> made(const SceneMaker& maker, const model::ImportProgress& progress,
                    const std::stop_token& stop) {
  try {
    return maker(progress, stop);
  } catch (const std::bad_alloc&) {
    return Error{.reason = "there is not enough memory",
                 .remedy = "Close other programs or open fewer files"};
  } catch (const std::exception& failure) {
    return Error{.reason = std::string("a library failed: ") + failure.what(),
                 .remedy = "Open the files one by one to see which it is"};
  }
}

}  // namespace

SceneJob::SceneJob(SceneMaker maker, QObject* parent)
    : QObject(parent), m_maker(std::move(maker)) {}

void SceneJob::start() {
  m_thread = std::jthread([this](const std::stop_token& stop) {
    standBack();
    const auto progress = [this, &stop](float done, const std::string& what) {
      report(done, what);
      return !stop.stop_requested();
    };
    auto result = std::make_shared<Result<Loaded>>(sline::widgets::made(m_maker, progress, stop));
    QMetaObject::invokeMethod(
        this, [this, result] { finish(result); }, Qt::QueuedConnection);
  });
}

SceneJob::~SceneJob() {
  cancel();
  if (m_thread.joinable())
    m_thread.join();
}

void SceneJob::cancel() {
  m_thread.request_stop();
}

void SceneJob::report(float done, const std::string& what) {
  using namespace std::chrono;
  constexpr std::int64_t pause = 100;  // as often as an eye can follow; whoever shows it repaints
  const std::int64_t now =
      duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
  std::int64_t last = m_lastReport;
  if (now - last >= pause && m_lastReport.compare_exchange_strong(last, now))
    emit progressed(double(done), QString::fromStdString(what));
}

void SceneJob::finish(const std::shared_ptr<Result<Loaded>>& result) {
  if (m_thread.get_stop_token().stop_requested())
    emit cancelled();
  else if (result->ok())
    emit made(result->value());
  else
    emit failed(result->error());
}

}  // namespace sline::widgets

#include "moc_scene_job.cpp"
