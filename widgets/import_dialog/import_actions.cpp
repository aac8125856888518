// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/import_actions.h"

#include <QAction>
#include <QFileInfo>
#include <QPointer>
#include <QSettings>
#include <algorithm>

#include "model/edit/settled_units.h"
#include "model/scene_file/scene_file.h"
#include "widgets/import_dialog/choice_rows.h"
#include "widgets/import_dialog/patients_question.h"
#include "widgets/preferences/preferences.h"
#include "widgets/shell/file_dialogs.h"
#include "widgets/shell/message_bar.h"
#include "widgets/shell/window_actions.h"

namespace sline::widgets {

namespace {

constexpr const char* alwaysKey = "files/importOptions";

std::vector<std::filesystem::path> pathsOf(const QStringList& texts) {
  std::vector<std::filesystem::path> paths;
  for (const QString& text : texts)
    paths.emplace_back(text.toStdString());
  return paths;
}

/// Tells whether all inputs are scene files, which themselves say how they are to be read.
bool onlyScenes(const std::vector<std::filesystem::path>& paths) {
  return std::all_of(paths.begin(), paths.end(),
                     [](const std::filesystem::path& path) { return model::isSceneFile(path); });
}

}  // namespace

ImportActions::ImportActions(const Context& context, QWidget& window)
    : QObject(&window),
      m_session(context.session),
      m_settings(context.settings),
      m_preferences(context.preferences),
      m_actions(context.actions),
      m_message(context.message),
      m_window(window),
      m_takeUnit(new QAction(this)),
      m_keepSize(new QAction(tr("The Size Is Right"), this)) {
  connectActions();
  connect(&m_session, &Session::documentChanged, this,
          [this](const Document&, const Document& now) {
            updateActions();
            // The doubt goes with what was doubted, however it goes.
            if (m_doubted == now.opening && !model::hasDoubtedUnits(now.scene)) {
              m_doubted = 0;
              m_message.hideRemarks();
            }
          });
  connect(&m_session, &Session::remarked, this, &ImportActions::offer);
  connect(&m_session, &Session::patientsFound, this,
          [this](const PatientQuestion& question) { askAboutPatients(m_window, question); });
  updateActions();
}

void ImportActions::connectActions() {
  const auto on = [this](const char* id, auto function) {
    connect(&m_actions[QLatin1String(id)], &QAction::triggered, this, function);
  };
  on("importFiles", [this] { choose(false); });
  on("importFolder", [this] { choose(true); });
  on("importAgain", [this] { show(m_session.sources()); });
  connect(m_takeUnit, &QAction::triggered, this, &ImportActions::takeUnit);
  connect(m_keepSize, &QAction::triggered, this, [this] {
    m_session.apply(tr("The size is right"), model::withUnitsSettled(m_session.scene()));
    m_message.hideRemarks();
  });
}

void ImportActions::offer() {
  QAction& again = m_actions[QStringLiteral("importAgain")];
  const int opening = m_session.document().opening;
  if (std::exchange(m_offered, opening) == opening)
    return;
  if (again.isEnabled())
    m_message.offer(again);
  if (!model::hasDoubtedUnits(m_session.scene()))
    return;
  m_doubted = opening;
  const std::vector<model::UnitDoubt> doubts = m_session.unitDoubts();
  // One unit for all that was opened: where files differ, the dialog has them one by one.
  if (doubts.size() == 1 && doubts.front().file.empty() && !doubts.front().units.empty()) {
    m_takeUnit->setText(tr("Take %1 as the Unit").arg(unitText(doubts.front().units.front())));
    m_message.offer(*m_takeUnit);
  }
  m_message.offerOther(*m_keepSize);
}

void ImportActions::takeUnit() {
  const std::vector<model::UnitDoubt> doubts = m_session.unitDoubts();
  if (doubts.empty() || doubts.front().units.empty())
    return;
  m_guard([this, unit = doubts.front().units.front()] {
    m_session.openPaths(m_session.sources(), {.unit = unit});
  });
}

void ImportActions::updateActions() {
  const std::vector<std::filesystem::path> sources = m_session.sources();
  m_actions[QStringLiteral("importAgain")].setEnabled(!sources.empty() && !onlyScenes(sources));
}

bool ImportActions::asksFor(const QStringList& paths, Qt::KeyboardModifiers keys) {
  const std::vector<std::filesystem::path> inputs = pathsOf(paths);
  const bool wanted =
      keys.testFlag(Qt::ShiftModifier) || m_preferences.isOn(QLatin1String(alwaysKey));
  if (!wanted || inputs.empty() || onlyScenes(inputs))
    return false;
  m_settings.setValue(QLatin1String(lastFolderKey), QFileInfo(paths.front()).absolutePath());
  show(inputs);
  return true;
}

void ImportActions::choose(bool folder) {
  const QString start = m_settings.value(QLatin1String(lastFolderKey)).toString();
  const auto showThese = [this](const QStringList& paths) {
    m_settings.setValue(QLatin1String(lastFolderKey), QFileInfo(paths.front()).absolutePath());
    show(pathsOf(paths));
  };
  if (folder)
    chooseFolder(m_window, start, showThese);
  else
    chooseFiles(m_window, start, showThese);
}

void ImportActions::show(std::vector<std::filesystem::path> inputs) {
  if (m_dialog)
    m_dialog->reject();
  m_dialog = new ImportDialog(m_session.names(), std::move(inputs),
                              m_session.document().opening != 0, &m_window);
  m_dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(m_dialog, &ImportDialog::importWanted, this, [this](const model::ImportPlan& plan) {
    m_guard([this, plan] { carryOut(plan, false); });
  });
  connect(m_dialog, &ImportDialog::addWanted, this,
          [this](const model::ImportPlan& plan) { carryOut(plan, true); });
  m_dialog->open();
}

void ImportActions::carryOut(const model::ImportPlan& plan, bool intoScene) {
  std::vector<std::filesystem::path> all = m_session.sources();
  all.insert(all.end(), plan.inputs.begin(), plan.inputs.end());
  const auto together = [self = QPointer(this), plan](model::PatientsWanted wanted) {
    if (!self)
      return;  // the window's controls were made anew meanwhile
    model::ImportPlan answered = plan;
    answered.options.patients = wanted;
    self->carryOut(answered, true);
  };
  m_session.openMade(
      titleOf(plan.inputs), [plan, intoScene, all, together](const model::ImportProgress& progress,
                                                             const std::stop_token&) {
        // What is open may be of another patient than what is added.
        if (intoScene && plan.options.patients != model::PatientsWanted::together)
          if (model::Patients patients =
                  model::patientsAmong(all, plan.options.limits, model::ScannerSlices::read);
              patients.several())
            return Result<LoadedDocument>(
                LoadedDocument{.question = PatientQuestion{std::move(patients), false, together}});
        Result<model::Imported> imported = model::carryOut(plan, progress);
        if (!imported.ok())
          return Result<LoadedDocument>(imported.error());
        LoadedDocument loaded = loadedDocument(std::move(*imported), plan.inputs);
        loaded.added = intoScene;
        return Result<LoadedDocument>(std::move(loaded));
      });
}

}  // namespace sline::widgets

#include "moc_import_actions.cpp"
