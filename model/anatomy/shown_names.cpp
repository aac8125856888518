// SPDX-License-Identifier: Apache-2.0
#include "model/anatomy/shown_names.h"

#include <algorithm>
#include <array>
#include <string>
#include <unordered_set>
#include <vector>

#include "model/anatomy/anatomical_names.h"
#include "model/anatomy/name_words.h"
#include "model/anatomy/systems_table.h"
#include "model/anatomy/table_rows.h"
#include "model/base/letters.h"

namespace sline::model {

namespace {

/// Lists what the program, its users and makers of shapes call things that are no anatomy.
constexpr std::string_view ownWords =
    "3d 2d 4d front rear back behind middle "
    "surface structure segment segmentation seg label labelmap mask model mesh part piece "
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
    add(ownWords);
    add(anatomyWords);
    add(qualifyingWords);
    static const AnatomicalNames names;
    for (const NameRow& row : names.rows()) {
      for (const std::string& name : row.names)
        add(name);
      for (const std::string& name : row.synonyms)
        add(name);
    }
    for (const std::string_view table : {anatomySystemsText(), anatomyStructuresText()})
      for (const std::vector<std::string_view>& fields : tableRows(table))
        add(fields.front());
  }

  bool has(const std::string& word) const {
    return m_words.contains(word) || m_words.contains(singular(word));
  }

 private:
  void add(std::string_view name) {
    for (const std::string& word : wordsOf(name)) {
      m_words.insert(word);
      m_words.insert(singular(word));
    }
  }

  std::unordered_set<std::string> m_words;
};

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

Telling tellingOf(const std::string& word, bool target) {
  static const KnownWords known;
  constexpr std::size_t mostDigits = 2;  // more may be a date of birth or a number of a register
  const std::string_view number = withoutUnit(word);
  if (std::all_of(number.begin(), number.end(), isDigit))
    return number.size() <= mostDigits ? Telling::nothing : Telling::unknown;
  // "a", and "a1" or "t12", which are parts of a figure or levels of the spine.
  const bool letter = std::all_of(word.begin() + 1, word.end(), isDigit);
  constexpr std::array<std::string_view, 11> fillers{"to", "in", "with", "by", "from",   "the",
                                                     "at", "of", "and",  "or", "without"};
  if (std::find(fillers.begin(), fillers.end(), word) != fillers.end() ||
      (letter && word.size() <= 1 + mostDigits) || sideOfWord(word) != Side::none ||
      fromRoman(word) != 0)
    return Telling::nothing;
  static const std::vector<std::string> ofPlans = wordsOf(planWords);
  const bool ofPlan = target && std::find(ofPlans.begin(), ofPlans.end(), word) != ofPlans.end();
  return ofPlan || known.has(word) ? Telling::something : Telling::unknown;
}

/// Returns what the piece of a name tells: the most of its words.
Telling tellingOfPiece(std::string_view piece, bool target) {
  Telling most = Telling::nothing;
  for (const std::string& word : wordsOf(piece))
    most = std::max(most, tellingOf(word, target));
  return most;
}

}  // namespace

std::string shownName(std::string_view name) {
  std::string shown;
  bool whole = true;
  bool something = false;
  int numbers = 0;
  const bool target = namesTarget(wordsOf(name));
  std::size_t endOfLast = 0;  ///< of the last piece that is shown
  for (std::size_t at = 0; at < name.size();) {
    const auto isOfWord = [](char c) { return isLetter(c) || isDigit(c); };
    const auto begin = std::find_if(name.begin() + std::ptrdiff_t(at), name.end(), isOfWord);
    const auto end = std::find_if_not(begin, name.end(), isOfWord);
    at = std::size_t(end - name.begin());
    if (begin == end)
      break;
    const std::string_view piece(&*begin, std::size_t(end - begin));
    // Three numbers may be a date of birth.
    const bool number = std::all_of(piece.begin(), piece.end(), isDigit);
    const std::string lower = lowerCase(piece);
    numbers += number ? 1 : 0;
    const Telling telling = target && isDose(withoutUnit(lower)) ? Telling::something
                            : number && numbers > 2              ? Telling::unknown
                                                                 : tellingOfPiece(piece, target);
    if (telling == Telling::unknown) {
      whole = false;
      continue;
    }
    something = something || telling == Telling::something;
    // In "Liver-GTV" the dash says that the one is without the other.
    const std::string_view between =
        name.substr(endOfLast, std::size_t(begin - name.begin()) - endOfLast);
    shown += shown.empty() ? "" : between == "-" || between == "+" ? between : " ";
    shown += piece;
    endOfLast = at;
  }
  if (whole)
    return shown.empty() ? shown : std::string(name);
  return something ? shown : std::string();
}

}  // namespace sline::model
