// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/performance_page.h"

#include <QFontDatabase>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sline::bench {

namespace {

using ReportJson = nlohmann::json;

struct Row {
  std::string name;
  ReportJson report;

  double at(const char* pointer) const {
    const ReportJson::json_pointer place(pointer);
    return report.contains(place) ? report[place].get<double>() : 0.0;
  }
  double triangles() const { return at("/triangles"); }
  double vtk() const { return at("/vtk_phong_ms/median"); }
};

Result<Row> rowOf(const std::filesystem::path& file) {
  std::ifstream in(file);
  ReportJson report = ReportJson::parse(in, nullptr, false);
  if (!report.is_object())
    return Error{.file = file.string(),
                 .reason = "it holds no report",
                 .remedy = "Name files that sline-bench --json has printed"};
  return Row{file.stem().string(), std::move(report)};
}

std::string fixed(double value, int digits) {
  return QString::number(value, 'f', digits).toStdString();
}

std::string millions(double triangles) {
  return fixed(1e-6 * triangles, triangles < 1e6 ? 2 : 1) + " M";
}

/// A column of a table: its head, and the text of its cell in a row.
struct Column {
  const char* head;
  std::string (*cell)(const Row&);
};

constexpr std::array wholeColumns{
    Column{"Scene", [](const Row& r) { return r.name; }},
    Column{"Triangles", [](const Row& r) { return millions(r.triangles()); }},
    Column{"Import, s", [](const Row& r) { return fixed(1e-3 * r.at("/import_ms"), 1); }},
    Column{"Preparing, s per M",
           [](const Row& r) {
             return fixed(1e3 * r.at("/preprocess_ms") / std::max(r.triangles(), 1.0), 2);
           }},
    Column{"Reopening, s", [](const Row& r) { return fixed(1e-3 * r.at("/reopen_ms"), 1); }},
    Column{"Still picture, ms", [](const Row& r) { return fixed(r.at("/frame_ms/median"), 0); }},
    Column{"over VTK's Phong",
           [](const Row& r) { return fixed(r.at("/frame_ms/median") / r.vtk(), 2); }},
    Column{"Moving, ms", [](const Row& r) { return fixed(r.at("/moving_ms/median"), 0); }},
    Column{"Moving over Phong",
           [](const Row& r) { return fixed(r.at("/moving_ms/median") / r.vtk(), 2); }},
    Column{"Lines over Phong",
           [](const Row& r) { return fixed(r.at("/lines_ms/median") / r.vtk(), 3); }},
    Column{"Step of Γ over picture",
           [](const Row& r) {
             return r.at("/structures") > 1 ? fixed(r.at("/gamma_ratio"), 2) : std::string("–");
           }},
    Column{"Vector drawing, s", [](const Row& r) { return fixed(1e-3 * r.at("/vectors_ms"), 1); }},
    Column{"Bytes a triangle", [](const Row& r) { return fixed(r.at("/bytes_per_triangle"), 0); }},
    Column{"At most, times that", [](const Row& r) { return fixed(r.at("/peak_ratio"), 1); }},
};

void writeWhole(std::ostream& out, const std::vector<Row>& rows) {
  for (const Column& column : wholeColumns)
    out << "| " << column.head << ' ';
  out << "|\n";
  for (std::size_t i = 0; i < wholeColumns.size(); ++i)
    out << (i == 0 ? "|---" : "|---:");
  out << "|\n";
  for (const Row& row : rows) {
    for (const Column& column : wholeColumns)
      out << "| " << column.cell(row) << ' ';
    out << "|\n";
  }
}

void writePhases(std::ostream& out, const std::vector<Row>& rows) {
  std::vector<std::string> phases;
  for (const Row& row : rows)
    if (const auto passes = row.report.find("passes_ms"); passes != row.report.end())
      for (const auto& [phase, spread] : passes->items())
        if (std::find(phases.begin(), phases.end(), phase) == phases.end())
          phases.push_back(phase);
  out << "| Scene | lines ";
  for (const std::string& phase : phases)
    out << "| " << phase << ' ';
  out << "| VTK's Phong |\n|---|---:";
  for (std::size_t i = 0; i < phases.size(); ++i)
    out << "|---:";
  out << "|---:|\n";
  for (const Row& row : rows) {
    out << "| " << row.name << " | " << fixed(row.at("/lines_ms/median"), 1) << ' ';
    for (const std::string& phase : phases)
      out << "| " << fixed(row.at(("/passes_ms/" + phase + "/median").c_str()), 1) << ' ';
    out << "| " << fixed(row.vtk(), 0) << " |\n";
  }
}

/// Returns a name without the number at its end.
std::string familyOf(const std::string& name) {
  const std::size_t end = name.find_last_not_of("0123456789.");
  return name.substr(0, end == std::string::npos ? 0 : end + 1);
}

struct Curve {
  const char* name;
  QColor colour;
  std::vector<QPointF> points;  ///< triangles and milliseconds
};

/// Draws curves on logarithmic scales.
class Plot {
 public:
  explicit Plot(const std::vector<Curve>& curves)
      : m_image(width, height, QImage::Format_RGB32), m_painter(&m_image) {
    double left = 1e12, right = 1.0, low = 1e12, high = 1e-3;
    for (const Curve& curve : curves)
      for (const QPointF& p : curve.points) {
        left = std::min(left, p.x());
        right = std::max(right, p.x());
        low = std::min(low, p.y());
        high = std::max(high, p.y());
      }
    m_low = {std::floor(std::log10(left)), std::floor(std::log10(std::max(low, 1e-3)))};
    m_high = {std::ceil(std::log10(right)), std::ceil(std::log10(high))};
    m_image.fill(Qt::white);
    m_painter.setRenderHint(QPainter::Antialiasing);
    QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
    font.setPixelSize(15);
    m_painter.setFont(font);
    drawScales();
    for (const Curve& curve : curves)
      draw(curve);
  }
  bool save(const std::filesystem::path& file) {
    m_painter.end();
    return m_image.save(QString::fromStdString(file.string()), "PNG", 0);
  }

 private:
  static constexpr int width = 760;
  static constexpr int height = 460;
  static constexpr int margin = 84;
  static constexpr int nameRoom = 130;

  QPointF at(double x, double y) const {
    const QSizeF room(width - 2 * margin - nameRoom, height - 2 * margin);
    return {margin + room.width() * (x - m_low.x()) / (m_high.x() - m_low.x()),
            height - margin - room.height() * (y - m_low.y()) / (m_high.y() - m_low.y())};
  }

  void drawScales() {
    m_painter.setPen(QPen(QColor(205, 205, 205), 1.0));
    for (double x = m_low.x(); x <= m_high.x(); ++x)
      m_painter.drawLine(at(x, m_low.y()), at(x, m_high.y()));
    for (double y = m_low.y(); y <= m_high.y(); ++y)
      m_painter.drawLine(at(m_low.x(), y), at(m_high.x(), y));
    m_painter.setPen(Qt::black);
    const auto write = [this](const QPointF& middle, const QString& text) {
      m_painter.drawText(QRectF(middle.x() - 60, middle.y() - 12, 120, 24), Qt::AlignCenter, text);
    };
    for (double x = m_low.x(); x <= m_high.x(); ++x)
      write(at(x, m_low.y()) + QPointF(0, 18), numberOf(x - 6.0) + QStringLiteral(" M"));
    for (double y = m_low.y(); y <= m_high.y(); ++y)
      write(at(m_low.x(), y) - QPointF(36, 0), numberOf(y) + QStringLiteral(" ms"));
    write(at(0.5 * (m_low.x() + m_high.x()), m_low.y()) + QPointF(0, 42),
          QStringLiteral("triangles"));
  }

  void draw(const Curve& curve) {
    if (curve.points.empty())
      return;
    QPolygonF line;
    for (const QPointF& p : curve.points)
      line << at(std::log10(p.x()), std::log10(std::max(p.y(), 1e-3)));
    m_painter.setPen(QPen(curve.colour, 2.0));
    m_painter.drawPolyline(line);
    m_painter.setBrush(curve.colour);
    for (const QPointF& p : line)
      m_painter.drawEllipse(p, 3.5, 3.5);
    m_painter.setBrush(Qt::NoBrush);
    // Names stand one below the other beside the plot, as curves may end close together.
    const QPointF name(width - nameRoom - 24, margin + 22.0 * ++m_named);
    m_painter.drawLine(name - QPointF(32, 5), name - QPointF(10, 5));
    m_painter.drawText(name, QString::fromLatin1(curve.name));
  }

  static QString numberOf(double power) { return QString::number(std::pow(10.0, power), 'g', 6); }

  QImage m_image;
  QPainter m_painter;
  QPointF m_low;  ///< powers of ten
  QPointF m_high;
  int m_named = 0;
};

std::vector<Curve> growthOf(const std::vector<Row>& rows) {
  std::vector<Row> family;
  for (const Row& row : rows)
    if (familyOf(row.name) == familyOf(rows.front().name))
      family.push_back(row);
  std::sort(family.begin(), family.end(),
            [](const Row& a, const Row& b) { return a.triangles() < b.triangles(); });
  std::vector<Curve> curves{{"still picture", QColor(27, 94, 160), {}},
                            {"VTK's Phong", QColor(120, 120, 120), {}},
                            {"lines", QColor(178, 60, 30), {}}};
  const std::array places{"/frame_ms/median", "/vtk_phong_ms/median", "/lines_ms/median"};
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (const Row& row : family)
      curves[i].points.emplace_back(row.triangles(), row.at(places[i]));
  return curves;
}

}  // namespace

Status writePerformancePage(const std::filesystem::path& page,
                            std::span<const std::filesystem::path> reports) {
  std::vector<Row> rows;
  for (const std::filesystem::path& file : reports) {
    Result<Row> row = rowOf(file);
    if (!row)
      return row.error();
    rows.push_back(std::move(*row));
  }
  // Letters of the plot come from its fonts.
  qputenv("QT_QPA_PLATFORM", "offscreen");
  int count = 0;
  const QGuiApplication application(count, nullptr);
  if (rows.empty())
    return Error{.reason = "there is no report to make a page of",
                 .remedy = "Name files that sline-bench --json has printed"};
  const std::filesystem::path folder = page.parent_path() / page.stem();
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  std::ofstream out(page);
  out << "# Speed and memory\n\n"
         "All figures of a row come from one run of `sline-bench` without a graphics card ("
      << rows.front().report.value("driver", "")
      << "): the camera turns once around the scene, and the median picture counts. VTK's own "
         "Phong "
         "shading of the same triangles in the same run is the yardstick, since machines differ. "
         "tests/bench/performance.sh makes this page anew.\n\n";
  writeWhole(out, rows);
  out << "\nPreparing is what is computed once a surface: order, neighbours, curvature, fair "
         "normals. Lines are contours and suggestive contours. While the camera moves, lines are "
         "as "
         "ever and surfaces have a sample for three pixels each way. Bytes count everything "
         "that is held after the last picture, the meshes too, and the next column its highest "
         "since the import began. Γ is 0 to 5 over the structures of a scene, "
         "and 2 for a surface alone.\n\n"
         "## Where the time of a picture goes, in milliseconds\n\n";
  writePhases(out, rows);
  out << "\n## As a surface grows\n\n![Times of the still picture, of VTK's Phong and of the lines "
         "over the number of triangles]("
      << page.stem().string() << "/growth.png)\n";
  out.close();
  if (!out || !Plot(growthOf(rows)).save(folder / "growth.png"))
    return Error{.file = page.string(),
                 .reason = "it could not be written",
                 .remedy = "Choose a folder that can be written to"};
  return Unit{};
}

}  // namespace sline::bench
