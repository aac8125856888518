// SPDX-License-Identifier: Apache-2.0
#include <QtTest>
#include <array>

#include "render/gpu/shader_source.h"
#include "tests/support/suite.h"

using namespace sline::render::gpu;

namespace {
constexpr auto files = std::to_array<ShaderFile>({
    {"main.glsl", "#include \"a.glsl\"\n#include \"b.glsl\"\nmain\n"},
    {"a.glsl", "#include \"b.glsl\"\nfrom a\n"},
    {"b.glsl", "from b\n"},
    {"lost.glsl", "first\n#include \"absent.glsl\"\n"},
});
}  // namespace

class ShaderSourceTest : public QObject {
  Q_OBJECT
 private slots:
  void includesEachSnippetOnce();
  void startsWithTheDialect_data();
  void startsWithTheDialect();
  void namesWhatIsAbsent();
};

void ShaderSourceTest::includesEachSnippetOnce() {
  const auto source = shaderSource(files, "main.glsl", Dialect::desktop330);
  QVERIFY(source.ok());
  const QString text = QString::fromStdString(source->text);
  QCOMPARE(text.count("from b"), 1);
  QVERIFY(text.indexOf("from b") < text.indexOf("from a"));
  QVERIFY(text.indexOf("from a") < text.indexOf("main"));
  QVERIFY(!text.contains("#include"));
  const std::vector<std::string> names{"main.glsl", "a.glsl", "b.glsl"};
  QCOMPARE(source->files, names);
  // After two includes the compiler counts on at line 3 of file 0.
  QVERIFY(text.contains("#line 3 0\nmain"));
}

void ShaderSourceTest::startsWithTheDialect_data() {
  QTest::addColumn<int>("dialect");
  QTest::addColumn<QString>("start");
  QTest::newRow("desktop") << int(Dialect::desktop330) << "#version 330 core\n#line";
  QTest::newRow("ES") << int(Dialect::es300) << "#version 300 es\nprecision highp float;";
}

void ShaderSourceTest::startsWithTheDialect() {
  QFETCH(int, dialect);
  QFETCH(QString, start);
  const auto source = shaderSource(files, "b.glsl", Dialect(dialect));
  QVERIFY(source.ok());
  QVERIFY(QString::fromStdString(source->text).startsWith(start));
}

void ShaderSourceTest::namesWhatIsAbsent() {
  const auto source = shaderSource(files, "lost.glsl", Dialect::desktop330);
  QVERIFY(!source.ok());
  QCOMPARE(source.error().file, std::string("lost.glsl"));
  QVERIFY(source.error().reason.find("absent.glsl") != std::string::npos);
}

SLINE_TEST(ShaderSourceTest)
#include "shader_source_test.moc"
