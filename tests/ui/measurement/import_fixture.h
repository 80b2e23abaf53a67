// An import dialog that a file was typed into, for the tests of the import.
#pragma once

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "ui/measurement/import_dialog.h"
#include "ui/measurement/mapping_table.h"

namespace rotorbench {

/// Settings, components and files of a test go here.
class ImportFolder {
 public:
  ImportFolder() {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
    qputenv("XDG_DATA_HOME", folder_.path().toUtf8());
    QApplication::setOrganizationName("Rotorbench");
    QApplication::setApplicationName("Rotorbench");
  }
  /// The path of a new file.
  [[nodiscard]] QString write(const QString& name, const QByteArray& text) const {
    QFile file(folder_.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) qFatal("cannot write");
    return file.fileName();
  }

 private:
  QTemporaryDir folder_;
};

/// A dialog that a file was typed into.
struct Opened {
  RunList runs;
  QPointer<ImportDialog> dialog = new ImportDialog(runs);

  explicit Opened(const QString& file) {
    dialog->show();
    dialog->activateWindow();
    if (!QTest::qWaitForWindowActive(dialog)) qFatal("no active window");
    auto* edit = child<QLineEdit>("importFile");
    edit->setFocus();
    QTest::keyClicks(edit, file);
    QTest::keyClick(edit, Qt::Key_Return);
  }
  ~Opened() { delete dialog; }

  template <class W>
  [[nodiscard]] W* child(const char* name) const {
    return dialog->findChild<W*>(name);
  }
  [[nodiscard]] QString report() const {
    return child<QPlainTextEdit>("importReport")->toPlainText();
  }
  [[nodiscard]] QPushButton* ok() const {
    return dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  }
  /// Types into a line as a person does, and leaves it by the Tab key.
  void type(const char* line, const QString& text) const {
    auto* edit = child<QLineEdit>(line);
    QVERIFY2(edit != nullptr && edit->isEnabled(), line);
    edit->setFocus();
    edit->selectAll();
    if (text.isEmpty()) QTest::keyClick(edit, Qt::Key_Delete);
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Tab);
  }
  /// What stands below a column's choices: "0.145 … 1".
  [[nodiscard]] QString range(int column) const {
    return child<MappingTable>("importTable")->item(MappingTable::kRangeRow, column)->text();
  }
  void choose(const char* box, const QString& text) const {
    auto* combo = child<QComboBox>(box);
    QVERIFY2(combo != nullptr, box);
    const int index = combo->findText(text);
    QVERIFY2(index >= 0, qPrintable(text));
    combo->setCurrentIndex(index);
  }
};

}  // namespace rotorbench
