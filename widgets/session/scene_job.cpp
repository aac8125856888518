// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/scene_job.h"

#include <exception>
#include <new>

namespace sline::widgets {

namespace {

/// What a library threw ends here as an error a person can read.
Result<Loaded> made(const SceneMaker& maker, const model::ImportProgress& progress) {
  try {
    return maker(progress);
  } catch (const std::bad_alloc&) {
    return Error{.reason = "there is not enough memory",
                 .remedy = "Close other programs or open fewer files"};
  } catch (const std::exception& failure) {
    return Error{.reason = std::string("a library failed: ") + failure.what(),
                 .remedy = "Open the files one by one to see which it is"};
  }
}

}  // namespace

SceneJob::SceneJob(SceneMaker maker, QObject* parent) : QObject(parent) {
  m_thread = std::thread([this, maker = std::move(maker)] {
    const auto progress = [this](float done, const std::string& what) {
      return report(done, what);
    };
    auto result = std::make_shared<Result<Loaded>>(sline::widgets::made(maker, progress));
    QMetaObject::invokeMethod(
        this, [this, result] { finish(result); }, Qt::QueuedConnection);
  });
}

SceneJob::~SceneJob() {
  cancel();
  m_thread.join();
}

void SceneJob::cancel() {
  m_cancelled = true;
}

bool SceneJob::report(float done, const std::string& what) {
  const int percent = int(100.0f * done);
  if (m_percent.exchange(percent) != percent)
    emit progressed(double(done), QString::fromStdString(what));
  return !m_cancelled;
}

void SceneJob::finish(const std::shared_ptr<Result<Loaded>>& result) {
  if (m_cancelled)
    emit cancelled();
  else if (result->ok())
    emit made(result->value());
  else
    emit failed(result->error());
}

}  // namespace sline::widgets
