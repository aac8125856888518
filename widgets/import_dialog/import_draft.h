// SPDX-License-Identifier: Apache-2.0
// The plan under work: the one owner of what was chosen in the dialog. Plans in the background.
#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "widgets/import_dialog/plan_figures.h"
#include "widgets/session/session.h"

namespace sline::widgets {

class ImportDraft : public QObject {
  Q_OBJECT
 public:
  explicit ImportDraft(QObject* parent = nullptr);
  /// Does not wait for what is under way.
  ~ImportDraft() override;

  /// Reads what is there; `planned` or `failed` follows.
  void begin(std::vector<std::filesystem::path> inputs, const model::ImportOptions& options = {});
  const model::ImportPlan& plan() const { return m_plan; }
  const PlanFigures& figures() const { return *m_figures; }
  /// Whether there is a plan, of the newest choices.
  bool ready() const { return m_plan.read && !m_job; }
  bool planning() const { return m_job != nullptr; }

  void setOptions(const model::ImportOptions& options);
  /// Changes what is chosen of each of the structures. A frame or a unit is of a file: all that
  /// came from the same one take it, too.
  void choose(const NodeIds& ids, const std::function<void(model::StructureChoice&)>& change);
  /// Gives up planning; what was planned before stays.
  void cancel();

 signals:
  void planningBegan();
  /// `done` in [0, 1]; at most ten in a second.
  void progressed(double done, const QString& what);
  /// There is another plan, with other nodes perhaps.
  void planned();
  /// Something was chosen of the nodes or of all; the plan's tree is as it was.
  void chosen();
  void failed(const sline::Error& error);

 private:
  struct Planned {
    model::ImportPlan plan;
    std::shared_ptr<const PlanFigures> figures;
  };
  void start();
  void take(Planned result);

  model::ImportPlan m_plan;
  std::shared_ptr<const PlanFigures> m_figures;
  SceneJob* m_job = nullptr;
};

}  // namespace sline::widgets
