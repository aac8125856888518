// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/journal.h"

#include <sys/resource.h>

#include <QTemporaryDir>
#include <QtTest>
#include <csignal>
#include <random>

#include "model/disk/whole_file.h"
#include "model/scene_file/journal_records.h"
#include "model/scene_file/journal_succession.h"
#include "model/scene_file/text_delta.h"
#include "tests/model/scene_file/sample_scene.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {
Scene named(const std::string& name, const MeshPtr& mesh) {
  Scene scene;
  scene.append({.name = name, .mesh = mesh});
  return scene;
}

/// Returns a scene of which much is said, within what a scene may hold.
Scene told(const std::string& name, const std::string& words, const MeshPtr& mesh) {
  Scene scene = named(name, mesh);
  View view{.name = "Front"};
  view.words.text.text = words;
  scene.setViews(std::vector<View>(10, view));
  return scene;
}

/// The state after `place` steps, the last of which is called "to NAME".
JournalStep step(std::uint32_t place, std::uint32_t count, const Scene& scene) {
  return {.place = place,
          .count = count,
          .name = "to " + scene.nodes()[0].name,
          .scene = std::make_shared<const Scene>(scene)};
}

std::string bytesOf(const fs::path& file) {
  return readText(file, std::size_t(1) << 30).value();
}

/// Returns the names of the first nodes, the current one in brackets.
std::string namesIn(const Recovered& back) {
  std::string names;
  for (std::size_t i = 0; i < back.states.size(); ++i) {
    const std::string& name = back.states[i].scene.nodes()[0].name;
    names += i == back.current ? "[" + name + "]" : name;
  }
  return names;
}

std::string namesLeftIn(const fs::path& folder) {
  const auto found = recoverableIn(folder);
  const auto back = found.size() == 1 ? recovered(found[0]) : Result<Recovered>(Error{});
  return back.ok() ? namesIn(*back) : "nothing";
}
}  // namespace

class JournalTest : public QObject {
  Q_OBJECT
 private slots:
  void deltas();
  void smallEditsGiveSmallDeltas();
  void keptAndRecovered();
  void filesAreKeptWithTheirFolders();
  void history_data();
  void history();
  void tornAnywhere();
  void damagedByABit();
  void zerosAtTheEnd();
  void growsOnlySoFar();
  void meshesThatWereNotWritten();
  void whatIsAtFaultIsLeftOut();
  void aDamagedMeshLeavesAnEmptyRow();
  void aSuccessorCountsWhenTheOtherIsGone();
  void ofOneProcessEachHasItsOwn();
  void aFullDisk();
  void damagedJournalsAreFoundAllTheSame();
};

void JournalTest::deltas() {
  std::mt19937 random(1);
  const auto text = [&random](int lines) {
    std::string made;
    for (int i = 0; i < lines; ++i)
      made += std::string(random() % 3, char('a' + random() % 4)) + (random() % 20 ? "\n" : "");
    return made;
  };
  for (int i = 0; i < 2000; ++i) {
    const std::string before = text(int(random() % 40));
    std::string after = i % 2 ? text(int(random() % 40)) : before;
    if (i % 2 == 0)
      after.insert(random() % (after.size() + 1), text(3));
    const std::string delta = textDelta(before, after);
    QVERIFY(withDelta(before, delta) == after);
    // Cut off, it is refused or leads to something else, but reads nothing outside.
    static_cast<void>(withDelta(before, std::string_view(delta).substr(0, random() % 12)));
  }
  QCOMPARE(textDelta("same\n", "same\n").size(), std::size_t(12));
}

void JournalTest::smallEditsGiveSmallDeltas() {
  std::string before;
  for (int i = 0; i < 20'000; ++i)
    before += "line " + std::to_string(i % 50) + "\n";
  std::string after = before;
  after.replace(after.find("line 7\n", 1000), 7, "line seven\n");
  after.insert(after.find("line 9\n", 90'000), "more\nand more\n");
  after.erase(after.find("line 3\n", 60'000), 14);
  const std::string delta = textDelta(before, after);
  QVERIFY(withDelta(before, delta) == after);
  QVERIFY2(delta.size() < 200, std::to_string(delta.size()).c_str());
}

void JournalTest::keptAndRecovered() {
  const QTemporaryDir place;
  const fs::path folder = fs::path(place.path().toStdString()) / "new" / "journals";
  const JournalSource source{"Pélvis", "/home/someone/pelvis.sline", Fingerprint{12, 0xfedcba98u}};
  const SceneDocument document{
      .scene = test::sampleScene(), .thumbnail = "picture", .others = {{"notes.txt", "mine"}}};
  Scene edited = document.scene;
  edited.append({.name = "more", .mesh = test::sphere(3, 2)});
  edited.append({.name = "and more", .mesh = test::sphere(4, 2)});
  {
    const auto journal = Journal::reserve(folder);
    QVERIFY(journal.ok());
    Journal& kept = **journal;
    QVERIFY(kept.start(source, document, step(0, 0, document.scene)).ok());
    QVERIFY(kept.note({document.scene.nodes()[1].id}).ok());
    QVERIFY(kept.complete());  // they were few, and came first
    QVERIFY(kept.note(step(1, 1, edited)).ok());
    QVERIFY(!kept.complete());
    QVERIFY(kept.writeMeshes(0ms).ok() && !kept.complete());  // one at a time
    QVERIFY(kept.writeMeshes(1min).ok() && kept.sync().ok() && kept.complete());
    QVERIFY(recoverableIn(folder).empty());  // its program still runs
  }
  const auto found = recoverableIn(folder);
  QCOMPARE(found.size(), std::size_t(1));
  QVERIFY(found[0].source == source);
  const auto back = recovered(found[0]);
  QVERIFY2(back.ok(), back.ok() ? "" : back.error().text().c_str());
  QCOMPARE(back->states.size(), std::size_t(2));
  QCOMPARE(back->current, std::size_t(1));
  QCOMPARE(test::difference(back->states[0].scene, document.scene), std::string());
  QCOMPARE(test::difference(back->states[1].scene, edited), std::string());
  QVERIFY(back->selection == std::vector{document.scene.nodes()[1].id});
  QCOMPARE(back->rest.thumbnail, document.thumbnail);
  QCOMPARE(back->rest.others.size(), std::size_t(1));
  QCOMPARE(back->rest.others[0].bytes, std::string("mine"));
  forget(found[0]);
  QVERIFY(fs::is_empty(folder));
}

/// The next program may be started in another folder, where another file may have that name.
void JournalTest::filesAreKeptWithTheirFolders() {
  const QTemporaryDir place;
  const fs::path folder = place.path().toStdString();
  {
    const auto journal = Journal::reserve(folder);
    QVERIFY(journal.ok());
    QVERIFY((*journal)->start({"here", "here.sline"}, {}, step(0, 0, test::sampleScene())).ok());
    QVERIFY((*journal)->note(JournalSource{"there", "../there.sline"}).ok());
  }
  const auto found = recoverableIn(folder);
  QCOMPARE(found.size(), std::size_t(1));
  QVERIFY(found[0].source.file.is_absolute());
  QVERIFY(found[0].source.file == fs::absolute("../there.sline"));
  QVERIFY(!found[0].source.saved);
}

void JournalTest::history_data() {
  QTest::addColumn<QString>("steps");
  QTest::addColumn<QString>("left");
  // A letter is a step to the scene of that name, '<' and '>' go back and forth.
  QTest::newRow("one after the other") << "bcd"
                                       << "abc[d]";
  QTest::newRow("undone") << "bcd<<"
                          << "a[b]cd";
  QTest::newRow("and redone") << "bcd<<>"
                              << "ab[c]d";
  QTest::newRow("another way after undo") << "bcd<<e"
                                          << "ab[e]";
  QTest::newRow("before what the journal began with") << "b<<"
                                                      << "[?]ab";
  QTest::newRow("merged into the step before") << "bc=d"
                                               << "ab[d]";
}
void JournalTest::history() {
  QFETCH(QString, steps);
  QFETCH(QString, left);
  const QTemporaryDir place;
  const fs::path folder = place.path().toStdString();
  const MeshPtr mesh = test::sphere(1, 2);
  {
    const auto journal = Journal::reserve(folder);
    QVERIFY(journal.ok());
    std::string states = "??a";
    std::uint32_t at = 2;
    const auto now = [&] {
      return step(at, std::uint32_t(states.size() - 1), named(states.substr(at, 1), mesh));
    };
    QVERIFY((*journal)->start({"work", {}}, {}, now()).ok());
    for (const char c : steps.toStdString()) {
      if (c == '=') {
        states.resize(at--);
        continue;
      }
      if (c == '<')
        --at;
      else if (c == '>')
        ++at;
      else
        states = states.substr(0, ++at) + c;
      QVERIFY((*journal)->note(now()).ok());
    }
    QVERIFY((*journal)->writeMeshes(1min).ok());
  }
  QCOMPARE(QString::fromStdString(namesLeftIn(folder)), left);
  const auto back = recovered(recoverableIn(folder)[0]);
  QVERIFY(back.ok());
  for (const Recovered::State& state : back->states) {
    QCOMPARE(state.name, "to " + state.scene.nodes()[0].name);
    QVERIFY(state.scene.nodes()[0].mesh == back->states[0].scene.nodes()[0].mesh);
  }
}

void JournalTest::tornAnywhere() {
  JournalContent content{.source = {"work", {}},
                         .members = {},
                         .states = {},
                         .first = 3,
                         .current = 5,
                         .selection = {NodeId{4}}};
  for (const char* text : {"one\ntwo\n", "one\n2\n", "one\n2\nthree\n"})
    content.states.push_back({text, std::make_shared<const std::string>(text)});
  JournalWriter writer;
  const std::string bytes = journalBytes(content, writer);
  std::size_t most = 0;
  for (std::size_t size = 0; size <= bytes.size(); ++size) {
    const JournalContent read = journalContent(std::string_view(bytes).substr(0, size));
    QVERIFY(read.states.size() >= most);
    most = read.states.size();
    for (std::size_t i = 0; i < most; ++i)
      QVERIFY(read.states[i].name == content.states[i].name &&
              *read.states[i].text == *content.states[i].text);
  }
  const JournalContent read = journalContent(bytes);
  QVERIFY(most == 3 && read.first == 3 && read.current == 5);
  QVERIFY(read.selection == content.selection && read.source == content.source);
}

void JournalTest::damagedByABit() {
  std::string bytes(journalMagic);
  for (const char* payload : {"first", "second", "third"})
    bytes += recordOf(payload);
  for (std::size_t bit = 8 * journalMagic.size(); bit < 8 * bytes.size(); ++bit) {
    std::string damaged = bytes;
    damaged[bit / 8] = char(damaged[bit / 8] ^ (1 << bit % 8));
    RecordReader records(damaged);
    std::string all;
    while (const auto payload = records.next())
      all += *payload;
    QVERIFY2(all.empty() || all == "first" || all == "firstsecond", all.c_str());
  }
}

void JournalTest::zerosAtTheEnd() {
  const std::string bytes = std::string(journalMagic) + std::string(100, '\0');
  RecordReader records(bytes);
  QVERIFY(!records.next());
}

void JournalTest::growsOnlySoFar() {
  const QTemporaryDir place;
  const fs::path folder = place.path().toStdString();
  const MeshPtr mesh = test::sphere(1, 2);
  constexpr std::uint32_t steps = 50;
  const std::string filler(100'000, 'x');
  {
    const auto journal = Journal::reserve(folder);
    QVERIFY(journal.ok());
    QVERIFY((*journal)->start({"work", {}}, {}, step(0, 0, told("0", filler, mesh))).ok());
    std::uintmax_t largest = 0;
    for (std::uint32_t i = 1; i <= steps; ++i) {
      QVERIFY((*journal)
                  ->note(step(i, i,
                              told(std::to_string(i), std::to_string(i) + filler.substr(9), mesh)))
                  .ok());
      largest = std::max(largest, fs::file_size((*journal)->file()));
    }
    QVERIFY((*journal)->writeMeshes(1min).ok());
    QVERIFY2(largest < 90u << 20, std::to_string(largest).c_str());
  }
  const auto back = recovered(recoverableIn(folder)[0]);
  QVERIFY(back.ok());
  QVERIFY(back->states.size() > 10 && back->current + 1 == back->states.size());
  QVERIFY(back->states.back().scene.views()[9].words.text.text ==
          std::to_string(steps) + filler.substr(9));
}

void JournalTest::meshesThatWereNotWritten() {
  const QTemporaryDir place;
  const fs::path folder = place.path().toStdString();
  const fs::path file = folder / "saved.sline";
  const MeshPtr saved = test::sphere(1, 2);
  const MeshPtr fresh = test::sphere(2, 2);
  QVERIFY(writeSceneFile(file, {.scene = named("a", saved)}).ok());
  {
    const auto journal = Journal::reserve(folder);
    QVERIFY(journal.ok());
    QVERIFY((*journal)->start({"work", file}, {}, step(0, 0, named("a", saved))).ok());
    QVERIFY((*journal)->note(step(1, 1, named("b", saved))).ok());
    QVERIFY((*journal)->note(step(2, 2, named("c", fresh))).ok());
  }
  // The last state's mesh is nowhere; the others' has its own file, and is in the scene's.
  QCOMPARE(namesLeftIn(folder), std::string("a[b]"));
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".meshes")
      fs::resize_file(entry.path(), 0);
  QCOMPARE(namesLeftIn(folder), std::string("a[b]"));
  fs::remove(file);
  const auto nothing = recovered(recoverableIn(folder)[0]);
  QVERIFY(!nothing.ok() && !nothing.error().remedy.empty());
}

/// As of a scene file, only what is at fault is lost, and told.
void JournalTest::whatIsAtFaultIsLeftOut() {
  const QTemporaryDir place;
  const fs::path folder = place.path().toStdString();
  const MeshPtr mesh = test::sphere(1, 2);
  fs::path file;
  {
    const auto journal = Journal::reserve(folder);
    QVERIFY(journal.ok());
    file = (*journal)->file();
    QVERIFY((*journal)->start({"work", {}}, {}, step(0, 0, named("a", mesh))).ok());
    QVERIFY((*journal)->note({NodeId{0}, NodeId{1}}).ok());  // no node has the id 0
    QVERIFY((*journal)->note(step(1, 1, named("b", mesh))).ok());
    QVERIFY((*journal)->note(step(2, 2, named(std::string(1001, 'c'), mesh))).ok());
  }
  JournalContent content = journalContent(bytesOf(file));
  QCOMPARE(content.states.size(), std::size_t(3));
  QCOMPARE(content.selection, std::vector{NodeId{1}});
  for (JournalState& state : content.states) {
    std::string text = *state.text;
    text.insert(text.find("\"name\""), "\"locked\": 7,\n");
    state.text = std::make_shared<const std::string>(text);
  }
  JournalWriter writer;
  QVERIFY(writeText(file, journalBytes(content, writer)).ok());
  const auto found = recoverableIn(folder);
  QCOMPARE(found.size(), std::size_t(1));
  const auto back = recovered(found[0]);
  QVERIFY2(back.ok(), back.ok() ? "" : back.error().text().c_str());
  QCOMPARE(namesIn(*back), "ab[" + std::string(1000, 'c') + "]");
  QVERIFY(back->states[2].scene.nodes().back().mesh);
  const auto tells = [&back](const char* what) {
    return std::any_of(back->leftOut.begin(), back->leftOut.end(), [what](const std::string& line) {
      return line.find(what) != std::string::npos;
    });
  };
  QVERIFY(tells("locked): true or false is expected here"));
  QVERIFY(tells("the name is longer than 1000 bytes; it was cut there"));
}

/// Of a mesh that is nowhere any more the structure's row stays; the other structures are whole.
void JournalTest::aDamagedMeshLeavesAnEmptyRow() {
  const QTemporaryDir place;
  const fs::path folder = place.path().toStdString();
  fs::path file;
  {
    const auto journal = Journal::reserve(folder);
    QVERIFY(journal.ok());
    file = (*journal)->file();
    Scene scene;
    scene.append({.name = "first", .mesh = test::sphere(1, 2)});
    scene.append({.name = "second", .mesh = test::sphere(2, 2)});
    QVERIFY((*journal)->start({"work", {}}, {}, step(0, 0, scene)).ok());
    QVERIFY((*journal)->writeMeshes(1min).ok());
  }
  QVERIFY(recovered(recoverableIn(folder)[0])->leftOut.empty());
  const fs::path meshes = fs::path(file).replace_extension(".meshes");
  std::string bytes = bytesOf(meshes);
  bytes[bytes.size() / 4] ^= 1;
  QVERIFY(writeText(meshes, bytes).ok());
  const auto back = recovered(recoverableIn(folder)[0]);
  QVERIFY2(back.ok(), back.ok() ? "" : back.error().text().c_str());
  QCOMPARE(back->leftOut.size(), std::size_t(1));
  QVERIFY(back->leftOut[0].starts_with("\"first\" (nodes[0].mesh.file): "));
  const auto& nodes = back->states[0].scene.nodes();
  QCOMPARE(nodes.size(), std::size_t(2));
  QVERIFY(!nodes[0].mesh && nodes[1].mesh);
}

/// A document that was recovered has a journal of its own, which is the worse one until it is
/// whole. Where the program is killed before that, the next one begins from the old one again.
void JournalTest::aSuccessorCountsWhenTheOtherIsGone() {
  const QTemporaryDir place;
  const fs::path folder = place.path().toStdString();
  const MeshPtr mesh = test::sphere(1, 1);
  for (const char* name : {"a", "killed", "b"}) {
    SceneDocument rest;
    const auto left = recoverableIn(folder);
    if (!left.empty())
      rest.others.push_back(successionOf(left[0]));
    const auto journal = Journal::reserve(folder);
    QVERIFY(journal.ok());
    QVERIFY((*journal)->start({name, {}}, rest, step(0, 0, named(name, mesh))).ok());
    QVERIFY((*journal)->writeMeshes(1min).ok());
    QCOMPARE(recoverableIn(folder).size(), left.size());  // of a program that runs is none
    if (*name == 'b')
      forget(left[0]);
  }
  QCOMPARE(namesLeftIn(folder), std::string("[b]"));
  QVERIFY(recovered(recoverableIn(folder)[0])->rest.others.empty());
}

void JournalTest::ofOneProcessEachHasItsOwn() {
  const QTemporaryDir place;
  const fs::path folder = place.path().toStdString();
  QVERIFY(writeText(folder / "1-1.meshes", "of a program that was killed").ok());
  const auto a = Journal::reserve(folder);
  const auto b = Journal::reserve(folder);
  QVERIFY(a.ok() && b.ok());
  QVERIFY(!fs::exists(folder / "1-1.meshes"));
  QVERIFY((*a)->file() != (*b)->file());
  const JournalStep state = step(0, 0, named("a", test::sphere(1, 2)));
  QVERIFY((*a)->start({"a", {}}, {}, state).ok() && (*b)->start({"b", {}}, {}, state).ok());
  (*a)->discard();
  QVERIFY(!fs::exists((*a)->file()) && fs::exists((*b)->file()));
  QVERIFY(!Journal::reserve("/sys/journals").ok());
}

/// What cannot be kept leaves what was kept as it is, and is kept as soon as there is room.
void JournalTest::aFullDisk() {
  const QTemporaryDir place;
  const fs::path folder = place.path().toStdString();
  const MeshPtr mesh = test::sphere(1, 1);
  std::signal(SIGXFSZ, SIG_IGN);
  {
    const auto journal = Journal::reserve(folder);
    QVERIFY(journal.ok());
    QVERIFY((*journal)->start({"work", {}}, {}, step(0, 0, named("a", mesh))).ok());
    QVERIFY((*journal)->writeMeshes(1min).ok());
    const std::string before = bytesOf((*journal)->file());
    rlimit room{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &room), 0);
    const rlimit none{before.size() + 20, room.rlim_max};
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &none), 0);
    const Status full = (*journal)->note(step(1, 1, named("b", mesh)));
    const std::string after = bytesOf((*journal)->file());
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &room), 0);
    QVERIFY(!full.ok() && full.error().remedy.find("space") != std::string::npos);
    QVERIFY(after == before);
    QVERIFY((*journal)->note(step(2, 2, named("c", mesh))).ok());
  }
  QCOMPARE(namesLeftIn(folder), std::string("[c]"));
}

void JournalTest::damagedJournalsAreFoundAllTheSame() {
  const QTemporaryDir place;
  const fs::path folder = place.path().toStdString();
  QVERIFY(writeText(folder / "1-1.journal", "damaged").ok());
  QVERIFY(writeText(folder / "2-1.journal", "").ok());
  QVERIFY(writeText(folder / "note.txt", "nothing of ours").ok());
  const auto found = recoverableIn(folder);
  QCOMPARE(found.size(), std::size_t(1));
  QVERIFY(found[0].source.title.empty());
  const auto back = recovered(found[0]);
  QVERIFY(!back.ok() && back.error().file == found[0].journal.string());
}

SLINE_TEST_WITH_EVENTS(JournalTest)
#include "journal_test.moc"
