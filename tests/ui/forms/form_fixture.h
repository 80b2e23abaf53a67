// A panel on a test document, driven as a person drives it: fields are found by path, text is typed
// key by key.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QtTest>
#include <memory>

#include "tests/ui/forms/all_kinds.h"
#include "ui/forms/experiment_panel.h"
#include "ui/forms/parameter_form.h"
#include "ui/forms/section_tree.h"

namespace rotorbench::forms_test {

class FormFixture {
 public:
  explicit FormFixture(Document document = {}) : model(makeDocument(std::move(document))) {
    show();
  }

  void show() {
    panel = std::make_unique<ExperimentPanel>(&model, nullptr);
    panel->resize(420, 900);
    panel->show();
    panel->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(panel.get()));
  }

  template <class W = QLineEdit>
  W* find(const QString& name) {
    return panel->findChild<W*>(name);
  }

  /// Clicks into the field, replaces its text and presses Enter.
  void type(const QString& path, const QString& text) {
    auto* edit = find(path);
    QVERIFY2(edit != nullptr, qPrintable(path));
    QTest::mouseClick(edit, Qt::LeftButton);
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
  }

  /// The sentence shown under a field, empty if none.
  QString sentence(const QString& path) {
    auto* label = find<QLabel>(path + ".message");
    return label != nullptr && label->isVisible() ? label->text() : QString();
  }

  const Document& document() const { return model.as<Document>(); }
  QUndoStack& stack() { return *model.undoStack(); }

  DocumentModel model;
  std::unique_ptr<ExperimentPanel> panel;
};

}  // namespace rotorbench::forms_test
