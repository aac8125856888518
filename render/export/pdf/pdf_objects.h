// SPDX-License-Identifier: Apache-2.0
// The objects of a PDF file that Qt has written, so that they can be changed and joined by others.
#pragma once

#include <QByteArray>
#include <optional>
#include <vector>

namespace sline::render {

/// Names an object within its file.
struct PdfId {
  int value = 0;
};

class PdfObjects {
 public:
  /// Nothing for bytes that are no file as QPdfWriter makes them: a table of objects, each with its
  /// place.
  static std::optional<PdfObjects> read(const QByteArray& file);

  /// Between "obj" and "endobj".
  QByteArray& operator[](PdfId id) { return m_objects[std::size_t(id.value)]; }
  const QByteArray& operator[](PdfId id) const { return m_objects[std::size_t(id.value)]; }
  /// In their order.
  const std::vector<PdfId>& pages() const { return m_pages; }
  PdfId catalog() const { return m_catalog; }
  /// What "/Name 12 0 R" in an object refers to.
  std::optional<PdfId> reference(PdfId from, const QByteArray& name) const;

  PdfId add(QByteArray object);
  /// A compressed stream; `entries` are more of its dictionary.
  PdfId addStream(const QByteArray& bytes, const QByteArray& entries = {});

  /// A stream as it is, which others look for in the file; `entries` as above.
  PdfId addPlainStream(const QByteArray& bytes, const QByteArray& entries);
  /// The object that says who made the file and what it is called; without, none does.
  void setInfo(PdfId id) { m_info = id; }

  /// The file, without what QPdfWriter says of itself, of the machine and of the time.
  QByteArray written() const;

 private:
  std::vector<QByteArray> m_objects;  ///< by id; the first is none
  std::vector<PdfId> m_pages;
  PdfId m_catalog;
  PdfId m_info;
};

}  // namespace sline::render
