// What the library's dialog does with files: saving, copying, renaming, importing, exporting,
// deleting.
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include "sim/io/file.h"
#include "sim/library/component_file.h"
#include "ui/forms/document_model.h"
#include "ui/forms/field_text.h"
#include "ui/library/component_list.h"
#include "ui/library/library_dialog.h"

namespace rotorbench {

namespace {

QString sentenceOf(const InputError& error) {
  if (error.problems().empty()) return QString::fromUtf8(error.what());
  const QString place = toQString(error.problems().front().path);
  const QString sentence = problemSentence(error.problems().front());
  return place.isEmpty() || place == QLatin1String("name")
             ? sentence
             : place + QStringLiteral(": ") + sentence;
}

QString fileFilter() {
  return LibraryDialog::tr("Components (*.json);;All files (*)");
}

QString documentsFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

}  // namespace

QString LibraryDialog::change(const std::function<const LibraryEntry*()>& action) {
  try {
    const LibraryEntry* entry = action();
    list_->reload(entry == nullptr ? std::filesystem::path() : entry->file);
  } catch (const InputError& error) {
    list_->reload();
    return sentenceOf(error);
  }
  return {};
}

void LibraryDialog::askInfo(const QString& title, const ComponentInfo& info,
                            ComponentInfoDialog::Accept accept) {
  (new ComponentInfoDialog(title, info, std::move(accept), this))->open();
}

void LibraryDialog::saveCurrent() {
  const auto current = request_.current();
  if (!current) return say(tr("What the form holds now is no component of the library."), true);
  const Component component = makeComponent({}, *current);
  const ComponentKind& kind = *kindOf(*component.type);
  ComponentInfo info;
  info.name = library_.freeName(kind, tr("My %1").arg(toQString(kind.label)).toStdString());
  askInfo(tr("Save as component"), info, [this, component](const ComponentInfo& given) {
    return change([&] { return &library_.save({given, component.type, component.value}); });
  });
}

void LibraryDialog::duplicate() {
  const LibraryEntry* entry = list_->current();
  if (entry == nullptr) return;
  const Component component = entry->component;
  ComponentInfo info = component.info;
  info.name = library_.freeName(*kindOf(*component.type), info.name);
  askInfo(tr("Duplicate component"), info, [this, component](const ComponentInfo& given) {
    return change([&] { return &library_.save({given, component.type, component.value}); });
  });
}

void LibraryDialog::rename() {
  const LibraryEntry* entry = list_->current();
  if (entry == nullptr || !entry->own) return;
  const auto file = entry->file;
  askInfo(tr("Rename component"), entry->component.info, [this, file](const ComponentInfo& given) {
    return change([&]() -> const LibraryEntry* {
      for (const LibraryEntry& own : library_.entries()) {
        if (own.file != file) continue;
        return &library_.replace(own, {given, own.component.type, own.component.value});
      }
      return nullptr;
    });
  });
}

void LibraryDialog::importOne(const QString& file, QStringList& done, QStringList& faults) {
  const QString name = QFileInfo(file).fileName();
  const QString sentence = change([&] {
    Component component = loadComponent(file.toStdString());
    component.info.name = library_.freeName(*kindOf(*component.type), component.info.name);
    const LibraryEntry& entry = library_.save(component);
    done << toQString(entry.component.info.name);
    return &entry;
  });
  if (!sentence.isEmpty()) faults << tr("%1 cannot be imported: %2").arg(name, sentence);
}

void LibraryDialog::importFiles() {
  auto* dialog = new QFileDialog(this, tr("Import components"), documentsFolder(), fileFilter());
  dialog->setObjectName(QStringLiteral("libraryImportDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFiles);
  connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& files) {
    QStringList done, faults;
    for (const QString& file : files) importOne(file, done, faults);
    if (!done.isEmpty()) faults.prepend(tr("Imported: %1.").arg(done.join(QStringLiteral(", "))));
    say(faults.join(QLatin1Char('\n')), faults.size() > (done.isEmpty() ? 0 : 1));
  });
  dialog->open();
}

void LibraryDialog::exportFile() {
  const LibraryEntry* entry = list_->current();
  if (entry == nullptr) return;
  auto* dialog = new QFileDialog(this, tr("Export component"), documentsFolder(), fileFilter());
  dialog->setObjectName(QStringLiteral("libraryExportDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("json"));
  dialog->selectFile(toQString(entry->file.filename().string()));
  const Component component = entry->component;
  connect(dialog, &QFileDialog::fileSelected, this, [this, component](const QString& file) {
    try {
      writeFileAtomically(file.toStdString(), writeComponent(component));
      say(tr("Exported: %1").arg(QDir::toNativeSeparators(file)));
    } catch (const InputError& error) {
      say(tr("%1 cannot be written: %2").arg(QFileInfo(file).fileName(), sentenceOf(error)), true);
    }
  });
  dialog->open();
}

void LibraryDialog::remove() {
  const LibraryEntry* entry = list_->current();
  if (entry == nullptr || !entry->own) return;
  const auto file = entry->file;
  auto* box = new QMessageBox(
      QMessageBox::Question, tr("Delete component"),
      tr("Delete “%1” from your library?").arg(toQString(entry->component.info.name)),
      QMessageBox::Cancel, this);
  box->setObjectName(QStringLiteral("libraryDeleteBox"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  auto* yes = box->addButton(tr("Delete"), QMessageBox::DestructiveRole);
  yes->setObjectName(QStringLiteral("libraryDeleteYes"));
  box->setDefaultButton(QMessageBox::Cancel);
  connect(yes, &QPushButton::clicked, this, [this, file] {
    const QString sentence = change([&]() -> const LibraryEntry* {
      for (const LibraryEntry& own : library_.entries()) {
        if (own.file == file) {
          library_.remove(own);
          break;
        }
      }
      return nullptr;
    });
    say(sentence, true);
  });
  box->open();
}

}  // namespace rotorbench
