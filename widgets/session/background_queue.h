// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace sline::widgets {

/// Runs pieces of work one after the other on one thread of its own, which gives way to the window.
class BackgroundQueue : public QObject {
  Q_OBJECT
 public:
  /// Follows on the thread that this object belongs to; may be empty.
  using Sequel = std::function<void()>;
  using Work = std::function<Sequel(const std::stop_token&)>;

  explicit BackgroundQueue(QObject* parent = nullptr);
  /// Does all that was asked for, but drops the sequels.
  ~BackgroundQueue() override;

  void add(Work work);
  /// Drops the work that has not begun, and asks the running piece to stop.
  void drop();
  /// Returns true until the sequel of the last piece has run.
  bool busy() const { return m_unfinished > 0; }

 private:
  void run();
  void finish(const Sequel& sequel);

  std::mutex m_mutex;
  std::condition_variable m_wake;
  std::deque<Work> m_work;
  std::stop_source m_stop;
  bool m_quit = false;
  int m_unfinished = 0;
  std::thread m_thread;
};

}  // namespace sline::widgets
