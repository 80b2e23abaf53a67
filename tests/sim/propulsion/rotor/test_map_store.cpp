// Propeller maps on disk: found again bit for bit, never taken for another's, made anew where a
// file is wrong, whole however many write at once, and no more of them than there is room for.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <thread>

#include "sim/propulsion/rotor/map_store.h"

using namespace rotorbench;
namespace fs = std::filesystem;

namespace {

/// Small enough to be made in milliseconds.
MapPropeller small(double diameter = 0.2) {
  MapPropeller p;
  p.propeller.diameter = diameter;
  p.settings.elements = 4;
  p.settings.azimuths = 4;
  p.map.directions = 21;
  p.map.reynoldsNumbers = 4;
  p.map.sideDirections = 5;
  p.map.sideAngles = 4;
  p.map.sideReynoldsNumbers = 4;
  p.map.sideRefinements = 0;
  return p;
}

BladeElementRotor rotorOf(const MapPropeller& p) {
  return BladeElementRotor(p.propeller, p.settings);
}

PropellerMap mapOf(const MapPropeller& p) {
  return PropellerMap(rotorOf(p), p.map);
}

/// Loads in all directions, bit for bit.
bool same(const PropellerMap& a, const PropellerMap& b) {
  for (const double w : {-300.0, 0.0, 200.0, 900.0}) {
    for (const double z : {-15.0, 0.0, 4.0, 30.0}) {
      for (const double x : {0.0, 0.01, 7.0, 40.0}) {
        const Eigen::Vector3d v(x, -0.3 * x, z), axis = Eigen::Vector3d::UnitZ();
        const auto p = a.load<double, Eigen::Vector3d>(w, v, axis, 1, 1.2);
        const auto q = b.load<double, Eigen::Vector3d>(w, v, axis, 1, 1.2);
        if (p.force != q.force || p.moment != q.moment || p.torque != q.torque) return false;
      }
    }
  }
  return true;
}

}  // namespace

class TestMapStore : public QObject {
  Q_OBJECT
 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    path_ = (folder_->path() + "/a/b").toStdString();
  }
  void foundAgainBitForBit();
  void othersAreNotFound();
  void wrongFilesAreMadeAnew_data();
  void wrongFilesAreMadeAnew();
  void manyWriteAtOnce();
  void leastUsedGo();
  void withoutAFolderNothingIsKept();
  void flightsUseIt();

 private:
  [[nodiscard]] fs::path file(const MapPropeller& p) const {
    return path_ / MapStore::fileName(p, rotorOf(p));
  }
  std::unique_ptr<QTemporaryDir> folder_;
  fs::path path_;
};

void TestMapStore::foundAgainBitForBit() {
  const MapStore store(path_);
  const MapPropeller p = small();
  QVERIFY(!store.find(p, rotorOf(p)));
  const PropellerMap made = mapOf(p);
  store.keep(p, rotorOf(p), made);
  const auto found = store.find(p, rotorOf(p));
  QVERIFY(found.has_value());
  QVERIFY(same(made, *found));
  QCOMPARE(found->sideSolved(), made.sideSolved());
}

void TestMapStore::othersAreNotFound() {
  const MapStore store(path_);
  const MapPropeller p = small();
  store.keep(p, rotorOf(p), mapOf(p));
  std::vector<MapPropeller> others(6, p);
  others[0].propeller.diameter = std::nextafter(0.2, 1);
  others[1].map.sideTolerance *= 2;
  others[2].settings.momentumFactor = 0.8;
  others[3].propeller.root = FlappingBlades{0};
  others[4].propeller.stations.back().twist += 1e-9;
  others[5].propeller.line = BladeLine::Standard;
  for (const MapPropeller& other : others) QVERIFY(!store.find(other, rotorOf(other)));
  // The same parameters, but blade elements that answer otherwise: another version of the program.
  QVERIFY(!store.find(p, rotorOf(others[2])));
}

void TestMapStore::wrongFilesAreMadeAnew_data() {
  QTest::addColumn<QByteArray>("contents");
  QTest::addColumn<int>("cut");
  QTest::addRow("cut") << QByteArray() << 1000;
  QTest::addRow("a byte less") << QByteArray() << 1;
  QTest::addRow("cut within its head") << QByteArray() << -10;
  QTest::addRow("empty") << QByteArray("") << 0;
  QTest::addRow("another file") << QByteArray(5000, 'x') << 0;
  QTest::addRow("a bit has turned") << QByteArray("bit") << 0;
}

void TestMapStore::wrongFilesAreMadeAnew() {
  QFETCH(QByteArray, contents);
  QFETCH(int, cut);
  const MapStore store(path_);
  const MapPropeller p = small();
  store.keep(p, rotorOf(p), mapOf(p));
  QFile f(QString::fromStdString(file(p).string()));
  QVERIFY(f.open(QIODevice::ReadWrite));
  QByteArray bytes = f.readAll();
  if (cut > 0) bytes.chop(cut);
  if (cut < 0) bytes.truncate(-cut);
  if (contents == "bit") {
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  } else if (cut == 0) {
    bytes = contents;
  }
  f.resize(0);
  f.seek(0);
  f.write(bytes);
  f.close();
  QVERIFY(!store.find(p, rotorOf(p)));
  store.keep(p, rotorOf(p), mapOf(p));
  QVERIFY(store.find(p, rotorOf(p)).has_value());
}

void TestMapStore::manyWriteAtOnce() {
  const MapPropeller p = small();
  const PropellerMap made = mapOf(p);
  std::vector<std::thread> writers;
  std::atomic<int> wrong = 0;
  for (int i = 0; i < 4; ++i) {
    writers.emplace_back([&] {
      const MapStore store(path_);
      for (int k = 0; k < 20; ++k) {
        store.keep(p, rotorOf(p), made);
        const auto found = store.find(p, rotorOf(p));
        if (!found || !same(*found, made)) ++wrong;
      }
    });
  }
  for (std::thread& writer : writers) writer.join();
  QCOMPARE(wrong.load(), 0);
  QCOMPARE(QDir(QString::fromStdString(path_.string())).entryList(QDir::Files).size(),
           qsizetype{1});
}

void TestMapStore::leastUsedGo() {
  const MapPropeller first = small(0.2), second = small(0.3), third = small(0.4);
  {
    const MapStore store(path_);
    for (const MapPropeller& p : {first, second}) store.keep(p, rotorOf(p), mapOf(p));
  }
  const auto size = fs::file_size(file(first));
  const auto now = fs::file_time_type::clock::now();
  fs::last_write_time(file(first), now - std::chrono::hours(2));
  fs::last_write_time(file(second), now - std::chrono::hours(1));
  const MapStore store(path_, 2 * size + size / 2);
  QVERIFY(store.find(first, rotorOf(first)).has_value());  // used: no longer the oldest
  store.keep(third, rotorOf(third), mapOf(third));
  QVERIFY(fs::exists(file(first)) && fs::exists(file(third)) && !fs::exists(file(second)));
}

void TestMapStore::withoutAFolderNothingIsKept() {
  const MapPropeller p = small();
  const MapStore none{fs::path()};
  none.keep(p, rotorOf(p), mapOf(p));
  QVERIFY(!none.find(p, rotorOf(p)));
  // A folder that cannot be is no error either.
  const std::string name = folder_->path().toStdString() + "/file";
  std::ofstream(name) << "x";
  const MapStore impossible(fs::path(name) / "below");
  impossible.keep(p, rotorOf(p), mapOf(p));
  QVERIFY(!impossible.find(p, rotorOf(p)));
}

/// What a flight is built from is found where ROTORBENCH_CACHE says.
void TestMapStore::flightsUseIt() {
  qputenv("ROTORBENCH_CACHE", QByteArray::fromStdString(path_.string()));
  QCOMPARE(MapStore::userFolder(), path_);
  const MapPropeller p = small(0.37);
  QVERIFY(prepareRotor(p) != nullptr);
  QVERIFY(fs::exists(file(p)));
  qputenv("ROTORBENCH_CACHE", "");
  const MapPropeller other = small(0.38);
  QVERIFY(prepareRotor(other) != nullptr);
  QVERIFY(!fs::exists(file(other)));
  qunsetenv("ROTORBENCH_CACHE");
  qputenv("XDG_CACHE_HOME", "/somewhere");
  QCOMPARE(MapStore::userFolder(), fs::path("/somewhere/rotorbench/maps"));
}

QTEST_GUILESS_MAIN(TestMapStore)
#include "test_map_store.moc"
