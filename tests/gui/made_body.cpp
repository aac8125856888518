// SPDX-License-Identifier: Apache-2.0
#include "tests/gui/made_body.h"

#include <QFile>
#include <QTextStream>
#include <QtTest>
#include <map>

#include "tests/support/shapes.h"

namespace sline::test {

namespace {

QList<QStringList> table(const QString& name) {
  QFile file(QStringLiteral(SLINE_TEST_DATA "/terminology/bodyparts3d/") + name);
  QList<QStringList> rows;
  if (!file.open(QIODevice::ReadOnly | QIODevice::Text))
    return rows;
  QTextStream text(&file);
  text.readLine();  // the columns' headings
  while (!text.atEnd())
    rows << text.readLine().split('\t');
  return rows;
}

struct Part {
  QString name;
  QString group;
};

std::vector<Part> bodyParts() {
  std::vector<Part> parts;
  std::map<QString, QString> top;  // by concept
  for (const QStringList& row : table("partof_inclusion_relation_list.txt"))
    if (row.value(0) == "FMA20394")
      top[row.value(2)] = row.value(3);
  std::map<QString, QString> groups;  // by mesh
  for (const QStringList& row : table("partof_element_parts.txt"))
    if (const auto group = top.find(row.value(0)); group != top.end())
      groups.try_emplace(row.value(2), group->second);
  for (const QStringList& row : table("fj_element_names.tsv")) {
    const auto group = groups.find(row.value(0));
    parts.push_back({row.value(2), group == groups.end() ? "Other" : group->second});
  }
  for (int i = int(parts.size()); i < 2234; ++i)
    parts.push_back({QStringLiteral("%1 part %2 of system").arg(i % 2 ? "left" : "right").arg(i),
                     QStringLiteral("System %1").arg(i % 19)});
  return parts;
}

}  // namespace

model::Scene madeBody() {
  const model::MeshPtr ball = sphere(20.0f, 3);
  model::Scene scene;
  float x = -120.0f;
  const auto structure = [&](const char* name, model::NodeId parent) {
    scene.append({.parent = parent, .name = name, .mesh = moved(*ball, 1.0f, {x, 0.0f, 0.0f})});
    x += 48.0f;
  };
  const model::NodeId organs =
      scene.append({.name = "Organs", .style = {.colour = Colour{200, 120, 90}}});
  structure("left kidney", organs);
  structure("right kidney", organs);
  structure("bladder", organs);
  const model::NodeId vessels =
      scene.append({.name = "Vessels", .style = {.colour = Colour{200, 30, 30}}});
  structure("aorta", vessels);
  structure("left renal vein", vessels);
  structure("skin", model::rootId);
  return scene;
}

model::Scene wholeBody() {
  const model::MeshPtr ball = sphere(4.0f, 0);
  model::Scene scene;
  std::map<QString, model::NodeId> groups;
  int i = 0;
  for (const Part& part : bodyParts()) {
    auto [group, isNew] = groups.try_emplace(part.group);
    if (isNew)
      group->second = scene.append({.name = part.group.toStdString()});
    const glm::vec3 at(float(i % 50) * 10.0f, 0.0f, float(i / 50) * 10.0f);
    scene.append(
        {.parent = group->second, .name = part.name.toStdString(), .mesh = moved(*ball, 1.0f, at)});
    ++i;
  }
  return scene;
}

bool openScene(WindowFixture& f, const model::Scene& scene) {
  f.session.openMade("body",
                     [scene](const model::ImportProgress&,
                             const std::stop_token&) -> Result<widgets::LoadedDocument> {
                       return widgets::LoadedDocument{.scene = scene, .title = "body"};
                     });
  return QTest::qWaitFor([&] { return !f.session.busy(); }, 60'000);
}

}  // namespace sline::test
