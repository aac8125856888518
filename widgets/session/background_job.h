// SPDX-License-Identifier: Apache-2.0
// A long piece of work on a thread of its own.
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

/// Runs once; whoever made it hears from it on the thread it was made on.
class BackgroundJob : public QObject {
  Q_OBJECT
 public:
  /// Tells how much is done, in [0, 1], and what is being done; false where the work is to end.
  using Progress = std::function<bool(double done, std::string_view what)>;
  /// Returns an error, whatever it says, where it gave up.
  using Work = std::function<Status(const Progress&)>;

  explicit BackgroundJob(Work work, QObject* parent = nullptr);
  ~BackgroundJob() override;

  /// Once, when all that listen are connected.
  void start();
  /// The work is asked to give up; nothing but `cancelled` follows, or `done` where it was over.
  void cancel();

 signals:
  /// At most ten in a second.
  void progressed(double done, const QString& what);
  void done();
  void failed(const sline::Error& error);
  void cancelled();

 protected:
  /// Cancels, and waits until the work has noticed. To be called by the destructor of each class
  /// whose members the work uses.
  void end();
  /// True from any thread once somebody has cancelled.
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

/// What a person can do where the work could not go on.
struct JobAdvice {
  const char* memory = "";   ///< there was too little
  const char* library = "";  ///< one threw what nobody expected
};
/// Runs the work; what it throws becomes an error that a person can read.
Status caught(const std::function<Status()>& work, const JobAdvice& advice);

}  // namespace sline::widgets
