// What happened in this session: runs, their statistics and failures, files opened and saved.
// Newest last.
#pragma once

#include <QPlainTextEdit>

namespace rotorbench {

class LogPanel : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit LogPanel(QWidget* parent = nullptr);
  /// Adds a line behind the time of day.
  void add(const QString& line);
};

}  // namespace rotorbench
