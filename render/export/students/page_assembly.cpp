// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/page_assembly.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "render/export/encoding/gzip.h"
#include "render/export/encoding/xml_text.h"
#include "render/export/students/answer_hash.h"
#include "render/export/students/web_program.h"

namespace sline::render {

namespace {

/// A name that page.html has in braces, and what stands in its place.
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

/// Returns a script without what would end or confuse the element that holds it: both stand in
/// texts of a script alone, where the backslash changes nothing.
std::string withinElement(std::string_view script) {
  std::string safe;
  for (std::size_t at = 0; at < script.size(); ++at) {
    safe += script[at];
    const std::string_view rest = script.substr(at);
    if (rest.starts_with("<!--") || rest.starts_with("</script") || rest.starts_with("</SCRIPT"))
      safe += '\\';
  }
  return safe;
}

/// Returns JSON without what would end the element that holds it.
std::string withoutTags(const std::string& json) {
  std::string safe;
  for (const char each : json)
    if (each == '<')
      safe += "\\u003c";
    else
      safe += each;
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

/// The parts of a page, not yet put together.
struct Parts {
  std::string style;
  std::string script;
  std::string wasm;     ///< in gzip
  std::string scene;    ///< likewise
  std::string context;  ///< likewise; empty: there is none
};

Parts partsOf(const PageTemplate& page, const PageContent& content) {
  return {.style = page.style,
          .script = withinElement(page.script),
          .wasm = gzipped(page.wasm),
          .scene = gzipped(content.scene),
          .context = content.context.empty() ? std::string() : gzipped(content.context)};
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

AssembledPage assembledPage(const PageTemplate& page, const PageContent& content,
                            const PageForm& form) {
  const Parts parts = partsOf(page, content);
  std::vector<Filling> fillings{{"LANGUAGE", xmlText(content.language)},
                                {"DIRECTION", directionOf(content.language)},
                                {"TITLE", xmlText(content.title)},
                                {"STILLS", content.stills},
                                {"FACTS", withoutTags(content.facts)}};
  AssembledPage made;
  if (form.folder)
    made.files = putBeside(parts, form.report, fillings);
  else
    putWithin(parts, fillings);
  made.html = filled(page.html, fillings);
  return made;
}

}  // namespace sline::render
