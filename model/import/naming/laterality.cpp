// SPDX-License-Identifier: Apache-2.0
#include "model/import/naming/laterality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "model/anatomy/kin_names.h"
#include "model/import/naming/names.h"
#include "model/scene/known_frame.h"

namespace sline::model {

namespace {

/// Holds where the structures of one name are, by their side.
struct Pair {
  std::vector<std::size_t> left;  ///< indices in the places
  std::vector<std::size_t> right;
};

/// Says what a ballot compares with what, the most telling first.
enum class Ground { pair, eachOther, middle, hull, origin };

/// Holds what one pair, or one name without its counterpart, says.
struct Ballot {
  float leftMinusRight = 0.0f;
  Ground ground = Ground::pair;
  bool wholly = false;  ///< what is compared does not reach over the line between the sides
  std::vector<std::size_t> places;
};

/// Holds where the body's middle is, and how far beside it a place must be to lie on a side.
struct Midline {
  float x = 0.0f;
  float beside = 0.0f;
};

struct FrontAndBack {
  std::vector<float> front;  ///< y of the places
  std::vector<float> back;
};

/// Returns −1 for a word that says front, 1 for back, else 0.
int frontOrBack(const std::string& word) {
  if (word == "anterior" || word == "ventral")
    return -1;
  return word == "posterior" || word == "dorsal" ? 1 : 0;
}

/// The words of names, in English and in the singular.
using NameWords = std::vector<std::string>;

bool hasAny(const NameWords& words, std::span<const std::string_view> wanted) {
  return std::any_of(words.begin(), words.end(), [wanted](const std::string& word) {
    return std::find(wanted.begin(), wanted.end(), word) != wanted.end();
  });
}

/// Tells whether the name is that of what lies at a structure or in it, and not where that lies.
bool liesBeside(const NameWords& words) {
  static constexpr std::array<std::string_view, 35> beside{
      "gall",      "muscle",  "ligament", "artery",    "vein",     "nerve",      "gland",
      "tumour",    "tumor",   "lesion",   "cyst",      "nodule",   "metastasis", "mass",
      "carcinoma", "cancer",  "abscess",  "haematoma", "hematoma", "stone",      "fracture",
      "fragment",  "implant", "screw",    "electrode", "lead",     "clip",       "seed",
      "graft",     "stent",   "catheter", "margin",    "node",     "defect",     "drain"};
  return hasAny(words, beside);
}

/// Tells whether the name is that of a structure that lies in the middle of every body: where no
/// pair tells the midline, those do.
bool liesInTheMiddle(const NameWords& words) {
  static constexpr std::array<std::string_view, 24> middle{
      "sacrum",    "coccyx",   "vertebra", "lumbar",    "spine",   "spinal",
      "sternum",   "mandible", "hyoid",    "larynx",    "trachea", "tongue",
      "pharynx",   "skull",    "cranium",  "brain",     "uterus",  "cerebellum",
      "brainstem", "prostate", "urethra",  "symphysis", "bladder", "rectum"};
  return hasAny(words, middle) && !liesBeside(words);
}

/// Tells whether the name is that of the body as a whole.
bool isHull(const std::string& name) {
  static constexpr std::array<std::string_view, 14> hulls{
      "body",         "skin",         "external",   "outline",         "torso",
      "trunk",        "whole body",   "integument", "body surface",    "body contour",
      "body outline", "skin surface", "patient",    "external contour"};
  std::string whole;
  for (const std::string& word : nameWords(name))
    whole += (whole.empty() ? "" : " ") + word;
  return std::find(hulls.begin(), hulls.end(), whole) != hulls.end();
}

/// Returns the side on which an organ lies in all but one body of ten thousand, though its name has
/// none.
Side sideByNature(const NameWords& words) {
  static constexpr std::array<std::string_view, 6> left{
      "spleen", "heart", "stomach", "descending colon", "colon descending", "sigmoid colon"};
  static constexpr std::array<std::string_view, 8> right{
      "liver", "appendix",        "vermiform appendix", "caecum",
      "cecum", "ascending colon", "colon ascending",    "gallbladder"};
  std::string whole;
  for (const std::string& word : words)
    whole += (whole.empty() ? "" : " ") + word;
  const auto among = [&whole](const auto& names) {
    return !whole.empty() && std::find(names.begin(), names.end(), whole) != names.end();
  };
  if (among(left))
    return Side::left;
  return among(right) ? Side::right : Side::none;
}

/// Tells whether a side in the name tells parts of one organ apart, which need not lie on that side
/// of the body: the right ventricle lies in its middle, the left gastric artery begins there.
bool isPartOfUnpaired(const NameWords& words) {
  static constexpr std::array<std::string_view, 18> unpaired{
      "liver",   "hepatic",  "portal",  "heart",           "atrium",        "auricle",
      "cardiac", "coronary", "gastric", "colic",           "gastroomental", "gastroepiploic",
      "colon",   "bile",     "biliary", "brachiocephalic", "pancreatic",    "aortic"};
  // A segment whose organ is not named is the liver's as often as the lung's, and "left medial
  // lobe" no lung has.
  static constexpr std::array<std::string_view, 4> segments{"segment", "subsegment", "sector",
                                                            "subsector"};
  static constexpr std::array<std::string_view, 1> lobe{"lobe"};
  static constexpr std::array<std::string_view, 4> lobes{"medial", "lateral", "caudate",
                                                         "quadrate"};
  static constexpr std::array<std::string_view, 16> paired{
      "lung",   "pulmonary", "bronchopulmonary", "bronchial", "bronchus", "kidney",
      "renal",  "apical",    "apicoposterior",   "basal",     "lingular", "lingula",
      "spinal", "breast",    "temporal",         "frontal"};
  if ((hasAny(words, segments) || (hasAny(words, lobe) && hasAny(words, lobes))) &&
      !hasAny(words, paired))
    return true;
  static constexpr std::array<std::string_view, 1> ventricle{"ventricle"};
  static constexpr std::array<std::string_view, 1> lateral{"lateral"};
  return hasAny(words, unpaired) || (hasAny(words, ventricle) && !hasAny(words, lateral));
}

/// Returns the words of the name in English, without a side.
NameWords englishWords(const std::string& name) {
  return nameWords(kinName(name).pair);
}

/// Returns these and those of the name itself, which the table of names may know by another one.
NameWords allWords(const std::string& name) {
  NameWords words = englishWords(name);
  for (std::string& word : nameWords(name))
    words.push_back(std::move(word));
  return words;
}

float mean(std::span<const NamedPosition> places, const std::vector<std::size_t>& which) {
  double sum = 0.0;
  for (const std::size_t i : which)
    sum += double(places[i].x);
  return float(sum / double(std::max<std::size_t>(1, which.size())));
}

float median(std::vector<float> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Compares places by what their names say of sides.
class Comparison {
 public:
  explicit Comparison(std::span<const NamedPosition> places) : m_places(places) { sort(); }

  /// Returns the ballots of all names that say something. The middle of whatever else there is says
  /// nothing of the body's: where all that was cut out is of one side, that is its middle.
  std::vector<Ballot> ballots() {
    comparePairs();
    if (!m_middles.empty())
      compareWith({median(m_middles), 0.0f}, Ground::middle);
    else if (!m_spine.empty())
      compareWith(midlineOf(m_spine), Ground::middle);
    else if (!m_alone.left.empty() && !m_alone.right.empty())
      compareWith(betweenTheSides(), Ground::eachOther);
    else if (!m_hulls.empty())
      compareWith(midlineOf(m_hulls), Ground::hull);
    else
      compareWithOrigin();
    return std::move(m_cast);
  }

 private:
  void sort() {
    float low = std::numeric_limits<float>::infinity();
    float high = -low;
    for (std::size_t i = 0; i < m_places.size(); ++i) {
      const NamedPosition& place = m_places[i];
      low = std::min(low, place.x - place.halfWidth);
      high = std::max(high, place.x + place.halfWidth);
      const NameWords words = englishWords(place.name);
      const SidedName name = sidedName(place.name);
      const Side nature = name.side == Side::none ? sideByNature(words) : Side::none;
      if (name.side != Side::none)
        (name.side == Side::left ? m_pairs[name.rest].left : m_pairs[name.rest].right).push_back(i);
      else if (nature != Side::none)
        (nature == Side::left ? m_alone.left : m_alone.right).push_back(i);
      else if (isHull(place.name))
        m_hulls.push_back(i);
      else if (liesInTheMiddle(allWords(place.name)))
        m_spine.push_back(i);
    }
    m_least = 0.01f * (high - low);
  }

  void add(Ballot ballot) {
    if (std::abs(ballot.leftMinusRight) > m_least)
      m_cast.push_back(std::move(ballot));
  }

  float halfWidthOf(const std::vector<std::size_t>& which) const {
    float widest = 0.0f;
    for (const std::size_t i : which)
      widest = std::max(widest, m_places[i].halfWidth);
    return widest;
  }

  void comparePairs() {
    for (const auto& [name, pair] : m_pairs) {
      if (pair.left.empty() || pair.right.empty()) {
        const auto& [from, to] = pair.left.empty() ? std::tie(pair.right, m_alone.right)
                                                   : std::tie(pair.left, m_alone.left);
        if (!isPartOfUnpaired(allWords(m_places[from.front()].name)))
          to.insert(to.end(), from.begin(), from.end());
        continue;
      }
      const float left = mean(m_places, pair.left);
      const float right = mean(m_places, pair.right);
      std::vector<std::size_t> both = pair.left;
      both.insert(both.end(), pair.right.begin(), pair.right.end());
      const bool apart =
          2.0f * std::abs(left - right) > halfWidthOf(pair.left) + halfWidthOf(pair.right);
      // The lobes of the liver tell left from right, and not where the body's middle is.
      if (!isPartOfUnpaired(allWords(m_places[both.front()].name)))
        m_middles.push_back(0.5f * (left + right));
      add({left - right, Ground::pair, apart, std::move(both)});
    }
  }

  /// Returns the middle of the places, which are in the body's middle by nature, and how far they
  /// may be from it.
  Midline midlineOf(const std::vector<std::size_t>& which) const {
    constexpr float off = 0.15f;
    std::vector<float> xs;
    std::vector<float> widths;
    for (const std::size_t i : which) {
      xs.push_back(m_places[i].x);
      widths.push_back(m_places[i].halfWidth);
    }
    return {median(std::move(xs)), off * median(std::move(widths))};
  }

  void addSide(std::size_t i, float leftMinusRight, const Midline& midline, Ground ground) {
    constexpr float part = 0.1f;
    const float half = m_places[i].halfWidth;
    if (std::abs(leftMinusRight) > std::max(part * half, midline.beside))
      add({leftMinusRight, ground, std::abs(leftMinusRight) > half, {i}});
  }

  void compareWith(const Midline& midline, Ground ground) {
    for (const std::size_t i : m_alone.left)
      addSide(i, m_places[i].x - midline.x, midline, ground);
    for (const std::size_t i : m_alone.right)
      addSide(i, midline.x - m_places[i].x, midline, ground);
  }

  /// Returns the line that parts names of the left best from names of the right, whichever way that
  /// is; of several the one with the most room.
  Midline betweenTheSides() const {
    std::vector<std::pair<float, int>> sorted;  // with 1 for left, −1 for right
    for (const std::size_t i : m_alone.left)
      sorted.emplace_back(m_places[i].x, 1);
    for (const std::size_t i : m_alone.right)
      sorted.emplace_back(m_places[i].x, -1);
    std::sort(sorted.begin(), sorted.end());
    Midline best;
    int most = -1;
    float room = 0.0f;
    int below = 0;  // how many more names of the left than of the right lie there
    const int all = int(m_alone.left.size()) - int(m_alone.right.size());
    for (std::size_t i = 0; i + 1 < sorted.size(); ++i) {
      below += sorted[i].second;
      const int parted = std::abs(below - (all - below));
      const float gap = sorted[i + 1].first - sorted[i].first;
      if (parted < most || (parted == most && gap <= room))
        continue;
      most = parted;
      room = gap;
      best.x = 0.5f * (sorted[i].first + sorted[i + 1].first);
    }
    return best;
  }

  /// Scanners and atlases have their origin in the middle as a rule: a structure that lies mostly
  /// beside it, and not so far off that the origin cannot be in the body, says a little.
  void compareWithOrigin() {
    constexpr float beside = 0.3f;
    constexpr float farOff = 15.0f;
    const auto tells = [this](std::size_t i) {
      const float half = m_places[i].halfWidth;
      return std::abs(m_places[i].x) > beside * half &&
             (half <= 0.0f || std::abs(m_places[i].x) < farOff * half);
    };
    for (const std::size_t i : m_alone.left)
      if (tells(i))
        add({m_places[i].x, Ground::origin, false, {i}});
    for (const std::size_t i : m_alone.right)
      if (tells(i))
        add({-m_places[i].x, Ground::origin, false, {i}});
  }

  std::span<const NamedPosition> m_places;
  std::map<std::string, Pair> m_pairs;
  Pair m_alone;  ///< without their counterparts
  std::vector<float> m_middles;
  std::vector<std::size_t> m_spine;
  std::vector<std::size_t> m_hulls;
  float m_least = 0.0f;
  std::vector<Ballot> m_cast;
};

}  // namespace

std::optional<Frame> FrameVote::winner() const {
  if (lps == ras)
    return std::nullopt;
  return lps > ras ? Frame::lps : Frame::ras;
}

bool FrameVote::isClear() const {
  const int all = lps + ras;
  const bool enough = compared || (all > 1 && !byOrigin);
  return lps != ras && enough && isClearVote(std::min(lps, ras), all);
}

std::string FrameVote::text() const {
  return std::string(isClear() ? "" : "weak ") + std::string(votedFrame) +
         std::to_string(std::max(lps, ras)) + " of " + std::to_string(lps + ras) +
         " left/right names";
}

FrameVote voteOnFrame(std::span<const NamedPosition> places) {
  FrameVote vote;
  for (const Ballot& ballot : Comparison(places).ballots()) {
    const bool left = ballot.leftMinusRight > 0.0f;
    const bool pair = ballot.ground == Ground::pair;
    ++(left ? vote.lps : vote.ras);
    vote.pairsLps += pair && left;
    vote.pairsRas += pair && !left;
    vote.compared = vote.compared || pair || ballot.ground == Ground::eachOther;
    vote.byOrigin =
        vote.byOrigin || ballot.ground == Ground::origin || ballot.ground == Ground::hull;
  }
  return vote;
}

bool FrameVote::refutes(bool left) const {
  const int against = left ? pairsRas : pairsLps;
  const int agreeing = left ? pairsLps : pairsRas;
  return against > 0 && isClearVote(agreeing, against + agreeing) && isClear() &&
         (left ? ras > lps : lps > ras);
}

std::vector<std::size_t> namedForOtherSide(std::span<const NamedPosition> places) {
  std::vector<std::size_t> found;
  for (const Ballot& ballot : Comparison(places).ballots())
    if (ballot.leftMinusRight < 0.0f && ballot.wholly && ballot.ground != Ground::hull)
      found.insert(found.end(), ballot.places.begin(), ballot.places.end());
  std::sort(found.begin(), found.end());
  return found;
}

namespace {
/// Names what lies in front of what in every body.
struct FrontRow {
  std::string_view region;  ///< within which they are compared
  std::array<std::string_view, 9> front;
  std::array<std::string_view, 9> back;
};

constexpr std::array<FrontRow, 3> frontRows{
    {{"the trunk",
      {"sternum", "symphysis", "bladder", "stomach", "heart", "liver", "mandible", "pancreas",
       "gallbladder"},
      {"vertebra", "spine", "spinal", "sacrum", "coccyx", "scapula", "rectum", "kidney", "spleen"}},
     {"the head",
      {"eye", "orbit", "eyeball", "maxilla", "nose", "nasal", "zygomatic", "hyoid", "vomer"},
      {"cerebellum", "occipital", "brainstem", "pons", "medulla", "spine", "vertebra", "atlas",
       "axis"}},
     {"the knee", {"patella"}, {"femur", "fibula", "popliteal"}}}};

/// Sorts by name what lies before and what behind in every body.
void addByNature(const NamedPosition& place, std::map<std::string, FrontAndBack>& pairs) {
  const NameWords words = allWords(place.name);
  if (liesBeside(words))
    return;
  const auto among = [&words](const std::array<std::string_view, 9>& names) {
    return std::any_of(names.begin(), names.end(), [&words](std::string_view name) {
      return !name.empty() && std::find(words.begin(), words.end(), name) != words.end();
    });
  };
  for (const FrontRow& row : frontRows)
    if (among(row.back))
      pairs[std::string(row.region)].back.push_back(place.y);
    else if (among(row.front))
      pairs[std::string(row.region)].front.push_back(place.y);
}
}  // namespace

FrontVote voteOnFront(std::span<const NamedPosition> places) {
  std::map<std::string, FrontAndBack> pairs;
  float low = std::numeric_limits<float>::infinity();
  float high = -low;
  for (const NamedPosition& place : places) {
    low = std::min(low, place.y);
    high = std::max(high, place.y);
    addByNature(place, pairs);
    std::string rest;
    int side = 0;
    for (const std::string& word : nameWords(place.name)) {
      const int told = frontOrBack(word);
      side = side == 0 ? told : side;
      rest += told != 0 ? std::string() : word + ' ';
    }
    if (side != 0)
      (side > 0 ? pairs[rest].back : pairs[rest].front).push_back(place.y);
  }
  FrontVote vote;
  for (const auto& [rest, pair] : pairs) {
    if (pair.front.empty() || pair.back.empty())
      continue;
    const float backward = median(pair.back) - median(pair.front);
    if (std::abs(backward) > 0.01f * (high - low))
      ++(backward > 0.0f ? vote.posterior : vote.anterior);
  }
  return vote;
}

std::optional<bool> FrontVote::toTheBack() const {
  if (posterior == anterior)
    return std::nullopt;
  return posterior > anterior;
}

const FrameAxes& axesOf(Frame frame) {
  return frames[std::size_t(frame)];
}

const FrameAxes& axesOf(std::string_view name) {
  const auto found = std::find_if(frames.begin(), frames.end(),
                                  [&](const FrameAxes& axes) { return axes.name == name; });
  return found == frames.end() ? frames.front() : *found;
}

FrameAxes axesIn(Frame frame, bool onlySideOpen) {
  FrameAxes axes = axesOf(frame);
  axes.posterior = axes.posterior && !onlySideOpen;
  return axes;
}

Frame frameWith(bool left, bool posterior) {
  if (left)
    return posterior ? Frame::lps : Frame::las;
  return posterior ? Frame::rps : Frame::ras;
}

std::string frameName(Frame frame) {
  return std::string(axesOf(frame).name);
}

}  // namespace sline::model
