// SPDX-License-Identifier: Apache-2.0
#include "render/export/anki/anki_package.h"

#include <sqlite3.h>

#include <QCryptographicHash>
#include <memory>
#include <nlohmann/json.hpp>
#include <variant>

namespace sline::render {

namespace {

using Json = nlohmann::ordered_json;
using Value = std::variant<std::int64_t, std::string>;

/// Anki takes these numbers for times in milliseconds; ours stand for no particular day.
constexpr std::int64_t firstId = 1'400'000'000'000;
constexpr std::int64_t noteType = firstId;
constexpr std::int64_t begun = 1'400'000'000;

std::int64_t idOf(const std::string& text) {
  constexpr std::uint64_t range = 100'000'000'000;
  return firstId + 2 + std::int64_t(fingerprintOf(text) % range);
}

std::string textOf(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

constexpr const char* schema =
    "CREATE TABLE col (id integer PRIMARY KEY, crt integer NOT NULL, mod integer NOT NULL,"
    " scm integer NOT NULL, ver integer NOT NULL, dty integer NOT NULL, usn integer NOT NULL,"
    " ls integer NOT NULL, conf text NOT NULL, models text NOT NULL, decks text NOT NULL,"
    " dconf text NOT NULL, tags text NOT NULL);"
    "CREATE TABLE notes (id integer PRIMARY KEY, guid text NOT NULL, mid integer NOT NULL,"
    " mod integer NOT NULL, usn integer NOT NULL, tags text NOT NULL, flds text NOT NULL,"
    " sfld integer NOT NULL, csum integer NOT NULL, flags integer NOT NULL, data text NOT NULL);"
    "CREATE TABLE cards (id integer PRIMARY KEY, nid integer NOT NULL, did integer NOT NULL,"
    " ord integer NOT NULL, mod integer NOT NULL, usn integer NOT NULL, type integer NOT NULL,"
    " queue integer NOT NULL, due integer NOT NULL, ivl integer NOT NULL, factor integer NOT NULL,"
    " reps integer NOT NULL, lapses integer NOT NULL, left integer NOT NULL, odue integer NOT NULL,"
    " odid integer NOT NULL, flags integer NOT NULL, data text NOT NULL);"
    "CREATE TABLE revlog (id integer PRIMARY KEY, cid integer NOT NULL, usn integer NOT NULL,"
    " ease integer NOT NULL, ivl integer NOT NULL, lastIvl integer NOT NULL,"
    " factor integer NOT NULL, time integer NOT NULL, type integer NOT NULL);"
    "CREATE TABLE graves (usn integer NOT NULL, oid integer NOT NULL, type integer NOT NULL);"
    "CREATE INDEX ix_notes_usn ON notes (usn);"
    "CREATE INDEX ix_cards_usn ON cards (usn);"
    "CREATE INDEX ix_revlog_usn ON revlog (usn);"
    "CREATE INDEX ix_cards_nid ON cards (nid);"
    "CREATE INDEX ix_cards_sched ON cards (did, queue, due);"
    "CREATE INDEX ix_revlog_cid ON revlog (cid);"
    "CREATE INDEX ix_notes_csum ON notes (csum);";

/// A database in memory.
class Database {
 public:
  Database() {
    sqlite3* opened = nullptr;
    m_fine = sqlite3_open(":memory:", &opened) == SQLITE_OK;
    m_data.reset(opened);
  }

  void run(const char* statements) {
    m_fine =
        m_fine && sqlite3_exec(m_data.get(), statements, nullptr, nullptr, nullptr) == SQLITE_OK;
  }

  void insert(const std::string& table, const std::vector<Value>& values) {
    std::string statement = "INSERT INTO " + table + " VALUES (";
    for (std::size_t i = 0; i < values.size(); ++i)
      statement += i == 0 ? "?" : ",?";
    sqlite3_stmt* prepared = nullptr;
    m_fine = m_fine && sqlite3_prepare_v2(m_data.get(), (statement + ")").c_str(), -1, &prepared,
                                          nullptr) == SQLITE_OK;
    for (std::size_t i = 0; i < values.size() && m_fine; ++i) {
      const auto* text = std::get_if<std::string>(&values[i]);
      const int bound =
          text ? sqlite3_bind_text(prepared, int(i) + 1, text->data(), int(text->size()),
                                   SQLITE_TRANSIENT)
               : sqlite3_bind_int64(prepared, int(i) + 1, std::get<std::int64_t>(values[i]));
      m_fine = bound == SQLITE_OK;
    }
    m_fine = m_fine && sqlite3_step(prepared) == SQLITE_DONE;
    sqlite3_finalize(prepared);
  }

  /// Returns the whole database as the bytes of a file.
  Result<std::string> bytes() const {
    sqlite3_int64 size = 0;
    const std::unique_ptr<unsigned char, void (*)(void*)> data(
        m_fine ? sqlite3_serialize(m_data.get(), "main", &size, 0) : nullptr, sqlite3_free);
    if (!data)
      return Error{
          .reason = "the collection cannot be made: " + std::string(sqlite3_errmsg(m_data.get())),
          .remedy = "Write the deck as a folder"};
    return std::string(data.get(), data.get() + size);
  }

 private:
  struct Close {
    void operator()(sqlite3* data) const { sqlite3_close(data); }
  };
  std::unique_ptr<sqlite3, Close> m_data;
  bool m_fine = false;
};

Json configuration() {
  return {{"activeDecks", {1}}, {"addToCur", true},       {"collapseTime", 1200},
          {"curDeck", 1},       {"curModel", noteType},   {"dueCounts", true},
          {"estTimes", true},   {"newBury", true},        {"newSpread", 0},
          {"nextPos", 1},       {"sortBackwards", false}, {"sortType", "noteFld"},
          {"timeLim", 0}};
}

Json field(const char* name, int place) {
  return {{"name", name},    {"ord", place}, {"sticky", false},       {"rtl", false},
          {"font", "Arial"}, {"size", 20},   {"media", Json::array()}};
}

/// A template of cards; those without that field have none.
Json cardOf(int place, const char* name, const char* field, const char* answer) {
  const std::string front =
      "{{#" + std::string(field) + "}}{{" + std::string(field) + "}}{{/" + field + "}}";
  return {{"name", name},   {"ord", place}, {"qfmt", front}, {"afmt", answer},
          {"did", nullptr}, {"bqfmt", ""},  {"bafmt", ""}};
}

Json noteTypes(std::int64_t deck) {
  const char* named = "{{Answer}}<div class=label>{{Label}}</div>";
  Json cards{cardOf(0, "What is this?", "Marked", named),
             cardOf(1, "Which number?", "Numbered",
                    "<div class=label>{{Number}}</div>{{Answer}}<div class=label>{{Label}}</div>"),
             cardOf(2, "Which name?", "Covered", named)};
  Json needs = Json::array();
  for (const int place : {0, 1, 2})
    needs.push_back(Json::array({place, "all", Json::array({place + 2})}));
  Json type{{"id", noteType},
            {"name", "Sline picture"},
            {"type", 0},
            {"mod", begun},
            {"usn", -1},
            // Notes are distinguished by their labels.
            {"sortf", 0},
            {"did", deck},
            {"tmpls", std::move(cards)},
            {"flds",
             {field("Label", 0), field("Answer", 1), field("Marked", 2), field("Numbered", 3),
              field("Covered", 4), field("Number", 5)}},
            {"css",
             ".card { font-family: sans-serif; font-size: 20px; text-align: center; margin: 6px; "
             "color: #111; background-color: #fff; }\n.label { margin: 0.3em 0; }"},
            {"latexPre", ""},
            {"latexPost", ""},
            {"tags", Json::array()},
            {"vers", Json::array()},
            {"req", std::move(needs)}};
  return {{std::to_string(noteType), std::move(type)}};
}

Json deckNamed(const std::string& name, std::int64_t id, const std::string& description = {}) {
  Json deck{
      {"id", id}, {"name", name}, {"mod", begun},       {"usn", -1},       {"desc", description},
      {"dyn", 0}, {"conf", 1},    {"collapsed", false}, {"extendNew", 10}, {"extendRev", 50}};
  for (const char* today : {"newToday", "revToday", "lrnToday", "timeToday"})
    deck[today] = {0, 0};
  return deck;
}

Json deckOptions() {
  return {
      {"1",
       {{"id", 1},
        {"name", "Default"},
        {"mod", 0},
        {"usn", 0},
        {"maxTaken", 60},
        {"timer", 0},
        {"autoplay", true},
        {"replayq", true},
        {"new",
         {{"delays", {1, 10}},
          {"ints", {1, 4, 7}},
          {"initialFactor", 2500},
          {"order", 1},
          {"perDay", 20},
          {"bury", false},
          {"separate", true}}},
        {"rev",
         {{"perDay", 200},
          {"ease4", 1.3},
          {"fuzz", 0.05},
          {"minSpace", 1},
          {"ivlFct", 1},
          {"maxIvl", 36500},
          {"bury", false}}},
        {"lapse",
         {{"delays", {10}}, {"mult", 0}, {"minInt", 1}, {"leechFails", 8}, {"leechAction", 0}}}}}};
}

/// Returns the first 32 bits of the SHA-1 of the first field, by which Anki finds notes that are
/// alike.
std::int64_t checksum(const std::string& text) {
  const QByteArray hash =
      QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha1);
  return hash.left(4).toHex().toLongLong(nullptr, 16);
}

std::int64_t deckIdOf(const AnkiDeck& deck, const AnkiPart& part) {
  return idOf("deck " + deck.nameOf(part));
}

std::string spacedTags(const AnkiPart& part) {
  std::string tags;
  for (const std::string& tag : part.tags)
    tags += " " + tag;
  return tags.empty() ? tags : tags + " ";
}

void addNotes(Database& database, const AnkiDeck& deck) {
  const std::int64_t zero = 0;
  const std::int64_t none = -1;
  std::int64_t due = 0;
  for (const AnkiNote& note : deck.notes) {
    const AnkiPart& part = deck.parts[note.part];
    const std::string label = htmlText(note.label);
    std::string fields = label;
    // Fields are separated by U+001F.
    for (const AnkiFace* face : {&note.named, &note.marked, &note.numbered, &note.covered})
      fields += "\x1f" + htmlOf(*face);
    fields += "\x1f" + htmlText(note.numbers);
    const std::int64_t id = idOf(note.id);
    database.insert("notes", {id, note.id, noteType, begun, none, spacedTags(part), fields, label,
                              checksum(label), zero, std::string()});
    std::int64_t place = 0;
    for (const AnkiFace* face : {&note.marked, &note.numbered, &note.covered}) {
      const std::string card = note.id + " card" + (place == 0 ? "" : std::to_string(place));
      if (!face->empty())
        database.insert(
            "cards", {idOf(card), id, deckIdOf(deck, part), place, begun, none, zero, zero, ++due,
                      zero, zero, zero, zero, zero, zero, zero, zero, std::string()});
      ++place;
    }
  }
}

/// Returns the decks: Anki's own, which must be there, that of the name, and those in it.
Json decksOf(const AnkiDeck& deck) {
  Json decks;
  decks["1"] = deckNamed("Default", 1);
  const std::int64_t whole = idOf("deck " + deck.name);
  decks[std::to_string(whole)] = deckNamed(deck.name, whole, htmlText(deck.description));
  for (const AnkiPart& part : deck.parts)
    if (const std::int64_t id = deckIdOf(deck, part); id != whole)
      decks[std::to_string(id)] = deckNamed(deck.nameOf(part), id);
  return decks;
}

}  // namespace

Result<std::string> ankiPackage(const AnkiDeck& deck) {
  Database database;
  database.run(schema);
  const std::int64_t zero = 0;
  database.insert("col",
                  {std::int64_t(1), begun, 1000 * begun, 1000 * begun, std::int64_t(11), zero, zero,
                   zero, textOf(configuration()), textOf(noteTypes(idOf("deck " + deck.name))),
                   textOf(decksOf(deck)), textOf(deckOptions()), std::string("{}")});
  addNotes(database, deck);
  std::string collection = TRY(database.bytes());
  std::vector<model::ZipMember> members{{"collection.anki2", std::move(collection)}};
  // Pictures are stored under numbers; a table has their names.
  Json names = Json::object();
  for (std::size_t i = 0; i < deck.media.size(); ++i) {
    names[std::to_string(i)] = deck.media[i].name;
    members.push_back({std::to_string(i), deck.media[i].bytes});
  }
  members.push_back({"media", textOf(names)});
  std::vector<const model::ZipMember*> all;
  all.reserve(members.size());
  for (const model::ZipMember& member : members)
    all.push_back(&member);
  return model::zipped(all);
}

}  // namespace sline::render
