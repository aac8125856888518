// SPDX-License-Identifier: Apache-2.0
#include "render/export/description/alt_text.h"

#include <QStringList>
#include <algorithm>
#include <array>
#include <set>

#include "model/scene/known_frame.h"
#include "model/scene/label_words.h"
#include "render/export/description/description_words.h"
#include "render/export/description/picture_facts.h"
#include "render/export/plate/marks.h"
#include "render/export/plate/source_credits.h"
#include "render/lettering/mark_words.h"

namespace sline::render {

namespace {

/// Puts facts into words, as many as may be.
class Describing {
 public:
  Describing(const ExportOrder& order, std::size_t mostWords)
      : m_order(order),
        m_facts(pictureFacts(order)),
        m_sides(knownSides(order.scene)),
        m_language(model::firstLanguage(order.labels.language)),
        m_words(descriptionTable(m_language)),
        m_left(mostWords) {}

  std::string make(bool named) {
    if (m_facts.structures.empty())
      return m_words.empty;
    addFirst(named);
    addEdge(m_words.onLeft, m_facts.left);
    addEdge(m_words.onTop, m_facts.top);
    if (m_facts.sidesInDoubt)
      add(told(m_words.inDoubt));
    addSections();
    if (!named)
      return m_said.join(QLatin1Char(' ')).toStdString();
    addLabelled();
    for (const QString& distance : m_facts.distances)
      add(distance + QLatin1Char('.'));
    if (m_named.empty()) {
      addOthers(m_words.shown);
      addBefore();
    } else {
      addBefore();
      addOthers(m_words.others);
    }
    return m_said.join(QLatin1Char(' ')).toStdString();
  }

 private:
  static QString told(const char* text) { return QString::fromUtf8(text); }

  /// Adds the sentence if there are words left for it.
  bool add(const QString& sentence) {
    const std::size_t words = wordCount(sentence);
    if (words > m_left)
      return false;
    m_left -= words;
    m_said << sentence;
    return true;
  }

  /// Returns the mark of a side of which nobody is sure.
  QString doubtOf(model::AnatomicalView side) const {
    return m_sides.inDoubt(model::axisOf(side)) ? QLatin1String(model::doubtMark) : QString();
  }

  void addFirst(bool named) {
    const std::size_t all = m_facts.structures.size();
    QString first = all == 1 ? told(m_words.one) : told(m_words.many).arg(all);
    QStringList from;
    for (const model::AnatomicalView side : m_facts.from)
      from << told(m_words.from[std::size_t(side)]) + doubtOf(side);
    if (!from.empty())
      first = told(m_words.seen).arg(first, listed(from, m_words));
    const auto labelled =
        std::count_if(m_facts.structures.begin(), m_facts.structures.end(),
                      [](const SeenStructure& structure) { return structure.labelled; });
    if (named && labelled > 0)
      first = told(m_words.labelled).arg(first).arg(labelled);
    add(first + QLatin1Char('.'));
  }

  void addEdge(const char* sentence, const std::optional<model::AnatomicalView>& side) {
    if (side)
      add(told(sentence).arg(told(m_words.ends[std::size_t(*side)]) + doubtOf(*side)));
  }

  void addSections() {
    const std::vector<const model::Section*> sections = sectionsSeen(m_order.scene);
    const MarkWords words(m_language, m_sides);
    constexpr std::size_t single = 2;
    if (sections.size() > single)
      add(words.sections(sections.size()) + QLatin1Char('.'));
    else
      for (const model::Section* section : sections)
        add(words.section(section->plane, drawnUnit(m_order.scene)) + QLatin1Char('.'));
  }

  /// Adds the names of what is labelled, by where it stands; those of which one sees most first,
  /// where not all have room.
  void addLabelled() {
    std::vector<const SeenStructure*> labelled;
    for (const SeenStructure& one : m_facts.structures)
      if (one.labelled)
        labelled.push_back(&one);
    for (std::size_t count = labelled.size(); count > 0; --count) {
      const std::vector<const SeenStructure*> some(labelled.begin(),
                                                   labelled.begin() + std::ptrdiff_t(count));
      const QString sentence = inZones(some, labelled.size() - count);
      if (!add(sentence))
        continue;
      for (const SeenStructure* one : some)
        m_named.insert(one->id);
      return;
    }
  }

  QString inZones(const std::vector<const SeenStructure*>& structures, std::size_t more) const {
    std::array<QStringList, 3> zones;
    for (const SeenStructure* one : structures)
      zones[one->across < 0.42f ? 0 : one->across > 0.58f ? 2 : 1] << one->name;
    QStringList sentences;
    const auto all = qsizetype(structures.size());
    for (std::size_t i = 0; i < zones.size(); ++i)
      if (zones[i].size() == all)
        sentences << told(i == 1 ? m_words.names : m_words.zones[i]).arg(listed(zones[i], m_words));
      else if (!zones[i].empty())
        sentences << told(m_words.zones[i]).arg(listed(zones[i], m_words));
    if (more > 0)
      sentences << told(m_words.others).arg(told(m_words.more).arg(more));
    return sentences.join(QLatin1Char(' '));
  }

  const QString* nameOf(model::NodeId id) const {
    for (const SeenStructure& one : m_facts.structures)
      if (one.id == id)
        return &one.name;
    return nullptr;
  }

  /// Tells that what is labelled lies before what is; where nothing is, that of all.
  void addBefore() {
    constexpr std::size_t mostSentences = 3;
    constexpr qsizetype mostBehind = 4;
    std::size_t sentences = 0;
    for (const SeenBefore& one : m_facts.before) {
      QStringList behind;
      for (const model::NodeId id : one.behind)
        if ((m_named.empty() || m_named.contains(id)) && behind.size() < mostBehind)
          behind << *nameOf(id);
      const bool wanted = m_named.empty() || m_named.contains(one.before);
      if (wanted && !behind.empty() && sentences < mostSentences &&
          add(told(m_words.before).arg(*nameOf(one.before), listed(behind, m_words))))
        ++sentences;
    }
  }

  /// Names the largest of the others, and counts the rest.
  void addOthers(const char* sentence) {
    constexpr std::size_t mostOthers = 12;
    std::vector<const QString*> others;
    for (const SeenStructure& one : m_facts.structures)
      if (!m_named.contains(one.id) && !one.labelled)
        others.push_back(&one.name);
    for (std::size_t count = std::min(others.size(), mostOthers); count > 0; --count) {
      QStringList names;
      for (std::size_t i = 0; i < count; ++i)
        names << *others[i];
      if (count < others.size())
        names << told(m_words.more).arg(others.size() - count);
      if (add(told(sentence).arg(listed(names, m_words))))
        return;
    }
  }

  const ExportOrder& m_order;
  PictureFacts m_facts;
  model::KnownSides m_sides;
  std::string m_language;
  const DescriptionTable& m_words;
  std::size_t m_left;  ///< words that may still be said
  QStringList m_said;
  std::set<model::NodeId> m_named;
};

std::string oneLine(const std::string& text) {
  return QString::fromStdString(text).simplified().toStdString();
}

}  // namespace

std::string describedPicture(const ExportOrder& order, std::size_t mostWords) {
  return Describing(order, mostWords).make(order.labels.mode == LabelMode::on);
}

AltText altTextOf(const ExportOrder& order) {
  const std::string language = model::firstLanguage(order.labels.language);
  const bool test =
      order.labels.mode == LabelMode::numbers || order.labels.mode == LabelMode::blank;
  if (order.altText == "off")
    return {};
  if (!test && !order.altText.empty())
    return {oneLine(order.altText), language};
  const model::Wording& said = order.words.description;
  if (order.labels.mode == LabelMode::on && !said.in(language).empty())
    return {oneLine(said.in(language)), said.texts.contains(language) ? language : std::string()};
  // A file does not tell what nobody has written on the picture, such as names of files.
  const bool named = order.labels.mode == LabelMode::on && hasLabels(order.scene);
  return {Describing(order, usualWords).make(named), descriptionTable(language).language};
}

AltText altTextOfFilm(const ExportOrder& first) {
  AltText said = altTextOf(first);
  if (first.altText.empty() && !said.text.empty())
    said.text = QString::fromUtf8(descriptionTable(said.language).film)
                    .arg(QString::fromStdString(said.text))
                    .toStdString();
  return said;
}

ExportCredit fileCredit(const ExportOrder& order, const AltText& said) {
  ExportCredit credit = order.credit;
  credit.description = said.text;
  credit.descriptionLanguage = said.language;
  if (const std::string sources = sourcesInOne(order.scene);
      order.sourcesInPicture() && !sources.empty())
    credit.copyright += (credit.copyright.empty() ? "" : "; ") + sources;
  return credit;
}

ExportCredit fileCredit(const ExportOrder& order) {
  return fileCredit(order, altTextOf(order));
}

}  // namespace sline::render
