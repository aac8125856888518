// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/choice_rows.h"

#include <QLocale>

#include "widgets/import_dialog/import_draft.h"

namespace sline::widgets {

std::vector<ChoiceOf<model::Frame>> frameRows() {
  return {
      {{QStringLiteral("lps"), ImportDraft::tr("LPS – left, posterior, superior")},
       model::Frame::lps},
      {{QStringLiteral("ras"), ImportDraft::tr("RAS – right, anterior, superior")},
       model::Frame::ras},
      {{QStringLiteral("las"), ImportDraft::tr("LAS – left, anterior, superior (mirrors)")},
       model::Frame::las},
      {{QStringLiteral("rps"), ImportDraft::tr("RPS – right, posterior, superior (mirrors)")},
       model::Frame::rps},
      {{QStringLiteral("file"), ImportDraft::tr("As in the file, unturned")}, model::Frame::file}};
}

std::vector<ChoiceOf<float>> unitRows() {
  return {{{QStringLiteral("mm"), ImportDraft::tr("mm – millimetres")}, 1.0f},
          {{QStringLiteral("cm"), ImportDraft::tr("cm – centimetres")}, 10.0f},
          {{QStringLiteral("m"), ImportDraft::tr("m – metres")}, 1000.0f},
          {{QStringLiteral("inch"), ImportDraft::tr("in – inches")}, 25.4f},
          {{QStringLiteral("um"), ImportDraft::tr("µm – micrometres")}, 1e-3f},
          {{QStringLiteral("angstrom"), ImportDraft::tr("Å – ångström")}, 1e-7f}};
}

std::vector<ChoiceOf<model::Smoothing>> smoothingRows() {
  using Mode = model::Smoothing::Mode;
  std::vector<ChoiceOf<model::Smoothing>> rows{
      {{QStringLiteral("auto"), ImportDraft::tr("Automatic")}, {}},
      {{QStringLiteral("off"), ImportDraft::tr("Off")}, {Mode::off, 0}}};
  constexpr std::pair<const char*, int> strengths[] = {
      {"5", 5}, {"10", 10}, {"20", 20}, {"50", 50}, {"100", 100}};
  for (const auto& [id, steps] : strengths)
    rows.push_back(
        {{QLatin1String(id), ImportDraft::tr("%n steps", nullptr, steps)}, {Mode::steps, steps}});
  return rows;
}

std::vector<ChoiceOf<float>> decimationRows() {
  std::vector<ChoiceOf<float>> rows{{{QStringLiteral("0"), ImportDraft::tr("Keep all")}, 0.0f}};
  constexpr std::pair<const char*, float> bounds[] = {
      {"0.02", 0.02f}, {"0.05", 0.05f}, {"0.1", 0.1f}, {"0.3", 0.3f}, {"1", 1.0f}};
  for (const auto& [id, bound] : bounds)
    rows.push_back({{QLatin1String(id), decimationText(bound)}, bound});
  return rows;
}

QString unitText(float millimetres) {
  for (const ChoiceOf<float>& row : unitRows())
    if (row.value == millimetres)
      return row.text.section(QLatin1Char(' '), 0, 0);
  return ImportDraft::tr("%1 mm").arg(QLocale().toString(double(millimetres), 'g', 4));
}

QString smoothingText(const model::Smoothing& smoothing) {
  switch (smoothing.mode) {
    case model::Smoothing::Mode::automatic:
      return ImportDraft::tr("automatic");
    case model::Smoothing::Mode::off:
      return ImportDraft::tr("off");
    case model::Smoothing::Mode::steps:
      break;
  }
  return ImportDraft::tr("%n steps", nullptr, smoothing.steps);
}

QString decimationText(float millimetres) {
  return millimetres > 0.0f
             ? ImportDraft::tr("within %1 mm").arg(QLocale().toString(double(millimetres), 'g', 3))
             : ImportDraft::tr("no");
}

}  // namespace sline::widgets
