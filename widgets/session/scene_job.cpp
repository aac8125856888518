// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/scene_job.h"

#include <utility>

namespace sline::widgets {

SceneJob::SceneJob(SceneMaker maker, QObject* parent)
    : BackgroundJob([this](const Progress& progress) { return make(progress); }, parent),
      m_maker(std::move(maker)) {
  connect(this, &BackgroundJob::done, this, [this] { emit made(*m_loaded); });
}

Status SceneJob::make(const Progress& progress) {
  return caught(
      [&]() -> Status {
        LoadedDocument result = TRY(m_maker(
            [&](float done, const std::string& what) { return progress(double(done), what); },
            stopToken()));
        // A result that was made meanwhile is no longer wanted.
        if (stopped())
          return Error{.reason = "cancelled"};
        m_loaded = std::make_unique<LoadedDocument>(std::move(result));
        return Unit{};
      },
      {.memory = "Close other programs or open fewer files",
       .library = "Open the files one by one to see which it is"});
}

}  // namespace sline::widgets

#include "moc_scene_job.cpp"
