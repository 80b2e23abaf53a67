#include "ui/shell/log_panel.h"

#include <QTime>

namespace rotorbench {

namespace {
constexpr int kMostLines = 5000;
}

LogPanel::LogPanel(QWidget* parent) : QPlainTextEdit(parent) {
  setObjectName("logPanel");
  setAccessibleName(tr("Log"));
  setReadOnly(true);
  setMaximumBlockCount(kMostLines);
  setFrameShape(QFrame::NoFrame);
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setPlaceholderText(tr("Runs, files and warnings are noted here."));
}

void LogPanel::add(const QString& line) {
  appendPlainText(QTime::currentTime().toString("HH:mm:ss") + "  " + line);
}

}  // namespace rotorbench
