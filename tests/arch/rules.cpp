// SPDX-License-Identifier: Apache-2.0
#include "tests/arch/rules.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>

namespace sline::arch {

namespace {
bool isHeader(const std::string& path) {
  return path.ends_with(".h");
}

const std::regex includeLine(R"re(\s*#\s*include\s*(<([^>]+)>|"([^"]+)").*)re");

bool isTest(const std::string& path) {
  return isUnder(path, "tests");
}

void checkLibrary(const File& file, const std::string& header, const House& house,
                  Complaints& out) {
  for (const Library& library : house.libraries) {
    if (!std::regex_match(header, library.headers))
      continue;
    const bool allowed =
        std::any_of(library.folders.begin(), library.folders.end(),
                    [&](const std::string& folder) { return isUnder(file.path, folder); });
    if (!allowed)
      out.push_back(file.path + " includes <" + header + ">: " + library.name +
                    " stays out of here");
    if (library.sourcesAlone && isHeader(file.path) && !isTest(file.path))
      out.push_back(file.path + ": " + library.name + " stays out of headers");
  }
}

/// Returns the rooms that a file enters, its own left out.
std::vector<std::string> roomsEntered(const File& file, const House& house) {
  std::vector<std::string> rooms;
  for (const std::string& line : linesOf(file.text)) {
    std::smatch match;
    if (!std::regex_match(line, match, includeLine) || !match[3].matched)
      continue;
    const std::string room = roomOf(house, match[3]);
    if (!room.empty() && room != roomOf(house, file.path))
      rooms.push_back(room);
  }
  return rooms;
}

void checkRoom(const File& file, const std::string& included, const House& house, Complaints& out) {
  const std::string from = roomOf(house, file.path);
  const std::string to = roomOf(house, included);
  if (isTest(file.path) || from == to)
    return;
  if (from.empty()) {
    out.push_back(file.path + " lies in no room of the table");
    return;
  }
  // Generated files have no folder, and shaders' snippets no room.
  if (to.empty() && (included.find('/') == std::string::npos || isUnder(included, "resources")))
    return;
  // What a room shares with shaders lies in a folder of its own.
  if (included.ends_with(".glsl") && included.starts_with(from + "/"))
    return;
  const Room& room = house.rooms.at(from);
  if (!room.mayUse.contains(to) && !room.wholeLayers.contains(to.substr(0, to.find('/'))))
    out.push_back(file.path + " includes \"" + included + "\": " + from + " may not enter " +
                  (to.empty() ? "what is no room" : to));
}

/// Returns the headers that a CMakeLists.txt lists as those that others include, from the tree's
/// top.
std::set<std::string> listedHeaders(const File& lists) {
  static const std::regex part(R"(\bHEADERS((\s+[\w./]+\.h)+))");
  static const std::regex header(R"([\w./]+\.h)");
  const std::string folder = lists.path.substr(0, lists.path.rfind('/') + 1);
  std::set<std::string> all;
  for (std::sregex_iterator it(lists.text.begin(), lists.text.end(), part), end; it != end; ++it) {
    const std::string names = (*it)[1];
    for (std::sregex_iterator name(names.begin(), names.end(), header); name != end; ++name)
      all.insert(folder + name->str());
  }
  return all;
}

/// Returns the folder of the CMakeLists.txt that a file belongs to.
std::string targetOf(const std::string& path, const std::set<std::string>& folders) {
  std::string folder = path.substr(0, path.rfind('/'));
  while (!folder.empty() && !folders.contains(folder))
    folder = folder.find('/') == std::string::npos ? "" : folder.substr(0, folder.rfind('/'));
  return folder;
}

/// Describes a definition: its first line, the lines of its signature joined, and how many lines it
/// takes.
struct Function {
  std::size_t line;
  std::string signature;
  std::size_t length;
};

bool opensFunction(const std::string& signature) {
  static const std::regex other(
      R"(\s*(namespace|class|struct|enum|union|extern|static const std::|const std::|if|for|while|switch|do|else|return|public|private|constexpr std::array)\b.*)");
  static const std::regex lambda(R"(\[[^\[\]]*\] ?[({])");
  return signature.find('(') != std::string::npos && signature.ends_with("{") &&
         !std::regex_match(signature, other) && !std::regex_search(signature, lambda);
}

/// Collects functions with definitions that start at this indentation, in clang-format's shape.
void collectFunctions(const std::vector<std::string>& lines, std::size_t indent,
                      std::vector<Function>& out) {
  const std::string margin(indent, ' ');
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& first = lines[i];
    if (first.size() <= indent || !first.starts_with(margin) || first[indent] == ' ' ||
        first[indent] == '#' || first[indent] == '}' || first[indent] == '/')
      continue;
    std::string signature = first;
    std::size_t open = i;
    while (!signature.ends_with("{") && !signature.ends_with(";") && open + 1 < lines.size() &&
           open < i + 12)
      signature += " " + lines[++open];
    if (!opensFunction(signature))
      continue;
    const auto close = std::find_if(lines.begin() + std::ptrdiff_t(open), lines.end(),
                                    [&](const std::string& line) { return line == margin + "}"; });
    if (close == lines.end())
      continue;
    out.push_back({i + 1, signature, std::size_t(close - lines.begin()) - i + 1});
  }
}

std::size_t parameterCount(const std::string& signature) {
  int round = 0;
  int angle = 0;
  std::size_t commas = 0;
  bool any = false;
  for (std::size_t i = signature.find('('); i < signature.size(); ++i) {
    const char c = signature[i];
    round += (c == '(' || c == '{') - (c == ')' || c == '}');
    angle += (c == '<') - (c == '>' && signature[i - 1] != '-');
    if (round == 0)
      break;
    any = any || (round == 1 && c != '(' && c != ' ');
    commas += round == 1 && angle == 0 && c == ',';
  }
  return any ? commas + 1 : 0;
}
}  // namespace

Complaints checkIncludes(const File& file, const House& house) {
  Complaints out;
  static const std::regex glType(R"(.*\bGL(uint|int|enum|sizei|float|boolean|bitfield|sync)\b.*)");
  for (const std::string& line : linesOf(file.text)) {
    std::smatch match;
    if (std::regex_match(line, match, includeLine)) {
      if (match[2].matched)
        checkLibrary(file, match[2], house, out);
      else
        checkRoom(file, match[3], house, out);
    } else if (isHeader(file.path) && !isUnder(file.path, "render/gpu") &&
               std::regex_match(line, glType)) {
      out.push_back(file.path + " shows an OpenGL type: " + line);
    }
  }
  return out;
}

Complaints checkPermissions(const std::vector<File>& files, const House& house) {
  std::map<std::string, std::set<std::string>> used;
  std::set<std::string> there;
  for (const File& file : files) {
    const std::string from = roomOf(house, file.path);
    there.insert(from);
    for (const std::string& to : roomsEntered(file, house))
      used[from].insert(to);
  }
  Complaints out;
  for (const auto& [name, room] : house.rooms) {
    if (!there.contains(name))
      out.push_back("the table has " + name + ", where no source is");
    for (const std::string& to : room.mayUse)
      if (!used[name].contains(to))
        out.push_back("the table lets " + name + " into " + to + ", where it never goes");
  }
  return out;
}

Complaints checkPublicHeaders(const std::vector<File>& sources, const std::vector<File>& lists) {
  std::set<std::string> folders;
  std::set<std::string> listed;
  for (const File& list : lists) {
    if (list.text.find("room(") == std::string::npos || isTest(list.path) ||
        list.path.find('/') == std::string::npos)
      continue;
    folders.insert(list.path.substr(0, list.path.rfind('/')));
    listed.merge(listedHeaders(list));
  }
  Complaints out;
  std::set<std::string> used;
  for (const File& file : sources) {
    if (isTest(file.path))
      continue;
    for (const std::string& line : linesOf(file.text)) {
      std::smatch match;
      if (!std::regex_match(line, match, includeLine) || !match[3].matched)
        continue;
      const std::string header = match[3];
      const std::string home = targetOf(header, folders);
      if (home.empty() || home == targetOf(file.path, folders))
        continue;
      used.insert(header);
      if (!listed.contains(header))
        out.push_back(file.path + " includes \"" + header + "\", which " + home +
                      " keeps to itself");
    }
  }
  for (const std::string& header : listed)
    if (!used.contains(header))
      out.push_back(header + " is listed for others, and none includes it");
  return out;
}

std::map<std::string, std::string> targetsIn(const std::vector<File>& lists) {
  static const std::regex definition(R"((?:sline_room|sline_widget_room)\((sline_\w+))");
  std::map<std::string, std::string> targets;
  for (const File& list : lists)
    for (std::sregex_iterator it(list.text.begin(), list.text.end(), definition), end; it != end;
         ++it)
      if (!isTest(list.path))
        targets[(*it)[1]] = list.path.substr(0, list.path.rfind('/'));
  return targets;
}

Complaints checkLinks(const File& list, const std::map<std::string, std::string>& targets,
                      const House& house) {
  static const std::regex target(R"(\bsline_\w+)");
  static const std::regex widgets("Qt6::\\w*Widgets");
  std::set<std::string> folders;
  for (const auto& [name, folder] : targets)
    folders.insert(folder);
  const std::string home = list.path.substr(0, list.path.rfind('/'));
  Complaints out;
  if (!isUnder(home, "widgets") && !isUnder(home, "app") && std::regex_search(list.text, widgets))
    out.push_back(list.path + " links Qt's widgets");
  if (!folders.contains(home))
    return out;
  std::set<std::string> allowed{home};
  std::set<std::string> layers;
  for (const auto& [name, room] : house.rooms) {
    if (targetOf(name + "/", folders) != home)
      continue;
    layers.insert(room.wholeLayers.begin(), room.wholeLayers.end());
    for (const std::string& other : room.mayUse)
      allowed.insert(targetOf(other + "/", folders));
  }
  for (std::sregex_iterator it(list.text.begin(), list.text.end(), target), end; it != end; ++it) {
    const auto linked = targets.find(it->str());
    if (linked != targets.end() && !allowed.contains(linked->second) &&
        !layers.contains(linked->second.substr(0, linked->second.find('/'))))
      out.push_back(list.path + " links " + linked->first + ", whose room its own may not enter");
  }
  return out;
}

Complaints checkSizes(const File& file, const House& house) {
  Complaints out;
  if (house.largeFiles.contains(file.path))
    return out;
  const std::vector<std::string> lines = linesOf(file.text);
  const std::size_t limit = isHeader(file.path) ? 250 : 500;
  if (lines.size() > limit)
    out.push_back(file.path + " has " + std::to_string(lines.size()) + " lines, not at most " +
                  std::to_string(limit));
  std::vector<Function> functions;
  collectFunctions(lines, 0, functions);
  collectFunctions(lines, 1, functions);
  collectFunctions(lines, 2, functions);
  for (const Function& f : functions) {
    const std::string where = file.path + ":" + std::to_string(f.line);
    // A table of test rows reads best in one piece.
    const bool rows = f.signature.find("_data()") != std::string::npos;
    if (f.length > 60 && !rows)
      out.push_back(where + ": a function of " + std::to_string(f.length) + " lines");
    if (parameterCount(f.signature) > 5)
      out.push_back(where + ": more than five parameters");
  }
  return out;
}

Complaints checkRoomSizes(const std::vector<File>& files, const House& house,
                          const std::map<std::string, std::size_t>& larger) {
  constexpr std::size_t most = 4000;
  std::map<std::string, std::size_t> sizes;
  for (const File& file : files)
    if (const std::string room = roomOf(house, file.path); !room.empty() && !isTest(file.path))
      sizes[room] += linesOf(file.text).size();
  Complaints out;
  const auto told = [](const std::string& room, std::size_t lines) {
    return room + " has " + std::to_string(lines) + " lines";
  };
  for (const auto& [room, lines] : sizes) {
    const auto known = larger.find(room);
    const std::size_t allowed = known == larger.end() ? most : known->second;
    if (lines > allowed)
      out.push_back(told(room, lines) + ", not at most " + std::to_string(allowed));
  }
  for (const auto& [room, lines] : larger)
    if (sizes[room] <= most)
      out.push_back(told(room, sizes[room]) + " and need not be listed as larger");
  return out;
}

Complaints checkOwnHeaderFirst(const File& file, const std::set<std::string>& paths) {
  const std::string own = file.path.substr(0, file.path.rfind('.')) + ".h";
  if (!file.path.ends_with(".cpp") || !paths.contains(own))
    return {};
  for (const std::string& line : linesOf(file.text))
    if (line.starts_with("#"))
      return line == "#include \"" + own + "\""
                 ? Complaints{}
                 : Complaints{file.path + " includes " + own + " too late"};
  return {file.path + " does not include " + own};
}

std::set<std::string> methodSections(const std::string& method) {
  static const std::regex heading(R"(^## (\d+)\. )");
  static const std::regex item(R"(^(\d+)\. )");
  std::set<std::string> sections;
  std::string section;
  for (const std::string& line : linesOf(method))
    if (std::smatch found; std::regex_search(line, found, heading))
      sections.insert(section = found[1]);
    else if (!section.empty() && std::regex_search(line, found, item))
      sections.insert(section + "." + found[1].str());
  return sections;
}

Complaints checkCitations(const File& file, const std::set<std::string>& sections) {
  static const std::regex citation(R"(METHOD((?:,?\s+(?://+\s*)?(?:and\s+)?§\d+(?:\.\d+)?)+))");
  static const std::regex number(R"(§(\d+(?:\.\d+)?))");
  Complaints out;
  for (std::sregex_iterator it(file.text.begin(), file.text.end(), citation), end; it != end;
       ++it) {
    const std::string cited = (*it)[1];
    for (std::sregex_iterator one(cited.begin(), cited.end(), number); one != end; ++one)
      if (!sections.contains((*one)[1]))
        out.push_back(file.path + " cites METHOD " + one->str() + ", which render/METHOD.md lacks");
  }
  return out;
}

Complaints checkTries(const File& file) {
  static const std::regex handsOn(R"(!(\w+)(?:\.ok\(\))?\)\n\s*return \1\.error\(\);)");
  static const std::regex declared(R"(^(\s*)(?:const )?(?:auto|Status|Result<.*>) (\w+) =.*)");
  static const std::regex dropped(R"([;{})]\n\s*TRY\(\w+(?:::\w+)*::(?:create|acquire|open)\()");
  Complaints out;
  const std::string& text = file.text;
  if (std::regex_search(text, dropped))
    out.push_back(file.path + " ends at once what it has made in a TRY: it has to be kept");
  for (std::sregex_iterator it(text.begin(), text.end(), handsOn), end; it != end; ++it) {
    const std::string name = (*it)[1];
    const auto at = std::size_t(it->position());
    const std::size_t test = text.rfind("if (", at);
    const std::size_t line = text.rfind('\n', test) + 1;
    const std::string inside = text.substr(test, at - test);
    const std::string margin = text.substr(line, test - line);
    // Declared within the test, or by the statement before it.
    bool just = inside.find(" " + name + " = ") != std::string::npos &&
                margin.find_first_not_of(' ') == std::string::npos;
    if (inside == "if (") {
      const std::vector<std::string> before = linesOf(text.substr(0, line));
      const auto statement = std::find_if(before.rbegin(), before.rend(), [&](const auto& each) {
        return each.starts_with(margin) && each.size() > margin.size() &&
               std::isalpha(static_cast<unsigned char>(each[margin.size()]));
      });
      std::smatch found;
      just = statement != before.rend() && std::regex_match(*statement, found, declared) &&
             found[1] == margin && found[2] == name;
    }
    if (just)
      out.push_back(file.path + ": the error of " + name + " is only handed on: that is TRY");
  }
  return out;
}

Complaints checkLicenceLine(const File& file) {
  const std::vector<std::string> lines = linesOf(file.text);
  for (std::size_t i = 0; i < std::min<std::size_t>(2, lines.size()); ++i)
    if (lines[i].find("SPDX-License-Identifier: Apache-2.0") != std::string::npos)
      return {};
  return {file.path + " has no SPDX line"};
}

Complaints checkTopLevel(const std::vector<std::string>& names) {
  static const std::vector<std::string> agreed{
      "CMakeLists.txt", "app",          "widgets",          "render",          "model",
      "resources",      "tests",        "README.md",        "ARCHITECTURE.md", "CONTRIBUTING.md",
      "LICENSE",        "translations", "CMakePresets.json"};
  Complaints out;
  for (const std::string& name : names)
    if (!name.starts_with(".") && name != "build" &&
        std::find(agreed.begin(), agreed.end(), name) == agreed.end())
      out.push_back("the top level holds " + name);
  for (const std::string& name : agreed)
    if (std::find(names.begin(), names.end(), name) == names.end())
      out.push_back("the top level lacks " + name);
  return out;
}

Complaints checkNeeded(const std::string& neededLibraries) {
  std::smatch match;
  // Gui sets text, and needs the other two.
  if (std::regex_search(neededLibraries, match,
                        std::regex("libQt[0-9](?!(Core|Gui|DBus)\\.)[0-9A-Za-z]*|libOpenImageIO")))
    return {"the program needs " + match.str()};
  return {};
}

}  // namespace sline::arch
