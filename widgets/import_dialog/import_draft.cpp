// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/import_draft.h"

#include <QCoreApplication>
#include <utility>

namespace sline::widgets {

namespace {

bool decidesPlaces(const model::ImportOptions& a, const model::ImportOptions& b) {
  return a.frame != b.frame || a.unit != b.unit || a.overlay != b.overlay || a.repair != b.repair ||
         a.thresholds != b.thresholds || a.patients != b.patients ||
         a.keepFileNames != b.keepFileNames;
}

}  // namespace

ImportDraft::ImportDraft(QObject* parent)
    : QObject(parent), m_figures(std::make_shared<const PlanFigures>()) {}

ImportDraft::~ImportDraft() {
  cancel();
}

void ImportDraft::begin(std::vector<std::filesystem::path> inputs,
                        const model::ImportOptions& options) {
  m_plan = {.inputs = std::move(inputs), .options = options};
  start();
}

void ImportDraft::setOptions(const model::ImportOptions& options) {
  const bool again = decidesPlaces(options, m_plan.options);
  m_plan.options = options;
  emit chosen();
  if (again || m_job)
    start();
}

void ImportDraft::choose(const NodeIds& ids,
                         const std::function<void(model::StructureChoice&)>& change) {
  bool places = false;
  const auto write = [this](model::NodeId id, const model::StructureChoice& choice) {
    if (choice == model::StructureChoice())
      m_plan.choices.erase(id);
    else
      m_plan.choices[id] = choice;
  };
  for (const model::NodeId id : ids) {
    const model::StructureChoice before = m_plan.choiceOf(id);
    model::StructureChoice after = before;
    change(after);
    write(id, after);
    places = places || before.frame != after.frame || before.unit != after.unit;
  }
  if (places)
    for (const model::NodeId id : model::ofSameFiles(m_plan, ids)) {
      model::StructureChoice place = m_plan.choiceOf(id);
      model::StructureChoice with = place;
      change(place);
      with.frame = place.frame;
      with.unit = place.unit;
      write(id, with);
    }
  emit chosen();
  if (places || m_job)
    start();
}

void ImportDraft::cancel() {
  if (!m_job)
    return;
  // The job is released at once and deletes itself when its thread has stopped; the dialog may have
  // been destroyed by then.
  m_job->setParent(QCoreApplication::instance());
  connect(m_job, &SceneJob::cancelled, m_job, &QObject::deleteLater);
  m_job->disconnect(this);
  m_job->cancel();
  m_job = nullptr;
}

void ImportDraft::start() {
  cancel();
  const auto result = std::make_shared<Planned>();
  m_job = new SceneJob(
      [request = m_plan, before = m_figures, result](const model::ImportProgress& progress,
                                                     const std::stop_token&) {
        if (!request.read && request.options.patients == model::PatientsWanted::one) {
          result->patients = model::patientsAmong(request.inputs, request.options.limits,
                                                  model::ScannerSlices::read);
          if (result->patients.several())
            return Result<LoadedDocument>(LoadedDocument{});
        }
        Result<model::ImportPlan> plan = model::planAgain(request, progress);
        if (!plan)
          return Result<LoadedDocument>(plan.error());
        result->figures = std::make_shared<const PlanFigures>(figuresOf(*plan, *before));
        result->plan = std::move(*plan);
        return Result<LoadedDocument>(LoadedDocument{});
      },
      this);
  connect(m_job, &SceneJob::progressed, this, &ImportDraft::progressed);
  connect(m_job, &SceneJob::made, this, [this, result] { take(std::move(*result)); });
  connect(m_job, &SceneJob::failed, this, [this](const Error& error) {
    std::exchange(m_job, nullptr)->deleteLater();
    emit failed(error);
  });
  emit planningBegan();
  m_job->start();
}

void ImportDraft::take(Planned result) {
  std::exchange(m_job, nullptr)->deleteLater();
  if (result.patients.several()) {
    const auto goOn = [this](model::PatientsWanted wanted) {
      model::ImportOptions answered = m_plan.options;
      answered.patients = wanted;
      setOptions(answered);
    };
    emit patientsFound({std::move(result.patients), true, goOn});
    return;
  }
  m_plan = std::move(result.plan);
  m_figures = std::move(result.figures);
  emit planned();
}

}  // namespace sline::widgets

#include "moc_import_draft.cpp"
