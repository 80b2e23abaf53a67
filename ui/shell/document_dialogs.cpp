#include "ui/shell/document_dialogs.h"

#include <QDir>
#include <QFileDialog>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <utility>

#include "sim/document/experiment_file.h"

namespace rotorbench {

namespace {

QString fileFilter() {
  return DocumentDialogs::tr("Experiments (*%1);;All files (*)")
      .arg(QString::fromUtf8(kExperimentSuffix.data(),
                             static_cast<qsizetype>(kExperimentSuffix.size())));
}

/// A file name made from a title: "F450 hover and steps" -> "f450-hover-and-steps.json".
QString proposedName(const QString& title) {
  QString name;
  for (const QChar c : title.toLower().simplified()) {
    name += c.isLetterOrNumber() || c == '.' ? c : QChar('-');
  }
  return (name.isEmpty() ? QString("experiment") : name) +
         QString::fromStdString(std::string(kExperimentSuffix));
}

}  // namespace

QString problemLines(const std::vector<Problem>& problems, std::size_t most) {
  QStringList lines;
  for (std::size_t i = 0; i < std::min(most, problems.size()); ++i) {
    lines << QString::fromStdString(problems[i].message());
  }
  if (problems.size() > most) {
    lines << DocumentDialogs::tr("… and %n more", nullptr,
                                 static_cast<int>(problems.size() - most));
  }
  return lines.join('\n');
}

DocumentDialogs::DocumentDialogs(DocumentController& documents, QWidget& window)
    : QObject(&window), documents_(documents), window_(window) {
  connect(&documents_, &DocumentController::failed, this,
          [this](const QString& file, const std::vector<Problem>& problems) {
            showProblems(tr("Open"),
                         tr("“%1” cannot be opened.").arg(QDir::toNativeSeparators(file)),
                         problems);
          });
}

void DocumentDialogs::startNew(std::size_t kind) {
  guard([this, kind] { documents_.startNew(kind); });
}

void DocumentDialogs::openWithDialog() {
  guard([this] {
    const QString start = documents_.file().isEmpty()
                              ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                              : QFileInfo(documents_.file()).path();
    auto* dialog = new QFileDialog(&window_, tr("Open experiment"), start, fileFilter());
    dialog->setObjectName("openDialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString& file) { documents_.open(file); });
    dialog->open();
  });
}

void DocumentDialogs::openFile(const QString& file, bool asTemplate) {
  guard([this, file, asTemplate] { documents_.open(file, asTemplate); });
}

void DocumentDialogs::save() {
  saveThen({});
}

void DocumentDialogs::saveAs() {
  documents_.model().commitPendingEdits();
  askFileName({});
}

void DocumentDialogs::saveThen(std::function<void()> then) {
  documents_.model().commitPendingEdits();
  if (documents_.file().isEmpty()) {
    askFileName(std::move(then));
  } else if (saveTo(documents_.file()) && then) {
    then();
  }
}

void DocumentDialogs::askFileName(std::function<void()> then) {
  const QString folder = documents_.file().isEmpty()
                             ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                             : QFileInfo(documents_.file()).path();
  auto* dialog = new QFileDialog(&window_, tr("Save experiment"), folder, fileFilter());
  dialog->setObjectName("saveDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("json");
  dialog->selectFile(documents_.file().isEmpty()
                         ? proposedName(QString::fromStdString(documents_.experiment().title))
                         : QFileInfo(documents_.file()).fileName());
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, then = std::move(then)](const QString& file) {
            if (saveTo(file) && then) then();
          });
  dialog->open();
}

bool DocumentDialogs::saveTo(const QString& file) {
  try {
    documents_.save(file);
    emit saved(file);
    return true;
  } catch (const InputError& error) {
    showProblems(tr("Save"), tr("“%1” could not be saved.").arg(QDir::toNativeSeparators(file)),
                 error.problems());
    return false;
  }
}

void DocumentDialogs::guard(std::function<void()> proceed) {
  documents_.model().commitPendingEdits();
  if (!documents_.hasUnsavedChanges()) return proceed();
  auto* box =
      new QMessageBox(QMessageBox::Question, tr("Unsaved changes"),
                      tr("Save the changes to “%1”?").arg(documents_.displayName()),
                      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window_);
  box->setObjectName("unsavedBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setInformativeText(tr("Without saving they are lost."));
  connect(box, &QMessageBox::finished, this, [this, proceed = std::move(proceed)](int answer) {
    if (answer == QMessageBox::Save) saveThen(proceed);
    if (answer == QMessageBox::Discard) proceed();
  });
  box->open();
}

void DocumentDialogs::offerRecovery() {
  for (const LostWork& work : documents_.autosave().takeLostWork()) askRecovery(work);
}

void DocumentDialogs::askRecovery(const LostWork& work) {
  auto* box = new QMessageBox(
      QMessageBox::Question, tr("Recover unsaved work"),
      tr("Rotorbench was closed unexpectedly while “%1” had unsaved changes.").arg(work.title),
      QMessageBox::NoButton, &window_);
  box->setObjectName("recoveryBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  const QString when = QLocale().toString(work.time, QLocale::ShortFormat);
  box->setInformativeText(
      work.document.isEmpty()
          ? tr("The changes of %1 were kept. It was never saved to a file.").arg(when)
          : tr("The changes of %1 were kept. Its file: %2")
                .arg(when, QDir::toNativeSeparators(work.document)));
  auto* recover = box->addButton(tr("Recover"), QMessageBox::AcceptRole);
  auto* discard = box->addButton(tr("Discard"), QMessageBox::DestructiveRole);
  auto* later = box->addButton(tr("Decide later"), QMessageBox::RejectRole);
  recover->setObjectName("recoverButton");
  discard->setObjectName("discardButton");
  later->setObjectName("laterButton");
  box->setDefaultButton(recover);
  box->setEscapeButton(later);
  connect(box, &QMessageBox::finished, this, [this, box, work, recover, discard] {
    if (box->clickedButton() == discard) documents_.autosave().discard(work);
    if (box->clickedButton() != recover) return;
    try {
      documents_.recover(work);
    } catch (const InputError& error) {
      showProblems(tr("Recover"), tr("The kept work cannot be read."), error.problems());
    }
  });
  box->open();
}

void DocumentDialogs::showProblems(const QString& title, const QString& text,
                                   const std::vector<Problem>& problems) {
  auto* box = new QMessageBox(QMessageBox::Warning, title, text, QMessageBox::Ok, &window_);
  box->setObjectName("problemBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setInformativeText(problemLines(problems, 5));
  box->setTextInteractionFlags(Qt::TextSelectableByMouse);
  if (problems.size() > 5) box->setDetailedText(problemLines(problems, problems.size()));
  box->open();
}

}  // namespace rotorbench
