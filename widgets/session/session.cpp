// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/session.h"

#include <QElapsedTimer>
#include <QUndoCommand>
#include <algorithm>
#include <utility>

#include "model/anatomy/shown_names.h"
#include "model/edit/annotations.h"
#include "model/scene/scene_limits.h"
#include "model/scene_file/scene_file.h"
#include "widgets/text/path_text.h"

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
  if (const std::optional<Error> fault = model::limitFault(edited.scene, sceneBeforePreview())) {
    emit failed(*fault);
    return false;
  }
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
  const std::optional<Error> fault = model::limitFault(m_document.scene, m_beforePreview->scene);
  if (fault) {
    cancelPreview();
    emit failed(*fault);
  } else if (*m_beforePreview == m_document) {
    m_beforePreview.reset();
  } else {
    push(name, m_document, {});
  }
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
  if (m_restoring) {
    m_document = std::move(document);
    return;
  }
  if (document == m_document)
    return;
  const Document before = std::exchange(m_document, std::move(document));
  const bool another = before.opening != m_document.opening;
  if (another) {
    moveLock(before.opening, m_document.opening);
    m_activeSection.reset();
    m_activeAnnotation.reset();
  }
  m_otherSides.follow(m_document.scene, m_document.opening);
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

QString Session::publicTitle() const {
  const std::filesystem::path name = pathOf(m_document.title);
  // The program itself has given names that are no files'.
  if (file().path.empty() && !model::isSceneFile(name))
    return m_document.title;
  const std::filesystem::path& named = file().path.empty() ? name : file().path;
  const std::string shown = model::shownName(named.stem().string());
  return shown.empty() ? tr("Untitled") : QString::fromStdString(shown);
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

}  // namespace sline::widgets

#include "moc_session.cpp"
