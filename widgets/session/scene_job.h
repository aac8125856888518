// SPDX-License-Identifier: Apache-2.0
// Reading or modelling a scene on a thread of its own, with progress and cancel.
#pragma once

#include <QObject>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <thread>

#include "model/base/result.h"
#include "model/import/plan/import.h"
#include "widgets/session/document.h"

namespace sline::widgets {

/// Makes a scene; calls the progress now and then and gives up where that says false, or as soon as
/// stop is asked for. What it gives then is thrown away.
using SceneMaker =
    std::function<Result<Loaded>(const model::ImportProgress&, const std::stop_token&)>;

class SceneJob : public QObject {
  Q_OBJECT
 public:
  explicit SceneJob(SceneMaker maker, QObject* parent = nullptr);
  /// Once, when all that listen are connected.
  void start();
  /// Cancels, and waits until the maker has noticed.
  ~SceneJob() override;

  /// The maker is asked to give up; nothing but `cancelled` follows.
  void cancel();

 signals:
  /// `done` in [0, 1]; at most ten in a second.
  void progressed(double done, const QString& what);
  void made(const sline::widgets::Loaded& loaded);
  void failed(const sline::Error& error);
  void cancelled();

 private:
  void report(float done, const std::string& what);
  void finish(const std::shared_ptr<Result<Loaded>>& result);

  std::atomic<std::int64_t> m_lastReport = 0;  ///< milliseconds of the steady clock
  SceneMaker m_maker;
  std::jthread m_thread;
};

}  // namespace sline::widgets
