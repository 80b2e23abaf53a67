// Edits one propeller of a document: the form with its tables at the left, chord and twist on a
// chart and the drawn blade in 3D at the right, and below them live what it does by blade elements.
// It edits the document itself, so the experiment's form and undo know every change.
#pragma once

#include <QDialog>
#include <QTimer>

#include "sim/propulsion/rotor/blade.h"
#include "sim/sizing/lumping.h"
#include "ui/forms/document_model.h"
#include "ui/forms/form_context.h"
#include "ui/forms/unit_preferences.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace rotorbench {

class BladeCurves;
class ParameterForm;
class PropellerFigures;
class SceneView;

/// Where a document holds a propeller by its geometry: paths, in the order of the document.
QStringList propellersOf(schema::ConstRef root);

class PropellerEditor : public QDialog {
  Q_OBJECT

 public:
  /// `model` outlives the dialog and holds at least one propeller.
  PropellerEditor(DocumentModel& model, QWidget* parent = nullptr);
  ~PropellerEditor() override;

  [[nodiscard]] QString path() const { return path_; }
  [[nodiscard]] const PropellerGeometry& geometry() const;
  /// A section from these polar files, from the given radius (r/R) on, as one undo step. False,
  /// with a sentence in the window, if a file is no polar.
  bool importPolars(const QStringList& files, double radius);

 private:
  void buildPicker();
  void buildPages();
  void buildButtons();
  void fillPicker();
  void showPropeller(const QString& path);
  void followForm(const QString& section);
  void follow(const QString& changed);
  void refresh();
  void insertStation(double radius);
  void removeStation(int station);
  void askForPolars();
  /// The propeller as part of a rotor that could be lumped.
  [[nodiscard]] std::optional<RotorModelAt> lumpable() const;
  void openLumped();
  void replaceStations(const std::vector<BladeStation>& stations, const QString& text);
  [[nodiscard]] QString stationPath(int station, const char* key) const;

  DocumentModel& model_;
  UnitPreferences units_;
  FormContext context_;
  QString path_;
  QTimer refresh_;
  QComboBox* picker_;
  ParameterForm* form_;
  BladeCurves* curves_;
  SceneView* view_;
  PropellerFigures* figures_;
  QLabel* message_;
  QPushButton* lump_ = nullptr;
};

}  // namespace rotorbench
