// The reader's locale for typing numbers: no group separators, which are taken for decimal points
// too easily.
#pragma once

#include <QLocale>

namespace rotorbench {

inline QLocale plainLocale() {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
  return locale;
}

}  // namespace rotorbench
