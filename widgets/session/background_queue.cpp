// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/background_queue.h"

#include "model/disk/process.h"

namespace sline::widgets {

BackgroundQueue::BackgroundQueue(QObject* parent) : QObject(parent) {}

BackgroundQueue::~BackgroundQueue() {
  {
    const std::lock_guard guard(m_mutex);
    m_quit = true;
  }
  m_wake.notify_one();
  if (m_thread.joinable())
    m_thread.join();
}

void BackgroundQueue::add(Work work) {
  ++m_unfinished;
  {
    const std::lock_guard guard(m_mutex);
    m_work.push_back(std::move(work));
  }
  if (!m_thread.joinable())
    m_thread = std::thread([this] { run(); });
  m_wake.notify_one();
}

void BackgroundQueue::drop() {
  const std::lock_guard guard(m_mutex);
  m_unfinished -= int(m_work.size());
  m_work.clear();
  m_stop.request_stop();
  m_stop = {};
}

void BackgroundQueue::run() {
  model::standBack();
  for (;;) {
    std::unique_lock guard(m_mutex);
    m_wake.wait(guard, [this] { return m_quit || !m_work.empty(); });
    if (m_work.empty())
      return;
    const Work work = std::move(m_work.front());
    m_work.pop_front();
    const std::stop_token stop = m_stop.get_token();
    guard.unlock();
    Sequel sequel = work(stop);
    QMetaObject::invokeMethod(
        this, [this, sequel = std::move(sequel)] { finish(sequel); }, Qt::QueuedConnection);
  }
}

void BackgroundQueue::finish(const Sequel& sequel) {
  --m_unfinished;
  if (sequel)
    sequel();
}

}  // namespace sline::widgets

#include "moc_background_queue.cpp"
