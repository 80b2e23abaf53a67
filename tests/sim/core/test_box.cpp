// A box is its value, kept elsewhere.
#include <QTest>
#include <string>

#include "sim/core/box_members.h"

using namespace rotorbench;

namespace {

struct Counted {
  static inline int alive = 0;
  std::string text = "default";
  Counted() { ++alive; }
  Counted(std::string t) : text(std::move(t)) { ++alive; }  // NOLINT
  Counted(const Counted& other) : text(other.text) { ++alive; }
  Counted& operator=(const Counted&) = default;
  ~Counted() { --alive; }
  bool operator==(const Counted&) const = default;
};

using Choice = std::variant<Box<Counted>, int>;

}  // namespace

class TestBox : public QObject {
  Q_OBJECT
 private slots:
  void cleanup() { QCOMPARE(Counted::alive, 0); }

  void copiesAreApart() {
    Box<Counted> one = Counted("one"), two = one;
    two->text = "two";
    QCOMPARE(one->text, std::string("one"));
    QVERIFY(!(one == two));
    one = two;
    QVERIFY(one == two);
    two->text = "three";
    QCOMPARE(one->text, std::string("two"));
    Box<Counted>& self = one;
    one = self;
    QCOMPARE(one->text, std::string("two"));
  }

  void movingKeepsThePlace() {
    Box<Counted> one = Counted("one");
    const Counted* place = &*one;
    Box<Counted> two = std::move(one);
    QCOMPARE(&*two, place);
    one = Counted("again");  // what was moved from may be assigned to
    QCOMPARE(one->text, std::string("again"));
    one = std::move(two);
    QCOMPARE(&*one, place);
  }

  void variantsLookInside() {
    Choice choice;
    QVERIFY(holdsAlternative<Counted>(choice));
    QCOMPARE(alternative<Counted>(choice).text, std::string("default"));
    alternative<Counted>(choice).text = "changed";
    const Choice copy = choice;
    choice = 7;
    QCOMPARE(alternative<int>(choice), 7);
    QVERIFY(alternativeIf<Counted>(choice) == nullptr);
    QCOMPARE(alternativeIf<Counted>(copy)->text, std::string("changed"));
    QVERIFY_THROWS_EXCEPTION(std::bad_variant_access, alternative<Counted>(choice));
    choice = Counted("new");
    struct Length {
      std::size_t operator()(const Counted& c) const { return c.text.size(); }
      std::size_t operator()(int i) const { return static_cast<std::size_t>(i); }
    };
    QCOMPARE(visitAlternative(Length{}, choice), std::size_t{3});
    QCOMPARE(visitAlternative(Length{}, copy), std::size_t{7});
    QVERIFY(!(choice == copy));
  }
};

QTEST_GUILESS_MAIN(TestBox)
#include "test_box.moc"
