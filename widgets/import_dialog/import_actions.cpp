// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/import_actions.h"

#include <QAction>
#include <QFileInfo>
#include <QPointer>
#include <QSettings>
#include <algorithm>
#include <map>

#include "model/edit/settled_units.h"
#include "model/import/plan/scene_inputs.h"
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

/// Joins what was imported after the first with it.
void join(LoadedDocument& all, LoadedDocument& more) {
  if (more.frameAnew)
    all.scene = model::withFrameAnew(all.scene, *more.frameAnew).scene;
  model::append(all.scene, more.scene);
  all.remarks += more.remarks;
  const auto take = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  take(all.paths, more.paths);
  take(all.unitDoubts, more.unitDoubts);
  take(all.recipes, more.recipes);
}

/// Says which surfaces lie otherwise in the open scene than the plan shows for them alone.
QStringList otherwiseRead(const model::ImportPlan& alone, const model::ImportPlan& into) {
  std::map<std::size_t, std::string> shown;
  for (const auto& [id, number] : alone.parts)
    if (const model::Node* node = alone.scene.find(id))
      shown[number] = node->provenance.frame;
  std::map<std::string, int> others;
  for (const auto& [id, number] : into.parts)
    if (const std::string& frame = into.scene.find(id)->provenance.frame;
        shown.contains(number) && shown.at(number) != frame)
      ++others[frame];
  QStringList remarks;
  for (const auto& [frame, count] : others)
    remarks << ImportActions::tr(
                   "%n structures were read as %1, unlike alone: so they go with the "
                   "open scene",
                   nullptr, count)
                   .arg(QString::fromStdString(frame));
  return remarks;
}

/// Imports by the plan what is to be added to the scene.
Result<LoadedDocument> addedTo(const std::shared_ptr<const model::Scene>& open,
                               const model::ImportPlan& alone,
                               const model::ImportProgress& progress) {
  model::ImportPlan request = alone;
  request.options.into = open;
  const model::ImportPlan plan = TRY(model::planAgain(request, progress));
  model::Imported imported = TRY(model::carryOut(plan, progress));
  LoadedDocument loaded = loadedDocument(std::move(imported), plan);
  loaded.remarks << otherwiseRead(alone, plan);
  loaded.added = true;
  return loaded;
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
  connect(&m_session, &Session::scansFound, this,
          [this](const std::shared_ptr<const model::ImportPlan>& plan) { show(*plan); });
  updateActions();
}

void ImportActions::connectActions() {
  const auto on = [this](const char* id, auto function) {
    connect(&m_actions[QLatin1String(id)], &QAction::triggered, this, function);
  };
  on("importFiles", [this] { choose(false); });
  on("importFolder", [this] { choose(true); });
  on("importAgain", [this] { importAgain(); });
  connect(m_takeUnit, &QAction::triggered, this, &ImportActions::takeUnit);
  connect(m_keepSize, &QAction::triggered, this, [this] {
    m_session.apply(tr("The size is right"), model::withUnitsSettled(m_session.scene()));
    m_message.hideRemarks();
  });
}

void ImportActions::offer() {
  QAction& again = m_actions[QStringLiteral("importAgain")];
  const std::pair now(m_session.document().opening, m_session.sources().size());
  if (std::exchange(m_offered, now) == now)
    return;
  if (again.isEnabled())
    m_message.offer(again);
  if (!model::hasDoubtedUnits(m_session.scene()))
    return;
  m_doubted = now.first;
  const std::vector<model::UnitDoubt> doubts = m_session.unitDoubts();
  // One unit for all that was opened: where files differ, the dialog has them one by one.
  if (doubts.size() == 1 && doubts.front().file.empty() && !doubts.front().units.empty() &&
      !m_session.recipes().empty()) {
    m_takeUnit->setText(tr("Take %1 as the Unit").arg(unitText(doubts.front().units.front())));
    m_message.offer(*m_takeUnit);
  }
  m_message.offerOther(*m_keepSize);
}

namespace {

/// Imports one after the other again, each into what was there before, with the likeliest units.
Result<LoadedDocument> withLikelyUnits(const std::vector<ImportRecipe>& recipes,
                                       const model::ImportProgress& progress) {
  std::optional<LoadedDocument> all;
  for (const ImportRecipe& recipe : recipes) {
    model::ImportPlan request = *recipe;
    if (all)
      request.options.into = std::make_shared<const model::Scene>(all->scene);
    model::ImportPlan plan = TRY(model::planAgain(request, progress));
    model::chooseLikelyUnits(plan);
    model::Imported imported = TRY(model::carryOut(plan, progress));
    LoadedDocument loaded = loadedDocument(std::move(imported), plan);
    if (all)
      join(*all, loaded);
    else
      all = std::move(loaded);
  }
  return all ? std::move(*all) : LoadedDocument();
}

}  // namespace

void ImportActions::takeUnit() {
  const std::vector<ImportRecipe> recipes = m_session.recipes();
  if (recipes.empty())
    return;
  m_guard([this, recipes] {
    m_session.openMade(titleOf(m_session.sources()),
                       [recipes](const model::ImportProgress& progress, const std::stop_token&) {
                         return withLikelyUnits(recipes, progress);
                       });
  });
}

void ImportActions::importAgain() {
  const std::vector<ImportRecipe> recipes = m_session.recipes();
  if (recipes.size() == 1)
    return show(*recipes.front());
  // Choices for single structures are those of one import; the rest is as it was in the first.
  model::ImportPlan plan{.inputs = m_session.sources()};
  if (!recipes.empty())
    plan.options = recipes.front()->options;
  show(std::move(plan));
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
  show({.inputs = inputs});
  return true;
}

void ImportActions::choose(bool folder) {
  const QString start = m_settings.value(QLatin1String(lastFolderKey)).toString();
  const auto showThese = [this](const QStringList& paths) {
    m_settings.setValue(QLatin1String(lastFolderKey), QFileInfo(paths.front()).absolutePath());
    show({.inputs = pathsOf(paths)});
  };
  if (folder)
    chooseFolder(m_window, start, showThese);
  else
    chooseFiles(m_window, start, showThese);
}

void ImportActions::show(model::ImportPlan plan) {
  if (m_dialog)
    m_dialog->reject();
  m_dialog = new ImportDialog(m_session.names(), std::move(plan), m_session.document().opening != 0,
                              &m_window);
  m_dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(m_dialog, &ImportDialog::importWanted, this, [this](const model::ImportPlan& plan) {
    m_guard([this, plan] { carryOut(plan, false); });
  });
  connect(m_dialog, &ImportDialog::addWanted, this,
          [this](const model::ImportPlan& plan) { carryOut(plan, true); });
  m_dialog->open();
}

void ImportActions::carryOut(const model::ImportPlan& plan, bool intoScene) {
  if (!intoScene) {
    m_session.openMade(titleOf(plan.inputs), [plan](const model::ImportProgress& progress,
                                                    const std::stop_token&) {
      Result<model::Imported> imported = model::carryOut(plan, progress);
      return imported.ok() ? Result<LoadedDocument>(loadedDocument(std::move(*imported), plan))
                           : Result<LoadedDocument>(imported.error());
    });
    return;
  }
  const auto together = [self = QPointer(this), plan](model::PatientsWanted wanted) {
    if (!self)
      return;  // the window's controls were made anew meanwhile
    model::ImportPlan answered = plan;
    answered.options.patients = wanted;
    self->carryOut(answered, true);
  };
  // The scene knows of its files what they say of their studies; the files themselves, where they
  // are still there, say more.
  std::vector<std::filesystem::path> all = m_session.sources();
  std::erase_if(all, [](const std::filesystem::path& file) { return model::isSceneFile(file); });
  all.insert(all.end(), plan.inputs.begin(), plan.inputs.end());
  const auto open = std::make_shared<const model::Scene>(m_session.scene());
  m_session.openMade(
      titleOf(plan.inputs),
      [plan, open, all, together](const model::ImportProgress& progress, const std::stop_token&) {
        if (plan.options.patients != model::PatientsWanted::together)
          if (model::Patients patients = model::patientsAmong(
                  all, plan.options.limits, model::ScannerSlices::read, open.get());
              patients.several())
            return Result<LoadedDocument>(
                LoadedDocument{.question = PatientQuestion{std::move(patients), false, together}});
        return addedTo(open, plan, progress);
      });
}

}  // namespace sline::widgets

#include "moc_import_actions.cpp"
