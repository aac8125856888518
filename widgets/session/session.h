// SPDX-License-Identifier: Apache-2.0
// The one door for change. Everybody else reads the document, asks for edits and hears what became
// of them; nobody keeps a copy.
#pragma once

#include <QObject>
#include <QUndoStack>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "model/edit/edited.h"
#include "widgets/session/document.h"
#include "widgets/session/scene_job.h"
#include "widgets/session/shown_names.h"

namespace sline::widgets {

using NodeIds = std::vector<model::NodeId>;

class Session : public QObject {
  Q_OBJECT
 public:
  explicit Session(QObject* parent = nullptr);
  ~Session() override;

  const Document& document() const { return m_document; }
  const model::Scene& scene() const { return m_document.scene; }
  /// For looking at; `undo` and `redo` are the way to go back and forth.
  QUndoStack& history() { return m_history; }
  /// A drag under way ends as if it had not been.
  void undo();
  void redo();

  /// An edit as one undo step; false, and no step, where it changes nothing. Edits with the same
  /// `series` that follow each other within a second (a key held down) become one step.
  bool apply(const QString& name, model::Edited edited, const QString& series = {});
  /// Shows a scene without making a step: a drag's. The first call begins the drag.
  void preview(model::Scene scene);
  /// Ends the drag with one step, or none where all is as before.
  void commitPreview(const QString& name);
  /// Ends the drag as if it had not been.
  void cancelPreview();
  bool previewing() const { return m_beforePreview.has_value(); }
  /// What edits during a drag start from: the scene before it.
  const model::Scene& sceneBeforePreview() const;

  /// What structures are called on screen; not part of the document.
  ShownNames& names() { return m_names; }
  /// The scene file of the document.
  const DocumentFile& file() const;
  /// The file's name, where there is one, else what the document goes by.
  QString title() const;
  /// Whether there is something to lose: the scene differs from what the file has or, where there
  /// is none, from what came in. A drag under way counts.
  bool modified() const { return m_modified; }
  /// A file was written with the scene of this opening; its lock stays with the document.
  void noteSaved(int opening, DocumentFile file);

  const NodeIds& selection() const { return m_selection; }
  /// Ids that the scene lacks are left out.
  void select(NodeIds ids);

  /// The section that is being worked on, where the scene has it.
  std::optional<model::SectionId> activeSection() const;
  void activateSection(std::optional<model::SectionId> id);
  /// The label that is being worked on, where the scene has it.
  std::optional<model::AnnotationId> activeAnnotation() const;
  void activateAnnotation(std::optional<model::AnnotationId> id);

  /// Reads the files and folders in the background; the scene becomes the document when it is
  /// there (one undo step). A job that is under way is cancelled.
  void openPaths(std::vector<std::filesystem::path> paths);
  /// Reads meshes again whose files have changed since they were opened, in the background, as one
  /// undo step. Only in this session is it known where they lie.
  void reloadSources();
  /// Where something is known to reload from.
  bool canReload() const { return !sources().empty(); }
  void openMade(const QString& title, SceneMaker maker);
  /// The files and folders that the document was made of, as they were named.
  std::vector<std::filesystem::path> sources() const;
  /// A scene without anything in it.
  void openEmpty(const QString& title);
  /// A copy that was left by a crash: it differs from its file until it is saved.
  void openRecovered(const model::Recoverable& found);
  /// Reads the document's file again, as an undo step.
  void revert();
  /// Nothing is open afterwards (one undo step).
  void closeDocument();
  void cancelJob();
  bool busy() const { return m_job != nullptr; }

 signals:
  /// Also at each step of a drag; compare the two to see what differs.
  void documentChanged(const sline::widgets::Document& before, const sline::widgets::Document& now);
  void selectionChanged();
  /// Which file it is, whether it may be written, or whether the document differs from it.
  void fileChanged();
  /// What was asked for is there. Nothing for what was made.
  void opened(const std::vector<std::filesystem::path>& paths);
  /// Another one was activated; that it left the scene, or came back, is a change of the document.
  void activeSectionChanged();
  /// As for sections.
  void activeAnnotationChanged();
  void jobStarted(const QString& title);
  void jobProgressed(double done, const QString& what);
  void jobEnded();
  /// Something could not be done; the document is as it was.
  void failed(const sline::Error& error);
  /// A scene came in, but parts of it were left out or mended.
  void remarked(const QStringList& remarks);

 private:
  friend class DocumentStep;
  void set(Document document);
  void push(const QString& name, Document after, const QString& series);
  void open(const Loaded& loaded);
  void renew(const Loaded& loaded);
  void add(const Loaded& loaded);
  void goBack(const Loaded& loaded);
  void addOpening(Document document, DocumentFile file);
  /// Locks are held for what is open, not for what undo could bring back.
  void moveLock(int from, int to);
  void compareWithFile(bool another);
  void startJob(const QString& title, SceneMaker maker);
  void endJob();

  Document m_document;
  QUndoStack m_history;
  std::optional<Document> m_beforePreview;
  NodeIds m_selection;
  ShownNames m_names;
  std::optional<model::SectionId> m_activeSection;
  std::optional<model::AnnotationId> m_activeAnnotation;
  SceneJob* m_job = nullptr;
  bool m_modified = false;
  int m_openings = 0;
  /// By Document::opening, so that they hold after undo, too.
  std::map<int, std::vector<std::filesystem::path>> m_sources;
  std::map<int, DocumentFile> m_files;
};

}  // namespace sline::widgets
