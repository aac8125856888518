// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <span>

#include "model/base/letters.h"
#include "model/import/molecules/entry_files.h"
#include "model/import/molecules/entry_rows.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {

using Row = std::span<const EntryValue>;

std::string textOf(Row row, std::size_t column) {
  return column < row.size() && row[column].says() ? asciiOf(row[column].text) : std::string();
}

/// Returns the authors' name for it, or the data bank's where there is none.
std::string authorsOr(Row row, std::size_t authors, std::size_t label) {
  std::string text = textOf(row, authors);
  return text.empty() ? textOf(row, label) : text;
}

bool realNumber(Row row, std::size_t column, double& value) {
  if (column >= row.size() || !row[column].says())
    return false;
  // "1.234(5)" carries its uncertainty in brackets.
  const std::string_view text = row[column].text.substr(0, row[column].text.find('('));
  TextCursor at(text);
  return at.number(value) && at.atEnd() && std::isfinite(value);
}

std::int64_t wholeNumber(Row row, std::size_t column) {
  std::int64_t value = 0;
  if (column < row.size())
    TextCursor(row[column].text).integer(value);
  return value;
}

struct AtomColumns {
  explicit AtomColumns(const EntryColumns& h)
      : group(h.column("_atom_site.group_pdb")),
        id(h.column("_atom_site.id")),
        symbol(h.column("_atom_site.type_symbol")),
        atom(h.column("_atom_site.auth_atom_id")),
        labelAtom(h.column("_atom_site.label_atom_id")),
        alternate(h.column("_atom_site.label_alt_id")),
        residue(h.column("_atom_site.auth_comp_id")),
        labelResidue(h.column("_atom_site.label_comp_id")),
        chain(h.column("_atom_site.auth_asym_id")),
        labelChain(h.column("_atom_site.label_asym_id")),
        entity(h.column("_atom_site.label_entity_id")),
        number(h.column("_atom_site.auth_seq_id")),
        labelNumber(h.column("_atom_site.label_seq_id")),
        insertion(h.column("_atom_site.pdbx_pdb_ins_code")),
        x(h.column("_atom_site.cartn_x")),
        y(h.column("_atom_site.cartn_y")),
        z(h.column("_atom_site.cartn_z")),
        occupancy(h.column("_atom_site.occupancy")),
        model(h.column("_atom_site.pdbx_pdb_model_num")) {}
  std::size_t group, id, symbol, atom, labelAtom, alternate, residue, labelResidue, chain,
      labelChain, entity, number, labelNumber, insertion, x, y, z, occupancy, model;
};

/// Reads "_pdbx_struct_oper_list.matrix[2][3]" and the like; returns the identity where a number is
/// missing.
AssemblyOperator operatorOf(const EntryColumns& columns, Row row) {
  const auto column = [&](std::string name, std::initializer_list<int> indices) {
    name.insert(0, "_pdbx_struct_oper_list.");
    for (const int index : indices) {
      name += '[';
      name += std::to_string(index + 1);
      name += ']';
    }
    return columns.column(name);
  };
  AssemblyOperator result;
  for (int r = 0; r < 3; ++r) {
    realNumber(row, column("vector", {r}), result.shift[r]);
    for (int c = 0; c < 3; ++c)
      realNumber(row, column("matrix", {r, c}), result.rotation[c][r]);
  }
  return result;
}

class MmcifRecords : public EntryRowReader {
 public:
  void readRow(const EntryColumns& columns, Row row) override {
    if (columns.areOf("_atom_site."))
      readAtom(columns, row);
    else if (columns.areOf("_atom_site_"))
      m_fractional = true;
    else if (columns.areOf("_pdbx_struct_"))
      readOther(columns, row);
    else
      readNote(columns, row);
  }

  void missRow(const EntryColumns& columns) override {
    if (columns.areOf("_atom_site."))
      ++m_records.unreadable;
  }

  bool hasEnough() const override { return !m_records.atoms.empty(); }

  /// Returns the records, where they are worth drawing; `read` says how the reading ended.
  Result<EntryRecords> finish(const Source& source, const Status& read) {
    if (m_records.atoms.empty() && m_fractional)
      return source.whole(
          "is a crystal structure with fractional coordinates, as of small molecules, which are "
          "not supported",
          "Export it as PDB or mmCIF with orthogonal coordinates");
    if (!read && m_records.atoms.empty())
      return read.error();
    if (m_records.atoms.empty() && m_records.unreadable == 0)
      return source.whole("is an entry without the atoms of a molecule (_atom_site)",
                          "Give an entry of the Protein Data Bank with coordinates");
    TRY(judgeAtoms(source, m_records));
    if (!read)
      m_records.cutShort = read.error().where + ": " + read.error().reason;
    finishNotes();
    return std::move(m_records);
  }

 private:
  void readNote(const EntryColumns& columns, Row row) {
    EntryNotes& notes = m_records.notes;
    const auto text = [&](std::string_view name) { return textOf(row, columns.column(name)); };
    if (columns.areOf("_entity.")) {
      notes.entityTypes[text("_entity.id")] = lowerCase(text("_entity.type"));
      m_entityNames[text("_entity.id")] = text("_entity.pdbx_description");
    } else if (columns.areOf("_chem_comp.")) {
      notes.componentNames[text("_chem_comp.id")] = readableCapitals(text("_chem_comp.name"));
      if (const std::string parent = text("_chem_comp.mon_nstd_parent_comp_id"); !parent.empty())
        notes.parents[text("_chem_comp.id")] = parent;
    } else if (columns.areOf("_struct.")) {
      notes.title = readableCapitals(text("_struct.title"));
    } else if (columns.areOf("_entry.")) {
      notes.id = text("_entry.id");
    }
  }

  void readOther(const EntryColumns& columns, Row row) {
    Assemblies& assemblies = m_records.assemblies;
    const auto text = [&](std::string_view name) {
      return textOf(row, columns.column("_pdbx_struct_" + std::string(name)));
    };
    if (columns.areOf("_pdbx_struct_mod_residue."))
      m_records.notes.parents[text("mod_residue.auth_comp_id")] =
          text("mod_residue.parent_comp_id");
    else if (columns.areOf("_pdbx_struct_oper_list."))
      assemblies.operators.emplace(text("oper_list.id"), operatorOf(columns, row));
    else if (columns.areOf("_pdbx_struct_assembly."))
      assemblyCalled(text("assembly.id")).details = text("assembly.oligomeric_details");
    else if (columns.areOf("_pdbx_struct_assembly_gen."))
      assemblyCalled(text("assembly_gen.assembly_id"))
          .steps.push_back({namesInList(text("assembly_gen.asym_id_list")),
                            text("assembly_gen.oper_expression")});
  }

  Assembly& assemblyCalled(const std::string& id) {
    std::vector<Assembly>& all = m_records.assemblies.all;
    const auto [known, isNew] = m_assemblies.try_emplace(id, all.size());
    if (isNew)
      all.push_back({id, {}, {}});
    return all[known->second];
  }

  void readAtom(const EntryColumns& header, Row row) {
    if (m_header != header.names) {
      m_header = header.names;
      m_columns.emplace(header);
    }
    const AtomColumns& c = *m_columns;
    const std::string model = textOf(row, c.model);
    if (m_models.empty() || (m_models.size() < 100'000 && !m_models.contains(model))) {
      if (m_models.empty())
        m_firstModel = model;
      m_models.insert(model);
      m_records.otherModels = m_models.size() - 1;
    }
    if (model != m_firstModel)
      return;
    AtomRecord atom;
    if (!realNumber(row, c.x, atom.place.x) || !realNumber(row, c.y, atom.place.y) ||
        !realNumber(row, c.z, atom.place.z)) {
      ++m_records.unreadable;
      m_fractional = m_fractional || header.column("_atom_site.fract_x") < row.size();
      return;
    }
    atom.name = authorsOr(row, c.atom, c.labelAtom);
    atom.residue = authorsOr(row, c.residue, c.labelResidue);
    atom.chain = authorsOr(row, c.chain, c.labelChain);
    atom.entity = textOf(row, c.entity);
    atom.part = textOf(row, c.labelChain);
    if (atom.part.empty())
      atom.part = atom.chain;
    atom.insertion = textOf(row, c.insertion);
    atom.number = wholeNumber(row, textOf(row, c.number).empty() ? c.labelNumber : c.number);
    atom.serial = wholeNumber(row, c.id);
    const std::string alternate = textOf(row, c.alternate);
    atom.alternate = alternate.empty() ? ' ' : alternate.front();
    atom.hetero = textOf(row, c.group) == "HETATM";
    double occupancy = 1.0;
    realNumber(row, c.occupancy, occupancy);
    atom.occupancy = float(std::clamp(occupancy, 0.0, 1.0));
    atom.element = elementOf(textOf(row, c.symbol));
    if (!atom.element)
      atom.element = elementOfName(" " + atom.name, atom.residue);
    if (!atom.element)
      atom.element = &unknownElement();
    if (!atom.entity.empty())
      m_entityOfChain.emplace(atom.chain, atom.entity);
    m_records.atoms.push_back(std::move(atom));
  }

  /// Names each chain like its polymer.
  void finishNotes() {
    EntryNotes& notes = m_records.notes;
    for (const auto& [chain, entity] : m_entityOfChain) {
      const auto type = notes.entityTypes.find(entity);
      if (type != notes.entityTypes.end() && type->second == "polymer")
        notes.chainNames[chain] = readableCapitals(m_entityNames[entity]);
    }
  }

  EntryRecords m_records;
  std::vector<std::string> m_header;
  std::optional<AtomColumns> m_columns;
  std::map<std::string, std::string> m_entityNames;
  std::map<std::string, std::size_t> m_assemblies;  ///< index by id
  std::set<std::pair<std::string, std::string>> m_entityOfChain;
  std::set<std::string> m_models;
  std::string m_firstModel;
  bool m_fractional = false;
};

}  // namespace

Result<EntryRecords> readMmcifRecords(const Source& source) {
  MmcifRecords records;
  const Status read = readCifRows(source, records);
  return records.finish(source, read);
}

Result<EntryRecords> readMmjsonRecords(const Source& source) {
  MmcifRecords records;
  const Status read = readMmjsonRows(source, records);
  return records.finish(source, read);
}

}  // namespace sline::model
