// Component files and the folders of the library: what is written reads back, what is wrong is
// said, nothing is lost.
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

#include "sim/core/schema_tree.h"
#include "sim/io/file.h"
#include "sim/library/component_file.h"
#include "sim/library/component_library.h"
#include "sim/propulsion/drive/battery.h"
#include "sim/propulsion/drive/motor.h"
#include "sim/propulsion/rotor/blade.h"

using namespace rotorbench;
namespace fs = std::filesystem;

namespace {

Component motorNamed(const char* name, double resistance = 0.2) {
  MotorParameters motor;
  motor.resistance = resistance;
  return makeComponent<MotorParameters>({name, "A motor", "Somebody, 2014", "Inertia assumed"},
                                        motor);
}

QString faultOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return QString::fromUtf8(error.what());
  }
  return {};
}

void put(const fs::path& file, std::string_view text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

}  // namespace

class TestComponentLibrary : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    shipped_ = fs::path(folder_->path().toStdString()) / "shipped";
    own_ = fs::path(folder_->path().toStdString()) / "own";
  }
  void kindsAreTold();
  void everyKindReadsBack_data();
  void everyKindReadsBack();
  void unitsAndDefaultsAsInExperiments();
  void faults_data();
  void faults();
  void oneBadFileHidesNoOther();
  void savedIsFoundAgain();
  void noNameTwice();
  void replaceAndRename();
  void shippedStay();
  void removing();

 private:
  [[nodiscard]] ComponentLibrary library() const { return {shipped_, own_}; }

  std::unique_ptr<QTemporaryDir> folder_;
  fs::path shipped_, own_;
};

void TestComponentLibrary::kindsAreTold() {
  QSet<QString> keys, folders;
  for (const auto& kind : componentKinds()) {
    keys << QString::fromStdString(kind.key);
    folders << QString::fromStdString(kind.folder);
    QCOMPARE(kindOf(*kind.type), &kind);
    QCOMPARE(kindOf(kind.key), &kind);
  }
  QCOMPARE(std::size_t(keys.size()), componentKinds().size());
  QCOMPARE(std::size_t(folders.size()), componentKinds().size());
  QCOMPARE(kindOf("motr"), nullptr);
}

void TestComponentLibrary::everyKindReadsBack_data() {
  QTest::addColumn<QString>("key");
  for (const auto& kind : componentKinds()) {
    QTest::addRow("%s", kind.key.c_str()) << QString::fromStdString(kind.key);
  }
}

void TestComponentLibrary::everyKindReadsBack() {
  QFETCH(QString, key);
  const ComponentKind& kind = *kindOf(key.toStdString());
  const auto value = kind.type->make();
  const Component component =
      makeComponent({"Näme \"1\"", "Line\nline", "s", ""}, {kind.type, value.get()});
  const std::string text = writeComponent(component);
  const Component back = readComponent(text, "a.json");
  QCOMPARE(back.type, kind.type);
  QVERIFY(back.info == component.info);
  QVERIFY(schema::compare(back.ref(), component.ref()).empty());
  QCOMPARE(writeComponent(back), text);
}

void TestComponentLibrary::unitsAndDefaultsAsInExperiments() {
  const Component c = readComponent(
      R"({"rotorbench-component": 1, "kind": "motor", "name": "M", "value": {"speedConstant": "1100 rpm/V", "resistance": 0.1}})",
      "m.json");
  const auto* motor = c.as<MotorParameters>();
  QVERIFY(motor != nullptr);
  QVERIFY(c.as<BatteryParameters>() == nullptr);
  // 1100 rpm = 1100 * 2 pi/60 rad/s
  QCOMPARE(motor->speedConstant, 1100 * 2 * 3.14159265358979323846 / 60);
  // What is left out has no effect.
  QCOMPARE(motor->noLoadCurrent, 0.0);
  QCOMPARE(motor->maxCurrent, kMostCurrentLimit);
}

void TestComponentLibrary::faults_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<QStringList>("said");
  const auto row = [](const char* name, const char* text, const QStringList& said) {
    QTest::addRow("%s", name) << QString(text) << said;
  };
  row("no JSON", "{", {"m.json"});
  row("a list", "[1]", {"not a component file", "rotorbench-component"});
  row("another file", R"({"hello": 1})", {"not a component file"});
  row("an experiment", R"({"rotorbench": 1})", {"an experiment, not a component"});
  row("no kind", R"({"rotorbench-component": 1, "name": "M"})", {"kind", "missing"});
  row("unknown kind", R"({"rotorbench-component": 1, "kind": "moter", "name": "M"})",
      {"kind", "moter", "motor"});
  row("later version", R"({"rotorbench-component": 7, "kind": "motor", "name": "M"})",
      {"version 7 is unknown", "reads version 1"});
  row("no name", R"({"rotorbench-component": 1, "kind": "motor", "name": " "})", {"no name"});
  row("two faults at once",
      R"({"rotorbench-component": 1, "kind": "motor", "name": "M", "value": {"resistance": -1, "kv": 3}})",
      {"value.resistance", "value.kv"});
  row("no value is neutral",
      R"({"rotorbench-component": 1, "kind": "motor", "name": "M", "value": {"resistance": 0.1}})",
      {"value.speedConstant: this key is missing"});
  row("rule over members",
      R"({"rotorbench-component": 1, "kind": "motor", "name": "M", "value": {"speedConstant": 100, "resistance": 100, "noLoadCurrent": 9}})",
      {"value.noLoadCurrent"});
}

void TestComponentLibrary::faults() {
  QFETCH(QString, text);
  QFETCH(QStringList, said);
  const QString fault = faultOf([&] { readComponent(text.toStdString(), "m.json"); });
  for (const QString& words : said) QVERIFY2(fault.contains(words), qPrintable(fault));
}

void TestComponentLibrary::oneBadFileHidesNoOther() {
  put(shipped_ / "motors/a.json", writeComponent(motorNamed("A")));
  put(shipped_ / "motors/b.json", "{");
  put(shipped_ / "motors/notes.txt", "not a component");
  put(shipped_ / "batteries/c.json", writeComponent(motorNamed("C")));
  const ComponentLibrary all = library();
  QCOMPARE(all.entries().size(), std::size_t(1));
  QCOMPARE(all.entries()[0].component.info.name, std::string("A"));
  QCOMPARE(all.faults().size(), std::size_t(2));
  QCOMPARE(all.faults()[0].file.filename().string(), std::string("b.json"));
  QVERIFY(!all.faults()[0].sentence.empty());
  QVERIFY(all.faults()[1].sentence.find("batteries") != std::string::npos);
}

void TestComponentLibrary::savedIsFoundAgain() {
  ComponentLibrary all = library();
  const ComponentKind& motors = *kindOf("motor");
  const LibraryEntry& entry = all.save(motorNamed("My Motor (2nd)", 0.31));
  QVERIFY(entry.own);
  QCOMPARE(entry.file.filename().string(), std::string("my-motor-2nd.json"));
  QCOMPARE(all.find(motors, "My Motor (2nd)")->component.as<MotorParameters>()->resistance, 0.31);
  // Names without a plain letter, and names that differ only in what a file name leaves out.
  all.save(motorNamed("\u6a21\u578b"));
  all.save(motorNamed("My motor 2nd"));
  const ComponentLibrary again = library();
  QCOMPARE(again.list(motors).size(), std::size_t(3));
  QVERIFY(again.find(motors, "\u6a21\u578b") != nullptr);
  QVERIFY(again.faults().empty());
}

void TestComponentLibrary::noNameTwice() {
  put(shipped_ / "motors/a.json", writeComponent(motorNamed("A")));
  ComponentLibrary all = library();
  QVERIFY(faultOf([&] { all.save(motorNamed("A")); }).contains("A 2"));
  QCOMPARE(all.entries().size(), std::size_t(1));
  const ComponentKind& motors = *kindOf("motor");
  all.save(motorNamed("A 2"));
  QCOMPARE(all.freeName(motors, "A"), std::string("A 3"));
  QCOMPARE(all.freeName(motors, "B"), std::string("B"));
  // Of another kind the name is free.
  all.save(makeComponent<BatteryParameters>({"A", "", "", ""}, {}));
  QVERIFY(faultOf([&] { all.save(motorNamed("")); }).contains("name"));
  QVERIFY(faultOf([&] { all.save(motorNamed("Bad", -1)); }).contains("value.resistance"));
  QCOMPARE(all.entries().size(), std::size_t(3));
}

void TestComponentLibrary::replaceAndRename() {
  ComponentLibrary all = library();
  const ComponentKind& motors = *kindOf("motor");
  all.save(motorNamed("A", 0.1));
  all.save(motorNamed("B", 0.2));
  all.replace(*all.find(motors, "A"), motorNamed("C", 0.3));
  QVERIFY(all.find(motors, "A") == nullptr);
  QCOMPARE(all.find(motors, "C")->component.as<MotorParameters>()->resistance, 0.3);
  QVERIFY(!faultOf([&] { all.replace(*all.find(motors, "C"), motorNamed("B")); }).isEmpty());
  QCOMPARE(library().list(motors).size(), std::size_t(2));
}

void TestComponentLibrary::shippedStay() {
  put(shipped_ / "motors/a.json", writeComponent(motorNamed("A", 0.1)));
  ComponentLibrary all = library();
  const LibraryEntry& a = all.entries().front();
  QVERIFY(!a.own);
  QVERIFY(faultOf([&] { all.remove(a); }).contains("shipped"));
  QVERIFY(!faultOf([&] { all.replace(a, motorNamed("A", 0.9)); }).isEmpty());
  // A file put into the own folder by hand may bear a shipped name: the own one is found.
  put(own_ / "motors/x.json", writeComponent(motorNamed("A", 0.7)));
  all.reload();
  QCOMPARE(all.entries().size(), std::size_t(2));
  QCOMPARE(all.find(*kindOf("motor"), "A")->component.as<MotorParameters>()->resistance, 0.7);
}

void TestComponentLibrary::removing() {
  ComponentLibrary all = library();
  const fs::path file = all.save(motorNamed("A")).file;
  all.remove(all.entries().front());
  QVERIFY(all.entries().empty());
  QVERIFY(!fs::exists(file));
}

QTEST_GUILESS_MAIN(TestComponentLibrary)
#include "test_component_library.moc"
