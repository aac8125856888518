// SPDX-License-Identifier: Apache-2.0
#include "model/import/molecules/assemblies.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <glm/matrix.hpp>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "model/import/molecules/molecule.h"

namespace sline::model {

namespace {

constexpr std::uint64_t mostCopies = 1000;
constexpr std::uint64_t mostAtomsOfAssembly = 2'000'000;
constexpr std::size_t mostChainsOfAssembly = 5000;
constexpr std::size_t mostFactors = 8;
constexpr std::size_t mostTold = 5;

/// Reads "(X0)(1-60)" and the like; a list without brackets is one factor.
class OperatorExpression {
 public:
  explicit OperatorExpression(std::string_view text) {
    while (!text.empty()) {
      const bool bracket = text.front() == '(';
      const std::size_t end = std::min(bracket ? text.find(')') : text.find('('), text.size());
      addFactor(text.substr(bracket ? 1 : 0, bracket ? std::max<std::size_t>(end, 1) - 1 : end));
      text.remove_prefix(std::min(bracket ? end + 1 : end, text.size()));
    }
  }

  /// Returns how many copies the expression stands for, at most `mostCopies` + 1, which is also
  /// returned for more factors than any file needs.
  std::uint64_t count() const {
    if (m_factors.size() > mostFactors)
      return mostCopies + 1;
    std::uint64_t product = m_factors.empty() ? 0 : 1;
    for (const Factor& factor : m_factors) {
      std::uint64_t sum = 0;
      for (const auto& [first, last] : factor.ranges)
        sum = std::min(sum + (last - first) + 1, mostCopies + 1);
      product = std::min(product * (sum + factor.names.size()), mostCopies + 1);
    }
    return product;
  }

  /// Returns the names of the operators of each copy, from left to right; for counts within bounds.
  std::vector<std::vector<std::string>> copies() const {
    std::vector<std::vector<std::string>> result(m_factors.empty() ? 0 : 1);
    for (const Factor& factor : m_factors) {
      std::vector<std::string> names = factor.names;
      for (const auto& [first, last] : factor.ranges)
        for (std::uint64_t n = first; n <= last; ++n)
          names.push_back(std::to_string(n));
      std::vector<std::vector<std::string>> longer;
      for (const std::vector<std::string>& before : result)
        for (const std::string& name : names) {
          longer.push_back(before);
          longer.back().push_back(name);
        }
      result = std::move(longer);
    }
    return result;
  }

 private:
  struct Factor {
    std::vector<std::string> names;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> ranges;
  };

  static std::optional<std::uint64_t> wholeNumber(std::string_view text) {
    std::uint32_t value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc() || end != text.data() + text.size())
      return std::nullopt;
    return value;
  }

  static std::string_view trimmedName(std::string_view text) {
    while (!text.empty() && text.front() == ' ')
      text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ')
      text.remove_suffix(1);
    return text;
  }

  void addFactor(std::string_view list) {
    Factor factor;
    while (!list.empty()) {
      const std::size_t end = std::min(list.find(','), list.size());
      const std::string_view item = trimmedName(list.substr(0, end));
      list.remove_prefix(std::min(end + 1, list.size()));
      const std::size_t dash = item.find('-');
      const auto first = wholeNumber(item.substr(0, dash));
      const auto last =
          dash == std::string_view::npos ? std::nullopt : wholeNumber(item.substr(dash + 1));
      if (first && last && *first <= *last)
        factor.ranges.emplace_back(*first, *last);
      else if (!item.empty())
        factor.names.emplace_back(item);
    }
    if (!factor.names.empty() || !factor.ranges.empty())
      m_factors.push_back(std::move(factor));
  }

  std::vector<Factor> m_factors;
};

/// Tells whether the operator turns and moves, but neither scales nor mirrors. Files round to four
/// digits at worst.
bool isRigid(const AssemblyOperator& by) {
  const glm::dmat3 unit = by.rotation * glm::transpose(by.rotation);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (!(std::abs(unit[i][k] - (i == k ? 1.0 : 0.0)) < 0.01))
        return false;
  return glm::determinant(by.rotation) > 0.0 && std::isfinite(by.shift.x) &&
         std::isfinite(by.shift.y) && std::isfinite(by.shift.z);
}

class Assembler {
 public:
  Assembler(const Source& source, EntryRecords& entry, const Assembly& assembly)
      : m_source(source), m_entry(entry), m_assembly(assembly) {
    for (std::size_t i = 0; i < entry.atoms.size(); ++i) {
      m_atomsOf[entry.atoms[i].part].push_back(i);
      m_taken.insert(entry.atoms[i].chain);
    }
  }

  Status assemble() {
    TRY(judgeSize());
    for (const AssemblyStep& step : m_assembly.steps) {
      if (atomsIn(step) == 0)
        continue;
      for (const std::vector<std::string>& names : OperatorExpression(step.operators).copies())
        TRY(addCopy(step, names));
    }
    if (m_atoms.empty())
      return refusal("names no part that the file has atoms of");
    m_entry.atoms = std::move(m_atoms);
    m_entry.notes.assembly = m_assembly.id;
    return Unit{};
  }

 private:
  Error refusal(const std::string& what, const std::string& remedy = "Get the entry again") const {
    return m_source.whole("its assembly " + inQuotes(m_assembly.id) + " " + what, remedy);
  }

  std::uint64_t atomsIn(const AssemblyStep& step) const {
    std::uint64_t atoms = 0;
    for (const std::string& part : std::set(step.parts.begin(), step.parts.end()))
      if (const auto own = m_atomsOf.find(part); own != m_atomsOf.end())
        atoms += own->second.size();
    return atoms;
  }

  Status judgeSize() const {
    std::uint64_t copies = 0;
    std::uint64_t atoms = 0;
    for (const AssemblyStep& step : m_assembly.steps) {
      const std::uint64_t times = OperatorExpression(step.operators).count();
      copies = std::max(copies, times);
      atoms += times * atomsIn(step);
    }
    const std::string remedy = "Leave it as it is in the file, without the assembly";
    if (copies > mostCopies)
      return refusal("has more than " + std::to_string(mostCopies) + " copies, or more than " +
                         std::to_string(mostFactors) + " operators in a row",
                     remedy);
    if (atoms > mostAtomsOfAssembly)
      return refusal("has " + std::to_string(atoms) + " atoms, the limit is " +
                         std::to_string(mostAtomsOfAssembly),
                     remedy);
    return Unit{};
  }

  Status addCopy(const AssemblyStep& step, const std::vector<std::string>& names) {
    AssemblyOperator whole;
    for (const std::string& name : names) {
      const auto known = m_entry.assemblies.operators.find(name);
      if (known == m_entry.assemblies.operators.end())
        return refusal("needs the operator " + inQuotes(name) + ", which the file does not list");
      const AssemblyOperator& by = known->second;
      if (!isRigid(by))
        return refusal("has an operator, " + inQuotes(name) + ", that is no rotation");
      whole.shift += whole.rotation * by.shift;
      whole.rotation = whole.rotation * by.rotation;
    }
    for (const std::string& part : std::set(step.parts.begin(), step.parts.end())) {
      const auto own = m_atomsOf.find(part);
      if (own == m_atomsOf.end())
        continue;
      const std::size_t time = ++m_times[part];
      for (const std::size_t i : own->second) {
        AtomRecord& atom = m_atoms.emplace_back(m_entry.atoms[i]);
        atom.place = whole.rotation * atom.place + whole.shift;
        atom.chain = nameOfCopy(atom.chain, time);
      }
      if (m_names.size() > mostChainsOfAssembly)
        return refusal(
            "has more than " + std::to_string(mostChainsOfAssembly) + " chains, the limit",
            "Leave it as it is in the file, without the assembly");
    }
    return Unit{};
  }

  /// Returns "A", "A-2" …, or another name where the file already calls a chain so.
  const std::string& nameOfCopy(const std::string& chain, std::size_t time) {
    const auto [entry, isNew] = m_names.try_emplace({chain, time}, chain);
    if (isNew && time > 1) {
      std::string& name = entry->second;
      name += "-" + std::to_string(time);
      while (!m_taken.insert(name).second)
        name += "'";
      std::map<std::string, std::string>& shown = m_entry.notes.chainNames;
      if (const auto known = shown.find(chain); known != shown.end())
        shown.emplace(name, known->second);
    }
    return entry->second;
  }

  const Source& m_source;
  EntryRecords& m_entry;
  const Assembly& m_assembly;
  std::map<std::string, std::vector<std::size_t>> m_atomsOf;  ///< by part
  std::map<std::string, std::size_t> m_times;                 ///< copies so far, by part
  std::map<std::pair<std::string, std::size_t>, std::string> m_names;
  std::set<std::string> m_taken;
  std::vector<AtomRecord> m_atoms;
};

std::uint64_t copiesOf(const Assembly& assembly) {
  std::uint64_t most = 0;
  for (const AssemblyStep& step : assembly.steps)
    most = std::max(most, OperatorExpression(step.operators).count());
  return most;
}

std::string assemblyText(const Assembly& assembly) {
  const std::uint64_t copies = copiesOf(assembly);
  std::string text = assembly.id + " (";
  text += copies > mostCopies ? "more than " + std::to_string(mostCopies) : std::to_string(copies);
  text += copies == 1 ? " copy" : " copies";
  return text + (assembly.details.empty() ? "" : ", " + assembly.details) + ")";
}

}  // namespace

Status assemble(const Source& source, EntryRecords& entry, const std::string& id) {
  const std::vector<Assembly>& all = entry.assemblies.all;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Assembly& one) { return one.id == id; });
  if (found == all.end())
    return source.whole(all.empty() ? "describes no assembly"
                                    : "has no assembly " + inQuotes(id) + "; it " +
                                          assembliesText(entry.assemblies),
                        "Ask for one that it describes, or for none");
  return Assembler(source, entry, *found).assemble();
}

std::string assembliesText(const Assemblies& assemblies) {
  std::string list;
  for (std::size_t i = 0; i < std::min(assemblies.all.size(), mostTold); ++i)
    list += (i == 0 ? "" : ", ") + assemblyText(assemblies.all[i]);
  if (assemblies.all.size() > mostTold)
    list += " and " + std::to_string(assemblies.all.size() - mostTold) + " more";
  return (assemblies.all.size() == 1 ? "describes assembly " : "describes assemblies ") + list;
}

bool differFromTheirAtoms(const Assemblies& assemblies) {
  return assemblies.all.size() > 1 ||
         std::any_of(assemblies.all.begin(), assemblies.all.end(),
                     [](const Assembly& one) { return copiesOf(one) > 1; });
}

}  // namespace sline::model
