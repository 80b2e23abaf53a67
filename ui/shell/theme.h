// Light and dark: Fusion style with the system's palette or one of our two, and icons that fit.
#pragma once

#include <QIcon>
#include <QString>

namespace rotorbench {

enum class Theme { System, Light, Dark };

/// "system", "light", "dark", as kept in the settings.
QString themeKey(Theme theme);
Theme themeFromKey(const QString& key);

/// Sets style, palette and icon theme of the application. Icons made before keep their look.
void applyTheme(Theme theme);

/// Icon of the desktop's theme, else of Breeze, else one of ours from resources/icons.
QIcon themedIcon(const QString& name);

}  // namespace rotorbench
