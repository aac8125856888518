// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/session.h"

#include <QElapsedTimer>
#include <QUndoCommand>
#include <algorithm>

#include "model/edit/annotations.h"
#include "model/edit/look.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/plan/scene_inputs.h"

namespace sline::widgets {

/// Goes from one document to the next; scenes share their meshes, so both together are small.
class DocumentStep : public QUndoCommand {
 public:
  DocumentStep(Session& session, Document after, QString series)
      : m_session(session),
        m_before(session.m_beforePreview.value_or(session.m_document)),
        m_after(std::move(after)),
        m_series(std::move(series)) {
    m_age.start();
  }
  void undo() override { m_session.set(m_before); }
  void redo() override { m_session.set(m_after); }
  int id() const override { return m_series.isEmpty() ? -1 : 1; }
  bool mergeWith(const QUndoCommand* other) override {
    constexpr qint64 oneGesture = 1000;  // milliseconds
    const auto* next = static_cast<const DocumentStep*>(other);
    if (next->m_series != m_series || m_age.elapsed() > oneGesture)
      return false;
    m_after = next->m_after;
    m_age.restart();
    setObsolete(m_before == m_after);
    return true;
  }

 private:
  Session& m_session;
  Document m_before;
  Document m_after;
  QString m_series;
  QElapsedTimer m_age;
};

namespace {

QStringList remarksOf(const model::ImportReport& report) {
  QStringList remarks;
  for (const model::ImportWarning& warning : report.warnings)
    remarks << QString::fromStdString(warning.file.empty() ? warning.reason
                                                           : warning.file + ": " + warning.reason);
  for (const std::string& note : report.notes)
    remarks << QString::fromStdString(note);
  if (!report.repairs.summary.empty())
    remarks << QString::fromStdString(report.repairs.summary);
  return remarks;
}

Result<LoadedDocument> loadedDocument(Result<ReadDocument> read, const QString& title) {
  if (!read.ok())
    return read.error();
  return LoadedDocument{.scene = std::move(read->scene),
                        .title = title,
                        .remarks = {},
                        .file = std::move(read->file)};
}

QStringList remarksOf(const model::Reloaded& reloaded) {
  using Fate = model::ReloadedFile::Fate;
  QStringList remarks;
  const auto renewed = int(reloaded.meshes.size());
  remarks << (renewed == 0 ? Session::tr("No file that could be read again has changed")
                           : Session::tr("%n structures were read again", nullptr, renewed));
  for (const model::ReloadedFile& file : reloaded.files)
    if (file.fate == Fate::absent || file.fate == Fate::failed)
      remarks << QString::fromStdString(file.file + ": " + file.reason);
  for (const model::ImportWarning& warning : reloaded.warnings)
    remarks << QString::fromStdString(warning.file + ": " + warning.reason);
  return remarks;
}

/// Returns where to look for files again, because scenes refer to files beside them.
std::vector<std::filesystem::path> placesOf(std::vector<std::filesystem::path> sources) {
  for (std::filesystem::path& path : sources)
    if (!model::isSurfaceFile(path) && !std::filesystem::is_directory(path))
      path = path.parent_path();
  return sources;
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

}  // namespace

QString titleOf(const std::vector<std::filesystem::path>& paths) {
  std::filesystem::path path = paths.empty() ? std::filesystem::path() : paths.front();
  if (!path.has_filename())  // "folder/"
    path = path.parent_path();
  const QString name = QString::fromStdString(path.filename().string());
  return paths.size() < 2 ? name
                          : Session::tr("%1 and %n more", nullptr, int(paths.size()) - 1).arg(name);
}

LoadedDocument loadedDocument(model::Imported imported,
                              const std::vector<std::filesystem::path>& paths) {
  LoadedDocument loaded{.scene = std::move(imported.scene),
                        .title = titleOf(paths),
                        .remarks = remarksOf(imported.report),
                        .paths = paths};
  if (!imported.others.empty())
    loaded.file = DocumentFile{.others = std::make_shared<const std::vector<model::ZipMember>>(
                                   std::move(imported.others))};
  return loaded;
}

Session::Session(QObject* parent) : QObject(parent), m_files{{0, {.saved = model::Scene()}}} {}

Session::~Session() {
  m_history.disconnect(this);
}

void Session::undo() {
  cancelPreview();
  m_history.undo();
}

void Session::redo() {
  cancelPreview();
  m_history.redo();
}

bool Session::apply(const QString& name, model::Edited edited, const QString& series) {
  if (!edited.changed)
    return false;
  if (m_beforePreview)
    commitPreview(name);
  Document after = m_document;
  after.scene = std::move(edited.scene);
  push(name, std::move(after), series);
  return true;
}

void Session::completeOpening(const QString& name, model::Edited edited) {
  const bool saved = !m_modified;
  if (apply(name, std::move(edited)) && saved) {
    m_files[m_document.opening].saved = m_document.scene;
    compareWithFile(true);
  }
}

void Session::push(const QString& name, Document after, const QString& series) {
  auto* step = new DocumentStep(*this, std::move(after), series);
  step->setText(name);
  m_beforePreview.reset();
  m_history.push(step);
}

void Session::preview(model::Scene scene) {
  if (!m_beforePreview)
    m_beforePreview = m_document;
  Document document = m_document;
  document.scene = std::move(scene);
  set(std::move(document));
}

void Session::commitPreview(const QString& name) {
  if (!m_beforePreview)
    return;
  if (*m_beforePreview == m_document)
    m_beforePreview.reset();
  else
    push(name, m_document, {});
}

void Session::cancelPreview() {
  if (!m_beforePreview)
    return;
  Document before = std::move(*m_beforePreview);
  m_beforePreview.reset();
  set(std::move(before));
}

const model::Scene& Session::sceneBeforePreview() const {
  return m_beforePreview ? m_beforePreview->scene : m_document.scene;
}

void Session::select(NodeIds ids) {
  std::erase_if(ids, [this](model::NodeId id) { return !scene().find(id); });
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  if (ids == m_selection)
    return;
  m_selection = std::move(ids);
  emit selectionChanged();
}

std::optional<model::SectionId> Session::activeSection() const {
  const auto& sections = scene().sections();
  const bool there = std::any_of(sections.begin(), sections.end(), [this](const auto& section) {
    return section.id == m_activeSection;
  });
  return there ? m_activeSection : std::nullopt;
}

void Session::activateSection(std::optional<model::SectionId> id) {
  if (id == m_activeSection)
    return;
  m_activeSection = id;
  emit activeSectionChanged();
}

std::optional<model::AnnotationId> Session::activeAnnotation() const {
  return m_activeAnnotation && model::findAnnotation(scene(), *m_activeAnnotation)
             ? m_activeAnnotation
             : std::nullopt;
}

void Session::activateAnnotation(std::optional<model::AnnotationId> id) {
  if (id == m_activeAnnotation)
    return;
  m_activeAnnotation = id;
  emit activeAnnotationChanged();
}

void Session::set(Document document) {
  if (document == m_document)
    return;
  const Document before = std::exchange(m_document, std::move(document));
  const bool another = before.opening != m_document.opening;
  if (another) {
    moveLock(before.opening, m_document.opening);
    m_activeSection.reset();
    m_activeAnnotation.reset();
  }
  emit documentChanged(before, m_document);
  compareWithFile(another);
  select(before.opening == m_document.opening ? m_selection : NodeIds{});
}

const DocumentFile& Session::file() const {
  return m_files.at(m_document.opening);
}

QString Session::title() const {
  return file().path.empty() ? m_document.title
                             : QString::fromStdString(file().path.filename().string());
}

void Session::noteSaved(int opening, DocumentFile file) {
  const bool shown = opening == m_document.opening;
  if (!shown)
    file.lock.reset();
  m_files[opening] = std::move(file);
  if (shown)
    compareWithFile(true);
}

void Session::moveLock(int from, int to) {
  // A file that is opened twice has one lock in both: the new one holds it before the old one
  // releases it.
  if (m_files[to].lock) {
    m_files[from].lock.reset();
    return;
  }
  m_files[from].lock.reset();
  relock(m_files[to]);
}

void Session::compareWithFile(bool another) {
  const std::optional<model::Scene>& saved = file().saved;
  const bool modified = !saved || !(*saved == m_document.scene);
  if (std::exchange(m_modified, modified) != modified || another)
    emit fileChanged();
}

std::vector<std::filesystem::path> Session::sources() const {
  const auto found = m_sources.find(m_document.opening);
  return found == m_sources.end() ? std::vector<std::filesystem::path>() : found->second;
}

void Session::renew(const LoadedDocument& loaded) {
  apply(tr("Reload from source"),
        {model::withNewMeshes(sceneBeforePreview(), *loaded.renewed), !loaded.renewed->empty()});
  emit remarked(loaded.remarks);
}

void Session::add(const LoadedDocument& loaded) {
  cancelPreview();
  model::Scene together = m_document.scene;
  std::vector<model::NodeId> fresh;
  for (const auto& [old, id] : model::append(together, solid(loaded.scene)))
    if (old != model::rootId)
      fresh.push_back(id);
  std::vector<std::filesystem::path>& sources = m_sources[m_document.opening];
  sources.insert(sources.end(), loaded.paths.begin(), loaded.paths.end());
  apply(tr("Add %1").arg(loaded.title), {std::move(together), true});
  select(fresh);
  if (!loaded.remarks.isEmpty())
    emit remarked(loaded.remarks);
}

void Session::reloadSources() {
  startJob(m_document.title, [scene = sceneBeforePreview(), places = sources()](
                                 const model::ImportProgress& progress, const std::stop_token&) {
    const auto goesOn = [&progress] { return progress(0.0f, {}); };
    model::Reloaded reloaded = model::reload(scene, placesOf(places), {.goesOn = goesOn});
    return Result<LoadedDocument>(
        LoadedDocument{.remarks = remarksOf(reloaded), .renewed = std::move(reloaded.meshes)});
  });
}

void Session::open(const LoadedDocument& loaded) {
  cancelPreview();
  m_sources[m_openings + 1] = loaded.paths;
  DocumentFile file = loaded.file.value_or(DocumentFile());
  Document document{.scene = solid(loaded.scene), .title = loaded.title};
  if (!file.copy)
    file.saved = document.scene;
  if (model::hasNoLook(loaded.scene))
    m_withoutLook.insert(m_openings + 1);
  addOpening(std::move(document), std::move(file));
  emit opened(loaded.paths);
  if (!loaded.remarks.isEmpty())
    emit remarked(loaded.remarks);
}

void Session::addOpening(Document document, DocumentFile file) {
  document.opening = ++m_openings;
  m_files[document.opening] = std::move(file);
  if (m_document.opening == 0 && m_history.count() == 0)
    set(std::move(document));  // there is nothing to go back to
  else
    push(tr("Open %1").arg(document.title), document, {});
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

void Session::openPaths(std::vector<std::filesystem::path> paths) {
  const QString title = titleOf(paths);
  startJob(title, [paths = std::move(paths), title, lock = file().lock](
                      const model::ImportProgress& progress, const std::stop_token&) {
    if (paths.size() == 1 && model::isSceneFile(paths.front())) {
      Result<LoadedDocument> loaded = loadedDocument(readDocument(paths.front(), lock), title);
      if (loaded.ok())
        loaded->paths = paths;
      return loaded;
    }
    auto imported = model::importInputs(paths, {}, progress);
    if (!imported)
      return Result<LoadedDocument>(imported.error());
    return Result<LoadedDocument>(loadedDocument(std::move(*imported), paths));
  });
}

void Session::openRecovered(const model::Recoverable& found) {
  const QString title = QString::fromStdString(found.source.title);
  startJob(title, [found, title, lock = file().lock](const model::ImportProgress&,
                                                     const std::stop_token&) {
    return loadedDocument(readRecovered(found, lock), title);
  });
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

void Session::openMade(const QString& title, SceneMaker maker) {
  startJob(title, std::move(maker));
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
    if (loaded.renewed)
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

#include "moc_session.cpp"
