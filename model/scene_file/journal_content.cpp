// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/journal_content.h"

#include <algorithm>
#include <limits>
#include <set>
#include <system_error>

#include "model/scene_file/journal_records.h"
#include "model/scene_file/text_delta.h"
#include "model/scene_json/scene_json.h"
#include "model/scene_json/scene_reader.h"

namespace sline::model {

namespace {
constexpr char sourceKind = 'D';
constexpr char memberKind = 'O';
constexpr char stateKind = 'S';
constexpr char selectionKind = 'L';

/// The texts of all records together have at most so many bytes, and so many are held at a time; a
/// journal is made shorter long before (journal.cpp).
constexpr std::size_t mostStateText = std::size_t(1) << 30;
constexpr std::size_t mostHeldText = std::size_t(256) << 20;

/// Puts the journal's content together, record by record.
class ContentReader {
 public:
  /// Returns false where the record does not fit to those before it; what follows it does neither.
  bool take(std::string_view payload) {
    const char kind = payload.front();
    payload.remove_prefix(1);
    switch (kind) {
      case sourceKind:
        takeSource(payload);
        return true;
      case memberKind:
        return takeMember(payload);
      case stateKind:
        return takeState(payload);
      case selectionKind:
        takeSelection(payload);
        return true;
      default:
        return true;  // of a newer program
    }
  }
  JournalContent content() && { return std::move(m_content); }

 private:
  /// Takes what can be read of it; what follows makes sense without the rest.
  void takeSource(std::string_view text) {
    const Result<Json> json = parseJson(text);
    if (!json.ok())
      return;
    std::vector<JsonRefusal> unread;
    JsonFault fault;
    fault.all = &unread;
    const JsonValue value(*json, fault);
    JsonObject object(value);
    JournalSource source;
    readInto(object.take("title"), source.title, asText);
    readInto(object.take("file"), source.file, asText);
    Fingerprint saved;
    const auto bytes = object.take("bytes");
    const auto crc = object.take("crc");
    const FaultWatch watch(fault);
    readInto(bytes, saved.bytes, [](const JsonValue& number) {
      return std::uint64_t(number.whole(0, std::numeric_limits<std::int64_t>::max()));
    });
    readInto(crc, saved.crc, [](const JsonValue& number) {
      return std::uint32_t(number.whole(0, std::numeric_limits<std::uint32_t>::max()));
    });
    if (bytes && crc && watch.clean())
      source.saved = saved;
    m_content.source = source;
  }

  bool takeMember(std::string_view bytes) {
    const auto length = takeNumber(bytes);
    const auto name = length ? takeBytes(bytes, *length) : std::nullopt;
    if (name)
      m_content.members.push_back({std::string(*name), std::string(bytes)});
    return name.has_value();
  }

  void takeSelection(std::string_view text) {
    const Result<Json> json = parseJson(text);
    if (!json.ok())
      return;
    std::vector<JsonRefusal> unread;
    JsonFault fault;
    fault.all = &unread;
    m_content.selection.clear();
    JsonValue(*json, fault).forEach([this](const JsonValue& value) {
      if (const auto id = sound(value, idOf))
        m_content.selection.push_back(NodeId{*id});
    });
  }

  bool takeState(std::string_view bytes) {
    const auto place = takeNumber(bytes);
    const auto count = takeNumber(bytes);
    const auto length = takeNumber(bytes);
    const auto name = length ? takeBytes(bytes, *length) : std::nullopt;
    auto text = name && *count >= *place ? withDelta(*m_last, bytes) : std::nullopt;
    if (!text || (m_text += text->size()) > mostStateText)
      return false;
    m_last = std::make_shared<const std::string>(std::move(*text));
    put(*place, {std::string(*name), m_last});
    const std::size_t most = std::size_t(*count) - m_content.first + 1;
    if (m_content.states.size() > most)
      m_content.states.resize(most);
    // What is held is counted again only when it may be too much.
    if ((m_held += m_last->size() + name->size()) > mostHeldText)
      m_held = dropFarStates(m_content, mostHeldText / 2);
    return true;
  }

  void put(std::uint32_t place, JournalState state) {
    JournalContent& to = m_content;
    const std::uint64_t end = to.first + std::uint64_t(to.states.size());
    if (!to.states.empty() && place >= to.first && place < end) {
      to.states[place - to.first] = std::move(state);
    } else if (!to.states.empty() && place == end) {
      to.states.push_back(std::move(state));
    } else if (!to.states.empty() && place + std::uint64_t(1) == to.first) {
      to.states.push_front(std::move(state));
      to.first = place;
    } else {  // nothing leads there from the others
      to.states.clear();
      to.states.push_back(std::move(state));
      to.first = place;
    }
    to.current = place;
  }

  JournalContent m_content;
  std::shared_ptr<const std::string> m_last = std::make_shared<const std::string>();
  std::size_t m_text = 0;
  std::size_t m_held = 0;
};

/// Separates the lines of keys from scene.json.
std::pair<std::string_view, std::string_view> partsOf(std::string_view text) {
  const std::size_t end = text.starts_with('{') ? 0 : text.find("\n{");
  if (end == std::string_view::npos)
    return {text, {}};
  const std::size_t json = end == 0 ? 0 : end + 1;
  return {text.substr(0, json), text.substr(json)};
}

/// Calls visit(name, key) for each line "key name".
template <class Visit>
void forEachKey(std::string_view lines, const Visit& visit) {
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    const std::string_view line = lines.substr(0, end);
    lines.remove_prefix(std::min(end + 1, lines.size()));
    if (const std::size_t space = line.find(' '); space != std::string_view::npos)
      visit(line.substr(space + 1), line.substr(0, space));
  }
}
}  // namespace

std::string JournalWriter::source(const JournalSource& source) const {
  std::error_code fault;  // no folder is at work: the path stays as it is, and is not trusted later
  const std::filesystem::path file =
      source.file.empty() ? source.file : std::filesystem::absolute(source.file, fault);
  Json json = {{"title", source.title}, {"file", fault ? source.file.string() : file.string()}};
  if (source.saved)
    json.update({{"bytes", source.saved->bytes}, {"crc", source.saved->crc}});
  return recordOf(sourceKind + json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string JournalWriter::member(const ZipMember& member) const {
  std::string payload(1, memberKind);
  appendNumber(payload, std::uint32_t(member.name.size()));
  return recordOf(payload + member.name + member.bytes);
}

std::string JournalWriter::selection(const std::vector<NodeId>& ids) const {
  Json json = Json::array();
  for (const NodeId id : ids)
    json.push_back(id.value);
  return recordOf(selectionKind + json.dump());
}

std::string JournalWriter::state(std::uint32_t place, std::uint32_t count,
                                 const JournalState& state) const {
  std::string payload(1, stateKind);
  appendNumber(payload, place);
  appendNumber(payload, count);
  appendNumber(payload, std::uint32_t(state.name.size()));
  return recordOf(payload + state.name + textDelta(*m_last, *state.text));
}

JournalContent journalContent(std::string_view bytes) {
  RecordReader records(bytes);
  ContentReader reader;
  while (const auto payload = records.next())
    if (!reader.take(*payload))
      break;
  return std::move(reader).content();
}

std::string journalBytes(const JournalContent& content, JournalWriter& writer) {
  std::string bytes(journalMagic);
  bytes += writer.source(content.source);
  for (const ZipMember& member : content.members)
    bytes += writer.member(member);
  writer = {};
  const auto count = std::uint32_t(content.first + content.states.size() - 1);
  const auto add = [&](std::uint32_t place) {
    const JournalState& state = content.states[place - content.first];
    bytes += writer.state(place, count, state);
    writer.wrote(state);
  };
  for (std::uint32_t i = 0; i < content.states.size(); ++i)
    add(content.first + i);
  if (!content.states.empty() && content.current != count)
    add(content.current);
  if (!content.selection.empty())
    bytes += writer.selection(content.selection);
  return bytes;
}

std::size_t dropFarStates(JournalContent& content, std::size_t bytes) {
  const auto sizeOf = [](const JournalState& state) {
    return state.name.size() + state.text->size();
  };
  std::size_t held = 0;
  for (const JournalState& state : content.states)
    held += sizeOf(state);
  while (held > bytes && content.states.size() > 1) {
    const bool back = content.current > content.first;
    held -= sizeOf(back ? content.states.front() : content.states.back());
    if (back) {
      content.states.pop_front();
      ++content.first;
    } else {
      content.states.pop_back();
    }
  }
  return held;
}

std::string stateText(const Scene& scene, BulkKeys& keys) {
  std::string text;
  std::set<std::string_view> named;
  const std::map<MeshPtr, std::string> names = meshNames(scene);
  for (const Node& node : scene.nodes())
    if (const auto name = names.find(node.mesh); name != names.end())
      if (named.insert(name->second).second)
        text += keys.of(node.mesh) + " " + name->second + "\n";
  for (const Node& node : scene.nodes())
    if (node.paint)
      text += keys.of(node.paint) + " " + paintName(node.id) + "\n";
  for (std::size_t n = 0; n < scene.scans().size(); ++n)
    text += keys.of(scene.scans()[n].voxels) + " " + voxelsName(n) + "\n";
  return text + sceneJson(scene);
}

Result<Scene> sceneOfState(std::string_view text, const Bulk& bulk,
                           std::vector<JsonRefusal>& leftOut) {
  const auto [lines, json] = partsOf(text);
  Json root = TRY(parseJson(json, sceneJsonLimits));
  SceneParts parts;
  forEachKey(lines, [&](std::string_view name, std::string_view key) {
    const auto item = bulk.find(key);
    if (item == bulk.end())
      return;
    if (const auto* mesh = std::get_if<MeshPtr>(&item->second))
      parts.meshes[std::string(name)] = *mesh;
    else if (const auto* paint = std::get_if<PaintPtr>(&item->second))
      parts.paints[std::string(name)] = *paint;
    else
      parts.voxels[std::string(name)] = std::get<VoxelsPtr>(item->second);
  });
  return sceneFromJson(root, parts, leftOut);
}

std::vector<std::string> keysCalledFor(std::string_view text) {
  std::vector<std::string> keys;
  forEachKey(partsOf(text).first,
             [&keys](std::string_view, std::string_view key) { keys.emplace_back(key); });
  return keys;
}

}  // namespace sline::model
