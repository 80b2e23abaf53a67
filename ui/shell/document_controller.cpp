#include "ui/shell/document_controller.h"

#include <QFileInfo>
#include <QtConcurrentRun>

#include "sim/document/experiment_file.h"

namespace rotorbench {

namespace {
// Long enough that typing is not interrupted, short enough that little is lost.
constexpr int kAutosaveMilliseconds = 2000;
}  // namespace

DocumentController::DocumentController(const QString& dataFolder, QObject* parent)
    : QObject(parent), model_(makeDocument(Experiment{})), autosave_(dataFolder) {
  autosaveTimer_.setSingleShot(true);
  autosaveTimer_.setInterval(kAutosaveMilliseconds);
  connect(&autosaveTimer_, &QTimer::timeout, this, &DocumentController::keepWork);
  connect(model_.undoStack(), &QUndoStack::indexChanged, this, [this] {
    if (!autosaveTimer_.isActive()) autosaveTimer_.start();
    emit titleChanged();
  });
  connect(&model_, &DocumentModel::cleanChanged, this, &DocumentController::titleChanged);
  connect(&reading_, &QFutureWatcher<ReadResult>::finished, this, &DocumentController::finishOpen);
}

// The undo stack tells of its end when the model goes, after the members that listen.
DocumentController::~DocumentController() {
  reading_.waitForFinished();
  model_.undoStack()->disconnect(this);
  model_.disconnect(this);
}

QString DocumentController::displayName() const {
  return file_.isEmpty() ? QString::fromStdString(experiment().title) : QFileInfo(file_).fileName();
}

void DocumentController::startNew(std::size_t kind) {
  Experiment experiment;
  schema::typeOf<Experiment>().field("setup")->choose(&experiment, kind);
  take(std::move(experiment), {}, {});
}

void DocumentController::open(const QString& file, bool asTemplate) {
  reading_.waitForFinished();
  openingFile_ = QFileInfo(file).absoluteFilePath();
  openingTemplate_ = asTemplate;
  reading_.setFuture(QtConcurrent::run(read, openingFile_));
}

DocumentController::ReadResult DocumentController::read(const QString& file) {
  try {
    return {loadExperiment(file.toStdString())};
  } catch (const InputError& error) {
    return {error.problems()};
  } catch (const std::exception& error) {
    return {std::vector<Problem>{{"", error.what(), "", false}}};
  }
}

void DocumentController::finishOpen() {
  ReadResult result = reading_.result();
  if (const auto* problems = std::get_if<std::vector<Problem>>(&result.outcome)) {
    recent_.remove(openingFile_);
    emit failed(openingFile_, *problems);
    return;
  }
  if (!openingTemplate_) recent_.add(openingFile_);
  take(std::get<Experiment>(std::move(result.outcome)), openingTemplate_ ? QString() : openingFile_,
       std::filesystem::path(openingFile_.toStdString()).parent_path());
}

void DocumentController::take(Experiment experiment, const QString& file,
                              const std::filesystem::path& directory) {
  file_ = file;
  directory_ = directory;
  recovered_ = false;
  model_.replaceDocument(makeDocument(std::move(experiment)));
  autosaveTimer_.stop();
  autosave_.forget();
  emit opened();
  emit titleChanged();
}

void DocumentController::save(const QString& file) {
  const QString path = QFileInfo(file).absoluteFilePath();
  saveExperiment(experiment(), path.toStdString());
  file_ = path;
  directory_ = std::filesystem::path(path.toStdString()).parent_path();
  recovered_ = false;
  model_.setClean();
  autosaveTimer_.stop();
  autosave_.forget();
  recent_.add(path);
  emit titleChanged();
}

void DocumentController::recover(const LostWork& work) {
  Experiment experiment = autosave_.recover(work);
  take(std::move(experiment), work.document,
       std::filesystem::path(work.document.toStdString()).parent_path());
  recovered_ = true;
  // The old copy goes only when this session has its own.
  keepWork();
  autosave_.flush();
  autosave_.discard(work);
  emit titleChanged();
}

void DocumentController::keepWork() {
  if (hasUnsavedChanges()) {
    autosave_.keep(experiment(), file_);
  } else {
    autosave_.forget();
  }
}

}  // namespace rotorbench
