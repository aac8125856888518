// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/values.h"
#include "model/import/naming/laterality.h"

#include <QTest>

#include "tests/support/suite.h"

namespace sline::cli {

class ValuesTest : public QObject {
  Q_OBJECT

 private slots:
  void parses_data();
  void parses();
};

void ValuesTest::parses_data() {
  QTest::addColumn<QString>("kind");
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("value");  // empty: refused
  QTest::newRow("size") << "size"
                        << "1920x1080"
                        << "1920 1080";
  QTest::newRow("size, large X") << "size"
                                 << "16X20000"
                                 << "16 20000";
  QTest::newRow("size, one number") << "size"
                                    << "1920"
                                    << "";
  QTest::newRow("size, rest") << "size"
                              << "64x64px"
                              << "";
  QTest::newRow("size, negative") << "size"
                                  << "-64x64"
                                  << "";
  QTest::newRow("size, too small") << "size"
                                   << "64x15"
                                   << "";
  QTest::newRow("size, overflow") << "size"
                                  << "99999999999x64"
                                  << "";
  QTest::newRow("samples") << "samples"
                           << "4"
                           << "4";
  QTest::newRow("samples, auto") << "samples"
                                 << "AUTO"
                                 << "0";
  QTest::newRow("samples, none") << "samples"
                                 << "0"
                                 << "";
  QTest::newRow("samples, too many") << "samples"
                                     << "5"
                                     << "";
  QTest::newRow("gamma") << "gamma"
                         << "2.5"
                         << "2.5";
  QTest::newRow("gamma, lowest") << "gamma"
                                 << "0"
                                 << "0";
  QTest::newRow("gamma, comma") << "gamma"
                                << "2,5"
                                << "";
  QTest::newRow("gamma, empty") << "gamma"
                                << ""
                                << "";
  QTest::newRow("gamma, infinite") << "gamma"
                                   << "inf"
                                   << "";
  QTest::newRow("gamma, below") << "gamma"
                                << "-0.1"
                                << "";
  QTest::newRow("colour") << "colour"
                          << "#A0ff07"
                          << "160 255 7";
  QTest::newRow("colour, short") << "colour"
                                 << "#fff"
                                 << "";
  QTest::newRow("colour, no digit") << "colour"
                                    << "#fffffg"
                                    << "";
  QTest::newRow("colour, no sign") << "colour"
                                   << "ffffff0"
                                   << "";
  QTest::newRow("frame") << "frame"
                         << "ras"
                         << "RAS";
  QTest::newRow("frame, other") << "frame"
                                << "LP"
                                << "";
  QTest::newRow("smoothing") << "smoothing"
                             << "auto"
                             << "0 0";
  QTest::newRow("smoothing off") << "smoothing"
                                 << "OFF"
                                 << "1 0";
  QTest::newRow("smoothing steps") << "smoothing"
                                   << "60"
                                   << "2 60";
  QTest::newRow("smoothing, none") << "smoothing"
                                   << "0"
                                   << "";
  QTest::newRow("smoothing, endless") << "smoothing"
                                      << "1001"
                                      << "";
  const std::pair<const char*, const char*> thresholds[] = {{"bone", "bone - -"},
                                                            {"SKIN", "skin - -"},
                                                            {"bone=250", "bone 250 -"},
                                                            {"fat=-150..-50", "fat -150 -50"},
                                                            {"air=..-800", "air - -800"},
                                                            {"x=5..", "x 5 -"},
                                                            {"liver", ""},
                                                            {"x=", ""},
                                                            {"x=9..3", ""},
                                                            {"x=..", ""},
                                                            {"=3", ""},
                                                            {"x=nan", ""},
                                                            {"x=1..2..3", ""}};
  for (const auto& [text, value] : thresholds)
    QTest::addRow("threshold %s", text) << "threshold" << text << value;
  QTest::newRow("hatching") << "hatching"
                            << "As-Printed"
                            << "1";
  QTest::newRow("light") << "light"
                         << "above"
                         << "0 0.81";
  QTest::newRow("light, other") << "light"
                                << "below"
                                << "";
  QTest::newRow("hatching, other") << "hatching"
                                   << "printed"
                                   << "";
  QTest::newRow("named") << "named"
                         << "left=right=3"
                         << "left=right 3";
  QTest::newRow("not named") << "named"
                             << "3"
                             << "";
}

void ValuesTest::parses() {
  QFETCH(QString, kind);
  QFETCH(QString, text);
  QFETCH(QString, value);
  const std::string input = text.toStdString();
  QString found;
  if (const auto size = parseSize(input); kind == "size" && size.ok())
    found = QString("%1 %2").arg(size->width).arg(size->height);
  if (const auto samples = parseSamples(input); kind == "samples" && samples.ok())
    found = QString::number(samples->value_or(0));
  if (const auto gamma = parseGamma(input); kind == "gamma" && gamma.ok())
    found = QString::number(double(gamma->value()));
  if (const auto colour = parseColour(input); kind == "colour" && colour.ok())
    found = QString("%1 %2 %3").arg(colour->red).arg(colour->green).arg(colour->blue);
  if (const auto frame = parseFrame(input); kind == "frame" && frame.ok())
    found = QString::fromStdString(model::frameName(*frame));
  if (const auto smoothing = parseSmoothing(input); kind == "smoothing" && smoothing.ok())
    found = QString("%1 %2").arg(int(smoothing->mode)).arg(smoothing->steps);
  const auto bound = [](const std::optional<double>& number) {
    return number ? QString::number(*number) : QStringLiteral("-");
  };
  if (const auto threshold = parseThreshold(input); kind == "threshold" && threshold.ok())
    found = QString::fromStdString(threshold->name) + " " + bound(threshold->low) + " " +
            bound(threshold->high);
  if (const auto hatching = parseHatching(input); kind == "hatching" && hatching.ok())
    found = QString::number(int(*hatching));
  if (const auto light = parseLight(input); kind == "light" && light.ok())
    found = QString("%1 %2").arg(double(light->x)).arg(double(light->y));
  if (const auto named = splitNamed(input); kind == "named" && named)
    found = QString::fromStdString(named->name + " " + named->value);
  QCOMPARE(found, value);
}

}  // namespace sline::cli

SLINE_TEST(sline::cli::ValuesTest)
#include "values_test.moc"
