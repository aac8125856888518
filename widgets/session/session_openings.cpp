// SPDX-License-Identifier: Apache-2.0
// Opens, adds, reloads and closes what the document is made of.
#include <algorithm>
#include <filesystem>
#include <utility>

#include "model/edit/look.h"
#include "model/edit/settled_units.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/plan/read_inputs.h"
#include "model/import/plan/reload_patients.h"
#include "model/import/plan/scene_inputs.h"
#include "widgets/session/session.h"

namespace sline::widgets {

namespace {

Result<LoadedDocument> loadedDocument(Result<ReadDocument> read, const QString& title) {
  if (!read.ok())
    return read.error();
  return LoadedDocument{.scene = std::move(read->scene),
                        .title = title,
                        .remarks = {},
                        .file = std::move(read->file),
                        .recovered = std::move(read->recovered)};
}

QStringList remarksOf(const model::Reloaded& reloaded) {
  QStringList remarks;
  const auto renewed = int(reloaded.meshes.size());
  remarks << (renewed == 0 ? Session::tr("No file that could be read again has changed")
                           : Session::tr("%n structures were read again", nullptr, renewed));
  for (const model::ReloadedFile& file : reloaded.files)
    if (!file.reason.empty())
      remarks << QString::fromStdString(file.file + ": " + file.reason);
  for (const model::ImportWarning& warning : reloaded.warnings)
    remarks << QString::fromStdString(warning.file + ": " + warning.reason);
  return remarks;
}

/// Tells whether a file was not read because of whose it is now.
bool refusedPatients(const model::Reloaded& reloaded) {
  return std::any_of(
      reloaded.files.begin(), reloaded.files.end(),
      [](const model::ReloadedFile& file) { return file.reason == model::otherPatientNow; });
}

/// Returns where to look for files again, because scenes refer to files beside them.
std::vector<std::filesystem::path> placesOf(std::vector<std::filesystem::path> sources) {
  for (std::filesystem::path& path : sources)
    if (!model::isSurfaceFile(path) && !std::filesystem::is_directory(path))
      path = path.parent_path();
  return sources;
}

using Patients = model::PatientsWanted;

/// Reads the sources again. Where files of the scene have become another patient's it asks first,
/// if there is a way to go on from the answer.
SceneMaker reloaderOf(const model::Scene& scene, const std::vector<std::filesystem::path>& places,
                      Patients wanted, const std::function<void(Patients)>& answered = {}) {
  return [scene, places, wanted, answered](const model::ImportProgress& progress,
                                           const std::stop_token&) {
    const model::ReadOptions options{.goesOn = [&progress] { return progress(0.0f, {}); }};
    model::Reloaded reloaded = model::reload(scene, places, options, wanted);
    if (answered && refusedPatients(reloaded))
      return Result<LoadedDocument>(
          LoadedDocument{.question = PatientQuestion{
                             model::patientsToReload(scene, places, options), true, answered}});
    return Result<LoadedDocument>(
        LoadedDocument{.remarks = remarksOf(reloaded), .renewed = std::move(reloaded.meshes)});
  };
}

/// Makes structures hide what is behind them unless the scene sets a fill, because a drawing in a
/// window is read as solid.
model::Scene solid(const model::Scene& scene) {
  NodeIds top;
  for (const model::Node& node : scene.nodes()) {
    if (node.style.fill)
      return scene;
    if (node.parent == model::rootId)
      top.push_back(node.id);
  }
  return model::withLook(scene, top, {.fill = model::Fill::paper}).scene;
}

/// Returns a plan of what could not be imported because it holds nothing but scans, for which
/// nobody has given a threshold; null where that is not so.
std::shared_ptr<const model::ImportPlan> scansAlone(const std::vector<std::filesystem::path>& paths,
                                                    const model::ImportOptions& options,
                                                    const model::ImportProgress& progress) {
  if (!model::mayHoldScans(paths, options.limits))
    return nullptr;
  Result<model::ImportPlan> plan = model::planImport(paths, options, progress);
  if (!plan.ok() || plan->read->scans.empty())
    return nullptr;
  return std::make_shared<const model::ImportPlan>(std::move(*plan));
}

}  // namespace

void Session::openPaths(std::vector<std::filesystem::path> paths,
                        const model::ImportOptions& options) {
  const QString title = titleOf(paths);
  const auto again = [this, paths, options](model::PatientsWanted wanted) {
    model::ImportOptions answered = options;
    answered.patients = wanted;
    openPaths(paths, answered);
  };
  startJob(title, [paths = std::move(paths), options, again, title, lock = file().lock](
                      const model::ImportProgress& progress, const std::stop_token&) {
    if (paths.size() == 1 && model::isSceneFile(paths.front())) {
      Result<LoadedDocument> loaded = loadedDocument(readDocument(paths.front(), lock), title);
      if (loaded.ok())
        loaded->paths = paths;
      return loaded;
    }
    if (options.patients == model::PatientsWanted::one)
      if (model::Patients patients =
              model::patientsAmong(paths, options.limits, model::ScannerSlices::leftOut);
          patients.several())
        return Result<LoadedDocument>(
            LoadedDocument{.question = PatientQuestion{std::move(patients), true, again}});
    auto imported = model::importInputs(paths, options, progress);
    if (!imported) {
      if (auto scans = scansAlone(paths, options, progress))
        return Result<LoadedDocument>(LoadedDocument{.scans = std::move(scans)});
      return Result<LoadedDocument>(imported.error());
    }
    return Result<LoadedDocument>(
        loadedDocument(std::move(*imported), {.inputs = paths, .options = options}));
  });
}

std::vector<ImportRecipe> Session::recipes() const {
  const auto found = m_recipes.find(m_document.opening);
  if (found == m_recipes.end())
    return {};
  std::vector<std::filesystem::path> inputs;
  for (const ImportRecipe& recipe : found->second)
    inputs.insert(inputs.end(), recipe->inputs.begin(), recipe->inputs.end());
  return inputs == sources() ? found->second : std::vector<ImportRecipe>();
}

std::vector<model::UnitDoubt> Session::unitDoubts() const {
  const auto found = m_unitDoubts.find(m_document.opening);
  return found == m_unitDoubts.end() ? std::vector<model::UnitDoubt>() : found->second;
}

void Session::openMade(const QString& title, SceneMaker maker) {
  startJob(title, std::move(maker));
}

void Session::openRecovered(const model::Recoverable& found) {
  const QString title = QString::fromStdString(found.source.title);
  startJob(title, [found, title, lock = file().lock](const model::ImportProgress&,
                                                     const std::stop_token&) {
    return loadedDocument(readRecovered(found, lock), title);
  });
}

void Session::reloadSources() {
  const auto isTogether = [](const ImportRecipe& recipe) {
    return recipe->options.patients == model::PatientsWanted::together;
  };
  const std::vector<ImportRecipe>& all = m_recipes[m_document.opening];
  const Patients wanted =
      std::any_of(all.begin(), all.end(), isTogether) ? Patients::together : Patients::one;
  const auto answered = [this, opening = m_document.opening](Patients answer) {
    if (m_document.opening == opening)
      startJob(m_document.title, reloaderOf(sceneBeforePreview(), placesOf(sources()), answer));
  };
  startJob(m_document.title,
           reloaderOf(sceneBeforePreview(), placesOf(sources()), wanted, answered));
}

void Session::revert() {
  if (file().path.empty())
    return;
  startJob(title(), [path = file().path, lock = file().lock, opening = m_document.opening](
                        const model::ImportProgress&, const std::stop_token&) {
    Result<LoadedDocument> loaded = loadedDocument(readDocument(path, lock), {});
    if (loaded.ok())
      loaded->reverts = opening;
    return loaded;
  });
}

void Session::openEmpty(const QString& title) {
  cancelJob();
  cancelPreview();
  addOpening({.scene = {}, .title = title}, {.saved = model::Scene()});
}

void Session::closeDocument() {
  cancelJob();
  cancelPreview();
  if (m_document.opening != 0)
    push(tr("Close %1").arg(title()), {}, {});
}

void Session::open(const LoadedDocument& loaded) {
  cancelPreview();
  m_sources[m_openings + 1] = loaded.paths;
  m_unitDoubts[m_openings + 1] = loaded.unitDoubts;
  m_recipes[m_openings + 1] = loaded.recipes;
  DocumentFile file = loaded.file.value_or(DocumentFile());
  // What was being edited comes back as it was.
  Document document{.scene = loaded.recovered ? loaded.scene : solid(loaded.scene),
                    .title = loaded.title};
  if (!file.left)
    file.saved = document.scene;
  if (model::hasNoLook(loaded.scene))
    m_withoutLook.insert(m_openings + 1);
  addOpening(std::move(document), std::move(file));
  if (loaded.recovered)
    restore(*loaded.recovered);
  emit opened(loaded.paths);
  QStringList remarks = loaded.remarks;
  if (loaded.unitDoubts.empty() && model::hasDoubtedUnits(loaded.scene))
    remarks << tr(
        "Nobody has said how long the unit of its files is, and not all has the size that it "
        "should have: lengths stand with a “?”");
  if (!remarks.isEmpty())
    emit remarked(remarks);
}

void Session::restore(const model::Recovered& recovered) {
  const Document first = m_document;
  m_restoring = true;
  const int begin = m_history.index();
  for (std::size_t i = 1; i < recovered.states.size(); ++i) {
    Document after = m_document;
    after.scene = recovered.states[i].scene;
    push(QString::fromStdString(recovered.states[i].name), std::move(after), {});
  }
  m_history.setIndex(begin + int(recovered.current));
  m_restoring = false;
  Document now = std::exchange(m_document, first);
  set(std::move(now));
  select(recovered.selection);
}

void Session::add(const LoadedDocument& loaded) {
  cancelPreview();
  model::Scene together = loaded.frameAnew
                              ? model::withFrameAnew(m_document.scene, *loaded.frameAnew).scene
                              : m_document.scene;
  std::vector<model::NodeId> fresh;
  for (const auto& [old, id] : model::append(together, solid(loaded.scene)))
    if (old != model::rootId)
      fresh.push_back(id);
  if (!apply(tr("Add %1").arg(loaded.title), {std::move(together), true}))
    return;
  std::vector<std::filesystem::path>& sources = m_sources[m_document.opening];
  sources.insert(sources.end(), loaded.paths.begin(), loaded.paths.end());
  const auto take = [](auto& all, const auto& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  take(m_recipes[m_document.opening], loaded.recipes);
  take(m_unitDoubts[m_document.opening], loaded.unitDoubts);
  select(fresh);
  if (!loaded.remarks.isEmpty())
    emit remarked(loaded.remarks);
}

void Session::renew(const LoadedDocument& loaded) {
  apply(tr("Reload from source"),
        {model::withNewMeshes(sceneBeforePreview(), *loaded.renewed), !loaded.renewed->empty()});
  emit remarked(loaded.remarks);
}

void Session::goBack(const LoadedDocument& loaded) {
  cancelPreview();
  if (m_document.opening != loaded.reverts)
    return;  // undo went to another document meanwhile
  DocumentFile file = *loaded.file;
  const model::Scene scene = solid(loaded.scene);
  file.saved = scene;
  m_files[loaded.reverts] = std::move(file);
  if (!apply(tr("Revert to Saved"), {scene, !(scene == m_document.scene)}))
    compareWithFile(true);
}

void Session::addOpening(Document document, DocumentFile file) {
  document.opening = ++m_openings;
  m_files[document.opening] = std::move(file);
  if (m_document.opening == 0 && m_history.count() == 0)
    set(std::move(document));  // there is nothing to go back to
  else
    push(tr("Open %1").arg(document.title), document, {});
}

void Session::startJob(const QString& title, SceneMaker maker) {
  cancelJob();
  m_job = new SceneJob(std::move(maker), this);
  connect(m_job, &SceneJob::progressed, this,
          [this, job = m_job](double done, const QString& what) {
            if (job == m_job)
              emit jobProgressed(done, what);
          });
  connect(m_job, &SceneJob::made, this, [this, job = m_job](const LoadedDocument& loaded) {
    if (job != m_job)
      return;
    endJob();
    if (loaded.question)
      emit patientsFound(*loaded.question);
    else if (loaded.scans)
      emit scansFound(loaded.scans);
    else if (loaded.renewed)
      renew(loaded);
    else if (loaded.added)
      add(loaded);
    else if (loaded.reverts != 0)
      goBack(loaded);
    else
      open(loaded);
  });
  connect(m_job, &SceneJob::failed, this, [this, job = m_job](const Error& error) {
    if (job != m_job)
      return;
    endJob();
    emit failed(error);
  });
  emit jobStarted(title);
  m_job->start();
}

void Session::cancelJob() {
  if (!m_job)
    return;
  // The job is released at once and deletes itself when its thread has stopped.
  connect(m_job, &SceneJob::cancelled, m_job, &QObject::deleteLater);
  connect(m_job, &SceneJob::done, m_job, &QObject::deleteLater);
  m_job->cancel();
  m_job = nullptr;
  emit jobEnded();
}

void Session::endJob() {
  m_job->deleteLater();
  m_job = nullptr;
  emit jobEnded();
}

}  // namespace sline::widgets
