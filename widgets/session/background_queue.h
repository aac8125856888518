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

/// Work on one thread of its own that lets the window go first, one piece after the other.
class BackgroundQueue : public QObject {
  Q_OBJECT
 public:
  /// What is to follow on the thread that this object belongs to; empty: nothing.
  using Sequel = std::function<void()>;
  using Work = std::function<Sequel(const std::stop_token&)>;

  explicit BackgroundQueue(QObject* parent = nullptr);
  /// Does all that was asked for, but drops the sequels.
  ~BackgroundQueue() override;

  void add(Work work);
  /// What has not begun is not done, and what is under way is asked to stop.
  void drop();
  /// True until the sequel of the last piece was run.
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
