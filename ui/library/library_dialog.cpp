#include "ui/library/library_dialog.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QStandardPaths>
#include <QVBoxLayout>

#include "ui/forms/field_text.h"
#include "ui/forms/form_style.h"
#include "ui/library/component_details.h"
#include "ui/library/component_list.h"

namespace rotorbench {

LibraryRequest browseRequest() {
  LibraryRequest request;
  request.title = LibraryDialog::tr("Component library");
  for (const ComponentKind& kind : componentKinds()) request.kinds.push_back(&kind);
  return request;
}

std::filesystem::path ownLibraryDirectory() {
  const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  return std::filesystem::path(data.toStdString()) / "library";
}

LibraryDialog::LibraryDialog(LibraryRequest request, QWidget* parent)
    : QDialog(parent),
      request_(std::move(request)),
      library_(shippedLibraryDirectory(), ownLibraryDirectory()),
      units_(nullptr),
      list_(new ComponentList(library_, units_, request_.kinds)),
      details_(new ComponentDetails(units_)),
      message_(new QLabel) {
  setObjectName(QStringLiteral("libraryDialog"));
  setWindowTitle(request_.use ? tr("%1 – component library").arg(request_.title) : request_.title);
  setAttribute(Qt::WA_DeleteOnClose);
  resize(940, 620);
  message_->setObjectName(QStringLiteral("libraryMessage"));
  message_->setAccessibleName(tr("Message"));
  message_->setTextFormat(Qt::PlainText);
  message_->setWordWrap(true);
  message_->hide();
  auto* splitter = new QSplitter;
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(list_);
  splitter->addWidget(details_);
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 2);
  auto* column = new QVBoxLayout(this);
  column->addWidget(splitter, 1);
  column->addWidget(message_);
  column->addWidget(buildManaging());
  column->addWidget(buildClosing());
  if (use_ != nullptr) use_->setDefault(true);  // counts only inside the dialog
  connect(list_, &ComponentList::currentChanged, this, &LibraryDialog::showCurrent);
  connect(list_, &ComponentList::activated, this, &LibraryDialog::use);
  showCurrent();
  sayFaults();
  list_->focusSearch();
}

LibraryDialog::~LibraryDialog() {
  // List and details look at the library and the units to the end.
  delete list_;
  delete details_;
}

QPushButton* LibraryDialog::addButton(QWidget* box, const char* name, const QString& text,
                                      const QString& help, void (LibraryDialog::*slot)()) {
  auto* button = new QPushButton(text, box);
  button->setObjectName(QString::fromLatin1(name));
  button->setToolTip(help);
  button->setAutoDefault(false);
  box->layout()->addWidget(button);
  connect(button, &QPushButton::clicked, this, slot);
  return button;
}

QWidget* LibraryDialog::buildManaging() {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  if (request_.current) {
    addButton(box, "librarySave", tr("Save current as…"),
              tr("Keeps what the form holds now as a component of yours"),
              &LibraryDialog::saveCurrent);
  }
  duplicate_ = addButton(box, "libraryDuplicate", tr("Duplicate…"),
                         tr("Makes one of yours from this component"), &LibraryDialog::duplicate);
  rename_ = addButton(box, "libraryRename", tr("Rename…"),
                      tr("Changes name and texts of a component of yours"), &LibraryDialog::rename);
  delete_ = addButton(box, "libraryDelete", tr("Delete"), tr("Deletes a component of yours"),
                      &LibraryDialog::remove);
  addButton(box, "libraryImport", tr("Import…"), tr("Adds components from files"),
            &LibraryDialog::importFiles);
  export_ = addButton(box, "libraryExport", tr("Export…"), tr("Writes this component to a file"),
                      &LibraryDialog::exportFile);
  row->addStretch(1);
  const auto shortcut = [this](const QKeySequence& keys, QPushButton* button) {
    auto* action = new QAction(this);
    action->setShortcut(keys);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    list_->addAction(action);
    connect(action, &QAction::triggered, button, [button] { button->click(); });
  };
  shortcut(QKeySequence(Qt::Key_F2), rename_);
  shortcut(QKeySequence::Delete, delete_);
  return box;
}

QWidget* LibraryDialog::buildClosing() {
  auto* buttons =
      new QDialogButtonBox(request_.use ? QDialogButtonBox::Cancel : QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  if (!request_.use) return buttons;
  use_ = buttons->addButton(tr("Use"), QDialogButtonBox::AcceptRole);
  use_->setObjectName(QStringLiteral("libraryUse"));
  use_->setToolTip(tr("Fills the form with this component"));
  connect(use_, &QPushButton::clicked, this, &LibraryDialog::use);
  return buttons;
}

void LibraryDialog::showCurrent() {
  const LibraryEntry* entry = list_->current();
  details_->show(entry == nullptr ? nullptr : &entry->component);
  if (duplicate_ == nullptr) return;  // while the dialog is being built
  for (QPushButton* button : {use_, duplicate_, export_}) {
    if (button != nullptr) button->setEnabled(entry != nullptr);
  }
  for (QPushButton* button : {rename_, delete_}) {
    button->setEnabled(entry != nullptr && entry->own);
  }
}

void LibraryDialog::say(const QString& sentence, bool wrong) {
  message_->setText(sentence);
  message_->setVisible(!sentence.isEmpty());
  const auto severity = wrong ? form_style::Severity::Error : form_style::Severity::None;
  form_style::setTextColour(message_, form_style::severityColour(severity, palette()));
}

void LibraryDialog::sayFaults() {
  QStringList sentences;
  for (const LibraryFault& fault : library_.faults()) {
    sentences << tr("%1 cannot be read: %2.")
                     .arg(toQString(fault.file.filename().string()), toQString(fault.sentence));
  }
  if (!sentences.isEmpty()) say(sentences.join(QLatin1Char('\n')), true);
}

/// The window answers F1 by what has the focus, and this dialog keeps the key from it.
void LibraryDialog::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_F1 || parentWidget() == nullptr) {
    return QDialog::keyPressEvent(event);
  }
  if (auto* help = parentWidget()->findChild<QAction*>(QStringLiteral("actionHelpHere"))) {
    help->trigger();
  }
}

void LibraryDialog::use() {
  const LibraryEntry* entry = list_->current();
  if (entry == nullptr || !request_.use) return;
  request_.use(entry->component);
  accept();
}

}  // namespace rotorbench
