// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/answer_hash.h"

#include <QByteArray>
#include <QCryptographicHash>
#include <QList>
#include <QString>

namespace sline::render {

namespace {

QByteArray viewOf(std::string_view bytes) {
  return QByteArray::fromRawData(bytes.data(), qsizetype(bytes.size()));
}

QByteArray sha256(std::string_view bytes) {
  return QCryptographicHash::hash(viewOf(bytes), QCryptographicHash::Sha256);
}

}  // namespace

std::string normalisedAnswer(std::string_view name) {
  const QString whole = QString::fromUtf8(name.data(), qsizetype(name.size()))
                            .normalized(QString::NormalizationForm_KD)
                            .toLower();
  QString kept;
  for (const char32_t letter : whole.toUcs4())
    if (QChar::isLetterOrNumber(letter))
      kept += QString::fromUcs4(&letter, 1);
  return kept.toStdString();
}

std::string answerHash(const std::string& salt, std::string_view name) {
  constexpr std::size_t digits = 16;
  return sha256Hex(salt + normalisedAnswer(name)).substr(0, digits);
}

std::string sha256Hex(std::string_view bytes) {
  return sha256(bytes).toHex().toStdString();
}

std::string sha256Source(std::string_view bytes) {
  return "sha256-" + sha256(bytes).toBase64().toStdString();
}

std::string base64(std::string_view bytes) {
  return viewOf(bytes).toBase64().toStdString();
}

}  // namespace sline::render
