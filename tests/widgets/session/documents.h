// SPDX-License-Identifier: Apache-2.0
// Makes documents, opens and saves them as a window does, and changes their files meanwhile.
#pragma once

#include <QSignalSpy>
#include <QTest>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>

#include "model/edit/look.h"
#include "model/scene_file/journal.h"
#include "model/scene_file/scene_file.h"
#include "tests/support/shapes.h"
#include "widgets/session/scene_saver.h"

namespace sline::widgets {

namespace fs = std::filesystem;

inline model::Scene balls() {
  model::Scene scene;
  scene.append({.name = "one", .style = {.fill = model::Fill::paper}, .mesh = test::sphere(1, 1)});
  scene.append({.name = "two", .mesh = test::sphere(2, 1)});
  return scene;
}

inline bool idle(const Session& session) {
  return QTest::qWaitFor([&] { return !session.busy(); });
}

/// What happens to a file while nobody has it open.
enum class Meanwhile {
  nothing,
  touched,
  replaced,
  replacedByAnOlder,
  replacedByOneAsLarge,
  gone,
  goneWithItsFolder,
};

inline void happen(Meanwhile what, const fs::path& path) {
  const fs::file_time_type time = fs::last_write_time(path);
  const bool older = what == Meanwhile::replacedByAnOlder;
  if (what == Meanwhile::touched)
    fs::last_write_time(path, time + std::chrono::hours(1));
  if (what == Meanwhile::replaced || older) {
    model::Scene other = balls();
    other.append({.name = "three", .mesh = test::sphere(3, 1)});
    if (!model::writeSceneFile(path, {.scene = other}).ok())
      qFatal("no other scene");
  }
  if (what == Meanwhile::replacedByOneAsLarge) {
    std::fstream stream(path, std::ios::binary | std::ios::in | std::ios::out);
    stream.seekp(100).put('!');
  }
  if (older || what == Meanwhile::replacedByOneAsLarge)
    fs::last_write_time(path, older ? time - std::chrono::hours(24) : time);
  if (what == Meanwhile::gone)
    fs::remove(path);
  if (what == Meanwhile::goneWithItsFolder)
    fs::remove_all(path.parent_path());
}

/// Leaves what a program leaves that was killed with unsaved work.
inline void leaveJournal(const fs::path& journals, const model::JournalSource& source) {
  const auto journal = model::Journal::reserve(journals);
  if (!journal.ok() ||
      !(*journal)
           ->start(source, {}, {.scene = std::make_shared<const model::Scene>(balls())})
           .ok() ||
      !(*journal)->writeMeshes(std::chrono::minutes(1)).ok())
    qFatal("no journal");
}

inline bool openMade(Session& session) {
  session.openMade(
      QStringLiteral("balls"),
      [](const model::ImportProgress&, const std::stop_token&) -> Result<LoadedDocument> {
        return LoadedDocument{.scene = balls(), .title = QStringLiteral("balls"), .remarks = {}};
      });
  return idle(session);
}

inline bool open(Session& session, const fs::path& path) {
  session.openPaths({path});
  return idle(session);
}

inline bool gamma(Session& session, float value, const QString& series = {}) {
  const model::NodeId first[] = {session.scene().nodes().front().id};
  return session.apply(QStringLiteral("Γ"),
                       model::withLook(session.scene(), first, {.gamma = Gamma::clamped(value)}),
                       series);
}

/// Saves the scene; returns false if it was not saved.
inline bool save(Session& session, const fs::path& path,
                 SceneSaver::As as = SceneSaver::As::document) {
  SceneSaver saver(session);
  QSignalSpy saved(&saver, &SceneSaver::saved);
  saver.save(path, as);
  return QTest::qWaitFor([&] { return !saver.busy(); }) && saved.count() == 1;
}

/// Returns the scene as another program would find it.
inline model::Scene onDisk(const fs::path& path) {
  const auto read = model::readSceneFile(path);
  return read.ok() ? read->scene : model::Scene();
}

/// Tells whether both give the same bytes as a file; meshes that were read are other objects.
inline bool same(const model::Scene& a, const model::Scene& b) {
  return *model::sceneFileBytes({.scene = a}) == *model::sceneFileBytes({.scene = b});
}

}  // namespace sline::widgets
