// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include "model/import/molecules/cif_tokens.h"
#include "model/import/molecules/entry_files.h"

namespace sline::model {

namespace {

std::string lowered(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  return result;
}

/// The items of one category that stand together: one row, or those of a loop.
struct Header {
  std::vector<std::string> names;  ///< in lower case

  bool isOf(std::string_view category) const {
    return !names.empty() && names.front().starts_with(category);
  }
  /// Which column holds the item; past the last where none does.
  std::size_t column(std::string_view name) const {
    return std::size_t(std::find(names.begin(), names.end(), name) - names.begin());
  }
};

using Row = std::vector<CifToken>;

std::string textOf(const Row& row, std::size_t column) {
  return column < row.size() && row[column].says() ? asciiOf(row[column].text) : std::string();
}

/// What the authors call it, or what the data bank does.
std::string authorsOr(const Row& row, std::size_t authors, std::size_t label) {
  std::string text = textOf(row, authors);
  return text.empty() ? textOf(row, label) : text;
}

bool realNumber(const Row& row, std::size_t column, double& value) {
  if (column >= row.size() || !row[column].says())
    return false;
  // "1.234(5)" carries its uncertainty in brackets.
  const std::string_view text = row[column].text.substr(0, row[column].text.find('('));
  TextCursor at(text);
  return at.number(value) && at.atEnd() && std::isfinite(value);
}

std::int64_t wholeNumber(const Row& row, std::size_t column) {
  std::int64_t value = 0;
  if (column < row.size())
    TextCursor(row[column].text).integer(value);
  return value;
}

struct AtomColumns {
  explicit AtomColumns(const Header& h)
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

class MmcifReader {
 public:
  explicit MmcifReader(const Source& source) : m_source(source), m_tokens(source.text()) {}

  Result<EntryRecords> read() {
    using Kind = CifToken::Kind;
    bool begun = false;
    while (m_tokens.peek().kind != Kind::end) {
      const Kind kind = m_tokens.peek().kind;
      if (kind == Kind::data && !m_records.atoms.empty())
        break;
      if (!begun && kind != Kind::data)
        return m_source.atLine(m_tokens.place(), "does not begin with a data block (data_…)",
                               "Check that the file is an mmCIF file");
      begun = true;
      if (kind == Kind::loop)
        readLoop();
      else if (kind == Kind::name)
        readItems();
      else
        m_tokens.next();
    }
    if (const Status status = judge(); !status)
      return status.error();
    finishNotes();
    return std::move(m_records);
  }

 private:
  Status judge() const {
    if (m_records.atoms.empty() && m_fractional)
      return m_source.whole(
          "is a crystal structure with fractional coordinates, as of small molecules, which are "
          "not supported",
          "Export it as PDB or mmCIF with orthogonal coordinates");
    if (m_records.atoms.empty() && m_records.unreadable == 0)
      return m_source.whole("is a CIF file without the atoms of a molecule (_atom_site)",
                            "Give an entry of the Protein Data Bank with coordinates");
    if (m_tokens.broken() && m_records.atoms.empty())
      return m_source.whole("a quoted text never ends", "Get the entry again");
    return judgeAtoms(m_source, m_records);
  }

  void readLoop() {
    m_tokens.next();
    Header header;
    while (m_tokens.peek().kind == CifToken::Kind::name)
      header.names.push_back(lowered(m_tokens.next().text));
    if (header.names.empty())
      return;
    Row row;
    while (m_tokens.peek().kind == CifToken::Kind::value) {
      row.push_back(m_tokens.next());
      if (row.size() == header.names.size()) {
        readRow(header, row);
        row.clear();
      }
    }
    // The file ends in the middle of an atom.
    if (!row.empty() && header.isOf("_atom_site."))
      ++m_records.unreadable;
  }

  /// Items outside loops: those of one category in a run are its only row.
  void readItems() {
    Header header;
    Row row;
    std::string category;
    while (m_tokens.peek().kind == CifToken::Kind::name) {
      const std::string name = lowered(m_tokens.peek().text);
      const std::string its = name.substr(0, name.find('.'));
      if (!category.empty() && its != category)
        break;
      category = its;
      m_tokens.next();
      header.names.push_back(name);
      const bool hasValue = m_tokens.peek().kind == CifToken::Kind::value;
      row.push_back(hasValue ? m_tokens.next() : CifToken{CifToken::Kind::value, "?", false});
    }
    readRow(header, row);
    while (m_tokens.peek().kind == CifToken::Kind::value)
      m_tokens.next();
  }

  void readRow(const Header& header, const Row& row) {
    EntryNotes& notes = m_records.notes;
    const auto text = [&](std::string_view name) { return textOf(row, header.column(name)); };
    if (header.isOf("_atom_site.")) {
      readAtom(header, row);
    } else if (header.isOf("_atom_site_")) {
      m_fractional = true;
    } else if (header.isOf("_entity.")) {
      notes.entityTypes[text("_entity.id")] = lowered(text("_entity.type"));
      m_entityNames[text("_entity.id")] = text("_entity.pdbx_description");
    } else if (header.isOf("_chem_comp.")) {
      notes.componentNames[text("_chem_comp.id")] = readableCapitals(text("_chem_comp.name"));
      if (const std::string parent = text("_chem_comp.mon_nstd_parent_comp_id"); !parent.empty())
        notes.parents[text("_chem_comp.id")] = parent;
    } else if (header.isOf("_pdbx_struct_mod_residue.")) {
      notes.parents[text("_pdbx_struct_mod_residue.auth_comp_id")] =
          text("_pdbx_struct_mod_residue.parent_comp_id");
    } else if (header.isOf("_struct.")) {
      notes.title = readableCapitals(text("_struct.title"));
    } else if (header.isOf("_entry.")) {
      notes.id = text("_entry.id");
    }
  }

  void readAtom(const Header& header, const Row& row) {
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

  /// A chain is called as its polymer is.
  void finishNotes() {
    EntryNotes& notes = m_records.notes;
    for (const auto& [chain, entity] : m_entityOfChain) {
      const auto type = notes.entityTypes.find(entity);
      if (type != notes.entityTypes.end() && type->second == "polymer")
        notes.chainNames[chain] = readableCapitals(m_entityNames[entity]);
    }
  }

  const Source& m_source;
  CifTokens m_tokens;
  EntryRecords m_records;
  std::vector<std::string> m_header;
  std::optional<AtomColumns> m_columns;
  std::map<std::string, std::string> m_entityNames;
  std::set<std::pair<std::string, std::string>> m_entityOfChain;
  std::set<std::string> m_models;
  std::string m_firstModel;
  bool m_fractional = false;
};

}  // namespace

Result<EntryRecords> readMmcifRecords(const Source& source) {
  return MmcifReader(source).read();
}

}  // namespace sline::model
