// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/journaler.h"

#include <atomic>
#include <chrono>
#include <cstdlib>

#include "model/scene_file/journal_succession.h"

namespace sline::widgets {

namespace {
constexpr int secondTry = 1000;  // milliseconds
/// Meshes give way to edits after so long, or while some are waiting.
constexpr std::chrono::milliseconds meshesAtOnce(150);
constexpr std::chrono::milliseconds meshesBetween(20);
/// While edits come faster than the disk is, they wait for it together.
constexpr std::chrono::milliseconds longestUnsynced(300);

model::JournalSource sourceOf(const Session& session) {
  return {session.title().toStdString(), session.file().path, session.file().stamp};
}
}  // namespace

/// Holds the journal, which gets its names when it is first needed.
struct Journaler::Shared {
  std::unique_ptr<model::Journal> journal;
  std::chrono::steady_clock::time_point synced;
  std::atomic<int> waiting = 0;  ///< tasks that have been handed over and not begun

  bool started() const { return journal && journal->started(); }
  Status run(const Task& task) {
    const bool last = --waiting == 0;
    if (Status done = task(*this); !done.ok() || !started())
      return done;
    TRY(journal->writeMeshes(last ? meshesAtOnce : meshesBetween));
    const auto now = std::chrono::steady_clock::now();
    if (!last && now - synced < longestUnsynced)
      return Unit{};
    synced = now;
    return journal->sync();
  }
};

struct Journaler::Outcome {
  Status status;
  bool started = false;
  bool complete = false;  ///< all meshes are there
};

Journaler::Journaler(Session& session, std::filesystem::path folder, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_folder(std::move(folder)),
      m_shared(std::make_shared<Shared>()) {
  connect(&session.history(), &QUndoStack::indexChanged, this, &Journaler::follow);
  // A step changes the file's state before the history tells of it: what the history does not tell
  // of is seen afterwards.
  connect(&session, &Session::fileChanged, this, &Journaler::fileChange, Qt::QueuedConnection);
  connect(&session, &Session::documentChanged, this, &Journaler::documentChange);
  connect(&session, &Session::selectionChanged, this, &Journaler::noteSelection);
  m_retry.setSingleShot(true);
  connect(&m_retry, &QTimer::timeout, this, [this] {
    m_last.reset();
    follow();
  });
  m_last = place();
}

Journaler::~Journaler() = default;

void Journaler::setEnabled(bool enabled) {
  if (std::exchange(m_enabled, enabled) == enabled)
    return;
  if (!enabled)
    return discard();
  m_discarded.reset();
  follow();
}

Journaler::Place Journaler::place() const {
  QUndoStack& history = m_session.history();
  const int at = history.index();
  return {m_session.document().opening,
          {.place = std::uint32_t(at),
           .count = std::uint32_t(history.count()),
           .name = at > 0 ? history.text(at - 1).toStdString() : std::string(),
           .scene = std::make_shared<const model::Scene>(m_session.sceneBeforePreview())}};
}

void Journaler::follow() {
  if (!m_enabled || m_folder.empty())
    return;
  const std::optional<Place> before = std::exchange(m_last, place());
  const Place& now = *m_last;
  if (!m_session.modified())
    return;
  // Of the last step before the journal was thrown away some may be told afterwards.
  if (m_discarded && m_discarded->isThatOf(now))
    return;
  m_discarded.reset();
  const bool same = before && before->opening == now.opening;
  if (m_running && before && before->isThatOf(now))
    return;
  if (!m_running || (before && !same)) {
    // The state before the first step is what undoing it leads to.
    const bool leads = same && std::abs(int(before->step.place) - int(now.step.place)) == 1 &&
                       *before->step.scene != *now.step.scene;
    begin(leads ? *before : now);
    if (!leads)
      return;
  }
  add([step = now.step](Shared& shared) -> Status {
    return shared.started() ? shared.journal->note(step) : Status(Unit{});
  });
}

void Journaler::begin(const Place& from) {
  m_running = true;
  m_source = sourceOf(m_session);
  const DocumentFile& file = m_session.file();
  model::SceneDocument rest;
  if (file.thumbnail)
    rest.thumbnail = *file.thumbnail;
  if (file.others)
    rest.others = *file.others;
  if (file.left)
    rest.others.push_back(model::successionOf(*file.left));
  const bool another = std::exchange(m_opening, from.opening) != from.opening;
  add([folder = m_folder, source = m_source, rest = std::move(rest), step = from.step,
       selection = m_session.selection(), another](Shared& shared) -> Status {
    if (!shared.journal) {
      shared.journal = TRY(model::Journal::reserve(folder));
    }
    if (another)
      shared.journal->discardAll();
    const Status begun = shared.journal->start(source, rest, step);
    return begun.ok() && !selection.empty() ? shared.journal->note(selection) : begun;
  });
}

void Journaler::noteSelection() {
  if (m_running)
    add([selection = m_session.selection()](Shared& shared) -> Status {
      return shared.started() ? shared.journal->note(selection) : Status(Unit{});
    });
}

void Journaler::documentChange(const Document& before, const Document& now) {
  // An opening that is the first has no step in the history.
  if (before.opening != now.opening)
    m_last = place();
}

void Journaler::fileChange() {
  if (!m_session.modified())
    return remove(m_opening != m_session.document().opening);
  if (m_session.previewing())
    return;
  follow();
  if (m_running && m_source != sourceOf(m_session)) {
    m_source = sourceOf(m_session);
    add([source = m_source](Shared& shared) -> Status {
      return shared.started() ? shared.journal->note(source) : Status(Unit{});
    });
  }
}

void Journaler::discard() {
  m_discarded = place();
  remove(true);
}

void Journaler::remove(bool meshesToo) {
  m_running = false;
  m_retry.stop();
  m_queue.add([shared = m_shared, meshesToo, left = m_session.file().left](const std::stop_token&) {
    if (shared->journal && meshesToo)
      shared->journal->discardAll();
    else if (shared->journal)
      shared->journal->discard();
    if (left)
      model::forget(*left);
    return BackgroundQueue::Sequel();
  });
}

void Journaler::add(Task task) {
  ++m_shared->waiting;
  m_queue.add([this, shared = m_shared,
               task = std::move(task)](const std::stop_token&) -> BackgroundQueue::Sequel {
    const Status status = shared->run(task);
    const Outcome outcome{status, shared->started(),
                          shared->started() && shared->journal->complete()};
    return [this, outcome] { finish(outcome); };
  });
}

void Journaler::finish(const Outcome& outcome) {
  if (!outcome.status.ok()) {
    m_running = m_running && outcome.started;
    m_retry.start(secondTry);
    if (!std::exchange(m_failing, true))
      emit failed(outcome.status.error());
    return;
  }
  if (m_queue.busy() || !m_running)
    return;
  if (!outcome.complete)
    return add([](Shared&) -> Status { return Unit{}; });
  if (m_retry.isActive())
    return;
  m_failing = false;
  // The document's own journal has everything that this one had.
  if (m_session.file().left)
    m_queue.add([left = *m_session.file().left](const std::stop_token&) {
      model::forget(left);
      return BackgroundQueue::Sequel();
    });
  emit kept();
}

}  // namespace sline::widgets

#include "moc_journaler.cpp"
