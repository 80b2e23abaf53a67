// Asks for what a person reads about a component: name, summary, source, warning.
#pragma once

#include <QDialog>
#include <functional>

#include "sim/library/component.h"

class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace rotorbench {

class ComponentInfoDialog : public QDialog {
  Q_OBJECT

 public:
  /// `accept` does what is to be done with the texts and returns the sentence that says why it
  /// could not: the dialog then stays open with it. Empty: done.
  using Accept = std::function<QString(const ComponentInfo&)>;

  ComponentInfoDialog(const QString& title, const ComponentInfo& info, Accept accept,
                      QWidget* parent);

 private:
  void finish();

  Accept accept_;
  QLineEdit* name_;
  QPlainTextEdit *summary_, *source_, *warning_;
  QLabel* message_;
};

}  // namespace rotorbench
