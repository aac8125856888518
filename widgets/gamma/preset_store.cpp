// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/preset_store.h"

#include <QSettings>
#include <algorithm>
#include <cmath>

#include "model/scene/gamma_map.h"
#include "model/scene/style_fields.h"
#include "model/scene/threshold_values.h"

namespace sline::widgets {

namespace {

constexpr const char* presetsKey = "presets";

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

/// Tells whether the map means something in other scenes: the targets of distances are of one.
bool isOfAnyScene(const model::GammaMap& map) {
  return map.scalar != model::GammaScalar::distance;
}

/// Returns "occlusion@0:0,1:+3".
QString written(const model::GammaMap& map) {
  const std::string_view name = model::gammaScalarNames[std::size_t(map.scalar)];
  return QString::fromUtf8(name.data(), qsizetype(name.size())) + QLatin1Char('@') +
         QString::fromStdString(model::curveText(map.curve));
}

std::optional<model::GammaMap> gammaMap(const QVariant& value) {
  const std::string text = value.toString().toStdString();
  const std::size_t at = text.find('@');
  const auto& names = model::gammaScalarNames;
  const auto name = std::find(names.begin(), names.end(), text.substr(0, at));
  if (at == std::string::npos || name == names.end())
    return std::nullopt;
  model::GammaMap map{.scalar = model::GammaScalar(name - names.begin())};
  if (const auto curve = model::curveFromText(std::string_view(text).substr(at + 1)))
    map.curve = *curve;
  return model::gammaMapFault(map) || !isOfAnyScene(map) ? std::nullopt : std::optional(map);
}

/// Returns "laplacian.slope=3 ridges.curvature=1.5".
QString written(const model::ThresholdValues& values) {
  QStringList texts;
  for (const model::ThresholdValue& value : values.all())
    texts.append(QString::fromStdString(value.name) + QLatin1Char('=') +
                 QString::number(double(value.value)));
  return texts.join(QLatin1Char(' '));
}

std::optional<model::ThresholdValues> thresholdValues(const QVariant& value) {
  model::ThresholdValues values;
  for (const QString& text : value.toString().split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
    const std::string name = text.section(QLatin1Char('='), 0, 0).toStdString();
    const std::optional<float> read = number(text.section(QLatin1Char('='), 1));
    if (!read || model::thresholdFault(name, *read) ||
        values.all().size() >= model::mostThresholdValues)
      return std::nullopt;
    values.set(name, *read);
  }
  return values.empty() ? std::nullopt : std::optional(values);
}

/// Reads a setting's value; returns none where it makes no sense.
template <class Field>
std::optional<typename Field::Value> readField(const Field& field, const QVariant& value) {
  using Value = typename Field::Value;
  if constexpr (std::is_same_v<Value, Colour>) {
    return colour(value);
  } else if constexpr (std::is_same_v<Value, bool>) {
    return std::nullopt;  // presets hold looks
  } else if constexpr (std::is_same_v<Value, model::GammaMap>) {
    return gammaMap(value);
  } else if constexpr (std::is_same_v<Value, model::ThresholdValues>) {
    return thresholdValues(value);
  } else if constexpr (std::is_enum_v<Value>) {
    const auto names = model::namesOf(Value());
    const auto found = std::find(names.begin(), names.end(), value.toString().toStdString());
    return found == names.end() ? std::nullopt : std::optional(Value(found - names.begin()));
  } else {
    const std::optional<float> read = number(value);
    if (!read)
      return std::nullopt;
    const float within = std::clamp(*read, field.limits().low, field.limits().high);
    if constexpr (std::is_same_v<Value, float>)
      return within;
    else
      return Value::clamped(within);
  }
}

/// Returns a number as text, which reads the same whatever kind of file the settings are.
QVariant settingOf(float value) {
  return QString::number(double(value));
}
QVariant settingOf(const Colour& colour) {
  return written(colour);
}
QVariant settingOf(const model::GammaMap& map) {
  return written(map);
}
QVariant settingOf(const model::ThresholdValues& values) {
  return written(values);
}
template <class T>
QVariant settingOf(const T& value) {
  if constexpr (std::is_enum_v<T>)
    return QString::fromUtf8(model::namesOf(value)[std::size_t(value)]);
  else
    return settingOf(value.value());
}

QString settingKey(std::string_view key) {
  return QString::fromStdString(model::camelCase(key));
}

model::Style readLook(const QSettings& settings) {
  model::Style look;
  model::forEachLookField([&](const auto& field) {
    look.*field.own = readField(field, settings.value(settingKey(field.key)));
  });
  return look;
}

void writeLook(QSettings& settings, const model::Style& look) {
  model::forEachLookField([&](const auto& field) {
    if (const auto& own = look.*field.own)
      settings.setValue(settingKey(field.key), settingOf(*own));
  });
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

bool PresetStore::save(const QString& name, const model::Style& kept) {
  model::Style look = kept;
  if (look.gammaMap && !isOfAnyScene(*look.gammaMap))
    look.gammaMap.reset();
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
