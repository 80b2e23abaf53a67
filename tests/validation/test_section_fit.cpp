// The fit of the section's constants that holds families out, on a few propellers: it comes nearer
// to them than the textbook it starts from, and it is the same every time.
#include <QtTest>
#include <cmath>

#include "sim/validation/propeller_scores.h"
#include "sim/validation/section_fit.h"
#include "sim/validation/statistics.h"
#include "tests/validation/uiuc_data.h"

using namespace rotorbench;
using namespace rotorbench::validation;

namespace {

std::vector<const PropellerSet*> some() {
  std::vector<const PropellerSet*> sets;
  for (const PropellerSet& set : uiuc::sets()) {
    if (set.propeller.starts_with("apc")) sets.push_back(&set);
  }
  return sets;
}

double meanError(const std::vector<const PropellerSet*>& sets, const BladeConstants& constants) {
  std::vector<double> errors;
  for (const PropellerSet* set : sets) {
    const PropellerScore s = scoreAtRest(*set, rotorWith(set->geometry, constants));
    errors.push_back(s.thrust);
    errors.push_back(s.power);
  }
  return mean(errors);
}

}  // namespace

class TestSectionFit : public QObject {
  Q_OBJECT
 private slots:
  void fitComesNearerThanTheTextbook() {
    const auto sets = some();
    QVERIFY(sets.size() > 10);
    const BladeConstants fitted = fittedConstants(sets);
    const double before = meanError(sets, textbookConstants()), after = meanError(sets, fitted);
    qInfo("textbook %.1f %%, fitted %.1f %%", before, after);
    QVERIFY(after < 0.8 * before);
    QVERIFY(fittedConstants(sets).section == fitted.section);
  }
  /// The program's own constants, asked for in this way, are the program's own propeller.
  void ownConstantsAreTheProgramsPropeller() {
    const PropellerSet& set = uiuc::sets().front();
    const Coefficients own = coefficients(BladeElementRotor(set.geometry), 500, 0.2);
    const Coefficients asked = coefficients(rotorWith(set.geometry, {}), 500, 0.2);
    QCOMPARE(asked.thrust, own.thrust);
    QCOMPARE(asked.power, own.power);
  }
};

QTEST_GUILESS_MAIN(TestSectionFit)
#include "test_section_fit.moc"
