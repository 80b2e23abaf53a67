#include "ui/shell/theme.h"

#include <QApplication>
#include <QFile>
#include <QPalette>
#include <QStandardPaths>
#include <QStyle>
#include <QStyleFactory>

#include "sim/document/resources.h"

namespace rotorbench {

namespace {

struct Shades {
  QColor window, base, alternate, text, button, mid, highlight, link;
};

QPalette paletteFrom(const Shades& s) {
  QPalette palette(s.button, s.window);
  palette.setColor(QPalette::Window, s.window);
  palette.setColor(QPalette::WindowText, s.text);
  palette.setColor(QPalette::Base, s.base);
  palette.setColor(QPalette::AlternateBase, s.alternate);
  palette.setColor(QPalette::Text, s.text);
  palette.setColor(QPalette::Button, s.button);
  palette.setColor(QPalette::ButtonText, s.text);
  palette.setColor(QPalette::BrightText, Qt::white);
  palette.setColor(QPalette::ToolTipBase, s.base);
  palette.setColor(QPalette::ToolTipText, s.text);
  palette.setColor(QPalette::Highlight, s.highlight);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, s.link);
  palette.setColor(QPalette::Mid, s.mid);
  QColor dim = s.text;
  dim.setAlphaF(0.55F);
  palette.setColor(QPalette::PlaceholderText, dim);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, dim);
  }
  palette.setColor(QPalette::Disabled, QPalette::Highlight, s.mid);
  return palette;
}

QPalette lightPalette() {
  return paletteFrom(
      {0xf2f3f4, 0xffffff, 0xf7f8f9, 0x1f2429, 0xf6f7f8, 0xb9bec4, 0x0b63a5, 0x0b63a5});
}

QPalette darkPalette() {
  return paletteFrom(
      {0x25282c, 0x1c1f22, 0x212428, 0xe4e7ea, 0x30343a, 0x565c63, 0x2d78b7, 0x6cb6f0});
}

bool isDark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() <
         palette.color(QPalette::WindowText).lightness();
}

}  // namespace

QString themeKey(Theme theme) {
  return theme == Theme::Light ? "light" : theme == Theme::Dark ? "dark" : "system";
}

Theme themeFromKey(const QString& key) {
  return key == "light" ? Theme::Light : key == "dark" ? Theme::Dark : Theme::System;
}

void applyTheme(Theme theme) {
  // Remembered before the first change: later the platform's own choice can no longer be read.
  static const QString systemIcons = QIcon::themeName();
  // Without a desktop Qt does not look where the desktops keep their icons.
  QStringList places = QIcon::themeSearchPaths();
  places << QStandardPaths::locateAll(QStandardPaths::GenericDataLocation, "icons",
                                      QStandardPaths::LocateDirectory);
  places.removeDuplicates();
  QIcon::setThemeSearchPaths(places);
  if (QApplication::style()->name() != "fusion")
    QApplication::setStyle(QStyleFactory::create("Fusion"));
  QApplication::setPalette(theme == Theme::Light  ? lightPalette()
                           : theme == Theme::Dark ? darkPalette()
                                                  : QPalette());
  const QString breeze = isDark(QApplication::palette()) ? "breeze-dark" : "breeze";
  const bool ownChoice =
      theme != Theme::System || systemIcons.isEmpty() || systemIcons == "hicolor";
  QIcon::setThemeName(ownChoice ? breeze : systemIcons);
  QIcon::setFallbackThemeName(breeze);
}

QIcon themedIcon(const QString& name) {
  if (QIcon::hasThemeIcon(name)) return QIcon::fromTheme(name);
  const auto own = resourceDirectory() / "icons" / (name.toStdString() + ".svg");
  const QString file = QString::fromStdString(own.string());
  return QFile::exists(file) ? QIcon(file) : QIcon();
}

}  // namespace rotorbench
