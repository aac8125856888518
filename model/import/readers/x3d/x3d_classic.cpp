// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "model/import/readers/x3d/x3d_document.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {

/// A token is a word, a quoted string with its quotes, or one of { } [ ]; empty at the end.
using ClassicToken = std::string_view;

bool isBracket(char c) {
  return c == '{' || c == '}' || c == '[' || c == ']';
}

/// Tells whether the token stands for itself: a number, a string, a truth value. Other words name
/// nodes and fields.
bool isValue(ClassicToken token) {
  if (token.empty() || isBracket(token[0]))
    return false;
  const char c = token[0];
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == '"' ||
         token == "TRUE" || token == "FALSE";
}

class X3dClassicParser {
 public:
  explicit X3dClassicParser(const Source& source)
      : m_source(source), m_at(source.begin()), m_end(source.end()) {}

  Result<X3dDocument> parse() {
    for (ClassicToken token = next(); !token.empty(); token = next()) {
      if (token == "UNIT" && next() == "length") {
        next();
        double metres = 0.0;
        if (TextCursor cursor(next()); cursor.number(metres))
          m_document.metresPerUnit = metres;
      } else if (token == "PROTO" || token == "EXTERNPROTO") {
        skipPrototype();
      } else if (token == "ROUTE") {
        next(), next(), next();
      } else if (peek() == "{" || token == "DEF" || token == "USE") {
        TRY(readNode(token, nullptr, 0));
      } else if (isBracket(token[0])) {
        return m_source.atLine(token.data(), inQuotes(token) + " stands where a node should");
      }
      // Other statements (PROFILE, COMPONENT, META, …) are words that lead to the next one.
    }
    return std::move(m_document);
  }

 private:
  /// Skips blanks, commas and comments, which separate tokens.
  void skipBetween() {
    while (m_at != m_end) {
      if (*m_at == '#')
        while (m_at != m_end && !TextCursor::isLineEnd(*m_at))
          ++m_at;
      else if (TextCursor::isSpace(*m_at) || *m_at == ',')
        ++m_at;
      else
        return;
    }
  }

  ClassicToken next() {
    skipBetween();
    const char* begin = m_at;
    if (m_at == m_end)
      return {};
    if (isBracket(*m_at)) {
      ++m_at;
    } else if (*m_at == '"') {
      for (++m_at; m_at != m_end && *m_at != '"'; ++m_at)
        if (*m_at == '\\' && m_at + 1 != m_end)
          ++m_at;
      m_at += m_at != m_end;
    } else {
      while (m_at != m_end && !TextCursor::isSpace(*m_at) && *m_at != ',' && *m_at != '#' &&
             *m_at != '"' && !isBracket(*m_at))
        ++m_at;
    }
    return {begin, std::size_t(m_at - begin)};
  }

  ClassicToken peek() {
    const char* at = m_at;
    const ClassicToken token = next();
    m_at = at;
    return token;
  }

  /// Moves behind the bracket that closes the next opening one.
  void skipBrackets() {
    std::size_t open = 0;
    for (ClassicToken token = next(); !token.empty(); token = next()) {
      open += token == "{" || token == "[";
      if ((token == "}" || token == "]") && --open == 0)
        return;
      if (open == 0)
        return;
    }
  }

  void skipPrototype() {
    m_document.prototypes = true;
    next();
    skipBrackets();
    if (peek() == "{" || peek() == "[")
      skipBrackets();
    else if (peek().starts_with('"'))
      next();
  }

  /// Reads a node that begins with `token`.
  Status readNode(ClassicToken token, X3dNode* parent, std::size_t depth) {
    std::string_view name;
    if (token == "USE") {
      const auto found = m_named.find(next());
      if (found != m_named.end())
        adopt(parent, found->second);
      return Unit{};
    }
    if (token == "DEF") {
      name = next();
      token = next();
    }
    if (depth > deepestX3dNode)
      return m_source.atLine(token.data(), "its nodes lie more than 256 levels deep in each other");
    if (token.empty() || isBracket(token[0]) || peek() != "{")
      return m_source.atLine(token.empty() ? m_source.end() : token.data(),
                             inQuotes(token) + " stands where a node should");
    if (token == "Script" || token == "ComposedShader") {
      skipBrackets();
      return Unit{};
    }
    X3dNode& node = m_document.nodes.emplace_back();
    node.type = token;
    node.name = name;
    node.place = token.data();
    if (!name.empty())
      m_named[name] = &node;
    adopt(parent, &node);
    next();
    return readBody(node, depth);
  }

  Status readBody(X3dNode& node, std::size_t depth) {
    for (ClassicToken key = next(); key != "}"; key = next()) {
      if (key.empty())
        return m_source.atLine(node.place, inQuotes(node.type) + " is not closed");
      if (key == "ROUTE")
        next(), next(), next();
      else if (key == "PROTO" || key == "EXTERNPROTO")
        skipPrototype();
      else
        TRY(readField(key, node, depth));
    }
    return Unit{};
  }

  Status readField(ClassicToken key, X3dNode& node, std::size_t depth) {
    if (isBracket(key[0]))
      return m_source.atLine(key.data(), inQuotes(key) + " stands where a field should");
    if (isValue(peek())) {
      const ClassicToken first = next();
      while (isValue(peek()))
        next();
      node.fields.emplace_back(key,
                               std::string_view(first.data(), std::size_t(m_at - first.data())));
      return Unit{};
    }
    const ClassicToken token = next();
    if (token == "NULL")
      return Unit{};
    if (token == "IS") {
      next();
      return Unit{};
    }
    if (token != "[")
      return readNode(token, &node, depth + 1);
    const char* begin = m_at;
    for (ClassicToken item = next(); item != "]"; item = next()) {
      if (item.empty())
        return m_source.atLine(begin, "a list is not closed");
      if (isValue(item))
        continue;
      TRY(readNode(item, &node, depth + 1));
    }
    node.fields.emplace_back(key, std::string_view(begin, std::size_t(m_at - 1 - begin)));
    return Unit{};
  }

  void adopt(X3dNode* parent, const X3dNode* node) {
    (parent ? parent->nodes : m_document.scene).push_back(node);
  }

  const Source& m_source;
  const char* m_at;
  const char* m_end;
  X3dDocument m_document;
  std::map<std::string_view, const X3dNode*> m_named;
};

}  // namespace

Result<X3dDocument> parseX3dClassic(const Source& source) {
  return X3dClassicParser(source).parse();
}

}  // namespace sline::model
