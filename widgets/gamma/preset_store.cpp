// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/preset_store.h"

#include <QSettings>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/gamma/style_rows.h"

namespace sline::widgets {

namespace {

constexpr const char* presetsKey = "presets";

struct FillName {
  model::Fill fill;
  const char* name;
};
constexpr std::array<FillName, 4> fillNames{{{model::Fill::none, "none"},
                                             {model::Fill::paper, "paper"},
                                             {model::Fill::tint, "tint"},
                                             {model::Fill::veil, "veil"}}};

std::optional<float> number(const QVariant& value) {
  bool fits = false;
  const float read = value.toFloat(&fits);
  return fits && std::isfinite(read) ? std::optional<float>(read) : std::nullopt;
}

std::optional<Colour> colour(const QVariant& value) {
  const QString text = value.toString();
  bool fits = false;
  const uint rgb = text.mid(1).toUInt(&fits, 16);
  if (!fits || text.size() != 7 || text[0] != QLatin1Char('#'))
    return std::nullopt;
  return Colour{std::uint8_t(rgb >> 16), std::uint8_t(rgb >> 8 & 255), std::uint8_t(rgb & 255)};
}

QString written(const Colour& c) {
  return QStringLiteral("#%1").arg(c.red << 16 | c.green << 8 | c.blue, 6, 16, QLatin1Char('0'));
}

model::Style readLook(const QSettings& settings) {
  model::Style look;
  if (const auto gamma = number(settings.value(QStringLiteral("gamma"))))
    look.gamma = Gamma::clamped(*gamma);
  const QString fill = settings.value(QStringLiteral("fill")).toString();
  for (const FillName& row : fillNames)
    if (fill == QLatin1String(row.name))
      look.fill = row.fill;
  for (const StyleNumber& row : styleNumbers())
    if (const auto value = number(settings.value(row.id)))
      model::patch(look, row.look(std::clamp(*value, 0.0f, float(row.high / row.shown))));
  for (const StyleColour& row : styleColours())
    if (const auto value = colour(settings.value(row.id)))
      look.*row.field = *value;
  return look;
}

void writeLook(QSettings& settings, const model::Style& look) {
  // As text, which reads the same whatever kind of file the settings are.
  const auto put = [&settings](const QString& id, float value) {
    settings.setValue(id, QString::number(double(value)));
  };
  if (look.gamma)
    put(QStringLiteral("gamma"), look.gamma->value());
  for (const FillName& row : fillNames)
    if (look.fill == row.fill)
      settings.setValue(QStringLiteral("fill"), QLatin1String(row.name));
  for (const StyleNumber& row : styleNumbers())
    if (const auto value = row.own(look))
      put(row.id, *value);
  for (const StyleColour& row : styleColours())
    if (const auto& value = look.*row.field)
      settings.setValue(row.id, written(*value));
}

}  // namespace

PresetStore::PresetStore(QSettings& settings, QObject* parent)
    : QObject(parent), m_settings(settings) {}

std::vector<model::StylePreset> PresetStore::presets() const {
  std::vector<model::StylePreset> presets;
  const int count = m_settings.beginReadArray(QLatin1String(presetsKey));
  for (int i = 0; i < count; ++i) {
    m_settings.setArrayIndex(i);
    model::StylePreset preset{m_settings.value(QStringLiteral("name")).toString().toStdString(),
                              readLook(m_settings)};
    if (!preset.name.empty() && preset.style != model::Style())
      presets.push_back(std::move(preset));
  }
  m_settings.endArray();
  return presets;
}

bool PresetStore::has(const QString& name) const {
  const std::vector<model::StylePreset> all = presets();
  return std::any_of(all.begin(), all.end(), [&](const model::StylePreset& preset) {
    return preset.name == name.trimmed().toStdString();
  });
}

bool PresetStore::save(const QString& name, const model::Style& look) {
  const std::string key = name.trimmed().toStdString();
  if (key.empty() || look == model::Style())
    return false;
  std::vector<model::StylePreset> all = presets();
  std::erase_if(all, [&](const model::StylePreset& preset) { return preset.name == key; });
  all.push_back({key, look});
  write(std::move(all));
  return true;
}

bool PresetStore::rename(const QString& from, const QString& to) {
  if (to.trimmed().isEmpty() || has(to))
    return false;
  std::vector<model::StylePreset> all = presets();
  const auto found = std::find_if(all.begin(), all.end(), [&](const model::StylePreset& preset) {
    return preset.name == from.toStdString();
  });
  if (found == all.end())
    return false;
  found->name = to.trimmed().toStdString();
  write(std::move(all));
  return true;
}

bool PresetStore::remove(const QString& name) {
  std::vector<model::StylePreset> all = presets();
  if (std::erase_if(all, [&](const model::StylePreset& preset) {
        return preset.name == name.toStdString();
      }) == 0)
    return false;
  write(std::move(all));
  return true;
}

void PresetStore::write(std::vector<model::StylePreset> presets) {
  std::sort(presets.begin(), presets.end(),
            [](const model::StylePreset& a, const model::StylePreset& b) {
              return QString::localeAwareCompare(QString::fromStdString(a.name),
                                                 QString::fromStdString(b.name)) < 0;
            });
  m_settings.remove(QLatin1String(presetsKey));
  m_settings.beginWriteArray(QLatin1String(presetsKey), int(presets.size()));
  for (int i = 0; i < int(presets.size()); ++i) {
    m_settings.setArrayIndex(i);
    m_settings.setValue(QStringLiteral("name"),
                        QString::fromStdString(presets[std::size_t(i)].name));
    writeLook(m_settings, presets[std::size_t(i)].style);
  }
  m_settings.endArray();
  emit changed();
}

}  // namespace sline::widgets

#include "moc_preset_store.cpp"
