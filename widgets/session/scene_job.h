// SPDX-License-Identifier: Apache-2.0
// Reads or models a scene on a thread of its own, with progress and cancel.
#pragma once

#include <functional>
#include <memory>

#include "model/import/plan/import.h"
#include "widgets/session/background_job.h"
#include "widgets/session/document.h"

namespace sline::widgets {

/// Makes a scene; calls the progress now and then and stops where that returns false, or as soon as
/// a stop is requested. Its result is discarded then.
using SceneMaker =
    std::function<Result<LoadedDocument>(const model::ImportProgress&, const std::stop_token&)>;

class SceneJob : public BackgroundJob {
  Q_OBJECT
 public:
  explicit SceneJob(SceneMaker maker, QObject* parent = nullptr);
  ~SceneJob() override { end(); }

 signals:
  void made(const sline::widgets::LoadedDocument& loaded);

 private:
  Status make(const Progress& progress);

  SceneMaker m_maker;
  std::unique_ptr<LoadedDocument> m_loaded;  ///< belongs to the thread until the job is done
};

}  // namespace sline::widgets
