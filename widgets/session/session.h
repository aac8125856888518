// SPDX-License-Identifier: Apache-2.0
// The only way to change the document: other objects read it, ask for edits and are told the
// result; none keeps a copy.
#pragma once

#include <QObject>
#include <QUndoStack>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "model/edit/edited.h"
#include "widgets/session/display_names.h"
#include "widgets/session/document.h"
#include "widgets/session/other_sides.h"
#include "widgets/session/scene_job.h"

namespace sline::widgets {

using NodeIds = std::vector<model::NodeId>;

class Session : public QObject {
  Q_OBJECT
 public:
  explicit Session(QObject* parent = nullptr);
  ~Session() override;

  const Document& document() const { return m_document; }
  const model::Scene& scene() const { return m_document.scene; }
  /// Returns the history for display; `undo` and `redo` are the way to go back and forth.
  QUndoStack& history() { return m_history; }
  /// Undoes one step; a drag under way is cancelled.
  void undo();
  void redo();

  /// Applies an edit as one undo step; returns false, and makes no step, where it changes nothing.
  /// Edits with the same `series` that follow each other within a second (a key held down) become
  /// one step.
  bool apply(const QString& name, model::Edited edited, const QString& series = {});
  /// Shows a scene without making a step, during a drag. The first call begins the drag.
  void preview(model::Scene scene);
  /// Ends the drag with one step, or none where nothing has changed.
  void commitPreview(const QString& name);
  /// Ends the drag and restores the scene before it.
  void cancelPreview();
  bool previewing() const { return m_beforePreview.has_value(); }
  /// Returns the scene before the drag, from which edits during a drag start.
  const model::Scene& sceneBeforePreview() const;

  /// Returns the names of structures on screen, which are not part of the document.
  DisplayNames& names() { return m_names; }
  /// Returns which structures lie on the other side than their names say.
  const OtherSides& otherSides() const { return m_otherSides; }
  /// Returns the scene file of the document.
  const DocumentFile& file() const;
  /// Returns the file's name if there is a file, otherwise the document's title.
  QString title() const;
  /// Returns of the title what may be shown to others (model/anatomy/shown_names.h), for names of
  /// what is made of the document.
  QString publicTitle() const;
  /// Tells whether there is unsaved work: the scene differs from what the file has or, where there
  /// is none, from what came in. A drag under way counts.
  bool modified() const { return m_modified; }
  /// Notes that a file was written with the scene of this opening; its lock stays with the
  /// document.
  void noteSaved(int opening, DocumentFile file);

  /// Tells whether what the document was opened from does not say how it looks, so that a look may
  /// be chosen for it (model/look).
  bool opensWithoutLook() const { return m_withoutLook.contains(m_document.opening); }
  /// Adds what was chosen for the opening: a step of the history, but no unsaved work.
  void completeOpening(const QString& name, model::Edited edited);

  const NodeIds& selection() const { return m_selection; }
  /// Selects the nodes; ids that the scene lacks are left out.
  void select(NodeIds ids);

  /// Returns the section that is being edited, if the scene has it.
  std::optional<model::SectionId> activeSection() const;
  void activateSection(std::optional<model::SectionId> id);
  /// Returns the label that is being edited, if the scene has it.
  std::optional<model::AnnotationId> activeAnnotation() const;
  void activateAnnotation(std::optional<model::AnnotationId> id);

  /// Reads the files and folders in the background; the scene becomes the document once it is read
  /// (one undo step). A job that is under way is cancelled.
  /// Where they are of several patients, `patientsFound` comes first, unless the options say what
  /// to do with them.
  void openPaths(std::vector<std::filesystem::path> paths,
                 const model::ImportOptions& options = {});
  /// Reads meshes again if their files have changed since they were opened, in the background, as
  /// one undo step. The places of these files are known only in this session.
  void reloadSources();
  /// Tells whether any source is known from which to reload.
  bool canReload() const { return !sources().empty(); }
  void openMade(const QString& title, SceneMaker maker);
  /// Returns what speaks against the units of what was opened.
  std::vector<model::UnitDoubt> unitDoubts() const;
  /// Returns how all that the document was made of was imported; none where some of it was not
  /// imported, but is a scene file.
  std::vector<ImportRecipe> recipes() const;
  /// Returns the files and folders that the document was made of, as they were named.
  std::vector<std::filesystem::path> sources() const;
  /// Opens an empty scene.
  void openEmpty(const QString& title);
  /// Opens what a journal has kept of a crash, with its history; it differs from its file until it
  /// is saved.
  void openRecovered(const model::Recoverable& found);
  /// Reads the document's file again, as an undo step.
  void revert();
  /// Closes the document, so that nothing is open (one undo step).
  void closeDocument();
  void cancelJob();
  bool busy() const { return m_job != nullptr; }

 signals:
  /// Tells of each change, also at each step of a drag; comparing the two shows what differs.
  void documentChanged(const sline::widgets::Document& before, const sline::widgets::Document& now);
  void selectionChanged();
  /// Tells that the file, its writability, or whether the document differs from it has changed.
  void fileChanged();
  /// Tells that what was asked for is open; the paths are empty for a scene made here.
  void opened(const std::vector<std::filesystem::path>& paths);
  /// Tells that another section was activated; an active section that leaves the scene, or comes
  /// back, is a change of the document instead.
  void activeSectionChanged();
  /// Tells that another label was activated, as for sections.
  void activeAnnotationChanged();
  void jobStarted(const QString& title);
  void jobProgressed(double done, const QString& what);
  void jobEnded();
  /// Tells that something could not be done; the document is as it was.
  void failed(const sline::Error& error);
  /// Tells that what was asked for is of several patients and waits for an answer.
  void patientsFound(const sline::widgets::PatientQuestion& question);
  /// Tells that what was asked for holds scans and nothing else, of which somebody must say what to
  /// make.
  void scansFound(const std::shared_ptr<const sline::model::ImportPlan>& plan);
  /// Tells that a scene came in, but parts of it were left out or mended.
  void remarked(const QStringList& remarks);

 private:
  friend class DocumentStep;
  void set(Document document);
  void push(const QString& name, Document after, const QString& series);
  void open(const LoadedDocument& loaded);
  /// Makes the history that a journal has brought back the document's, and goes to where it stood.
  void restore(const model::Recovered& recovered);
  void renew(const LoadedDocument& loaded);
  void add(const LoadedDocument& loaded);
  void goBack(const LoadedDocument& loaded);
  void addOpening(Document document, DocumentFile file);
  /// Moves the lock, because locks are held for what is open, not for what undo could bring back.
  void moveLock(int from, int to);
  void compareWithFile(bool another);
  void startJob(const QString& title, SceneMaker maker);
  void endJob();

  Document m_document;
  std::set<int> m_withoutLook;  ///< the openings of scenes without a look
  QUndoStack m_history;
  std::optional<Document> m_beforePreview;
  NodeIds m_selection;
  DisplayNames m_names;
  OtherSides m_otherSides;
  std::optional<model::SectionId> m_activeSection;
  std::optional<model::AnnotationId> m_activeAnnotation;
  SceneJob* m_job = nullptr;
  bool m_modified = false;
  bool m_restoring = false;  ///< steps are put in place, of which nobody needs to hear
  int m_openings = 0;
  /// The sources by Document::opening, so that they are right after undo, too.
  std::map<int, std::vector<std::filesystem::path>> m_sources;
  std::map<int, std::vector<model::UnitDoubt>> m_unitDoubts;  ///< likewise
  std::map<int, std::vector<ImportRecipe>> m_recipes;         ///< likewise
  std::map<int, DocumentFile> m_files;
};

}  // namespace sline::widgets
