// A window in a sandbox: settings, autosave and documents go to a temporary folder that goes away
// with it.
#pragma once

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QToolBar>
#include <QToolButton>
#include <QtTest>

#include "ui/charts/chart_grid.h"
#include "ui/forms/experiment_panel.h"
#include "ui/shell/gallery_card.h"
#include "ui/shell/main_window.h"
#include "ui/shell/workbench.h"

namespace rotorbench {

/// Makes the program forget the user's own settings; `folder` outlives every window.
inline void useSettingsIn(const QString& folder) {
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder);
  qputenv("XDG_DATA_HOME", folder.toUtf8());
  qputenv("XDG_CONFIG_HOME", folder.toUtf8());
  QApplication::setOrganizationName("Rotorbench");
  QApplication::setApplicationName("Rotorbench");
}

/// A click on the tool bar's button for an action, as a person does it.
inline void clickAction(MainWindow& window, const char* name) {
  auto* bar = window.findChild<QToolBar*>("mainToolBar");
  auto* action = window.findChild<QAction*>(name);
  QVERIFY2(action != nullptr, name);
  QVERIFY2(action->isEnabled(), name);
  QTest::mouseClick(bar->widgetForAction(action), Qt::LeftButton);
}

/// Starts from the gallery: a click on the card, then the workbench with the experiment.
inline void openCard(MainWindow& window, const QString& name) {
  auto* card = window.findChild<GalleryCard*>("card:" + name);
  QVERIFY2(card != nullptr, qPrintable(name));
  QTest::mouseClick(card, Qt::LeftButton);
  QTRY_VERIFY(window.workbench().isVisible());
}

inline void showWindow(MainWindow& window) {
  window.resize(1280, 800);
  window.show();
  QVERIFY(QTest::qWaitForWindowExposed(&window));
}

/// Chooses a speed in the tool bar by what a person reads.
inline void choosePace(MainWindow& window, const QString& text) {
  auto* box = window.findChild<QComboBox*>("paceBox");
  const int index = box->findText(text);
  QVERIFY2(index >= 0, qPrintable(text));
  box->setCurrentIndex(index);
}

/// Opens the form at a field by its path and types into it.
inline void typeInto(MainWindow& window, const QString& path, const QString& text) {
  window.workbench().experiment().jumpTo(path);
  QLineEdit* edit = nullptr;
  QTRY_VERIFY((edit = window.findChild<QLineEdit*>(path)) != nullptr && edit->isVisible());
  edit->setFocus();
  edit->selectAll();
  QTest::keyClicks(edit, text);
  QTest::keyClick(edit, Qt::Key_Return);
}

}  // namespace rotorbench
