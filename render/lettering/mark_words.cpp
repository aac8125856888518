// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/mark_words.h"

#include <array>
#include <cmath>

#include "model/scene/label_words.h"
#include "model/scene/scene.h"

namespace sline::render {

/// Views and sections are in the order of model::AnatomicalView; %1 is a place, a number or a
/// length, of sections across an axis the axis, before a place.
struct MarkTable {
  const char* language;
  std::array<const char*, 6> views;
  std::array<const char*, 6> sections;
  const char* oblique;
  const char* count;
  const char* midDepth;
  const char* cutFace;
  std::array<const char*, 2> axisSections;  ///< with smaller, with larger coordinates kept
  const char* touching;
  std::array<const char*, 5> scalars;  ///< in the order of model::GammaScalar
  const char* place;
};

namespace {

constexpr std::array<MarkTable, 5> tables{
    {{"en",
      {"Anterior view", "Posterior view", "Left lateral view", "Right lateral view",
       "Superior view", "Inferior view"},
      {"Coronal section at %1, anterior part kept", "Coronal section at %1, posterior part kept",
       "Sagittal section at %1, left part kept", "Sagittal section at %1, right part kept",
       "Axial section at %1, superior part kept", "Axial section at %1, inferior part kept"},
      "Oblique section",
      "%1 sections",
      "%1 at mid-depth",
      "%1 at the cut face",
      {"Section at %1 = %2, smaller %1 kept", "Section at %1 = %2, larger %1 kept"},
      "touching",
      {"", "Depth in cavities, 0 to 1", "Curvature (a ball: 1)", "Distance from %1 (mm)",
       "As painted, 0 to 1"},
      "a place"},
     {"de",
      {"Ansicht von vorn", "Ansicht von hinten", "Ansicht von links", "Ansicht von rechts",
       "Ansicht von oben", "Ansicht von unten"},
      {"Koronalschnitt bei %1, vorderer Teil erhalten",
       "Koronalschnitt bei %1, hinterer Teil erhalten",
       "Sagittalschnitt bei %1, linker Teil erhalten",
       "Sagittalschnitt bei %1, rechter Teil erhalten", "Axialschnitt bei %1, oberer Teil erhalten",
       "Axialschnitt bei %1, unterer Teil erhalten"},
      "Schräger Schnitt",
      "%1 Schnitte",
      "%1 in mittlerer Tiefe",
      "%1 an der Schnittfläche",
      {"Schnitt bei %1 = %2, kleinere %1 erhalten", "Schnitt bei %1 = %2, größere %1 erhalten"},
      "berühren sich",
      {"", "Tiefe in Höhlungen, 0 bis 1", "Krümmung (Kugel: 1)", "Abstand von: %1 (mm)",
       "Wie gemalt, 0 bis 1"},
      "einem Ort"},
     {"nl",
      {"Vooraanzicht", "Achteraanzicht", "Linkerzijaanzicht", "Rechterzijaanzicht", "Bovenaanzicht",
       "Onderaanzicht"},
      {"Coronale doorsnede bij %1, voorste deel behouden",
       "Coronale doorsnede bij %1, achterste deel behouden",
       "Sagittale doorsnede bij %1, linkerdeel behouden",
       "Sagittale doorsnede bij %1, rechterdeel behouden",
       "Axiale doorsnede bij %1, bovenste deel behouden",
       "Axiale doorsnede bij %1, onderste deel behouden"},
      "Schuine doorsnede",
      "%1 doorsneden",
      "%1 op halve diepte",
      "%1 op het snijvlak",
      {"Doorsnede bij %1 = %2, kleinere %1 behouden", "Doorsnede bij %1 = %2, grotere %1 behouden"},
      "raken elkaar",
      {"", "Diepte in holten, 0 tot 1", "Kromming (bol: 1)", "Afstand tot %1 (mm)",
       "Zoals geschilderd, 0 tot 1"},
      "een plaats"},
     {"nb",
      {"Sett forfra", "Sett bakfra", "Sett fra venstre", "Sett fra høyre", "Sett ovenfra",
       "Sett nedenfra"},
      {"Koronalt snitt ved %1, fremre del beholdt", "Koronalt snitt ved %1, bakre del beholdt",
       "Sagittalt snitt ved %1, venstre del beholdt", "Sagittalt snitt ved %1, høyre del beholdt",
       "Aksialt snitt ved %1, øvre del beholdt", "Aksialt snitt ved %1, nedre del beholdt"},
      "Skrått snitt",
      "%1 snitt",
      "%1 i midtre dybde",
      "%1 i snittflaten",
      {"Snitt ved %1 = %2, mindre %1 beholdt", "Snitt ved %1 = %2, større %1 beholdt"},
      "berører hverandre",
      {"", "Dybde i hulrom, 0 til 1", "Krumning (kule: 1)", "Avstand fra %1 (mm)",
       "Som malt, 0 til 1"},
      "et sted"},
     {"la",
      {"Aspectus anterior", "Aspectus posterior", "Aspectus lateralis sinister",
       "Aspectus lateralis dexter", "Aspectus superior", "Aspectus inferior"},
      {"Sectio coronalis ad %1, parte anteriore servata",
       "Sectio coronalis ad %1, parte posteriore servata",
       "Sectio sagittalis ad %1, parte sinistra servata",
       "Sectio sagittalis ad %1, parte dextra servata",
       "Sectio axialis ad %1, parte superiore servata",
       "Sectio axialis ad %1, parte inferiore servata"},
      "Sectio obliqua",
      "%1 sectiones",
      "%1 in media profunditate",
      "%1 in superficie sectionis",
      {"Sectio ad %1 = %2, %1 minore servata", "Sectio ad %1 = %2, %1 maiore servata"},
      "se tangunt",
      {"", "Profunditas cavitatum, 0 ad 1", "Curvatura (globus: 1)", "Distantia: %1 (mm)",
       "Ut pictum est, 0 ad 1"},
      "locus"}}};

const MarkTable& tableOf(const std::string& language) {
  const std::string primary = language.substr(0, language.find_first_of("-_+"));
  for (const MarkTable& table : tables)
    if (primary == table.language)
      return table;
  return tables.front();
}

QString symbolText(model::DrawnUnit unit) {
  return QString::fromStdString(std::string(symbolOf(unit)));
}

}  // namespace

MarkWords::MarkWords(const std::string& language, const model::KnownSides& sides)
    : m_table(tableOf(language)),
      m_sides(sides),
      m_locale(QString::fromStdString(language.empty() ? "en" : model::firstLanguage(language))) {}

QString MarkWords::view(const std::string& name, const model::Camera& camera) const {
  const auto named = model::anatomicalViewNamed(model::normalisedName(name));
  if (!named)
    return QString::fromStdString(name).simplified();
  const bool seen = model::nearestAnatomicalView(camera) == *named;
  const auto side = seen ? named : model::anatomicalViewOf(camera);
  return side ? doubted(QString::fromUtf8(m_table.views[std::size_t(*side)]), model::axisOf(*side))
              : QString();
}

QString MarkWords::doubted(const QString& text, int axis) const {
  return m_sides.inDoubt(axis) ? text + QLatin1String(model::doubtMark) : text;
}

QString MarkWords::section(const model::Plane& plane, model::DrawnUnit unit) const {
  const auto kept = model::keptSide(plane);
  if (!kept)
    return QString::fromUtf8(m_table.oblique);
  constexpr const char* positive = "LPS";
  constexpr const char* negative = "RAI";
  const double place = std::round(10.0 * model::positionOf(plane)) / 10.0;
  if (!m_sides.any) {
    const auto axis = std::size_t(model::axisOf(*kept));
    const bool larger = plane.normal[int(axis)] < 0.0f;
    const QString at = m_locale.toString(place == 0.0 ? 0.0 : place, 'f', 1) +
                       QString(QChar::Nbsp) + symbolText(unit);
    return QString::fromUtf8(m_table.axisSections[larger ? 1 : 0])
        .arg(QString(QLatin1Char("xyz"[axis])), at);
  }
  const char letter = (place < 0.0 ? negative : positive)[model::axisOf(*kept)];
  const QString at = QLatin1Char(letter) + QString(QChar::Nbsp) +
                     m_locale.toString(std::abs(place), 'f', 1) + QString(QChar::Nbsp) +
                     symbolText(unit);
  return doubted(QString::fromUtf8(m_table.sections[std::size_t(*kept)]).arg(at),
                 model::axisOf(*kept));
}

QString MarkWords::sections(std::size_t count) const {
  return QString::fromUtf8(m_table.count).arg(m_locale.toString(qulonglong(count)));
}

QString MarkWords::gammaScalar(model::GammaScalar scalar, model::DrawnUnit unit) const {
  return QString::fromUtf8(m_table.scalars[std::size_t(scalar)])
      .replace(QStringLiteral("(mm)"), QLatin1Char('(') + symbolText(unit) + QLatin1Char(')'));
}

QString MarkWords::somePlace() const {
  return QString::fromUtf8(m_table.place);
}

QString MarkWords::atMidDepth(const QString& length) const {
  return QString::fromUtf8(m_table.midDepth).arg(length);
}

QString MarkWords::atCutFace(const QString& length) const {
  return QString::fromUtf8(m_table.cutFace).arg(length);
}

QString MarkWords::touching() const {
  return QString::fromUtf8(m_table.touching);
}

}  // namespace sline::render
