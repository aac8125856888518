// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/page_stills.h"

#include "model/scene/markup.h"
#include "render/export/encoding/xml_text.h"
#include "render/export/order/view_orders.h"
#include "render/export/pixels/webp_image.h"
#include "render/export/plate/plate_image.h"
#include "render/export/students/answer_hash.h"
#include "render/lettering/typesetting.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::render {

namespace {

constexpr glm::ivec2 stillSize{960, 720};  // pixels
constexpr float stillHeightMm = 96.0f;     // so that numbers can be read on a telephone
constexpr float stillQuality = 72.0f;

/// Returns the order of a view's still, with numbers for its labels.
ExportOrder stillOrder(const ExportOrder& order, const model::View& view, const PageWords& words) {
  ExportOrder still = orderOfView(order, view);
  // Labels are called as the page calls them.
  std::vector<model::Annotation> labels = still.scene.annotations();
  for (model::Annotation& label : labels)
    if (label.kind == model::AnnotationKind::label || label.kind == model::AnnotationKind::pin)
      label.texts[words.language()] = words.unmarked(label).at(words.language());
  still.scene.setAnnotations(std::move(labels));
  const float aspect = float(stillSize.x) / float(stillSize.y);
  still.page.sizeMm = {aspect * stillHeightMm, stillHeightMm};
  still.camera = fittedToPage(still.scene, still.camera, aspect);
  still.environment.background = Background::white;
  still.labels = {.mode = words.silent() ? LabelMode::off : LabelMode::numbers,
                  .language = words.language()};
  still.marks = ExportMarks::none();
  still.marks.sides = true;
  still.legend = LegendList::none;
  still.sources = SourceCredits::off;
  return still;
}

std::string paragraphs(const model::Wording& text, const PageWords& words) {
  std::string html;
  for (const model::MarkedLine& line : model::markedLines(text.in(words.language()))) {
    std::string shown = line.bullet ? std::string(model::bulletSign) : "";
    for (const model::MarkedRun& run : line.runs)
      shown += run.text;
    if (!shown.empty())
      html += "<p>" + xmlText(shown) + "</p>\n";
  }
  return html;
}

std::string keyOf(const LabelReport& report) {
  std::string html;
  for (const LabelReport::Line& line : report.key)
    html += "<li value=\"" + std::to_string(line.number) + "\">" + xmlText(line.text) + "</li>\n";
  return html.empty() ? html : "<ol>\n" + html + "</ol>\n";
}

std::string textIn(const WordsByLanguage& words, const std::string& language) {
  const auto found = words.find(language);
  return found == words.end() ? std::string() : found->second;
}

}  // namespace

Result<std::string> pageStills(const ExportOrder& order, const PageWords& words,
                               const std::vector<WordsByLanguage>& shown,
                               const ExportProgress& progress) {
  const auto typesetting = TRY(Typesetting::create());
  HeadlessPicture picture = TRY(HeadlessPicture::create());
  const std::vector<model::View>& views = order.scene.views();
  std::string html;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (progress && !progress(0.3 + 0.5 * double(i) / double(views.size()), "drawing stills"))
      return givenUp({});
    const ExportOrder still = stillOrder(order, views[i], words);
    Image image = TRY(picture->render(
        still.scene, still.camera,
        {.width = stillSize.x, .height = stillSize.y, .environment = still.environment}, 2));
    const LabelReport report = drawPlate(image, still, *typesetting);
    const std::string webp = TRY(webpOf(image, stillQuality));
    const std::string alt = textIn(shown[i], words.language());
    html += "<figure>\n<img width=\"" + std::to_string(stillSize.x) + "\" height=\"" +
            std::to_string(stillSize.y) + "\" alt=\"" + xmlText(alt) +
            "\" src=\"data:image/webp;base64," + base64(webp) + "\">\n<figcaption>\n<h2>" +
            xmlText(textIn(words.titleOf(views[i]), words.language())) + "</h2>\n" +
            (words.silent() ? std::string() : paragraphs(views[i].words.text, words)) +
            (words.silent() ? std::string() : keyOf(report)) + "</figcaption>\n</figure>\n";
  }
  return html;
}

}  // namespace sline::render
