// SPDX-License-Identifier: Apache-2.0
// Holds the plan that the dialog edits, as the one owner of its choices. Plans in the background.
#pragma once

#include <QObject>
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
  /// Does not wait for planning that is under way.
  ~ImportDraft() override;

  /// Reads what the plan has not read, and plans; `planned` or `failed` follows.
  void begin(model::ImportPlan plan);
  const model::ImportPlan& plan() const { return m_plan; }
  const PlanFigures& figures() const { return *m_figures; }
  /// Tells whether there is a plan for the newest choices.
  bool ready() const { return model::isRead(m_plan) && !m_job; }
  bool planning() const { return m_job != nullptr; }

  void setOptions(const model::ImportOptions& options);
  /// Changes the choices for each of the structures. Frame and unit belong to a file, so every
  /// structure from the same file takes them too.
  void choose(const NodeIds& ids, const std::function<void(model::StructureChoice&)>& change);
  /// Stops planning; the previous plan stays.
  void cancel();

 signals:
  void planningBegan();
  /// Tells `done` in [0, 1]; at most ten times a second.
  void progressed(double done, const QString& what);
  /// Tells that there is another plan, perhaps with other nodes.
  void planned();
  /// Tells that a choice was made for some nodes or for all; the plan's tree is unchanged.
  void chosen();
  void failed(const sline::Error& error);
  /// Tells that the inputs are of several patients, before they are read.
  void patientsFound(const sline::widgets::PatientQuestion& question);

 private:
  struct Planned {
    model::ImportPlan plan;
    std::shared_ptr<const PlanFigures> figures;
    model::Patients patients = {};  ///< instead of the others
  };
  void start();
  void take(Planned result);

  model::ImportPlan m_plan;
  std::shared_ptr<const PlanFigures> m_figures;
  SceneJob* m_job = nullptr;
};

}  // namespace sline::widgets
