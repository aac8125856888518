// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/students_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "model/packed_scene/packed_scene.h"
#include "render/export/encoding/gzip.h"
#include "render/export/encoding/xml_text.h"
#include "render/export/students/answer_hash.h"
#include "render/export/students/found_labels.h"
#include "render/export/students/page_facts.h"
#include "render/export/students/page_order.h"
#include "render/export/students/page_stills.h"
#include "render/export/students/web_program.h"
#include "render/lettering/typesetting.h"

namespace sline::render {

namespace {

/// A placeholder of page.html, and what stands in its place.
using Filling = std::pair<std::string, std::string>;

/// Returns the template without its comment and with each "{{NAME}}" replaced. What was put in is
/// not looked at again.
std::string filled(std::string_view html, const std::vector<Filling>& fillings) {
  std::string page;
  const std::size_t comment = html.find("<!--");
  const std::size_t end = html.find("-->");
  if (comment != std::string_view::npos && end != std::string_view::npos && comment < end) {
    page = html.substr(0, comment);
    html.remove_prefix(std::min(html.find_first_not_of("\r\n", end + 3), html.size()));
  }
  for (std::size_t at = 0; at < html.size();) {
    const std::size_t open = std::min(html.find("{{", at), html.size());
    page += html.substr(at, open - at);
    at = open;
    if (open == html.size())
      break;
    const auto found = std::find_if(fillings.begin(), fillings.end(), [&](const Filling& each) {
      return html.substr(open).starts_with("{{" + each.first + "}}");
    });
    if (found == fillings.end()) {
      page += html[at++];
      continue;
    }
    page += found->second;
    at += found->first.size() + 4;
  }
  return page;
}

/// Returns a script in one function, without what would end or confuse the element that holds it:
/// both stand in texts of a script alone, where the backslash changes nothing.
std::string inOneFunction(const std::string& glue, const std::string& script) {
  const std::string whole = "(() => {\n\"use strict\";\n" + glue + "\n" + script + "})();\n";
  std::string safe;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    safe += whole[at];
    const std::string_view rest = std::string_view(whole).substr(at);
    if (rest.starts_with("<!--") || rest.starts_with("</script") || rest.starts_with("</SCRIPT"))
      safe += '\\';
  }
  return safe;
}

std::string directionOf(const std::string& language) {
  static constexpr std::array rightToLeft{"ar", "dv", "fa", "he", "ku",
                                          "ps", "sd", "ug", "ur", "yi"};
  const std::string tag = language.substr(0, language.find('-'));
  return std::find(rightToLeft.begin(), rightToLeft.end(), tag) == rightToLeft.end() ? "ltr"
                                                                                     : "rtl";
}

std::string dataElement(const std::string& id, const std::string& bytes) {
  return "<script type=\"text/plain\" id=\"" + id + "\">" + base64(bytes) + "</script>\n";
}

std::string fileElement(const std::string& id, const std::string& file) {
  return "<script type=\"text/plain\" id=\"" + id + "\" data-src=\"" + file + "\"></script>\n";
}

/// Returns "0.21", rounded up.
std::string hundredths(float millimetres) {
  const int whole = int(std::ceil(100.0f * millimetres));
  const std::string text = std::to_string(100 + whole % 100);
  return std::to_string(whole / 100) + '.' + text.substr(1);
}

/// The parts of a page, not yet put together.
struct Parts {
  std::string style;
  std::string script;
  std::string wasm;     ///< in gzip
  std::string scene;    ///< likewise
  std::string context;  ///< likewise; empty: there is none
};

Parts partsOf(const PageTemplate& page, const WebProgram& program,
              const model::PackedScene& packed) {
  return {.style = page.style,
          .script = inOneFunction(program.glue, page.script),
          .wasm = gzipped(program.wasm),
          .scene = gzipped(packed.first),
          .context = packed.rest.empty() ? std::string() : gzipped(packed.rest)};
}

/// Puts everything into the page.
void putWithin(const Parts& parts, std::vector<Filling>& fillings) {
  fillings.emplace_back("POLICY",
                        "default-src 'none'; script-src '" + sha256Source(parts.script) +
                            "' 'wasm-unsafe-eval'; style-src '" + sha256Source(parts.style) +
                            "'; img-src data: blob:; base-uri 'none'; form-action 'none'");
  fillings.emplace_back("STYLE", "<style>" + parts.style + "</style>");
  fillings.emplace_back("SCRIPT", "<script>" + parts.script + "</script>");
  fillings.emplace_back(
      "DATA",
      dataElement("program", parts.wasm) + dataElement("scene", parts.scene) +
          (parts.context.empty() ? std::string() : dataElement("scene-context", parts.context)));
}

/// Puts it into files beside the page. A learning system's own address takes what is reported to
/// it.
std::map<std::string, std::string> putBeside(const Parts& parts, const std::string& report,
                                             std::vector<Filling>& fillings) {
  const std::string others = report == "cmi5" ? " https: http:" : "";
  fillings.emplace_back("POLICY",
                        "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src "
                        "'self'; connect-src 'self'" +
                            others + "; img-src data: blob:; base-uri 'none'; form-action 'none'");
  fillings.emplace_back("STYLE", "<link rel=\"stylesheet\" href=\"page.css\">");
  fillings.emplace_back("SCRIPT", "<script src=\"page.js\"></script>");
  std::string data = fileElement("program", "engine.wasm") + fileElement("scene", "anatomy.scene");
  std::map<std::string, std::string> files{{"page.css", parts.style},
                                           {"page.js", parts.script},
                                           {"engine.wasm", parts.wasm},
                                           {"anatomy.scene", parts.scene}};
  if (!parts.context.empty()) {
    data += fileElement("scene-context", "context.scene");
    files["context.scene"] = parts.context;
  }
  fillings.emplace_back("DATA", data);
  return files;
}

}  // namespace

Result<StudentsPage> studentsPage(const ExportOrder& order, const StudentsOptions& own,
                                  const ExportProgress& progress) {
  const Result<PageTemplate> page = pageTemplate();
  if (!page.ok())
    return page.error();
  const Result<WebProgram> program = webProgram();
  if (!program.ok())
    return program.error();
  const auto typesetting = Typesetting::create();
  if (!typesetting.ok())
    return typesetting.error();
  const auto goesOn = [&progress](double share, const char* what) {
    return !progress || progress(share, what);
  };
  if (!goesOn(0.0, "simplifying surfaces"))
    return givenUp({});
  ExportOrder shown = pageOrder(order);
  SimplifiedScene simple = simplifiedScene(shown.scene, own, progress);
  shown.scene = std::move(simple.scene);
  if (simple.errorMm > 0.0f)
    progress.note({.kind = ExportNote::Kind::pageSimplified,
                   .names = {},
                   .detail = hundredths(simple.errorMm)});
  if (!goesOn(0.1, "packing the scene"))
    return givenUp({});
  const bool found = shown.of<StudentsOptions>().foundLabels;
  const model::PackedScene packed = model::packedScene(
      found ? withAllLabels(shown.scene) : shown.scene,
      {.later = laterStructures(shown.scene), .names = own.quiz != QuizMode::only});
  const Parts parts = partsOf(*page, *program, packed);
  const PageWords words(shown, own);
  if (!goesOn(0.2, "describing pictures"))
    return givenUp({});
  const std::vector<WordsByLanguage> seen = descriptionsOfViews(shown, words);
  const Result<std::string> stills = pageStills(shown, words, seen, progress);
  if (!stills.ok())
    return stills.error();
  std::vector<PageQuestion> questions = pageQuestions(shown, own, words);
  if (own.quiz != QuizMode::off && questions.empty())
    progress.note({.kind = ExportNote::Kind::quizEmpty, .names = {}, .detail = {}});
  if (!goesOn(0.85, "writing the page"))
    return givenUp({});
  std::vector<Filling> fillings{{"LANGUAGE", xmlText(words.language())},
                                {"DIRECTION", directionOf(words.language())},
                                {"TITLE", xmlText(words.title())},
                                {"STILLS", *stills},
                                {"FACTS", pageFacts(shown, own,
                                                    {.simplifiedMm = simple.errorMm,
                                                     .views = seen,
                                                     .questions = std::move(questions)})}};
  StudentsPage made{.html = {}, .files = {}, .title = words.title(), .language = words.language()};
  if (own.folder)
    made.files = putBeside(parts, own.report, fillings);
  else
    putWithin(parts, fillings);
  made.html = filled(page->html, fillings);
  return made;
}

}  // namespace sline::render
