// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/node_mime.h"

#include <QCoreApplication>
#include <QDataStream>
#include <QIODevice>
#include <QMimeData>

namespace sline::widgets {

namespace {
/// Returns a mark that tells this session from others, of this and of other running programs.
quint64 markOf(const Session& session) {
  return quint64(quintptr(&session)) ^ (quint64(QCoreApplication::applicationPid()) << 48);
}
}  // namespace

QMimeData* nodesAsMime(const Session& session, const NodeIds& ids) {
  QByteArray bytes;
  QDataStream stream(&bytes, QIODevice::WriteOnly);
  stream << markOf(session);
  for (const model::NodeId id : ids)
    stream << quint64(id.value);
  auto* data = new QMimeData;
  data->setData(QLatin1String(nodeMimeType), bytes);
  return data;
}

std::optional<NodeIds> nodesFromMime(const Session& session, const QMimeData& data) {
  const QByteArray bytes = data.data(QLatin1String(nodeMimeType));
  QDataStream stream(bytes);
  quint64 mark = 0;
  stream >> mark;
  if (stream.status() != QDataStream::Ok || mark != markOf(session))
    return std::nullopt;
  NodeIds ids;
  while (!stream.atEnd()) {
    quint64 id = 0;
    stream >> id;
    if (stream.status() != QDataStream::Ok)
      return std::nullopt;
    if (session.scene().find({id}))
      ids.push_back({id});
  }
  return ids;
}

}  // namespace sline::widgets
