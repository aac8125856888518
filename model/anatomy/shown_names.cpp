// SPDX-License-Identifier: Apache-2.0
#include "model/anatomy/shown_names.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "model/anatomy/anatomical_names.h"
#include "model/anatomy/laterality_words.h"
#include "model/anatomy/name_words.h"
#include "model/anatomy/names_table.h"
#include "model/anatomy/systems_table.h"
#include "model/anatomy/table_rows.h"
#include "model/base/letters.h"

namespace sline::model {

namespace {

/// Lists what the program, its users and makers of shapes call things that are no anatomy.
constexpr std::string_view ownWords =
    "3d 2d 4d front rear back behind middle "
    "surface Körper lichaam kropp structure segment segmentation seg label labelmap mask model "
    "mesh part piece "
    "volume scan scene group object shape body atlas demo test sample image series region "
    "area zone copy picture figure plate drawing view page sheet lesson quiz film slide deck "
    "card untitled ct mr mri mra cta pet us contrast phase smooth smoothed coarse fine final "
    "raw old new twice again mirrored shifted moved turned broken open closed hollow upper "
    "lower inner outer big small large near far pair one two three four five first second "
    "third ball sphere cube box block tube cylinder cone torus ring bowl blob bump wave plane "
    "grid knot tree stem branch hull shell target passing neighbour vessel cow bunny teapot "
    "half bridge step layer slab wedge vh sbu spl pial inflated aseg aparc wmparc surf lh rh "
    "hemi binary ascii rgb total points lines all none absent gone empty whole capsule square "
    "icosahedron octahedron dodecahedron hexahedron tetrahedron pyramid prism helix spiral solid "
    "hierarchy level data bundle general camera slicer union point tip risk patient mouse rat "
    "rabbit pig dog sheep human adult child fetal";

/// Lists words with which anatomists tell apart what the tables name, and what plans of treatment
/// add.
constexpr std::string_view anatomyWords =
    "th met mets hcc ccc crlm rcc roi "
    "stone calculus concrement stent graft prosthesis screw rod nail wire coil drain needle "
    "electrode lead pacemaker cyst abscess haematoma hematoma mass lesion nodule metastasis "
    "metastases infarct thrombus aneurysm dissection stenosis fistula hernia polyp fracture "
    "fragment callus remnant residual resected resection ablation enhancing core rim healthy "
    "diseased normal benign malignant preop postop growth effusion ascites air gas plaque "
    "calcification defect scar shunt bypass fiducial marker "
    "accessory acromial adenohypophysis afferent alar alimentary anastomosis anatomical ant "
    "antebrachial anterior antero anteroinferior anterolateral anterosuperior antlat apex apical "
    "apicoposterior apparatus appendicular "
    "aqueous archicortex arcuate areolar arm atypical auriculotemporal axial background bare "
    "base baseline basicranial basicranium basilic bed bleeding brachium branches breves "
    "bulbar bundle callosomarginal canaliculus capillary cardinal cartilaginous catheter "
    "caudal caval cavitated cecal cell centerline centralis centreline cephalic cerebro "
    "chamber cheek chest choroidal ciliaris circulation circumflex circumventricular clavicular "
    "clip clot "
    "cluster coli collateral commissural communicating compartment component conduit condyle "
    "connective contour corneoscleral corniculate corticomedullary cranial cricoid cruciate "
    "cubital cusp decussation diagonal diaphragmatic digital distal division dorsalis dorsum "
    "dome dose edema edge eighth elasticus elbow eleventh embolism epiglottic epiphysis epiploic "
    "epithalamus epithelium esophageal ethmoidal expanded extrahepatic extrinsic eyebrow face "
    "false fascial faucial feces fiber fibers fibre fibres fibrous fimbria finger flat "
    "floating follicle foot forearm formation free frontobasal fused genicular girdle half "
    "hand head hemiliver hepataduodenal hemisphere hepatoduodenal heterogeneous hilum hilus "
    "horizontal "
    "humeral humor hyo hypothalamic hypothenar ileal ileocolic iliolumbar implant impression "
    "incisure index inferomedial inflow infrahyoid infratrochlear infundibulum innermost "
    "integumentary intercondylar interlobar intermediomedial interpeduncular intracranial "
    "intrahepatic intrapulmonary intrinsic investing irregular isodose isthmus laryngeal "
    "laryngopharynx lata laterobasal leaf leaflet leg libera limb line lingular lips little "
    "lobar lobular longi loose lutea lymphoid mandibular margin mediastinum mediobasal "
    "meshwork mesocolica mons mucoid musculophrenic musculoskeletal myocardial nasociliary "
    "neck necrosis network neural neurocranium neurohypophysis ninth nonparenchymatous "
    "nonskeletal nose ocular oculomotor oesophageal omentalis oper opercular ora orbit orbital "
    "osseous outflow palpebral pancreaticobiliary parasympathetic parenchyma parenchymatous "
    "patellar pectoral pedis perforating pericallosal pericardial perineum peritoneal "
    "pneumatized polar porta portion pos postcommunicating "
    "posteroinferior posterolateral posteromedial posterosuperior posmed postvertebral "
    "precommunicating precuneal prefrontal prevertebral profundus proximal pterygomandibular "
    "pulmopleural recurrent retroperitoneal scapular secondary sector segmental septal serous "
    "serrata sesamoid set seventh short shrunk side sixth splenial sternal sternocostal "
    "striatum structures stump subaortic subcortex subcostal subdivision subendocardial "
    "suboccipital subscapular subsector subsegmental subsuperior sulcus superiomedial superficial "
    "superficialis suprahyoid suprascapular supratrochlear supreme suspensory systemic tectum "
    "temporo tenth terminal thalamogeniculate thalamoperforating thenar thoraco thoracodorsal "
    "thorax thumb thyroepiglotticus toe trabecular tracheal tract tri triangular trochlea "
    "trochlear true trunk tubercle twelfth typical upper urine uterosacral uvular variant "
    "vermian vertical viscerocranium vivo vocal wall wrist";

/// Lists words that turn the sense of others round or bound it, in the languages of names: a name
/// without them would say something else.
constexpr std::string_view qualifyingWords =
    "no not non none without minus plus except excluding excluded including spared sparing "
    "remaining suspected suspicious possible probable uncertain unknown presumed ohne kein keine "
    "nicht verdacht verdächtig fraglich sans sine zonder geen niet uten ikke ingen ipsilateral "
    "contralateral ipsi contra affected unaffected uninvolved visible invisible missing preserved "
    "cut divided injured ligated planned predicted expected measured simulated prv itv ptv ctv gtv "
    "nrv optnrv glnd musc strct";

/// Lists words that tell volumes of a plan of radiotherapy apart; elsewhere they may be a person's.
constexpr std::string_view planWords =
    "high low intermediate medium boost ring bag bolus couch avoid opt eval evl oar dvh fx";

class KnownWords {
 public:
  KnownWords() {
    for (const std::string_view list : {ownWords, anatomyWords, qualifyingWords})
      add(list);
    static const AnatomicalNames names;
    for (const NameRow& row : names.rows()) {
      for (std::size_t language = 0; language < nameLanguages; ++language)
        add(row.names[language], NameLanguage(language) != NameLanguage::english);
      for (const std::string& name : row.synonyms)
        add(name);
    }
    for (const std::string_view table : {anatomySystemsText(), anatomyStructuresText()})
      for (const std::vector<std::string_view>& fields : tableRows(table))
        add(fields.front());
    for (const std::vector<std::string_view>& fields : tableRows(cellNamesText()))
      for (const std::string_view name : fields)
        add(name);
  }

  bool has(const std::string& word) const {
    return m_words.contains(plainSpelling(word)) || m_words.contains(plainSpelling(singular(word)));
  }

  /// Tells whether the word is of a name in another language than English.
  bool isForeign(const std::string& word) const { return m_foreign.contains(plainSpelling(word)); }

 private:
  void add(std::string_view name, bool foreign = false) {
    for (const std::string& word : wordsOf(name)) {
      m_words.insert(plainSpelling(word));
      m_words.insert(plainSpelling(singular(word)));
      if (foreign)
        m_foreign.insert(plainSpelling(word));
    }
  }

  std::unordered_set<std::string> m_words;
  std::unordered_set<std::string> m_foreign;
};

const KnownWords& knownWords() {
  static const KnownWords known;
  return known;
}

enum class Telling {
  nothing,  ///< of a person either: a letter, a side, a small number
  something,
  unknown,
};

/// Returns the word without the unit of a length or dose at its end.
std::string_view withoutUnit(std::string_view word) {
  for (const std::string_view unit : {"mm", "cm", "cgy", "gy"}) {
    if (word.size() > unit.size() && word.ends_with(unit) && isDigit(word.front()))
      return word.substr(0, word.size() - unit.size());
  }
  return word;
}

/// Tells whether the number can only be a dose in cGy, beside a target of radiotherapy: no year and
/// no day has it.
bool isDose(std::string_view number) {
  return number.size() == 4 && number >= "2100" && number <= "9900" &&
         (number.back() == '0' || number.back() == '5');
}

/// Tells whether one of the words names a target volume of radiotherapy.
bool namesTarget(const std::vector<std::string>& words) {
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return word == "ptv" || word == "ctv" || word == "gtv" || word == "itv";
  });
}

/// Tells whether the word only counts or classes, as "a", "12", "t12", "4a" and "c7b" do: parts of
/// a figure, levels of the spine, segments of the liver, lobules of the cerebellum.
bool onlyCounts(std::string_view word) {
  constexpr std::size_t mostDigits = 2;  // more may be a date of birth or a number of a register
  if (fromRoman(word) != 0)
    return true;
  const bool before = isLetter(word.front());
  word.remove_prefix(before ? 1 : 0);
  if (!word.empty() && isLetter(word.back()))
    word.remove_suffix(1);
  else if (word.empty())
    return before;
  return !word.empty() && word.size() <= mostDigits &&
         std::all_of(word.begin(), word.end(), isDigit);
}

Telling tellingOf(const std::string& word, bool target) {
  constexpr std::size_t mostDigits = 2;  // more may be a date of birth or a number of a register
  const std::string_view number = withoutUnit(word);
  if (std::all_of(number.begin(), number.end(), isDigit))
    return number.size() <= mostDigits ? Telling::nothing : Telling::unknown;
  constexpr std::array<std::string_view, 11> fillers{"to", "in", "with", "by", "from",   "the",
                                                     "at", "of", "and",  "or", "without"};
  if (std::find(fillers.begin(), fillers.end(), word) != fillers.end() || onlyCounts(word) ||
      sideOfWord(word) != Side::none)
    return Telling::nothing;
  static const std::vector<std::string> ofPlans = wordsOf(planWords);
  const bool ofPlan = target && std::find(ofPlans.begin(), ofPlans.end(), word) != ofPlans.end();
  return ofPlan || knownWords().has(word) ? Telling::something : Telling::unknown;
}

/// Tells whether what is written at this place of a name's words ("li", "Re") is a side's
/// abbreviation: all else is anatomy. "Li" is a person's name, too: beside English words it is a
/// side only where it stands last and in letters of one size.
bool isShortSide(const std::vector<std::string>& words, std::size_t at, std::string_view written,
                 bool target) {
  if (!isSideAbbreviation(words, at))
    return false;
  bool foreign = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i != at && tellingOf(words[i], target) == Telling::unknown)
      return false;
    foreign = foreign || (i != at && knownWords().isForeign(words[i]));
  }
  const bool plain =
      std::none_of(written.begin() + 1, written.end(), isUpper) && isUpper(written.front());
  return foreign || (at > 0 && !plain);
}

/// Tells whether what is written is a Roman number with a letter, as "IVa" and "VIIb"; "Xia" and
/// "Iva" are persons' names where nothing before them says that they count.
bool isRomanPart(std::string_view written, std::string_view before) {
  constexpr std::string_view parts = "abcd";
  const std::string lower = lowerCase(written);
  if (lower.size() < 2 || parts.find(lower.back()) == std::string_view::npos ||
      fromRoman(std::string_view(lower).substr(0, lower.size() - 1)) == 0)
    return false;
  const std::string_view number = written.substr(0, written.size() - 1);
  const bool asNumber =
      std::all_of(number.begin(), number.end(), isUpper) && isLower(written.back());
  return (asNumber && written.size() > 2) || before == "segment" || before == "lobule";
}

/// What stands between two characters that are no letters or digits.
struct NamePiece {
  std::string_view text;
  std::string_view between;  ///< before it, from the end of the one before
  Telling telling = Telling::nothing;
};

std::vector<std::string_view> piecesOf(std::string_view name) {
  std::vector<std::string_view> pieces;
  for (std::size_t at = 0; at < name.size();) {
    const auto isOfWord = [](char c) { return isLetter(c) || isDigit(c); };
    const auto begin = std::find_if(name.begin() + std::ptrdiff_t(at), name.end(), isOfWord);
    const auto end = std::find_if_not(begin, name.end(), isOfWord);
    at = std::size_t(end - name.begin());
    if (begin != end)
      pieces.emplace_back(&*begin, std::size_t(end - begin));
  }
  return pieces;
}

bool isNumber(std::string_view piece) {
  return std::all_of(piece.begin(), piece.end(), isDigit);
}

/// Tells whether the numbers are widths of a margin, all of them the same ("5_5_5"), and not the
/// tenth of October 2010.
bool areMargins(std::span<const std::string_view> pieces, const std::vector<std::string>& words) {
  std::string_view first;
  for (const std::string_view piece : pieces) {
    if (!isNumber(piece))
      continue;
    if (!first.empty() && piece != first)
      return false;
    first = piece;
  }
  constexpr std::string_view lastMonth = "12";
  const bool widens = std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return word == "expanded" || word == "margin" || word == "ring" || word == "prv";
  });
  const bool none = first.empty() || first.front() == '0' || first.size() > 2;
  return !none && (first.size() == 1 || first > lastMonth || widens || namesTarget(words));
}

/// Returns the pieces of a name with what each tells.
std::vector<NamePiece> toldPieces(std::string_view name) {
  const std::vector<std::string_view> pieces = piecesOf(name);
  const std::vector<std::string> words = wordsOf(name);
  const bool target = namesTarget(words);
  const bool margins = areMargins(pieces, words);
  std::vector<NamePiece> told;
  int numbers = 0;
  std::size_t at = 0;  ///< of the piece's first word
  for (const std::string_view piece : pieces) {
    const bool number = isNumber(piece);
    numbers += number ? 1 : 0;
    Telling telling = Telling::nothing;
    const std::vector<std::string> own = wordsOf(piece);
    for (const std::string& word : own) {
      // In "NiereLi" the capital only begins the word.
      const std::string_view written = own.size() == 1 ? piece : std::string_view(word);
      const bool side = at < words.size() && isShortSide(words, at, written, target);
      const bool part =
          isRomanPart(written, at > 0 && at < words.size() ? std::string_view(words[at - 1])
                                                           : std::string_view());
      telling = std::max(telling, side || part ? Telling::nothing : tellingOf(word, target));
      ++at;
    }
    // Three numbers may be a date of birth.
    if (target && isDose(withoutUnit(lowerCase(piece))))
      telling = Telling::something;
    else if (number && numbers > 2 && !margins)
      telling = Telling::unknown;
    const std::string_view before = told.empty() ? std::string_view() : told.back().text;
    const char* from = told.empty() ? name.data() : before.data() + before.size();
    told.push_back({piece, {from, std::size_t(piece.data() - from)}, telling});
  }
  return told;
}

bool isUnknown(const NamePiece& piece) {
  return piece.telling == Telling::unknown;
}

bool isTelling(const NamePiece& piece) {
  return piece.telling == Telling::something;
}

}  // namespace

std::string shownName(std::string_view name) {
  const std::vector<NamePiece> pieces = toldPieces(name);
  if (std::none_of(pieces.begin(), pieces.end(), isUnknown))
    return pieces.empty() ? std::string() : std::string(name);
  if (std::none_of(pieces.begin(), pieces.end(), isTelling))
    return {};
  std::string shown;
  bool afterShown = false;
  for (const NamePiece& piece : pieces) {
    if (isUnknown(piece)) {
      afterShown = false;
      continue;
    }
    // In "Liver-GTV" the dash says that the one is without the other.
    const bool sign = afterShown && (piece.between == "-" || piece.between == "+");
    shown += shown.empty() ? std::string_view() : sign ? piece.between : " ";
    shown += piece.text;
    afterShown = true;
  }
  return shown;
}

std::vector<std::string> wordsNotShown(std::string_view name) {
  const std::vector<NamePiece> pieces = toldPieces(name);
  const bool nothing = std::none_of(pieces.begin(), pieces.end(), isTelling);
  std::vector<std::string> words;
  if (std::none_of(pieces.begin(), pieces.end(), isUnknown))
    return words;
  for (const NamePiece& piece : pieces)
    if (isUnknown(piece) || (nothing && !isNumber(piece.text)))
      words.emplace_back(piece.text);
  return words;
}

}  // namespace sline::model
