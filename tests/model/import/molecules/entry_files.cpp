// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/molecules/entry_files.h"

#include <QFile>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <map>

namespace sline::test {

namespace {

const char* residueOf(char letter) {
  static const std::map<char, const char*> names = {
      {'A', "ALA"}, {'R', "ARG"}, {'N', "ASN"}, {'D', "ASP"}, {'C', "CYS"},
      {'Q', "GLN"}, {'E', "GLU"}, {'G', "GLY"}, {'H', "HIS"}, {'I', "ILE"},
      {'L', "LEU"}, {'K', "LYS"}, {'M', "MET"}, {'F', "PHE"}, {'P', "PRO"},
      {'S', "SER"}, {'T', "THR"}, {'W', "TRP"}, {'Y', "TYR"}, {'V', "VAL"}};
  return names.at(letter);
}

/// Returns a point on a helix around z: radius in Å, angle in degrees, height in Å.
glm::dvec3 onHelix(double radius, double angle, double height) {
  const double a = angle * 3.14159265358979 / 180.0;
  return {radius * std::cos(a), radius * std::sin(a), height};
}

}  // namespace

QByteArray pdbLine(const Written& atom, int serial) {
  char line[128];
  std::snprintf(line, sizeof line,
                "%-6s%5d %-4s%c%-3s %1s%4d%c   %8.3f%8.3f%8.3f%6.2f%6.2f          %2s  \n",
                atom.hetero ? "HETATM" : "ATOM", serial, atom.name, atom.alternate, atom.residue,
                atom.chain, atom.number, atom.insertion, atom.place.x, atom.place.y, atom.place.z,
                atom.occupancy, 20.0, atom.element);
  return line;
}

QByteArray pdbFile(std::span<const Written> atoms) {
  QByteArray file;
  int serial = 0;
  for (const Written& atom : atoms)
    file += pdbLine(atom, ++serial);
  return file + "END\n";
}

QByteArray cifFile(std::span<const Written> atoms) {
  QByteArray file =
      "data_test\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n"
      "_atom_site.label_atom_id\n_atom_site.label_alt_id\n_atom_site.label_comp_id\n"
      "_atom_site.auth_asym_id\n_atom_site.auth_seq_id\n_atom_site.pdbx_PDB_ins_code\n"
      "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.occupancy\n";
  int serial = 0;
  for (const Written& atom : atoms) {
    char line[200];
    std::snprintf(line, sizeof line, "%s %d %s \"%s\" %c %s %s %d %c %.3f %.3f %.3f %.2f\n",
                  atom.hetero ? "HETATM" : "ATOM", ++serial, atom.element,
                  QByteArray(atom.name).trimmed().constData(),
                  atom.alternate == ' ' ? '.' : atom.alternate, atom.residue, atom.chain,
                  atom.number, atom.insertion == ' ' ? '?' : atom.insertion, atom.place.x,
                  atom.place.y, atom.place.z, atom.occupancy);
    file += line;
  }
  return file;
}

QByteArray jsonFile(std::span<const Written> atoms) {
  const char* const items[] = {"group_PDB",     "id",           "type_symbol",
                               "label_atom_id", "label_alt_id", "label_comp_id",
                               "auth_asym_id",  "auth_seq_id",  "Cartn_x",
                               "Cartn_y",       "Cartn_z",      "occupancy"};
  QByteArrayList columns;
  for (const char* item : items)
    columns << "\"" + QByteArray(item) + "\":[";
  int serial = 0;
  for (const Written& atom : atoms) {
    const auto text = [](const QByteArray& word) { return "\"" + word + "\""; };
    const QByteArrayList row = {text(atom.hetero ? "HETATM" : "ATOM"),
                                QByteArray::number(++serial),
                                text(atom.element),
                                text(QByteArray(atom.name).trimmed()),
                                atom.alternate == ' ' ? "false" : text({1, atom.alternate}),
                                text(atom.residue),
                                text(atom.chain),
                                QByteArray::number(atom.number),
                                QByteArray::number(atom.place.x, 'f', 3),
                                QByteArray::number(atom.place.y, 'f', 3),
                                QByteArray::number(atom.place.z, 'f', 3),
                                QByteArray::number(atom.occupancy, 'f', 2)};
    for (qsizetype i = 0; i < columns.size(); ++i)
      columns[i] += (serial == 1 ? "" : ",") + row[i];
  }
  return "{\"data_TEST\":{\"atom_site\":{" + columns.join("],") + "]}}}\n";
}

std::vector<Written> helix(const std::string& letters, const char* chain) {
  std::vector<Written> atoms;
  for (int i = 0; i < int(letters.size()); ++i) {
    const double turn = 100.0 * i;
    const double rise = 1.5 * i;
    const auto add = [&](const char* name, const char* element, const glm::dvec3& place) {
      atoms.push_back({.name = name,
                       .residue = residueOf(letters[std::size_t(i)]),
                       .chain = chain,
                       .number = i + 1,
                       .place = place,
                       .element = element});
    };
    // These are cylinder coordinates of an α-helix's backbone (Arnott & Dover 1967).
    add(" N  ", "N", onHelix(1.546, turn - 27.7, rise - 0.87));
    add(" CA ", "C", onHelix(2.280, turn, rise));
    add(" C  ", "C", onHelix(1.662, turn + 26.6, rise + 1.04));
    add(" O  ", "O", onHelix(2.036, turn + 19.6, rise + 2.20));
    if (letters[std::size_t(i)] != 'G')
      add(" CB ", "C", onHelix(3.300, turn - 18.0, rise - 0.90));
  }
  return atoms;
}

Result<model::EntryRecords> recordsOf(const QTemporaryDir& folder, const char* extension,
                                      const QByteArray& bytes) {
  const QString path = folder.filePath(QString("entry") + extension);
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
    qFatal("cannot write %s", qPrintable(path));
  file.close();
  const Result<model::Source> source = model::Source::read(path.toStdString(), {});
  if (!source)
    return source.error();
  if (QString(extension) == ".json")
    return model::readMmjsonRecords(*source);
  return QString(extension) == ".pdb" ? model::readPdbRecords(*source)
                                      : model::readMmcifRecords(*source);
}

bool isClosed(const model::TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const model::Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      ++edges[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end() || back->second != 1)
      return false;
  }
  return !mesh.triangles.empty();
}

double areaOf(const model::TriangleMesh& mesh) {
  double sum = 0.0;
  for (const model::Triangle& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t[0]]);
    sum += 0.5 * glm::length(glm::cross(glm::dvec3(mesh.positions[t[1]]) - a,
                                        glm::dvec3(mesh.positions[t[2]]) - a));
  }
  return sum;
}

double volumeOf(const model::TriangleMesh& mesh) {
  double sum = 0.0;
  for (const model::Triangle& t : mesh.triangles)
    sum += glm::dot(glm::dvec3(mesh.positions[t[0]]),
                    glm::cross(glm::dvec3(mesh.positions[t[1]]), glm::dvec3(mesh.positions[t[2]])));
  return sum / 6.0;
}

QByteArray bytesOf(const char* path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace sline::test
