// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/option_fields.h"

#include <QCoreApplication>
#include <QStringList>

#include "render/export/order/common_options.h"
#include "widgets/session/names_by_language.h"

namespace sline::widgets {

namespace {

QString translated(const char* text) {
  return text && *text ? QCoreApplication::translate("sline::render::ExportOption", text)
                       : QString();
}

FieldKind kindOf(const render::SwitchOption&) {
  return SwitchField{};
}

FieldKind kindOf(const render::ChoiceOption& kind) {
  ChoiceField field;
  for (const render::OptionChoice& choice : kind.choices)
    if (choice.text)
      field.choices.push_back({QLatin1String(choice.id), translated(choice.text)});
  return field;
}

FieldKind kindOf(const render::NumberOption& kind) {
  return NumberField{.low = kind.low,
                     .high = kind.high,
                     .decimals = kind.decimals,
                     .step = kind.step,
                     .unit = translated(kind.unit),
                     .lowestText = {}};
}

FieldKind kindOf(const render::TextOption& kind) {
  return TextField{.longest = kind.longest, .lines = kind.lines};
}

ChoiceField languageField(const QStringList& languages) {
  ChoiceField field{{{QString(), languageName({})}}};
  for (const QString& tag : languages)
    field.choices.push_back({tag, languageName(tag)});
  const QString latin = QStringLiteral("la");
  if (languages.contains(latin))
    for (const QString& tag : languages)
      if (const QString both = tag + QLatin1Char('+') + latin; tag != latin)
        field.choices.push_back({both, languageName(both)});
  return field;
}

}  // namespace

Field fieldOf(const render::ExportOption& option, const QStringList& languages) {
  const bool language = &option == &render::languageOption;
  return {QStringLiteral("export-") + QLatin1String(option.id), translated(option.title),
          translated(option.tip),
          language ? FieldKind(languageField(languages))
                   : std::visit([](const auto& kind) { return kindOf(kind); }, option.kind)};
}

QVariant valueIn(const render::ExportOrder& order, const render::ExportOption& option) {
  const render::OptionValue value = option.field.read(order);
  if (const bool* on = std::get_if<bool>(&value))
    return *on;
  if (const double* number = std::get_if<double>(&value))
    return *number;
  if (const int* number = std::get_if<int>(&value);
      number && !std::holds_alternative<render::ChoiceOption>(option.kind))
    return *number;
  return QString::fromStdString(render::optionText(option, value));
}

void setValue(render::ExportOrder& order, const render::ExportOption& option,
              const QVariant& value) {
  // A settings file may hold numbers and switches as words, so all values are read as on the
  // command line.
  if (!value.isValid())
    return;
  const Result<render::OptionValue> read =
      render::parseOption(option, value.toString().toStdString());
  if (read.ok())
    option.field.write(order, *read);
}

}  // namespace sline::widgets
