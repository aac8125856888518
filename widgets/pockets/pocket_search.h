// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "model/pockets/scene_pockets.h"
#include "widgets/session/background_queue.h"
#include "widgets/session/session.h"

namespace sline::widgets {

/// Finds the pockets of the document's molecules in the background, and again when their chains or
/// the options have changed, while someone wants to know them.
class PocketSearch : public QObject {
  Q_OBJECT
 public:
  explicit PocketSearch(Session& session, QObject* parent = nullptr);
  /// Stops a search that is under way.
  ~PocketSearch() override { m_queue.drop(); }

  /// Tells whether any structure keeps its atoms.
  bool hasMolecules() const { return !m_chains.empty(); }
  bool busy() const { return m_busy; }
  /// Returns what was found last; null where that does not belong to the document any more.
  const std::shared_ptr<const model::ScenePockets>& found() const { return m_found; }
  /// Returns why there is no answer; empty where there is one, or none was asked for.
  const QString& fault() const { return m_fault; }
  const model::PocketOptions& options() const { return m_options; }

  /// Says whether pockets are looked for at all.
  void setWanted(bool wanted);
  void setOptions(const model::PocketOptions& options);
  void cancel();
  /// Makes the pocket's room in the background; `roomMade` follows.
  void makeRoom(std::size_t pocket);

 signals:
  void changed();
  void roomMade(const std::shared_ptr<const sline::model::ScenePockets>& found, std::size_t pocket,
                const sline::model::MeshPtr& room);

 private:
  using Chains = std::vector<std::pair<model::NodeId, std::shared_ptr<const model::AtomSet>>>;
  static Chains chainsOf(const model::Scene& scene);
  void follow();
  void search();
  void take(int question, Result<model::ScenePockets> answer);

  Session& m_session;
  Chains m_chains;
  model::PocketOptions m_options;
  std::shared_ptr<const model::ScenePockets> m_found;
  QString m_fault;
  bool m_wanted = false;
  bool m_busy = false;
  bool m_cancelled = false;
  int m_question = 0;
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
