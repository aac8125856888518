// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/journal.h"

#include <algorithm>
#include <set>

#include "model/base/letters.h"
#include "model/disk/cache_folder.h"
#include "model/disk/process.h"
#include "model/disk/whole_file.h"
#include "model/scene_file/journal_records.h"
#include "model/scene_file/journal_succession.h"

namespace sline::model {

namespace fs = std::filesystem;

namespace {
constexpr std::string_view journalExtension = ".journal";
constexpr std::string_view pictureMember = "thumbnail.png";
constexpr std::string_view successionMember = "recovery/succession";
constexpr std::size_t largestJournal = std::size_t(16) << 30;
/// A journal is written anew, with the nearest states alone, when it has grown by so much, or its
/// states' texts would take that much to read.
constexpr std::uint64_t mostGrowth = std::uint64_t(16) << 20;
constexpr std::uint64_t mostNotedText = std::uint64_t(128) << 20;
constexpr std::size_t keptText = std::size_t(64) << 20;
/// A journal that begins has its meshes first, if that does not keep the first edit waiting.
constexpr std::chrono::milliseconds meshesFirst(400);
/// Reading a state takes some milliseconds.
constexpr std::size_t mostStepsBack = 300;

fs::path meshesOf(const fs::path& journal) {
  fs::path file = journal;
  return file.replace_extension(".meshes");
}

bool isJournal(const fs::path& file) {
  return lowerExtension(file) == journalExtension;
}

void removeFiles(const fs::path& journal) {
  std::error_code ignored;
  fs::remove(journal, ignored);
  fs::remove(meshesOf(journal), ignored);
}

/// Removes what programs that were killed without unsaved work have left.
void removeOrphans(const fs::path& folder) {
  std::vector<fs::path> orphans;
  std::error_code fault;
  for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
       entry.increment(fault)) {
    fs::path journal = entry->path();
    if (lowerExtension(journal) != ".meshes")
      continue;
    journal.replace_extension(journalExtension);
    std::error_code none;
    if (!fs::exists(journal, none) && !FileLock::held(journal))
      orphans.push_back(entry->path());
  }
  for (const fs::path& orphan : orphans)
    fs::remove(orphan, fault);
}

std::vector<ZipMember> membersOf(const SceneDocument& rest) {
  std::vector<ZipMember> members = rest.others;
  if (!rest.thumbnail.empty())
    members.push_back({std::string(pictureMember), rest.thumbnail});
  return members;
}

SceneDocument restOf(std::vector<ZipMember> members) {
  SceneDocument rest;
  for (ZipMember& member : members) {
    if (member.name == successionMember)
      continue;
    if (member.name == pictureMember)
      rest.thumbnail = std::move(member.bytes);
    else
      rest.others.push_back(std::move(member));
  }
  return rest;
}

/// Returns the journal from which this one goes on, which is beside it; empty where there is none.
fs::path predecessorOf(const fs::path& journal, const JournalContent& content) {
  const auto found = std::find_if(content.members.begin(), content.members.end(),
                                  [](const ZipMember& m) { return m.name == successionMember; });
  return found == content.members.end() ? fs::path()
                                        : journal.parent_path() / fs::path(found->bytes).filename();
}

/// Calls visit(file, content) for each journal whose program is no longer running.
template <class Visit>
void forEachLeft(const fs::path& folder, const Visit& visit) {
  std::error_code fault;
  for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
       entry.increment(fault)) {
    const fs::path file = entry->path();
    std::error_code gone;
    // An empty one was killed before it had anything.
    if (!isJournal(file) || FileLock::held(file) || fs::file_size(file, gone) == 0 || gone)
      continue;
    const Result<std::string> bytes = readText(file, largestJournal);
    visit(file, bytes.ok() ? journalContent(*bytes) : JournalContent());
  }
}

/// Returns the meshes of the journal and, where a state calls for others, of the scene file.
Bulk bulkFor(const fs::path& journal, const JournalContent& content) {
  const Result<std::string> bytes = readText(meshesOf(journal), largestJournal);
  Bulk bulk = bytes.ok() ? bulkFrom(*bytes) : Bulk();
  const auto known = [&bulk](const std::string& key) { return bulk.contains(key); };
  const std::vector<std::string> keys = keysCalledFor(*content.now().text);
  // A name without its folder would be looked for in whichever folder this program was started.
  if (std::all_of(keys.begin(), keys.end(), known) || !content.source.file.is_absolute())
    return bulk;
  if (const Result<SceneDocument> saved = readSceneFile(content.source.file); saved.ok())
    bulk.merge(bulkOf(saved->scene));
  return bulk;
}

/// Makes scenes of a journal's states.
class StateReader {
 public:
  /// What of a state's meshes, paints and voxels must be there for it to count.
  enum class Parts { all, some };
  StateReader(const JournalContent& content, Bulk bulk)
      : m_content(content), m_bulk(std::move(bulk)) {}

  /// Reads the newest state at which the document stood, then back and forth from it as far as it
  /// goes. Returns false where there is none.
  bool read(Parts wanted, Recovered& back) {
    std::size_t at = m_content.current - m_content.first;
    std::optional<Scene> scene = sceneAt(at, wanted, back);
    while (!scene && at > 0)
      scene = sceneAt(--at, wanted, back);
    if (!scene)
      return false;
    add(at, std::move(*scene), back);
    for (std::size_t i = at; i > 0 && back.current < mostStepsBack; ++back.current) {
      std::optional<Scene> before = sceneAt(--i, wanted, back);
      if (!before)
        break;
      add(i, std::move(*before), back);
    }
    std::reverse(back.states.begin(), back.states.end());
    for (std::size_t i = at + 1; i < m_content.states.size(); ++i) {
      std::optional<Scene> after = sceneAt(i, wanted, back);
      if (!after)
        break;
      add(i, std::move(*after), back);
    }
    return true;
  }

 private:
  void add(std::size_t i, Scene scene, Recovered& back) {
    back.states.push_back({m_content.states[i].name, std::move(scene)});
  }

  std::optional<Scene> sceneAt(std::size_t i, Parts wanted, Recovered& back) {
    const std::string& text = *m_content.states[i].text;
    const std::vector<std::string> keys = keysCalledFor(text);
    const auto there = std::size_t(std::count_if(
        keys.begin(), keys.end(), [this](const std::string& key) { return m_bulk.contains(key); }));
    if (there < keys.size() && (wanted == Parts::all || there == 0))
      return std::nullopt;
    std::vector<JsonRefusal> leftOut;
    Result<Scene> scene = sceneOfState(text, m_bulk, leftOut);
    if (!scene.ok())
      return std::nullopt;
    for (const JsonRefusal& each : leftOut)
      if (m_told.size() < mostToldFaults && m_told.insert(each.text()).second)
        back.leftOut.push_back(each.text());
    return std::move(*scene);
  }

  const JournalContent& m_content;
  Bulk m_bulk;
  std::set<std::string> m_told;  ///< what is wrong in one state is mostly so in the next
};
}  // namespace

fs::path userJournalFolder() {
  const fs::path state = userStateFolder();
  return state.empty() ? state : state / "journals";
}

Result<std::unique_ptr<Journal>> Journal::reserve(const fs::path& folder) {
  std::error_code ignored;  // if the folder is still missing, the lock reports the error
  fs::create_directories(folder, ignored);
  removeOrphans(folder);
  for (int number = 1;; ++number) {
    const fs::path file = folder / (std::to_string(processNumber()) + "-" + std::to_string(number) +
                                    std::string(journalExtension));
    // A journal of this name was left by an earlier process of the same number.
    if (fs::exists(file, ignored) || FileLock::held(file))
      continue;
    FileLock lock = TRY(FileLock::acquire(file));
    return std::unique_ptr<Journal>(new Journal(std::move(lock)));
  }
}

Journal::~Journal() {
  if (!started())
    removeFiles(file());
}

Status Journal::start(const JournalSource& source, const SceneDocument& rest,
                      const JournalStep& state) {
  m_states.reset();
  if (!m_bulk) {
    BulkStore bulk = TRY(BulkStore::create(meshesOf(file())));
    m_bulk.emplace(std::move(bulk));
  }
  JournalContent content{.source = source,
                         .members = membersOf(rest),
                         .states = {{state.name, std::make_shared<const std::string>(
                                                     stateText(*state.scene, m_keys))}},
                         .first = state.place,
                         .current = state.place,
                         .selection = {}};
  for (const auto& [key, item] : m_keys.takeFresh())
    m_bulk->want(key, item);
  TRY(m_bulk->write(meshesFirst));
  std::unique_ptr<AppendedFile> made = TRY(AppendedFile::create(file()));
  if (Status added = made->add(journalBytes(content, m_writer)); !added.ok()) {
    std::error_code ignored;
    fs::remove(file(), ignored);
    return added;
  }
  m_states = std::move(made);
  m_begun = m_states->size();
  m_text = content.now().text->size();
  return Unit{};
}

Status Journal::note(const JournalStep& step) {
  const JournalState state{step.name,
                           std::make_shared<const std::string>(stateText(*step.scene, m_keys))};
  for (const auto& [key, item] : m_keys.takeFresh())
    m_bulk->want(key, item);
  TRY(m_states->add(m_writer.state(step.place, step.count, state)));
  m_writer.wrote(state);
  m_text += state.text->size();
  if (m_states->size() - m_begun > mostGrowth || m_text > mostNotedText)
    shorten();
  return Unit{};
}

Status Journal::note(const JournalSource& source) {
  return m_states->add(m_writer.source(source));
}

Status Journal::note(const std::vector<NodeId>& selection) {
  return m_states->add(m_writer.selection(selection));
}

/// Writes the journal anew beside itself and puts it in its place. Where that fails it only goes on
/// growing, and is as good as before.
void Journal::shorten() {
  m_begun = m_states->size();
  m_text = 0;
  const Result<std::string> bytes = readText(file(), largestJournal);
  if (!bytes.ok())
    return;
  JournalContent content = journalContent(*bytes);
  if (content.states.empty())
    return;
  dropFarStates(content, keptText);
  JournalWriter writer;
  if (!writeText(file(), journalBytes(content, writer)).ok())
    return;
  // The old file is no longer in the folder: without the new one nothing can be kept.
  Result<std::unique_ptr<AppendedFile>> again = AppendedFile::goOn(file());
  if (!again.ok())
    return;
  m_states = std::move(*again);
  m_writer = writer;
  m_begun = m_states->size();
}

Status Journal::writeMeshes(std::chrono::milliseconds atMost) {
  return m_bulk ? m_bulk->write(atMost) : Status(Unit{});
}

Status Journal::sync() {
  if (m_states)
    TRY(m_states->sync());
  return m_bulk ? m_bulk->sync() : Status(Unit{});
}

void Journal::discard() {
  m_states.reset();
  std::error_code ignored;
  fs::remove(file(), ignored);
}

void Journal::discardAll() {
  discard();
  m_bulk.reset();
  m_keys = {};
  removeFiles(file());
}

std::vector<Recoverable> recoverableIn(const fs::path& folder) {
  std::vector<Recoverable> all;
  forEachLeft(folder, [&all](const fs::path& file, const JournalContent& content) {
    std::error_code gone;
    const fs::file_time_type when = fs::last_write_time(file, gone);
    // As long as the one before it is there, that one has more.
    if (!gone && !fs::exists(predecessorOf(file, content), gone))
      all.push_back({file, content.source, when});
  });
  std::sort(all.begin(), all.end(), [](const Recoverable& a, const Recoverable& b) {
    return a.when != b.when ? a.when > b.when : a.journal < b.journal;
  });
  return all;
}

Result<Recovered> recovered(const Recoverable& found) {
  const std::string bytes = TRY(readText(found.journal, largestJournal));
  JournalContent content = journalContent(bytes);
  Recovered back;
  if (!content.states.empty()) {
    StateReader reader(content, bulkFor(found.journal, content));
    if (!reader.read(StateReader::Parts::all, back))
      reader.read(StateReader::Parts::some, back);
  }
  if (back.states.empty())
    return Error{.file = found.journal.string(),
                 .reason = "it was damaged, and holds no state of the scene that is whole",
                 .remedy = "Open the scene file as it was saved last"};
  back.rest = restOf(std::move(content.members));
  back.selection = std::move(content.selection);
  return back;
}

ZipMember successionOf(const Recoverable& left) {
  return {std::string(successionMember), left.journal.string()};
}

void forget(const Recoverable& found) {
  const Result<FileLock> lock = FileLock::acquire(found.journal);
  if (!lock.ok())
    return;
  // Where a program was killed while it took this one over, what it had begun has less.
  std::vector<fs::path> begun;
  forEachLeft(found.journal.parent_path(),
              [&](const fs::path& file, const JournalContent& content) {
                if (predecessorOf(file, content) == found.journal)
                  begun.push_back(file);
              });
  for (const fs::path& file : begun)
    removeFiles(file);
  removeFiles(found.journal);
}

}  // namespace sline::model
