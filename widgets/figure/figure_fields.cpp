// SPDX-License-Identifier: Apache-2.0
#include "widgets/figure/figure_fields.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/camera/camera.h"
#include "model/figure/figure_edit.h"
#include "model/figure/figure_layout.h"

namespace sline::widgets {

namespace {

using model::Figure;

FigureField switchOf(const char* id, const QString& text, bool Figure::*member) {
  return {{QLatin1String(id), text, {}, SwitchField{}},
          [member](const Figure& figure) { return QVariant(figure.*member); },
          [member](Figure& figure, const QVariant& value) { figure.*member = value.toBool(); }};
}

FigureField numberOf(const char* id, const QString& text, float Figure::*member,
                     const Limits<float>& limits, const QString& unit = QStringLiteral("pt")) {
  return {{QLatin1String(id),
           text,
           {},
           NumberField{double(limits.low), double(limits.high), 2, 0.5, unit, {}}},
          [member](const Figure& figure) { return QVariant(double(figure.*member)); },
          [member](Figure& figure, const QVariant& value) { figure.*member = value.toFloat(); }};
}

template <class Value>
FigureField choiceOf(const char* id, const QString& text, std::vector<Choice> choices,
                     Value Figure::*member) {
  std::vector<QString> ids;
  ids.reserve(choices.size());
  for (const Choice& choice : choices)
    ids.push_back(choice.id);
  return {
      {QLatin1String(id), text, {}, ChoiceField{std::move(choices)}},
      [member, ids](const Figure& figure) { return QVariant(ids[std::size_t(figure.*member)]); },
      [member, ids](Figure& figure, const QVariant& value) {
        const auto found = std::find(ids.begin(), ids.end(), value.toString());
        if (found != ids.end())
          figure.*member = Value(found - ids.begin());
      }};
}

Choice named(std::string_view id, const QString& text) {
  return {QString::fromUtf8(id.data(), qsizetype(id.size())), text};
}

/// Wraps a switch of a panel that the figure answers where the panel does not.
FigureField panelSwitch(const char* id, const QString& text, std::size_t index,
                        std::optional<bool> model::FigurePanel::*own,
                        bool (*usual)(const Figure&, std::size_t)) {
  return {{QLatin1String(id), text, {}, SwitchField{}},
          [=](const Figure& figure) {
            return QVariant((figure.panels[index].*own).value_or(usual(figure, index)));
          },
          [=](Figure& figure, const QVariant& value) {
            const bool wanted = value.toBool();
            figure.panels[index].*own =
                wanted == usual(figure, index) ? std::nullopt : std::optional(wanted);
          }};
}

FigureField panelSpan(const char* id, const QString& text, std::size_t index,
                      int model::FigurePanel::*span) {
  return {
      {QLatin1String(id), text, {}, NumberField{1.0, double(model::mostTracks), 0, 1.0, {}, {}}},
      [=](const Figure& figure) { return QVariant(double(figure.panels[index].*span)); },
      [=](Figure& figure, const QVariant& value) {
        figure.panels[index].*span = int(std::lround(value.toDouble()));
      }};
}

/// The language of what is written; a text, as figures know it.
FigureField languageField(const QString& text) {
  return {{QStringLiteral("figureLanguage"), text, {}, TextField{.longest = 40}},
          [](const Figure& figure) { return QVariant(QString::fromStdString(figure.language)); },
          [](Figure& figure, const QVariant& value) {
            figure.language = value.toString().trimmed().toStdString();
          }};
}

/// The letter of a panel in place of the next one.
FigureField letterField(const QString& text, std::size_t index) {
  return {{QStringLiteral("panelLetter"), text, {}, TextField{.longest = 2}},
          [index](const Figure& figure) {
            const auto& letter = figure.panels[index].letter;
            return QVariant(!letter           ? QString()
                            : letter->empty() ? QStringLiteral(" ")
                                              : QString::fromStdString(*letter));
          },
          [index](Figure& figure, const QVariant& value) {
            const QString letter = value.toString();
            figure.panels[index].letter =
                letter.isEmpty() ? std::nullopt : std::optional(letter.trimmed().toStdString());
          }};
}

std::optional<model::FigureBox> placeOfInset(const Figure& figure, std::size_t index) {
  const model::PanelInset& inset = *figure.panels[index].inset;
  const auto of = model::panelOfLetter(figure, inset.of);
  const Result<model::FigureLayout> layout = model::layOut(figure);
  return of && layout.ok() ? model::insetPlace(inset.part, layout->panels[*of].box.size)
                           : std::nullopt;
}

}  // namespace

std::vector<FigureField> FigureFields::told(std::vector<FigureField> fields) {
  const QString own = tr("A panel may have a choice of its own");
  const QString panels = tr("If not as in the other panels");
  const std::pair<const char*, QString> tips[] = {
      {"figureWidth", tr("One column of a journal, one and a half, or two")},
      {"figureGap", tr("How far panels are apart")},
      {"figureSameScale",
       tr("So that sizes compare: one scale bar is true for all panels; enlarged "
          "parts stay enlarged")},
      {"figureLanguage", tr("Of labels, scale bars and the legend, as in de, la or de+la; empty: "
                            "the scene's own")},
      {"figureLeastPoints", tr("A figure with smaller ones is refused")},
      {"figureLeastLine", tr("What thin lines are measured by")},
      {"figureWidthMm", tr("For pages that no journal prescribes")},
      {"figureHeightMm", tr("Without it panels are 4 by 3 and the legend has its room")},
      {"figureColumns", tr("Into how many columns the page is divided; panels fill it by rows")},
      {"figureLetters", tr("Bold, at the upper left of each panel")},
      {"figureLetterPoints", tr("How large the letters of panels are")},
      {"figurePoints", tr("Scale bars and the legend are a fifth smaller")},
      {"figurePen", tr("How wide contours are, the same in all panels")},
      {"figureLegend", tr("One legend for all panels, at the foot of the page")},
      {"figureProjection", tr("Without perspective a scale bar is true everywhere")},
      {"figureThinLines", tr("What becomes of lines that are too thin to print; hatching stays")},
      {"figureLabels", own},
      {"figureScaleBars", own},
      {"figureSides", tr("And the other sides of the body")},
      {"figureBlackAndWhite", tr("Ink alone, without tones and colours")},
      {"panelView", tr("A saved view of the scene, or a side of the body")},
      {"panelCamera", tr("Like another panel: of the same direction and scale, to be compared")},
      {"panelCentred", tr("Moved aside to the middle of what this panel shows")},
      {"panelLetter", tr("In place of the next one; a blank for none")},
      {"panelSides", panels},
      {"panelInside", tr("The enlarged part lies on the panel of which it is a part")},
      {"panelLines", tr("From the corners of the frame to those of the enlarged part")},
      {"panelColumns", tr("How many columns of the page the panel is wide")},
      {"panelRows", tr("How many rows of the page the panel is high")},
      {"panelLabels", panels},
      {"panelScaleBar", panels}};
  for (FigureField& field : fields)
    for (const auto& [id, tip] : tips)
      if (field.field.id == QLatin1String(id))
        field.field.tip = tip;
  return fields;
}

std::vector<FigureField> FigureFields::ofSize() {
  std::vector<Choice> widths;
  widths.reserve(model::figureWidths.size() + 1);
  for (const model::FigureWidth& width : model::figureWidths)
    widths.push_back(named(width.name, tr("%1 mm").arg(double(width.mm))));
  widths.push_back({QStringLiteral("own"), tr("Other")});
  FigureField width{
      {QStringLiteral("figureWidth"), tr("&Width for journals"), {}, ChoiceField{widths}},
      [](const Figure& figure) {
        for (const model::FigureWidth& each : model::figureWidths)
          if (each.mm == figure.widthMm)
            return QVariant(QString::fromUtf8(each.name.data(), qsizetype(each.name.size())));
        return QVariant(QStringLiteral("own"));
      },
      [](Figure& figure, const QVariant& value) {
        for (const model::FigureWidth& each : model::figureWidths)
          if (value.toString().toStdString() == each.name)
            figure.widthMm = each.mm;
      }};
  FigureField millimetres{
      {QStringLiteral("figureWidthMm"),
       tr("Width"),
       {},
       NumberField{double(model::figureWidthLimits.low),
                   double(model::figureWidthLimits.high),
                   1,
                   1.0,
                   QStringLiteral("mm"),
                   {}}},
      [](const Figure& figure) { return QVariant(double(figure.widthMm)); },
      [](Figure& figure, const QVariant& value) { figure.widthMm = value.toFloat(); }};
  FigureField height{
      {QStringLiteral("figureHeightMm"),
       tr("Height"),
       {},
       NumberField{double(model::figureHeightLimits.low) - 1.0,
                   double(model::figureHeightLimits.high), 1, 1.0, QStringLiteral("mm"),
                   tr("As panels need")}},
      [](const Figure& figure) { return QVariant(double(figure.heightMm.value_or(0.0f))); },
      [](Figure& figure, const QVariant& value) {
        figure.heightMm = value.toFloat() < model::figureHeightLimits.low
                              ? std::nullopt
                              : std::optional(value.toFloat());
      }};
  FigureField columns{{QStringLiteral("figureColumns"),
                       tr("Colum&ns"),
                       {},
                       NumberField{1.0, double(model::mostTracks), 0, 1.0, {}, {}}},
                      [](const Figure& figure) { return QVariant(double(figure.columns.size())); },
                      [](Figure& figure, const QVariant& value) {
                        const auto count = std::size_t(std::lround(value.toDouble()));
                        if (count != figure.columns.size())
                          figure.columns.assign(count, 1.0f);
                      }};
  return {width, millimetres, height, columns,
          numberOf("figureGap", tr("Between panels"), &Figure::gapMm, model::figureGapLimits,
                   QStringLiteral("mm"))};
}

std::vector<FigureField> FigureFields::ofPage() {
  std::vector<FigureField> fields = ofSize();
  const std::vector<FigureField> others{
      choiceOf("figureLetters", tr("&Letters of panels"),
               {named("lower", QStringLiteral("a, b, c")),
                named("upper", QStringLiteral("A, B, C")), named("none", tr("None"))},
               &Figure::letters),
      numberOf("figureLetterPoints", tr("Their size"), &Figure::letterPoints,
               model::figureLetterLimits),
      numberOf("figurePoints", tr("Size of la&bels"), &Figure::points, model::figureLetterLimits),
      numberOf("figurePen", tr("&Contours"), &Figure::penPoints, model::figurePenLimits),
      choiceOf(
          "figureLegend", tr("Le&gend"),
          {named("none", tr("None")), named("all", tr("All structures")),
           named("labelled", tr("What labels point at")), named("focus", tr("What is in focus"))},
          &Figure::legend),
      choiceOf("figureProjection", tr("Per&spective"),
               {named("saved", tr("As views were saved")), named("parallel", tr("None"))},
               &Figure::projection),
      choiceOf("figureThinLines", tr("T&hin lines"),
               {named("raised", tr("Drawn wide enough to print")), named("refused", tr("Refused")),
                named("kept", tr("Kept"))},
               &Figure::thinLines),
      numberOf("figureLeastPoints", tr("Smallest letters"), &Figure::leastPoints,
               model::figureLeastLimits),
      numberOf("figureLeastLine", tr("Thinnest lines"), &Figure::leastLine,
               model::figureLeastLimits),
      languageField(tr("Language")),
      switchOf("figureSameScale", tr("Same scale in all panels"), &Figure::sameScale),
      switchOf("figureLabels", tr("Labels in all panels"), &Figure::labels),
      switchOf("figureScaleBars", tr("Scale bars in all panels"), &Figure::scaleBars),
      switchOf("figureSides", tr("R and L in all panels"), &Figure::sides),
      switchOf("figureBlackAndWhite", tr("Black and white"), &Figure::blackAndWhite),
  };
  fields.insert(fields.end(), others.begin(), others.end());
  return told(std::move(fields));
}

QString FigureFields::viewName(const std::string& view) {
  const auto side = model::anatomicalViewNamed(view);
  if (!side)
    return view.empty() ? tr("Anterior") : QString::fromStdString(view).simplified();
  const QString names[] = {tr("Anterior"), tr("Posterior"), tr("Left"),
                           tr("Right"),    tr("Superior"),  tr("Inferior")};
  return names[std::size_t(*side)];
}

QString FigureFields::nameOf(const model::Figure& figure, std::size_t index) {
  const model::FigurePanel& panel = figure.panels[index];
  const QString letter = QString::fromStdString(model::lettersOf(figure)[index]);
  const QString what = panel.inset ? tr("Part of %1").arg(QString::fromStdString(panel.inset->of))
                                   : viewName(panel.view);
  return letter.isEmpty() ? what : letter + QStringLiteral("   ") + what;
}

std::vector<FigureField> FigureFields::ofInset(std::size_t index) {
  std::vector<FigureField> fields;
  fields.push_back(
      {{QStringLiteral("panelInside"), tr("On its panel"), {}, SwitchField{}},
       [index](const Figure& f) { return QVariant(f.panels[index].inset->inside.has_value()); },
       [index](Figure& f, const QVariant& value) {
         f.panels[index].inset->inside = value.toBool() ? placeOfInset(f, index) : std::nullopt;
       }});
  fields.push_back({{QStringLiteral("panelLines"), tr("Lines from its frame"), {}, SwitchField{}},
                    [index](const Figure& f) { return QVariant(f.panels[index].inset->lines); },
                    [index](Figure& f, const QVariant& value) {
                      f.panels[index].inset->lines = value.toBool();
                    }});
  return fields;
}

std::vector<FigureField> FigureFields::ofCamera(const model::Figure& figure, std::size_t index) {
  std::vector<FigureField> fields;
  std::vector<Choice> cameras{named("saved", tr("As its view has it")),
                              named("fit", tr("Fitted to the panel"))};
  const std::vector<std::string> letters = model::lettersOf(figure);
  for (const std::size_t other : model::camerasFor(figure, index))
    cameras.push_back(
        named("like " + letters[other], tr("Like %1").arg(QString::fromStdString(letters[other]))));
  fields.push_back({{QStringLiteral("panelCamera"), tr("C&amera"), {}, ChoiceField{cameras}},
                    [index](const Figure& f) {
                      const auto& camera = f.panels[index].camera;
                      return QVariant(
                          !camera || *camera == model::PanelCamera() ? QStringLiteral("saved")
                          : camera->like.empty()
                              ? QStringLiteral("fit")
                              : QStringLiteral("like ") + QString::fromStdString(camera->like));
                    },
                    [index](Figure& f, const QVariant& value) {
                      const std::string text = value.toString().toStdString();
                      auto& camera = f.panels[index].camera;
                      camera.reset();
                      if (text == "fit")
                        camera = {.fit = true};
                      else if (text.starts_with("like "))
                        camera = {.like = text.substr(5)};
                    }});
  if (const auto& camera = figure.panels[index].camera; camera && !camera->like.empty())
    fields.push_back({{QStringLiteral("panelCentred"), tr("On its own middle"), {}, SwitchField{}},
                      [index](const Figure& f) {
                        return QVariant(f.panels[index].camera && f.panels[index].camera->centred);
                      },
                      [index](Figure& f, const QVariant& value) {
                        if (auto& own = f.panels[index].camera)
                          own->centred = value.toBool();
                      }});
  return fields;
}

std::vector<FigureField> FigureFields::ofPanel(const model::Figure& figure, std::size_t index,
                                               const model::Scene* scene) {
  std::vector<FigureField> fields;
  std::vector<Choice> views;
  if (scene)
    for (const model::View& view : scene->views())
      views.push_back(named(view.name, QString::fromStdString(view.name).simplified()));
  for (const std::string_view side : model::anatomicalViewNames)
    views.push_back(named(side, viewName(std::string(side))));
  const bool inset = figure.panels[index].inset.has_value();
  if (inset)
    views.insert(views.begin(), named("", tr("As its panel")));
  fields.push_back({{QStringLiteral("panelView"), tr("&View"), {}, ChoiceField{views}},
                    [index, inset](const Figure& f) {
                      const std::string& view = f.panels[index].view;
                      return QVariant(view.empty() && !inset ? QStringLiteral("anterior")
                                                             : QString::fromStdString(view));
                    },
                    [index](Figure& f, const QVariant& value) {
                      f.panels[index].view = value.toString().toStdString();
                    }});
  const std::vector<FigureField> seen = inset ? ofInset(index) : ofCamera(figure, index);
  fields.insert(fields.end(), seen.begin(), seen.end());
  fields.push_back(
      panelSpan("panelColumns", tr("Spans columns"), index, &model::FigurePanel::columns));
  fields.push_back(panelSpan("panelRows", tr("Spans rows"), index, &model::FigurePanel::rows));
  fields.push_back(panelSwitch("panelLabels", tr("Labels"), index, &model::FigurePanel::labels,
                               model::usualLabels));
  fields.push_back(panelSwitch("panelScaleBar", tr("Scale bar"), index,
                               &model::FigurePanel::scaleBar, model::usualScaleBar));
  fields.push_back(panelSwitch("panelSides", tr("R and L"), index, &model::FigurePanel::sides,
                               model::usualSides));
  fields.push_back(letterField(tr("Letter"), index));
  return told(std::move(fields));
}

}  // namespace sline::widgets
