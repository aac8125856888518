// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/arguments.h"

#include <QTest>

#include "tests/support/suite.h"

namespace sline::cli {

class ArgumentsTest : public QObject {
  Q_OBJECT

 private slots:
  void inputsFirst_data();
  void inputsFirst();
};

void ArgumentsTest::inputsFirst_data() {
  QTest::addColumn<QString>("given");
  QTest::addColumn<QString>("arranged");
  const auto row = [](const char* name, const char* given, const char* arranged) {
    QTest::newRow(name) << given << arranged;
  };
  row("nothing", "", "");
  row("as it should be", "render a.obj -o b.png --gamma 2", "render a.obj -o b.png --gamma 2");
  row("after a number", "render --gamma 2 a.obj -o b.png", "render a.obj --gamma 2 -o b.png");
  row("after a pen", "render --hatch-tone 2 a.obj -o b.png",
      "render a.obj --hatch-tone 2 -o b.png");
  row("option after values", "render a.obj --gamma 2 liver=4 -o b.png",
      "render a.obj --gamma 2 liver=4 -o b.png");
  row("after assignments", "render --gamma liver=4 aorta=5 a.obj",
      "render a.obj --gamma liver=4 aorta=5");
  row("after a colour", "render --color liver=#aa0000 a.obj b.obj",
      "render a.obj b.obj --color liver=#aa0000");
  row("after names", "render --only liver spleen a.obj -o b.png",
      "render a.obj --only liver spleen -o b.png");
  row("names that are no files", "render a.obj --only liver spleen",
      "render a.obj --only liver spleen");
  row("after an assignment", "render --pen liver=2 a.obj", "render a.obj --pen liver=2");
  row("after an equals sign", "render --gamma=2 a.obj --only=liver b.obj",
      "render a.obj b.obj --gamma=2 --only=liver");
  row("an input that is not there", "render --gamma 2 absent", "render absent --gamma 2");
  row("a name like a file", "render --only a.obj b.obj", "render b.obj --only a.obj");
  row("negative number", "render --gamma -1 a.obj", "render a.obj --gamma -1");
  row("after an option of one value", "render --view left a.obj", "render --view left a.obj");
}

void ArgumentsTest::inputsFirst() {
  QFETCH(QString, given);
  QFETCH(QString, arranged);
  std::vector<std::string> arguments;
  for (const QString& word : given.split(' ', Qt::SkipEmptyParts))
    arguments.push_back(word.toStdString());
  QStringList result;
  const ArgumentKinds kinds{
      .valuesOf =
          [](const std::string& option) {
            const std::string assigning = "--gamma --color --pen --hatch-tone";
            return option == "--only"                            ? Values::several
                   : assigning.find(option) != std::string::npos ? Values::assignments
                                                                 : Values::one;
          },
      .exists = [](const std::string& name) { return name.ends_with(".obj"); }};
  for (const std::string& word : withInputsFirst(arguments, kinds))
    result << QString::fromStdString(word);
  QCOMPARE(result.join(' '), arranged);
}

}  // namespace sline::cli

SLINE_TEST(sline::cli::ArgumentsTest)
#include "arguments_test.moc"
