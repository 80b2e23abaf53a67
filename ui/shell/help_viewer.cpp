#include "ui/shell/help_viewer.h"

#include <QAction>
#include <QListWidget>
#include <QSplitter>
#include <QTextBrowser>
#include <QToolBar>
#include <QVBoxLayout>

#include "ui/shell/theme.h"

namespace rotorbench {

namespace {

/// Pages are made here, links inside help are page names, links to the web open in the browser.
class HelpBrowser : public QTextBrowser {
 public:
  explicit HelpBrowser(const HelpLibrary& library) : library_(library) {}

 protected:
  QVariant loadResource(int type, const QUrl& name) override {
    if (type != QTextDocument::HtmlResource) return {};
    return library_.html(name.path().section('/', -1).section('.', 0, 0));
  }

 private:
  const HelpLibrary& library_;
};

}  // namespace

HelpViewer::HelpViewer(HelpLibrary library, QWidget* parent)
    : QWidget(parent, Qt::Window),
      library_(std::move(library)),
      contents_(new QListWidget),
      browser_(new HelpBrowser(library_)) {
  setObjectName("helpViewer");
  setWindowTitle(tr("Help"));
  resize(900, 700);
  contents_->setObjectName("helpContents");
  contents_->setAccessibleName(tr("Help contents"));
  for (const HelpPage& page : library_.pages()) {
    auto* item = new QListWidgetItem(page.title, contents_);
    item->setData(Qt::UserRole, page.name);
  }
  browser_->setObjectName("helpBrowser");
  browser_->setAccessibleName(tr("Help page"));
  browser_->setOpenExternalLinks(true);
  browser_->document()->setDocumentMargin(16);

  auto* bar = new QToolBar;
  QAction* back =
      bar->addAction(themedIcon("go-previous"), tr("Back"), browser_, &QTextBrowser::backward);
  QAction* forward =
      bar->addAction(themedIcon("go-next"), tr("Forward"), browser_, &QTextBrowser::forward);
  back->setShortcut(QKeySequence::Back);
  forward->setShortcut(QKeySequence::Forward);
  connect(browser_, &QTextBrowser::backwardAvailable, back, &QAction::setEnabled);
  connect(browser_, &QTextBrowser::forwardAvailable, forward, &QAction::setEnabled);

  auto* splitter = new QSplitter;
  splitter->addWidget(contents_);
  splitter->addWidget(browser_);
  splitter->setSizes({210, 690});
  splitter->setChildrenCollapsible(false);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(bar);
  layout->addWidget(splitter, 1);

  connect(contents_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    if (item != nullptr) load(item->data(Qt::UserRole).toString());
  });
  connect(browser_, &QTextBrowser::sourceChanged, this, &HelpViewer::markContents);
}

void HelpViewer::showTopic(const QStringList& topics) {
  load(library_.pageFor(topics));
  show();
  raise();
  activateWindow();
}

QString HelpViewer::currentPage() const {
  return browser_->source().path().section('/', -1).section('.', 0, 0);
}

void HelpViewer::load(const QString& page) {
  if (page != currentPage()) browser_->setSource(QUrl(page + ".html"));
  markContents();
}

void HelpViewer::markContents() {
  const QSignalBlocker blocker(contents_);
  for (int row = 0; row < contents_->count(); ++row) {
    if (contents_->item(row)->data(Qt::UserRole).toString() == currentPage())
      contents_->setCurrentRow(row);
  }
}

}  // namespace rotorbench
