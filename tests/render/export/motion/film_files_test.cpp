// SPDX-License-Identifier: Apache-2.0
// Tests films that are drawn, written and read again.
#include <QDir>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>

#include "render/export/motion/film_file.h"
#include "render/export/motion/film_options.h"
#include "render/gpu/headless/context.h"
#include "render/picture/picture.h"
#include "tests/render/export/motion/decoded_film.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using render::Motion;

namespace {

using Write = Status (*)(const render::ExportOrder&, const std::filesystem::path&,
                         const render::ExportProgress&);

void add(model::Scene& scene, const std::string& name, const Colour& colour, float gamma,
         const model::MeshPtr& mesh) {
  model::Node node;
  node.name = name;
  node.mesh = mesh;
  node.style.colour = colour;
  node.style.gamma = Gamma::clamped(gamma);
  scene.append(std::move(node));
}

/// Returns an order of 96 × 54 pixels and 6 frames in 0.6 s.
render::ExportOrder smallOrder() {
  render::ExportOrder order;
  add(order.scene, "ring", {220, 60, 40}, 5.0f, test::askew(*test::torus(20.0f, 7.0f, 48, 24)));
  add(order.scene, "ball", {60, 90, 200}, 2.0f,
      test::moved(*test::sphere(9.0f, 3), 1.0f, {14.0f, 6.0f, 12.0f}));
  order.camera = model::anatomicalCamera(model::AnatomicalView::anterior,
                                         order.scene.visibleBounds(), 16.0f / 9.0f);
  order.marks = render::ExportMarks::none();
  order.of<render::FilmOptions>() = {.seconds = 0.6,
                                     .framesPerSecond = 10,
                                     .format = render::FilmFormat::page,
                                     .height = 54,
                                     .hold = {},
                                     .swept = {}};
  return order;
}

render::ExportOrder labelledOrder() {
  render::ExportOrder order = smallOrder();
  order.of<render::FilmOptions>().height = 128;
  order.camera.eye = order.camera.target + 2.0f * (order.camera.eye - order.camera.target);
  order.labels.mode = render::LabelMode::on;
  order.labels.points = 24.0f;
  for (const std::size_t node : {0u, 1u}) {
    model::Annotation label;
    label.text = order.scene.nodes()[node].name;
    label.anchors = {model::SurfacePoint{order.scene.nodes()[node].id, 0, {0.3f, 0.3f}}};
    order.scene.appendAnnotation(label);
  }
  return order;
}

/// Returns the picture itself, as `sline render` draws it.
QImage still(const render::ExportOrder& order, const model::Camera& camera) {
  const auto context = render::gpu::HeadlessContext::create();
  const auto picture = render::Picture::create();
  if (!context.ok() || !picture.ok())
    return {};
  const auto drawn = (*picture)->render(
      order.scene, camera, {.width = 192, .height = 108, .environment = order.environment});
  const render::Image image = render::averaged(*drawn, 2);
  return QImage(image.rgba.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
}

/// Returns the mean difference of channels on white, 0 … 255; 255 if sizes differ.
double difference(const QImage& a, const QImage& b) {
  if (a.size() != b.size() || a.isNull())
    return 255.0;
  double sum = 0.0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QColor c = a.pixelColor(x, y);
      const QColor d = b.pixelColor(x, y);
      const auto onWhite = [](int value, int alpha) { return 255 + (value - 255) * alpha / 255; };
      sum += std::abs(onWhite(c.red(), c.alpha()) - onWhite(d.red(), d.alpha())) +
             std::abs(onWhite(c.green(), c.alpha()) - onWhite(d.green(), d.alpha())) +
             std::abs(onWhite(c.blue(), c.alpha()) - onWhite(d.blue(), d.alpha()));
    }
  return sum / (3.0 * a.width() * a.height());
}

bool haveFfmpeg() {
  return !QStandardPaths::findExecutable("ffmpeg").isEmpty();
}

QStringList allIn(const QString& folder) {
  return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
}

test::DecodedFilm decodedFrames(const QString& folder) {
  test::DecodedFilm film;
  for (const QString& name : allIn(folder))
    film.frames.push_back(QImage(folder + "/" + name).convertToFormat(QImage::Format_RGBA8888));
  film.milliseconds = 100 * int(film.frames.size());
  film.endless = true;
  return film;
}

}  // namespace

class FilmFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void readsBack_data() {
    QTest::addColumn<Write>("write");
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("within");
    QTest::newRow("webp") << Write(render::writeWebp) << "film.webp" << 3.0;
    QTest::newRow("gif") << Write(render::writeGif) << "film.gif" << 2.5;
    QTest::newRow("mp4") << Write(render::writeMp4) << "film.mp4" << 4.0;
    QTest::newRow("frames") << Write(render::writeFrames) << "frames/" << 0.0;
    QTest::newRow("any name") << Write(render::writeWebp) << "-Ünïcödé \"器官\" 🫀.webp"
                              << 3.0;
  }
  void readsBack() {
    QFETCH(Write, write);
    QFETCH(QString, name);
    QFETCH(double, within);
    if (name.endsWith("mp4") && !haveFfmpeg())
      SLINE_ABSENT("ffmpeg is not installed");
    const QTemporaryDir folder;
    const QString file = folder.filePath(name);
    const render::ExportOrder order = smallOrder();
    double last = -1.0;
    const Status written =
        write(order, file.toStdString(), [&last](double share, std::string_view what) {
          const bool forwards = share >= last && share <= 1.0 && !what.empty();
          last = share;
          return forwards;
        });
    QVERIFY2(written.ok(), written.ok() ? "" : written.error().text().c_str());
    QVERIFY(last > 0.9);
    QCOMPARE(allIn(folder.path()).size(), 1);
    const test::DecodedFilm film = name.endsWith("webp")  ? test::decodedWebp(file)
                                   : name.endsWith("gif") ? test::decodedGif(file)
                                   : name.endsWith("mp4") ? test::decodedMp4(file)
                                                          : decodedFrames(file);
    QCOMPARE(int(film.frames.size()), 6);
    QCOMPARE(film.milliseconds, 600);
    QVERIFY(film.endless || name.endsWith("mp4"));
    for (const QImage& frame : film.frames)
      QCOMPARE(frame.size(), QSize(96, 54));
    // The order's camera leaves room to turn, so the first frame is its picture, and the others
    // are others.
    const QImage first = still(order, order.camera);
    QVERIFY2(difference(film.frames[0], first) <= within,
             qPrintable(QString::number(difference(film.frames[0], first))));
    for (std::size_t i = 1; i < 6; ++i) {
      QVERIFY(difference(film.frames[i], first) > within + 2.0);
      QVERIFY(difference(film.frames[i], film.frames[i - 1]) > within + 2.0);
    }
  }

  void clearGroundStaysClear_data() {
    QTest::addColumn<Write>("write");
    QTest::addColumn<QString>("name");
    QTest::newRow("webp") << Write(render::writeWebp) << "film.webp";
    QTest::newRow("gif") << Write(render::writeGif) << "film.gif";
    QTest::newRow("frames") << Write(render::writeFrames) << "frames";
  }
  void clearGroundStaysClear() {
    QFETCH(Write, write);
    QFETCH(QString, name);
    const QTemporaryDir folder;
    const QString file = folder.filePath(name);
    render::ExportOrder order = smallOrder();
    order.environment.background = render::Background::transparent;
    QVERIFY(write(order, file.toStdString(), {}).ok());
    const test::DecodedFilm film = name.endsWith("webp")  ? test::decodedWebp(file)
                                   : name.endsWith("gif") ? test::decodedGif(file)
                                                          : decodedFrames(file);
    QCOMPARE(int(film.frames.size()), 6);
    for (const QImage& frame : film.frames) {
      QCOMPARE(frame.pixelColor(1, 1).alpha(), 0);
      int opaque = 0;
      for (int y = 0; y < frame.height(); ++y)
        for (int x = 0; x < frame.width(); ++x)
          opaque += frame.pixelColor(x, y).alpha() > 250;
      QVERIFY(opaque > 300);
      QVERIFY(opaque < 96 * 54 / 2);
    }
  }

  void sameAgain_data() { clearGroundStaysClear_data(); }
  void sameAgain() {
    QFETCH(Write, write);
    QFETCH(QString, name);
    const auto bytes = [&](const QString& folder) {
      QByteArray all;
      const QStringList files = name == "frames" ? allIn(folder + "/frames") : QStringList{name};
      for (const QString& one : files) {
        QFile file(folder + (name == "frames" ? "/frames/" : "/") + one);
        all += file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
      }
      return all;
    };
    const QTemporaryDir first;
    const QTemporaryDir second;
    QVERIFY(write(smallOrder(), first.filePath(name).toStdString(), {}).ok());
    QVERIFY(write(smallOrder(), second.filePath(name).toStdString(), {}).ok());
    QVERIFY(bytes(first.path()).size() > 1000);
    QVERIFY(bytes(first.path()) == bytes(second.path()));
  }

  void labelsAreThere() {
    const QTemporaryDir folder;
    const render::ExportOrder order = labelledOrder();
    QVERIFY(render::writeFrames(order, folder.filePath("with").toStdString(), {}).ok());
    render::ExportOrder plain = order;
    plain.labels.mode = render::LabelMode::off;
    QVERIFY(render::writeFrames(plain, folder.filePath("without").toStdString(), {}).ok());
    const test::DecodedFilm with = decodedFrames(folder.filePath("with"));
    const test::DecodedFilm without = decodedFrames(folder.filePath("without"));
    QCOMPARE(int(with.frames.size()), 6);
    for (std::size_t i = 0; i < 6; ++i) {
      int ink = 0;
      for (int y = 0; y < with.frames[i].height(); ++y)
        for (int x = 0; x < with.frames[i].width(); ++x)
          ink += with.frames[i].pixelColor(x, y).lightness() < 140 &&
                 without.frames[i].pixelColor(x, y).lightness() == 255;
      QVERIFY2(ink > 40, qPrintable(QString::number(ink)));
    }
  }

  void marksAreThere() {
    const QTemporaryDir folder;
    render::ExportOrder order = smallOrder();
    order.of<render::FilmOptions>().height = 254;
    order.marks.sides = true;
    order.of<render::FilmOptions>().framesPerSecond = 20;
    QVERIFY(render::writeFrames(order, folder.filePath("with").toStdString(), {}).ok());
    const test::DecodedFilm film = decodedFrames(folder.filePath("with"));
    QCOMPARE(int(film.frames.size()), 12);
    // The left edge shows R, P, L and A: from the front, the patient's left, the back, the right.
    std::vector<QImage> letters;
    for (const std::size_t i : {0u, 3u, 6u, 9u}) {
      letters.push_back(film.frames[i].copy(0, 113, 16, 28));
      int ink = 0;
      for (int y = 0; y < 28; ++y)
        for (int x = 0; x < 16; ++x)
          ink += letters.back().pixelColor(x, y).lightness() < 128;
      QVERIFY2(ink > 5, qPrintable(QString("%1: %2").arg(i).arg(ink)));
    }
    for (std::size_t i = 0; i < 4; ++i)
      QVERIFY(difference(letters[i], letters[(i + 1) % 4]) > 1.0);
  }

  void stoppedLeavesNothing_data() { readsBack_data(); }
  void stoppedLeavesNothing() {
    QFETCH(Write, write);
    QFETCH(QString, name);
    if (name.endsWith("mp4") && !haveFfmpeg())
      SLINE_ABSENT("ffmpeg is not installed");
    const QTemporaryDir folder;
    for (const int calls : {0, 1, 4}) {
      int asked = 0;
      const Status stopped = write(smallOrder(), folder.filePath(name).toStdString(),
                                   [&](double, std::string_view) { return asked++ < calls; });
      QVERIFY(!stopped.ok());
      QVERIFY2(stopped.error().reason.find("stopped") != std::string::npos,
               stopped.error().text().c_str());
      QVERIFY2(allIn(folder.path()).isEmpty(), qPrintable(allIn(folder.path()).join(' ')));
    }
  }

  void badTargets_data() {
    QTest::addColumn<Write>("write");
    QTest::addColumn<QString>("name");
    for (const auto& [kind, write] : {std::pair<const char*, Write>("webp", render::writeWebp),
                                      {"gif", render::writeGif},
                                      {"mp4", render::writeMp4},
                                      {"frames", render::writeFrames}}) {
      QTest::addRow("%s: no such folder", kind) << write << "nowhere/film";
      QTest::addRow("%s: below a file", kind) << write << "file/film";
      QTest::addRow("%s: something else", kind)
          << write << (QString(kind) == "frames" ? "file" : "folder");
      QTest::addRow("%s: a full folder", kind) << write << "folder";
      QTest::addRow("%s: name too long", kind) << write << QString(300, 'x');
      QTest::addRow("%s: no space", kind) << write << "/dev/full";
    }
  }
  void badTargets() {
    QFETCH(Write, write);
    QFETCH(QString, name);
    if (write == render::writeMp4 && !haveFfmpeg())
      SLINE_ABSENT("ffmpeg is not installed");
    if (name == "/dev/full" && !QFile::exists(name))
      QSKIP("this system has no device without space");
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkpath("folder/of mine"));
    QFile file(folder.filePath("file"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("mine") == 4);
    file.close();
    const std::string target = (name.startsWith("/") ? name : folder.filePath(name)).toStdString();
    const Status written = write(smallOrder(), target, {});
    QVERIFY(!written.ok());
    QCOMPARE(written.error().file, target);
    QVERIFY(!written.error().reason.empty());
    QVERIFY(!written.error().remedy.empty());
    QCOMPARE(allIn(folder.path()), QStringList({"file", "folder"}));
    QCOMPARE(allIn(folder.filePath("folder")), QStringList{"of mine"});
  }

  void anEmptyFolderWillDo() {
    const QTemporaryDir folder;
    QVERIFY(render::writeFrames(smallOrder(), folder.path().toStdString(), {}).ok());
    QCOMPARE(allIn(folder.path()).size(), 6);
    QCOMPARE(allIn(folder.path()).first(), QString("frame_0001.png"));
  }

  void withoutFfmpegItSaysSo() {
    const QByteArray path = qgetenv("PATH");
    const QTemporaryDir folder;
    qputenv("PATH", folder.path().toLocal8Bit());
    const Status written =
        render::writeMp4(smallOrder(), folder.filePath("film.mp4").toStdString(), {});
    qputenv("PATH", path);
    QVERIFY(!written.ok());
    QVERIFY(written.error().reason.find("ffmpeg") != std::string::npos);
    QVERIFY(written.error().remedy.find("Install ffmpeg") != std::string::npos);
    QVERIFY(allIn(folder.path()).isEmpty());
  }

  void gifHasItsLimit() {
    render::ExportOrder order = smallOrder();
    order.of<render::FilmOptions>().framesPerSecond = 60;
    const QTemporaryDir folder;
    const Status written = render::writeGif(order, folder.filePath("film.gif").toStdString(), {});
    QVERIFY(!written.ok());
    QVERIFY(written.error().reason.find("50 frames") != std::string::npos);
    order.of<render::FilmOptions>().framesPerSecond = 30;
    order.of<render::FilmOptions>().seconds = 0.2;
    QVERIFY(render::writeGif(order, folder.filePath("film.gif").toStdString(), {}).ok());
    // Thirtieths of a second are rounded to hundredths: 3, 4, 3 and so on.
    QCOMPARE(test::decodedGif(folder.filePath("film.gif")).milliseconds, 200);
  }
};

SLINE_TEST_WITH_GUI(FilmFilesTest)
#include "film_files_test.moc"
