// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/patient_marks.h"

#include <algorithm>
#include <array>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "model/base/letters.h"
#include "model/base/sha256.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/readers/dicom_identity.h"
#include "model/import/source/source.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;
using Mark = std::optional<std::uint64_t>;

constexpr std::size_t headerRead = std::size_t(1) << 16;
constexpr std::size_t longHeaderRead = std::size_t(8) << 20;

/// Returns letters and digits alone, so that "DOE^JANE" and "Doe, Jane" are one name.
std::string plain(std::string_view text) {
  std::string letters;
  for (const char c : text.substr(0, text.find('=')))
    if (isLetter(c) || isDigit(c))
      letters += lowerCase(c);
  return letters;
}

Mark markOf(std::string_view text) {
  constexpr std::array<std::string_view, 14> nobody{
      "",       "0",    "anon", "anonymous", "anonymized",   "anonymised",       "unknown",
      "noname", "none", "na",   "removed",   "deidentified", "anonymouspatient", "patient"};
  const std::string word = plain(text);
  if (std::find(nobody.begin(), nobody.end(), word) != nobody.end())
    return std::nullopt;
  return std::hash<std::string>()(word);
}

/// Identifiers count as they stand, blanks around them aside. The marks are the same in every build
/// of the program, since scenes keep traces of them.
Mark markOfUid(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string_view::npos)
    return std::nullopt;
  const Sha256 digest = sha256(text.substr(begin, text.find_last_not_of(' ') - begin + 1));
  std::uint64_t mark = 0;
  for (std::size_t i = 0; i < sizeof mark; ++i)
    mark = mark << 8 | digest[i];
  return mark;
}

std::string beginning(const fs::path& file, const ReadLimits& limits, std::size_t most) {
  const Result<Source> source = Source::readStored(file, limits, most);
  return source ? std::string(source->text()) : std::string();
}

PatientMarks ofDicom(const fs::path& file, const ReadLimits& limits) {
  DicomIdentity identity = dicomIdentity(beginning(file, limits, headerRead));
  if (!identity.complete)
    identity = dicomIdentity(beginning(file, limits, longHeaderRead));
  return {.id = markOf(identity.patientId),
          .name = markOf(identity.patientName),
          .subject = {},
          .study = markOfUid(identity.study),
          .frame = markOfUid(identity.frameOfReference)};
}

/// Takes what a key of a header says, however its program spells DICOM's words.
void take(PatientMarks& marks, std::string_view key, std::string_view value) {
  struct Row {
    std::string_view word;
    Mark PatientMarks::*mark;
    bool uid = false;
  };
  static constexpr std::array rows{Row{"patientname", &PatientMarks::name},
                                   Row{"patientsname", &PatientMarks::name},
                                   Row{"00100010", &PatientMarks::name},
                                   Row{"patientid", &PatientMarks::id},
                                   Row{"00100020", &PatientMarks::id},
                                   Row{"studyinstanceuid", &PatientMarks::study, true},
                                   Row{"0020000d", &PatientMarks::study, true},
                                   Row{"00200052", &PatientMarks::frame, true},
                                   Row{"frameofreferenceuid", &PatientMarks::frame, true}};
  const std::string word = plain(key);
  // "IssuerOfPatientID" is a hospital's.
  if (word.find("issuer") != std::string::npos)
    return;
  const auto says = [&word](std::string_view what) {
    return isDigit(what.front()) ? word.find(what) != std::string::npos : word.ends_with(what);
  };
  for (const Row& row : rows)
    if (says(row.word) && !(marks.*row.mark))
      marks.*row.mark = row.uid ? markOfUid(value) : markOf(value);
}

/// Reads "key:=value" and "key = value" up to the line that ends a header.
PatientMarks ofKeys(std::string_view text) {
  PatientMarks marks;
  for (TextCursor at(text); !at.atEnd();) {
    const std::string_view line = at.restOfLine();
    if (line.empty() || line.starts_with("ElementDataFile"))
      break;
    const std::size_t sign = std::min(line.find(":="), line.find(" = "));
    if (sign != std::string_view::npos)
      take(marks, line.substr(0, sign), line.substr(sign + 2));
  }
  return marks;
}

PatientMarks ofJson(const fs::path& file, const ReadLimits& limits) {
  PatientMarks marks;
  const auto json = nlohmann::json::parse(beginning(file, limits, longHeaderRead), nullptr, false);
  if (json.is_object())
    for (const auto& [key, value] : json.items())
      if (value.is_string())
        take(marks, key, value.get_ref<const std::string&>());
  return marks;
}

/// Reads patient_id of Analyze 7.5, where the header is not NIfTI's.
PatientMarks ofAnalyze(std::string_view header) {
  constexpr std::size_t whole = 348;
  if (header.size() < whole || header.substr(344, 2) == "ni" || header.substr(344, 2) == "n+")
    return {};
  const std::string_view id = header.substr(283, 10);
  return {.id = markOf(id.substr(0, id.find('\0'))),
          .name = {},
          .subject = {},
          .study = {},
          .frame = {}};
}

/// Returns the text of an attribute of netCDF: name, padding, type, length, text.
std::string_view netcdfText(std::string_view file, std::string_view name) {
  const std::size_t at = file.find(name);
  if (at == std::string_view::npos)
    return {};
  const std::size_t length = at + (name.size() + 3) / 4 * 4 + 4;
  if (length + 4 > file.size())
    return {};
  std::size_t size = 0;
  for (std::size_t i = 0; i < 4; ++i)
    size = size << 8 | static_cast<unsigned char>(file[length + i]);
  const std::string_view rest = file.substr(length + 4);
  return size > rest.size() ? std::string_view() : rest.substr(0, rest.substr(0, size).find('\0'));
}

PatientMarks ofMinc(std::string_view text) {
  return {.id = markOf(netcdfText(text, "identification")),
          .name = markOf(netcdfText(text, "full_name")),
          .subject = {},
          .study = {},
          .frame = {}};
}

/// Reads the items of the subject hierarchy: attributes="Level^Patient|DICOM.PatientID^7|…".
std::vector<PatientMarks> ofSlicer(std::string_view text) {
  const auto valueOf = [](std::string_view attributes, std::string_view key) {
    const std::size_t at = attributes.find(key);
    if (at == std::string_view::npos)
      return Mark();
    const std::string_view value = attributes.substr(at + key.size());
    return markOf(value.substr(0, value.find_first_of("|\"")));
  };
  constexpr std::string_view item = "<SubjectHierarchyItem";
  std::set<PatientMarks> patients;
  for (std::size_t at = text.find(item); at != std::string_view::npos;
       at = text.find(item, at + 1)) {
    const std::string_view tag = text.substr(at, text.find('>', at) - at);
    const PatientMarks marks{.id = valueOf(tag, "DICOM.PatientID^"),
                             .name = valueOf(tag, "DICOM.PatientName^"),
                             .subject = {},
                             .study = {},
                             .frame = {}};
    if (marks.any())
      patients.insert(marks);
  }
  return {patients.begin(), patients.end()};
}

/// Returns the subject that the Brain Imaging Data Structure has in names: "sub-01_T1w.nii".
/// Without a digit it may be anatomy: "sub-lingual gland.stl".
Mark subjectIn(const fs::path& file) {
  constexpr std::string_view entity = "sub-";
  Mark subject;
  for (const fs::path& step : file) {
    const std::string name = step.string();
    if (!name.starts_with(entity))
      continue;
    const std::string_view label = std::string_view(name).substr(
        entity.size(), name.find_first_of("_.", entity.size()) - entity.size());
    if (std::any_of(label.begin(), label.end(), isDigit) &&
        std::all_of(label.begin(), label.end(), [](char c) { return isLetter(c) || isDigit(c); }))
      subject = markOf(label);
  }
  return subject;
}

}  // namespace

std::vector<PatientMarks> patientMarks(const fs::path& file, const ReadLimits& limits) {
  const std::string ending = lowerExtension(file);
  if (ending == ".mrml")
    return ofSlicer(beginning(file, limits, longHeaderRead));
  PatientMarks marks;
  if (isDicomFile(file))
    marks = ofDicom(file, limits);
  else if (ending == ".nrrd" || ending == ".nhdr" || ending == ".mha" || ending == ".mhd")
    marks = ofKeys(beginning(file, limits, headerRead));
  else if (ending == ".hdr" || ending == ".img")
    marks = ofAnalyze(beginning(fs::path(file).replace_extension(".hdr"), limits, headerRead));
  else if (ending == ".mnc")
    marks = ofMinc(beginning(file, limits, headerRead));
  if (!marks.any() && isVolumeFile(file))
    marks = ofJson(file.parent_path() / (stemOf(file) + ".json"), limits);
  marks.subject = subjectIn(file);
  return marks.any() ? std::vector{marks} : std::vector<PatientMarks>();
}

}  // namespace sline::model
