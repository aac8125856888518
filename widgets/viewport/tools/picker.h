// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <functional>
#include <memory>

#include "render/picking/pick_index.h"

namespace sline::widgets {

/// Looks up what lies under the mouse in the background; answers come on the caller's thread.
class Picker : public QObject {
  Q_OBJECT
 public:
  explicit Picker(QObject* parent = nullptr);
  ~Picker() override;

  struct Question {
    model::Scene scene;
    std::vector<model::Ray> rays;
    bool anchored = false;  ///< Picks::anchor is wanted
  };
  using Answer = std::function<void(const render::Picks&)>;
  /// Asks a question; each is answered, in the order of asking.
  void ask(Question question, Answer answer);
  /// Asks a question that is answered unless another of these, or `forget`, comes first; for names
  /// under the mouse.
  void askLatest(Question question, Answer answer);
  /// Asks which structures are seen in a box.
  void askBox(model::Scene scene, const render::PickIndex::Box& box,
              std::function<void(const std::vector<model::NodeId>&)> answer);
  /// Drops the answer to `askLatest`, which is no longer wanted.
  void forget() { ++*m_latest; }

 private:
  std::shared_ptr<render::PickIndex> m_index = std::make_shared<render::PickIndex>();
  std::shared_ptr<std::atomic<int>> m_latest = std::make_shared<std::atomic<int>>(0);
  QThreadPool m_threads;
};

}  // namespace sline::widgets
