// The experiment being edited and the file it belongs to: new, open, save, autosave and recovery.
// Asks nothing and shows nothing; questions to the user are DocumentDialogs' part. Files are read
// on a worker thread, so that a large or slow one never stops the window.
#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QTimer>
#include <filesystem>
#include <variant>

#include "ui/forms/document_model.h"
#include "ui/shell/autosave.h"
#include "ui/shell/recent_files.h"

namespace rotorbench {

class DocumentController : public QObject {
  Q_OBJECT

 public:
  /// Autosaved work is kept in `dataFolder`.
  explicit DocumentController(const QString& dataFolder, QObject* parent = nullptr);
  ~DocumentController() override;

  [[nodiscard]] DocumentModel& model() { return model_; }
  [[nodiscard]] const Experiment& experiment() const { return model_.as<Experiment>(); }
  [[nodiscard]] RecentFiles& recentFiles() { return recent_; }
  [[nodiscard]] Autosave& autosave() { return autosave_; }
  /// The file of the document; empty if it has none (new, or from the gallery).
  [[nodiscard]] const QString& file() const { return file_; }
  /// Where files the experiment names are looked for.
  [[nodiscard]] std::filesystem::path directory() const { return directory_; }
  [[nodiscard]] bool hasUnsavedChanges() const { return recovered_ || !model_.isClean(); }
  /// What a person calls the document: its file name, else its title.
  [[nodiscard]] QString displayName() const;

  /// A new experiment of one kind: the alternative of `setup`.
  void startNew(std::size_t kind = 0);
  /// Reads the file in the background; opened() or failed() follows. A template (gallery card) is
  /// opened as a new document without a file of its own.
  void open(const QString& file, bool asTemplate = false);
  [[nodiscard]] bool opening() const { return reading_.isRunning(); }
  /// Throws InputError.
  void save(const QString& file);
  /// Takes over lost work as an unsaved document. Throws InputError if it cannot be read.
  void recover(const LostWork& work);

 signals:
  /// Another document is in the editor.
  void opened();
  void failed(const QString& file, const std::vector<rotorbench::Problem>& problems);
  /// Name, file or unsaved mark changed.
  void titleChanged();

 private:
  struct ReadResult {
    std::variant<Experiment, std::vector<Problem>> outcome;
  };
  static ReadResult read(const QString& file);
  void finishOpen();
  void take(Experiment experiment, const QString& file, const std::filesystem::path& directory);
  void keepWork();

  DocumentModel model_;
  RecentFiles recent_;
  Autosave autosave_;
  QTimer autosaveTimer_;
  QFutureWatcher<ReadResult> reading_;
  QString file_, openingFile_;
  bool openingTemplate_ = false;
  bool recovered_ = false;  ///< recovered work is unsaved though nothing was edited yet
  std::filesystem::path directory_;
};

}  // namespace rotorbench
