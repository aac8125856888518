// SPDX-License-Identifier: Apache-2.0
// Runs a long piece of work on a thread of its own.
#pragma once

#include <QObject>
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string_view>
#include <thread>

#include "model/base/result.h"

namespace sline::widgets {

/// Runs its work once and emits its signals on the thread on which it was made.
class BackgroundJob : public QObject {
  Q_OBJECT
 public:
  /// Reports how much is done, in [0, 1], and what is being done; returns false where the work must
  /// end.
  using Progress = std::function<bool(double done, std::string_view what)>;
  /// Does the work; where it gave up, it returns an error, whatever that says.
  using Work = std::function<Status(const Progress&)>;

  explicit BackgroundJob(Work work, QObject* parent = nullptr);
  ~BackgroundJob() override;

  /// Starts the work; to be called once, when all receivers are connected.
  void start();
  /// Asks the work to stop; only `cancelled` follows, or `done` if the work was already over.
  void cancel();

 signals:
  /// Tells the progress, at most ten times a second.
  void progressed(double done, const QString& what);
  void done();
  void failed(const sline::Error& error);
  void cancelled();

 protected:
  /// Cancels, and waits until the work has stopped. A class with members that the work uses must
  /// call it in its destructor.
  void end();
  /// Returns true, from any thread, once the job has been cancelled.
  bool stopped() const { return m_stop.stop_requested(); }
  std::stop_token stopToken() const { return m_stop.get_token(); }

 private:
  bool report(double done, std::string_view what);
  void finish(const std::optional<Error>& error);

  Work m_work;
  std::stop_source m_stop;
  std::atomic<std::int64_t> m_lastReport = 0;  ///< milliseconds of the steady clock
  std::thread m_thread;
};

/// Advises the user where the work could not go on.
struct JobAdvice {
  const char* memory = "";   ///< there was too little memory
  const char* library = "";  ///< a library threw an unexpected exception
};
/// Runs the work and turns exceptions into errors that the user can understand.
Status caught(const std::function<Status()>& work, const JobAdvice& advice);

}  // namespace sline::widgets
