// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <functional>
#include <memory>

#include "widgets/viewport/tools/pick_index.h"

namespace sline::widgets {

/// Where a person points: rays through the pixel and around it, within which lines count.
std::vector<model::Ray> sightsAround(const model::Camera& camera, const glm::vec2& pixel,
                                     const glm::vec2& size);

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
  using Answer = std::function<void(const Picks&)>;
  /// Every one of these is answered, in their order.
  void ask(Question question, Answer answer);
  /// Answered unless another of these, or `forget`, comes before; for names under the mouse.
  void askLatest(Question question, Answer answer);
  /// Nobody wants the answer to `askLatest` any more.
  void forget() { ++*m_latest; }

 private:
  std::shared_ptr<PickIndex> m_index = std::make_shared<PickIndex>();
  std::shared_ptr<std::atomic<int>> m_latest = std::make_shared<std::atomic<int>>(0);
  QThreadPool m_threads;
};

}  // namespace sline::widgets
