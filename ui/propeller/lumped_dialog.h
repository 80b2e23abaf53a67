// Lumped coefficients that stand for a propeller of a document: the range they are to hold over at
// the left, what came of it and what it leaves out at the right. Puts them in its place, as one
// step of undo.
#pragma once

#include <QDialog>
#include <QLocale>
#include <QSettings>

#include "sim/sizing/lumping.h"
#include "ui/forms/document_model.h"
#include "ui/forms/form_context.h"
#include "ui/sizing/latest_result.h"

class QPushButton;

namespace rotorbench {

class FigureTable;
class ParameterForm;

class LumpedDialog : public QDialog {
  Q_OBJECT

 public:
  /// `model` holds the rotor and outlives the dialog.
  LumpedDialog(DocumentModel& model, RotorModelAt rotor, QWidget* parent = nullptr);
  ~LumpedDialog() override;

 private:
  struct Result {
    std::optional<LumpingRange> first;  ///< what the form begins with
    std::optional<LumpedEquivalent> lumped;
    FigureSheet figures;
    QString problem;
  };

  void build();
  [[nodiscard]] const LumpingRange& range() const;
  [[nodiscard]] LatestResult<Result>::Job prepare() const;
  void showResult(const Result& result);
  void use();

  DocumentModel& model_;
  RotorModelAt rotor_;
  DocumentModel settings_;
  QSettings unitSettings_;
  UnitPreferences units_;
  FormContext context_;
  ParameterForm* form_;
  FigureTable* table_;
  QPushButton* use_ = nullptr;
  bool ranged_ = false;  ///< the form has what it begins with
  std::optional<LumpedEquivalent> lumped_;
  LatestResult<Result> result_;
};

}  // namespace rotorbench
