// Text of charts (names of channels, titles) broken into lines that fit, never cut short.
#pragma once

#include <QFont>
#include <QStringList>

namespace rotorbench {

/// `text` in lines of at most `room` px. It is broken between words, at the dots of a channel's
/// name, and inside a word only where even that is too wide.
QStringList wrappedText(const QString& text, const QFont& font, qreal room);

}  // namespace rotorbench
