// SPDX-License-Identifier: Apache-2.0
#include "tests/arch/rules.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace sline::arch {

namespace {
bool under(const std::string& path, const std::string& folder) {
  return path == folder || path.starts_with(folder + "/");
}

bool underAny(const std::string& path, const std::vector<std::string>& folders) {
  return std::any_of(folders.begin(), folders.end(),
                     [&](const std::string& folder) { return under(path, folder); });
}

bool isHeader(const std::string& path) {
  return path.ends_with(".h");
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

/// A room and the rooms it may include besides itself. The longest matching name counts.
struct Room {
  std::string name;
  std::vector<std::string> mayUse;
};

const std::vector<Room>& rooms() {
  static const std::vector<Room> table{
      {"model/base", {}},
      {"model/anatomy", {"model/base"}},
      {"model/geometry", {"model/base"}},
      {"model/scene", {"model/base", "model/geometry"}},
      {"model/edit", {"model/base", "model/geometry", "model/scene"}},
      {"model/focus", {"model/base", "model/geometry", "model/scene", "model/edit"}},
      {"model/isosurface", {"model/base", "model/geometry"}},
      {"model/demo",
       {"model/base", "model/files", "model/geometry", "model/isosurface", "model/scene"}},
      {"model/import",
       {"model/anatomy", "model/base", "model/edit", "model/files", "model/geometry",
        "model/isosurface", "model/meshing", "model/scene"}},
      {"model/meshing", {"model/base", "model/geometry"}},
      {"model/files", {"model/base", "model/geometry", "model/scene"}},
      {"render/lines", {"model/base", "model/geometry", "model/scene"}},
      {"render/gpu", {"model/base"}},
      {"render/passes", {"model/base", "model/geometry", "render/gpu", "resources/shaders"}},
      {"render/picture",
       {"model/base", "model/geometry", "model/scene", "render/lines", "render/gpu",
        "render/passes"}},
      {"render/measures",
       {"model/base", "model/geometry", "model/scene", "model/edit", "render/lines", "render/gpu",
        "render/picture"}},
      {"render/vectors",
       {"model/base", "model/geometry", "model/scene", "render/lines", "render/gpu",
        "render/passes", "render/picture"}},
      {"render/export/order", {"model/base", "model/scene", "render/labels", "render/picture"}},
      {"render/export/marks",
       {"model/base", "model/scene", "render/export", "render/labels", "render/picture"}},
      {"render/export/anki", {"model/base", "model/files", "model/scene", "render"}},
      {"render/export/gltf",
       {"model/base", "model/files", "model/geometry", "model/scene", "render/export/order"}},
      {"render/export/motion", {"model", "render"}},
      {"render/export/svg",
       {"model/base", "model/files", "model/scene", "render/export", "render/vectors"}},
      {"render/export/pdf",
       {"model/anatomy", "model/base", "model/files", "model/scene", "render/export",
        "render/labels", "render/vectors"}},
      {"render/export/pixels",
       {"model/base", "model/files", "model/scene", "render/export", "render/gpu", "render/labels",
        "render/picture"}},
      {"render/export/pixels/module", {"model/base", "render/export/pixels"}},
      {"render/export/proof",
       {"model/base", "model/edit", "model/geometry", "model/scene", "render/export", "render/gpu",
        "render/labels", "render/picture"}},
      {"render/export/formats", {"model/base", "render/export"}},
      {"render/labels", {"model/base", "model/geometry", "model/scene"}},
      {"render/export", {"model", "render"}},
      {"render", {"model", "render"}},
      {"widgets/text", {}},
      {"widgets/form", {}},
      {"widgets/preferences", {"widgets/form", "widgets/text"}},
      {"widgets/theme", {"widgets/preferences"}},
      {"widgets/help", {}},
      {"widgets/instance", {}},
      {"widgets/language", {"model/anatomy", "widgets/preferences"}},
      {"widgets/session", {"model", "widgets/text"}},
      {"widgets/start", {"model", "render", "widgets/session", "widgets/theme"}},
      {"widgets/focus", {"model", "widgets/session", "widgets/text"}},
      {"widgets/gamma", {"model", "widgets/session", "widgets/text"}},
      {"widgets/structure_tree", {"model", "widgets/session", "widgets/gamma", "widgets/text"}},
      {"widgets/sections", {"model", "widgets/session", "widgets/text"}},
      {"widgets/annotations",
       {"model", "render", "widgets/preferences", "widgets/session", "widgets/theme",
        "widgets/text"}},
      {"widgets/viewport",
       {"model", "render", "widgets/session", "widgets/sections", "widgets/annotations",
        "widgets/text"}},
      {"widgets/views",
       {"model", "render", "widgets/session", "widgets/theme", "widgets/viewport"}},
      {"widgets/export",
       {"model", "render", "widgets/session", "widgets/viewport", "widgets/form", "widgets/text"}},
      {"widgets/import_dialog", {"model", "widgets/form", "widgets/session"}},
      {"widgets/window", {"model", "render", "widgets"}},
      {"widgets", {"model", "render", "widgets"}},
      {"app/cli", {"model", "render"}},
      {"app/reader", {"model/import"}},
      {"app", {"model", "render", "widgets", "app"}},
      {"tests", {"model", "render", "widgets", "app", "tests"}},
  };
  return table;
}

const Room* roomOf(const std::string& path) {
  const Room* best = nullptr;
  for (const Room& room : rooms())
    if (under(path, room.name) && (!best || room.name.size() > best->name.size()))
      best = &room;
  return best;
}

/// Headers of a library and the only folders that may include them.
struct Library {
  std::string name;
  std::regex header;
  std::vector<std::string> allowed;
};

const std::vector<Library>& libraries() {
  static const std::vector<Library> table{
      {"Qt", std::regex("Q[A-Z].*|Qt.*"), {"widgets", "app/main.cpp", "render/export", "tests"}},
      {"VTK", std::regex("vtk.*"), {"model/import", "model/isosurface", "tests/bench"}},
      {"OpenMesh", std::regex("OpenMesh/.*"), {"model/meshing", "tests/bench"}},
      {"OpenGL", std::regex("(epoxy|GL|GLES[23]?|EGL|KHR)/.*"), {"render/gpu", "tests/bench"}},
      {"assimp, Draco, meshoptimizer",
       std::regex("assimp/.*|draco/.*|meshoptimizer\\.h"),
       {"model/import/foreign", "tests"}},
      {"oneTBB", std::regex("(oneapi/)?tbb/.*|tbb\\.h"), {"model/base"}},
      {"OpenImageIO", std::regex("OpenImageIO/.*"), {"render/export/pixels/module", "tests"}},
      {"DCMTK", std::regex("dcmtk/.*"), {"model/import/dicom", "tests"}},
      {"OpenJPEG", std::regex("openjpeg\\.h"), {"model/import/dicom", "tests"}},
      {"libhyphen", std::regex("hyphen\\.h"), {"render/export"}},
      {"gemmi, PEGTL", std::regex("(gemmi|tao)/.*"), {"model/import/molecules"}},
      {"qpdf", std::regex("qpdf/.*"), {"render/export/pdf", "tests"}},
      {"lcms2", std::regex("lcms2\\.h"), {"render/export/pixels", "render/export/proof"}},
      {"CLI11", std::regex("CLI/.*"), {"app", "tests"}},
      {"libzip", std::regex("zip(conf)?\\.h"), {"model/files"}},
      {"zlib, bzip2",
       std::regex("(zlib|bzlib)\\.h"),
       {"model/import", "render/export/pixels", "tests"}},
      {"sqlite3", std::regex("sqlite3\\.h"), {"render/export/anki", "tests"}},
      {"libwebp, giflib",
       std::regex("webp/.*|gif_lib\\.h"),
       {"render/export/motion", "render/export/pixels", "tests"}},
      {"nlohmann-json",
       std::regex("nlohmann/.*"),
       {"app", "model/files", "model/import", "render/export/anki", "render/export/gltf", "tests"}},
  };
  return table;
}

void checkLibrary(const File& file, const std::string& header, Complaints& out) {
  for (const Library& library : libraries()) {
    if (!std::regex_match(header, library.header))
      continue;
    if (!underAny(file.path, library.allowed))
      out.push_back(file.path + " includes <" + header + ">: " + library.name +
                    " stays out of here");
    const bool kept = library.name == "VTK" || library.name == "OpenMesh" ||
                      library.name == "DCMTK" || library.name == "OpenJPEG";
    if (kept && isHeader(file.path) && under(file.path, "model"))
      out.push_back(file.path + ": " + library.name + " stays out of headers");
  }
}

void checkRoom(const File& file, const std::string& included, Complaints& out) {
  const Room* from = roomOf(file.path);
  const Room* to = roomOf(included);
  if (!from || !to || from == to)
    return;
  if (!underAny(to->name, from->mayUse) && !underAny(included, from->mayUse))
    out.push_back(file.path + " includes \"" + included + "\": " + from->name + " may not enter " +
                  to->name);
}

/// A definition: its first line, the lines of its signature joined, and how many lines it takes.
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

/// Functions whose definitions start at this indentation, in clang-format's shape.
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

Complaints checkIncludes(const File& file) {
  Complaints out;
  static const std::regex include(R"re(\s*#\s*include\s*(<([^>]+)>|"([^"]+)").*)re");
  static const std::regex glType(R"(.*\bGL(uint|int|enum|sizei|float|boolean|bitfield|sync)\b.*)");
  for (const std::string& line : linesOf(file.text)) {
    std::smatch match;
    if (std::regex_match(line, match, include)) {
      if (match[2].matched)
        checkLibrary(file, match[2], out);
      else
        checkRoom(file, match[3], out);
    } else if (isHeader(file.path) && !under(file.path, "render/gpu") &&
               std::regex_match(line, glType)) {
      out.push_back(file.path + " shows an OpenGL type: " + line);
    }
  }
  return out;
}

Complaints checkLinks(const File& file) {
  struct Rule {
    std::string folder;
    std::regex forbidden;
  };
  static const std::vector<Rule> rules{
      {"model", std::regex(R"(sline_(lines|gpu|headless|passes|picture|cli)\b|Qt6|OpenImageIO)")},
      {"render/lines", std::regex(R"(Qt6|VTK|OpenMesh|TBB|OpenImageIO|sline_(gpu|import|demo)\b)")},
      {"render/gpu", std::regex(R"(Qt6|VTK|OpenMesh|TBB|OpenImageIO|sline_(import|demo|cli)\b)")},
      {"render/passes",
       std::regex(R"(Qt6|VTK|OpenMesh|TBB|OpenImageIO|sline_(import|demo|cli)\b)")},
      {"render/picture",
       std::regex(R"(Qt6|VTK|OpenMesh|TBB|OpenImageIO|sline_(import|demo|cli)\b)")},
      {"render/measures",
       std::regex(R"(Qt6|VTK|OpenMesh|TBB|OpenImageIO|sline_(import|demo|cli|headless)\b)")},
      {"render/labels",
       std::regex(R"(Qt6|VTK|OpenMesh|TBB|OpenImageIO|sline_(gpu|import|demo|cli)\b)")},
      {"render/export", std::regex(R"(Qt6::Widgets|VTK|OpenMesh|TBB|sline_(import|demo|cli)\b)")},
      {"app/cli", std::regex("Qt6|VTK|OpenMesh")},
  };
  Complaints out;
  for (const Rule& rule : rules) {
    std::smatch match;
    if (under(file.path, rule.folder) && std::regex_search(file.text, match, rule.forbidden))
      out.push_back(file.path + " links " + match.str());
  }
  return out;
}

Complaints checkSizes(const File& file, const std::string& exceptions) {
  Complaints out;
  if (exceptions.find(file.path) != std::string::npos)
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
