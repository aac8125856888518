// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/length_texts.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace sline::widgets {

namespace {

QString number(double value, int decimals) {
  return QLocale().toString(value, 'f', decimals);
}

/// Writes a power of a length in the unit that suits its root; `exponent` is its sign.
QString powerText(model::DrawnUnit unit, double value, int power, QChar exponent) {
  const model::ToldUnit in = model::toldUnit(std::pow(value, 1.0 / power), unit);
  const double shown = value / std::pow(in.millimetres, power);
  return number(shown, model::toldDecimals(shown)) + QLatin1Char(' ') +
         QString::fromUtf8(in.symbol.data(), qsizetype(in.symbol.size())) + exponent +
         (in.doubted ? QStringLiteral("?") : QString());
}

/// Tells whether so much is told in centimetres and millilitres.
bool isOfBodies(model::DrawnUnit unit, double value, double least) {
  return unit != model::DrawnUnit::angstrom && (value >= least || value <= 0.0);
}

QString mark(model::DrawnUnit unit) {
  return unit == model::DrawnUnit::doubtedMillimetre ? QStringLiteral("?") : QString();
}

}  // namespace

QString lengthText(const model::Scene& scene, double millimetres, std::optional<int> decimals) {
  const model::ToldUnit in = model::toldUnit(std::abs(millimetres), drawnUnit(scene));
  const double value = millimetres / in.millimetres;
  return number(value, decimals.value_or(std::abs(value) < 10.0 ? 1 : 0)) + QLatin1Char(' ') +
         QString::fromStdString(in.mark());
}

QString lengthText(const model::Scene& scene, const model::DrawnLength& length) {
  const model::ToldDistance told = model::toldDistance(length, drawnUnit(scene));
  const QString sign = QString::fromUtf8(told.sign.data(), qsizetype(told.sign.size()));
  return (sign.isEmpty() ? sign : sign + QChar(QChar::Nbsp)) + number(told.value, told.decimals) +
         QLatin1Char(' ') + QString::fromStdString(told.unit);
}

QString sizeText(const model::Scene& scene, const glm::dvec3& millimetres) {
  const double most = std::max({millimetres.x, millimetres.y, millimetres.z});
  const model::ToldUnit in = model::toldUnit(most, drawnUnit(scene));
  const glm::dvec3 shown = millimetres / in.millimetres;
  return QStringLiteral("%1 × %2 × %3 %4")
      .arg(number(shown.x, 1), number(shown.y, 1), number(shown.z, 1),
           QString::fromStdString(in.mark()));
}

QString areaText(model::DrawnUnit unit, double squareMillimetres) {
  if (isOfBodies(unit, squareMillimetres, 1.0))
    return number(squareMillimetres / 100.0, 2) + QStringLiteral(" cm²") + mark(unit);
  return powerText(unit, squareMillimetres, 2, u'²');
}

QString volumeText(model::DrawnUnit unit, double cubicMillimetres) {
  if (isOfBodies(unit, cubicMillimetres, 10.0))
    return number(cubicMillimetres / 1000.0, 2) + QStringLiteral(" ml") + mark(unit);
  return powerText(unit, cubicMillimetres, 3, u'³');
}

QString unitSuffix(const model::Scene& scene) {
  const QString symbol = QString::fromStdString(std::string(symbolOf(drawnUnit(scene))));
  return QLatin1Char(' ') + symbol;
}

}  // namespace sline::widgets
