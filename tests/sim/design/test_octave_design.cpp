// Placement, regulators and discretisation of eight plants against GNU Octave with its control
// package (SLICOT behind it), which this test writes a script for and runs, once for all.
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>
#include <map>
#include <sstream>

#include "sim/design/balancing.h"
#include "sim/design/discretise.h"
#include "sim/design/lqr.h"
#include "sim/design/placement.h"
#include "sim/design/polynomial.h"
#include "tests/sim/design/plants.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

constexpr double kAgreement = 1e-8;  // what the issue asks for

std::string literal(const Eigen::MatrixXd& matrix) {
  std::ostringstream text;
  const Eigen::IOFormat format(17, Eigen::DontAlignCols, ",", ";", "", "", "[", "]");
  text << matrix.format(format);
  return text.str();
}

std::string literal(const std::vector<std::complex<double>>& poles) {
  std::ostringstream text;
  text.precision(17);
  text << '[';
  for (const auto pole : poles) text << "complex(" << pole.real() << ',' << pole.imag() << ");";
  text << ']';
  return text.str();
}

/// Octave is given the plants in units that suit it (its care and acker fail where lengths are in
/// nanometres) and its gains are taken back to those of the plant. What it prints, a line each:
/// "<plant> <quantity> <rows> <columns> <numbers row by row>", then "done".
std::string script() {
  std::ostringstream text;
  text << "pkg load control\n"
          "function tell(plant, name, m)\n"
          "  printf('%s %s %d %d', plant, name, rows(m), columns(m));\n"
          "  printf(' %.17g', m.'); printf('\\n');\n"
          "end\n";
  for (const DesignPlant& plant : designPlants()) {
    text.precision(17);
    text << "A = " << literal(plant.A) << "; B = " << literal(plant.B)
         << "; p = " << literal(plant.wanted) << "; T = " << plant.period << "; n = '" << plant.name
         << "'; u = diag(" << literal(balancing(plant.A, plant.B)) << ");\n"
         << "a = u \\ A * u; b = u \\ B; Q = u * u; R = eye(columns(B));\n"
            "tell(n, 'place', place(a, b, p) / u);\n"
            "if (columns(B) == 1) tell(n, 'acker', acker(a, b, p) / u); end\n"
            "d = c2d(ss(a, b, eye(rows(A)), zeros(size(B))), T, 'zoh');\n"
            "tell(n, 'Ad', u * d.a / u); tell(n, 'Bd', u * d.b);\n"
            "try tell(n, 'lqr', lqr(a, b, Q, R) / u); end\n"
            "try tell(n, 'dlqr', dlqr(d.a, d.b, Q, R) / u); end\n";
  }
  text << "printf('done\\n');\n";
  return text.str();
}

}  // namespace

class TestOctaveDesign : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void placement_data() { plants(); }
  void placement();
  void regulators_data() { plants(); }
  void regulators();
  void heldSampling_data() { plants(); }
  void heldSampling();

 private:
  static void plants();
  [[nodiscard]] Eigen::MatrixXd octaves(const DesignPlant& plant, const std::string& name) const {
    const auto found = answers_.find(plant.name + " " + name);
    return found == answers_.end() ? Eigen::MatrixXd() : found->second;
  }
  std::map<std::string, Eigen::MatrixXd> answers_;
};

void TestOctaveDesign::initTestCase() {
  QString octave = QStandardPaths::findExecutable("octave-cli");
  if (octave.isEmpty()) octave = QStandardPaths::findExecutable("octave");
  if (octave.isEmpty())
    QSKIP("octave is not installed (Debian packages octave and octave-control)");
  QTemporaryDir folder;
  QFile file(folder.filePath("design.m"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(QByteArray::fromStdString(script()));
  file.close();
  QProcess process;
  process.start(octave, {"--no-gui", "--quiet", "--norc", file.fileName()});
  QVERIFY2(process.waitForFinished(240000), "Octave takes longer than four minutes");
  const QString output = QString::fromUtf8(process.readAllStandardOutput());
  QVERIFY2(output.endsWith("done\n"), process.readAllStandardError().constData());
  std::istringstream lines(output.toStdString());
  std::string plant, name;
  Eigen::Index rows = 0, columns = 0;
  while (lines >> plant >> name >> rows >> columns) {
    Eigen::MatrixXd& matrix = answers_[plant.append(" ").append(name)];
    matrix.resize(rows, columns);
    for (Eigen::Index i = 0; i < rows; ++i)
      for (Eigen::Index j = 0; j < columns; ++j) QVERIFY(lines >> matrix(i, j));
  }
}

void TestOctaveDesign::plants() {
  QTest::addColumn<int>("index");
  int index = 0;
  for (const DesignPlant& plant : designPlants())
    QTest::addRow("%s", plant.name.c_str()) << index++;
}

/// Gains of a single input are unique; of several, the polynomial they lead to is.
void TestOctaveDesign::placement() {
  QFETCH(int, index);
  const DesignPlant plant = designPlants()[static_cast<std::size_t>(index)];
  const Eigen::MatrixXd gain = placePoles(plant.A, plant.B, plant.poles()).gain;
  const Eigen::MatrixXd theirs = octaves(plant, "place");
  if (plant.B.cols() == 1) {
    const double place = relativeError(gain, theirs);
    const double acker = relativeError(gain, octaves(plant, "acker"));
    qInfo("gain: %.1e from place, %.1e from acker", place, acker);
    QVERIFY(place < kAgreement);
    QVERIFY(acker < kAgreement);
    return;
  }
  const auto polynomial = [&](const Eigen::MatrixXd& K) {
    return characteristicPolynomial(plant.A - plant.B * K);
  };
  const double apart = relativeError(polynomial(gain), polynomial(theirs));
  const double ours = relativeError(polynomial(gain), polynomialOf(plant.poles()));
  qInfo("polynomial: %.1e from place, %.1e from the poles wanted", apart, ours);
  QVERIFY(apart < kAgreement);
  QVERIFY(ours < kAgreement);
}

void TestOctaveDesign::regulators() {
  QFETCH(int, index);
  const DesignPlant plant = designPlants()[static_cast<std::size_t>(index)];
  const QuadraticCost cost{Eigen::MatrixXd::Identity(plant.A.rows(), plant.A.rows()),
                           Eigen::MatrixXd::Identity(plant.B.cols(), plant.B.cols())};
  // Octave gives up where lengths are in nanometres: there the equations' own residuals must do.
  if (octaves(plant, "lqr").size() == 0 || octaves(plant, "dlqr").size() == 0) {
    QCOMPARE(plant.name, std::string("badly-scaled"));
    QVERIFY(lqr(plant.A, plant.B, cost).residual < 1e-10);
    return;
  }
  const double continuous = relativeError(lqr(plant.A, plant.B, cost).gain, octaves(plant, "lqr"));
  // Of Octave's own sampled model, so that only the regulators differ.
  const double sampled = relativeError(
      sampledLqr(octaves(plant, "Ad"), octaves(plant, "Bd"), cost).gain, octaves(plant, "dlqr"));
  qInfo("gain: %.1e from lqr, %.1e from dlqr", continuous, sampled);
  QVERIFY(continuous < kAgreement);
  QVERIFY(sampled < kAgreement);
}

void TestOctaveDesign::heldSampling() {
  QFETCH(int, index);
  const DesignPlant plant = designPlants()[static_cast<std::size_t>(index)];
  const LinearSystem sampled = holdSampled(stateSystem(plant.A, plant.B), plant.period);
  const double transition = relativeError(sampled.A, octaves(plant, "Ad"));
  const double input = relativeError(sampled.B, octaves(plant, "Bd"));
  qInfo("A %.1e, B %.1e from c2d", transition, input);
  QVERIFY(transition < kAgreement);
  QVERIFY(input < kAgreement);
}

QTEST_GUILESS_MAIN(TestOctaveDesign)
#include "test_octave_design.moc"
