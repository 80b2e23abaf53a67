#include "ui/charts/wrapped_text.h"

#include <QTextLayout>
#include <algorithm>

namespace rotorbench {

QStringList wrappedText(const QString& text, const QFont& font, qreal room) {
  constexpr QChar kMayBreak(0x200b);
  QString breakable = text;
  breakable.replace(u'.', QString(u'.') + kMayBreak);
  QTextLayout layout(breakable, font);
  QTextOption option;
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  layout.setTextOption(option);
  QStringList lines;
  layout.beginLayout();
  for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
    line.setLineWidth(std::max(1.0, room));
    lines << breakable.mid(line.textStart(), line.textLength()).remove(kMayBreak).trimmed();
  }
  layout.endLayout();
  return lines;
}

}  // namespace rotorbench
