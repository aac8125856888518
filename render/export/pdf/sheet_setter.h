// SPDX-License-Identifier: Apache-2.0
// Sets the pages of one sheet, part by part: alone they are a document, and those of several views
// a lesson.
#pragma once

#include <QImage>
#include <filesystem>
#include <map>
#include <vector>

#include "render/export/description/alt_text.h"
#include "render/export/order/sheet_words.h"
#include "render/export/order/test_options.h"
#include "render/export/pdf/sheet_header.h"
#include "render/export/pdf/sheet_lists.h"
#include "render/export/plate/figure_plate.h"
#include "render/vectors/vector_drawing.h"

namespace sline::render {

/// Draws the figure of the order as vectors.
Result<VectorDrawing> drawFigure(const ExportOrder& order, const std::filesystem::path& target,
                                 const ExportProgress& progress);
/// Takes the line of sources from a figure that has a page of them.
void withoutSourcesLine(ExportOrder& order);
/// Sets what stands over a figure, as text. `at`: the figure's upper left corner.
void setPlate(SheetPages& pages, const FigurePlate& plate, const glm::vec2& at);

class SheetSetter {
 public:
  /// The order must outlive it.
  explicit SheetSetter(const ExportOrder& order);

  /// Draws the figure and prepares what stands beside it. `progress` may stop it.
  Status draw(const std::filesystem::path& target, const ExportProgress& progress);
  /// Prepares it with that picture in the figure's place, which must outlive this object.
  Status take(const QImage& figure, const ExportProgress& progress);

  const SheetLayout& layout() const { return m_layout; }
  /// Tells whether the sheet has a test, which asks for something.
  bool hasTest() const;

  /// Sets all pages of the sheet.
  void setAll(SheetPages& pages, PageCount& count);
  /// Sets the figure with its lists, and what the view says.
  void setFirst(SheetPages& pages, PageCount& count);
  void setTest(SheetPages& pages, PageCount& count);
  void setKey(SheetPages& pages, PageCount& count);
  /// Sets whose work the surfaces are on a page of its own, where that is wanted.
  void setSources(SheetPages& pages, PageCount& count);

  /// Returns what can be looked up on the first pages: what is labelled there, or in its legend
  /// where there are no labels.
  std::vector<QString> listed() const;
  /// Returns what the pages lack.
  const ExportNotes& notes() const { return m_notes; }

 private:
  struct Number {
    int number = 0;
    QString text;
  };
  /// Counts the entries of a list that are already set, row by row.
  struct ListProgress {
    std::size_t number = 0;
    std::size_t legend = 0;
    std::size_t hidden = 0;
    std::size_t word = 0;
  };
  struct ListWords {
    const std::vector<Number>& numbers;
    std::vector<std::string> words;  ///< to choose from
  };

  Status prepare(const ExportProgress& progress);
  void prepareNumbers(const ExportProgress& progress);
  void prepareTest(const ExportProgress& progress);
  Status prepareLegend();
  FigurePlate numbered(const ExportOrder& shown, const LabelLayout* before = nullptr);
  QString nameOf(const model::Node& node) const;
  /// Notes what is missing, but not of labels that the sheet adds, as the order does not ask for
  /// them.
  void noteOf(const FigurePlate& plate, const ExportProgress& progress) const;
  void addShortened(const QString& text);

  void beginPage(const QString& kind);
  void setNameAndDate();
  void setInstruction();
  void setFigure(const FigurePlate& plate, const AltText& said);
  void setCaption();
  void setList(const std::vector<RowKind>& kinds, const ListWords& words);
  void setRows(const std::vector<RowKind>& kinds, const ListFrames& frames, const ListWords& words);
  void setWordBank(const SheetRows& rows);
  SheetRow rowOf(RowKind kind, ListProgress& progress, const ListWords& words) const;
  QString headingOf(RowKind first) const;
  void setParagraphs(const std::string& text, LabelBox frame, const QString& kind);
  QPainter& painter() { return m_pages->painter(); }
  SheetRows rows() const;

  const ExportOrder& m_given;
  ExportOrder m_order;  ///< that of the figure
  SheetLayout m_layout;
  const SheetWords& m_words;
  model::MeshTrees m_trees;
  VectorDrawing m_drawing;            ///< the figure
  const QImage* m_picture = nullptr;  ///< shown in its place
  FigurePlate m_plate;
  FigurePlate m_testPlate;
  AltText m_said;          ///< what the figure shows
  AltText m_testSaid;      ///< and what it shows on a test
  LabelLayout m_numbered;  ///< of the first page, with the numbers that all pages have
  std::vector<Number> m_numbers;
  std::vector<Number> m_answers;            ///< of the test, by their numbers
  std::map<model::NodeId, int> m_numberOf;  ///< the numbers that the legend shows
  std::vector<LegendRow> m_legend;
  std::vector<VectorDrawing> m_samples;
  std::vector<VectorDrawing> m_hiddenSamples;  ///< in the order of `hiddenLinesShown`
  SheetPages* m_pages = nullptr;
  PageCount* m_count = nullptr;
  ExportNotes m_notes;
};

}  // namespace sline::render
