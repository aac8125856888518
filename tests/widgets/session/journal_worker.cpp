// SPDX-License-Identifier: Apache-2.0
// Stands in for the window, made to be killed: it opens what an earlier worker has left, or the
// scene file, and works on it by a script, quicker than any hand. After each action it says on
// standard output what must be there if it is killed from then on.
//   journal_worker FILE JOURNAL_FOLDER SEED
#include <unistd.h>

#include <QCoreApplication>
#include <QTimer>
#include <chrono>
#include <random>

#include "model/edit/annotations.h"
#include "model/edit/look.h"
#include "model/edit/sections.h"
#include "model/edit/tree.h"
#include "model/edit/views.h"
#include "tests/support/shapes.h"
#include "tests/widgets/session/journal_log.h"
#include "widgets/session/journaler.h"
#include "widgets/session/scene_saver.h"

using namespace sline;
using namespace sline::widgets;

namespace {
constexpr int structures = 94;

model::Scene body() {
  model::Scene scene;
  const model::NodeId group = scene.append({.name = "group"});
  for (int i = 0; i < structures; ++i)
    scene.append({.parent = group,
                  .name = "structure " + std::to_string(i),
                  .style = {.fill = model::Fill::paper},
                  .mesh = test::sphere(1 + 0.1f * float(i), 3 + i % 2)});
  return scene;
}

class Worker : public QObject {
 public:
  Worker(std::filesystem::path file, const std::filesystem::path& folder, unsigned seed)
      : m_file(std::move(file)), m_random(seed), m_saver(m_session) {
    // It is said before the journal hears of it.
    connect(&m_session.history(), &QUndoStack::indexChanged, this, [this] { say(); });
    connect(&m_session, &Session::selectionChanged, this, [this] { say(); });
    m_journaler.emplace(m_session, folder);
    connect(&*m_journaler, &Journaler::kept, this, [] { put(test::JournalLog::keptLine); });
    connect(&*m_journaler, &Journaler::failed, this, [](const Error& error) {
      static_cast<void>(write(STDERR_FILENO, error.reason.data(), error.reason.size()));
    });
    connect(&m_session, &Session::opened, this, [this] { begin(); });
    const auto left = model::recoverableIn(folder);
    if (!left.empty())
      m_session.openRecovered(left.front());
    else if (std::filesystem::exists(m_file))
      m_session.openPaths({m_file});
    else
      m_session.openMade(QStringLiteral("body"), [](auto&&...) -> Result<LoadedDocument> {
        return LoadedDocument{.scene = body(), .title = QStringLiteral("body"), .remarks = {}};
      });
  }

 private:
  int below(int end) { return int(m_random() % unsigned(end)); }

  void begin() {
    m_begun = true;
    if (m_session.file().path.empty())
      m_saver.save(m_file, SceneSaver::As::document);
    say();
    QTimer::singleShot(0, this, [this] { act(); });
  }

  void say() {
    if (!m_begun)
      return;
    m_seen[m_session.history().index()] = test::sumOf(m_session.scene());
    const auto before = m_seen.find(m_session.history().index() - 1);
    const std::string line = test::JournalLog{test::sumOf(m_session.scene()),
                                              before == m_seen.end() ? 0 : before->second,
                                              test::sumOf(m_session.selection())}
                                 .line();
    put(line);
  }
  static void put(const std::string& line) {
    if (write(STDOUT_FILENO, line.data(), line.size()) < 0)
      QCoreApplication::exit(1);
  }

  void act() {
    const model::Scene& scene = m_session.scene();
    const model::NodeId node[] = {scene.nodes()[std::size_t(below(int(scene.nodes().size())))].id};
    const QString name = QStringLiteral("edit %1").arg(m_random());
    const auto gamma = [this] {
      return model::Style{.gamma = Gamma::clamped(0.01f * float(below(500)))};
    };
    switch (below(12)) {
      case 0:
        m_session.undo();
        break;
      case 1:
        m_session.redo();
        break;
      case 2:
        m_session.select({node[0]});
        break;
      case 3:
        m_session.apply(name, model::withView(scene, {.name = name.toStdString(), .camera = {}}));
        break;
      case 4:
        m_session.apply(name, model::withSection(scene, {.name = name.toStdString(),
                                                         .plane = {{1, 0, 0}, float(below(10))}}));
        break;
      case 5:  // all structures at once
        m_session.apply(name, model::withLook(scene, scene.children(model::rootId), gamma()));
        break;
      case 6:
        for (int i = 0; i < 5; ++i)
          m_session.preview(model::withLook(m_session.sceneBeforePreview(), node, gamma()).scene);
        m_session.commitPreview(name);
        break;
      case 7:
        if (scene.nodes().size() > structures / 2 && node[0] != scene.nodes()[0].id)
          m_session.apply(name, model::removed(scene, node));
        break;
      case 8:
        if (below(4) == 0)
          m_saver.save(m_file, SceneSaver::As::document);
        break;
      case 9:
        m_session.apply(name, model::withLook(scene, node, gamma()), QStringLiteral("key"));
        break;
      default:
        m_session.apply(name, model::renamed(scene, node[0], name.toStdString()));
    }
    QTimer::singleShot(below(40), this, [this] { act(); });
  }

  std::filesystem::path m_file;
  std::mt19937 m_random;
  Session m_session;
  std::optional<Journaler> m_journaler;
  SceneSaver m_saver;
  bool m_begun = false;                 ///< it is open, with its history
  std::map<int, std::uint32_t> m_seen;  ///< by place in the history
};
}  // namespace

int main(int argc, char** argv) {
  QCoreApplication application(argc, argv);
  if (argc != 4)
    return 1;
  const Worker worker(argv[1], argv[2], unsigned(std::strtoul(argv[3], nullptr, 10)));
  return QCoreApplication::exec();
}
