#include "ui/shell/gallery.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QtConcurrentMap>

#include "sim/document/experiment_file.h"
#include "sim/document/resources.h"
#include "ui/shell/experiment_picture.h"
#include "ui/shell/theme.h"

namespace rotorbench {

namespace {

constexpr int kSideWidth = 240;
constexpr int kGap = 16;

QLabel* heading(const QString& text) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * 1.25);
  font.setBold(true);
  label->setFont(font);
  return label;
}

/// A file of the gallery always reads; one that was spoilt on disk gets an empty picture.
QImage pictureOf(const QString& file, qreal scale, const QPalette& palette) {
  try {
    return experimentPicture(loadExperiment(file.toStdString()), GalleryCard::kPictureSize, scale,
                             palette);
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

Gallery::Gallery(RecentFiles& recent, QWidget* parent) : QWidget(parent), recent_(recent) {
  setObjectName("gallery");
  setAccessibleName(tr("Start page"));
  cardArea_ = new QWidget;
  grid_ = new QGridLayout(cardArea_);
  grid_->setSpacing(kGap);
  grid_->setContentsMargins(kGap, kGap, kGap, kGap);
  grid_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  auto* scroll = new QScrollArea;
  scroll->setObjectName("galleryScroll");
  scroll->setWidget(cardArea_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(kGap, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(buildSide());
  layout->addWidget(scroll, 1);
  buildCards();
  showRecent();
  connect(&recent_, &RecentFiles::changed, this, &Gallery::showRecent);
  connect(&pictures_, &QFutureWatcher<QImage>::resultReadyAt, this, [this](int i) {
    cards_[static_cast<std::size_t>(i)]->setPicture(pictures_.resultAt(i));
  });
  drawPictures();
}

Gallery::~Gallery() {
  pictures_.cancel();
  pictures_.waitForFinished();
}

QWidget* Gallery::buildSide() {
  auto* side = new QWidget;
  side->setFixedWidth(kSideWidth);
  auto* layout = new QVBoxLayout(side);
  layout->setContentsMargins(0, kGap, 0, kGap);
  layout->addWidget(heading(tr("Rotorbench")));
  auto* intro = new QLabel(tr("Choose an experiment, then press Run (F5)."));
  intro->setWordWrap(true);
  layout->addWidget(intro);
  layout->addSpacing(kGap / 2);
  auto* create = new QPushButton(themedIcon("document-new"), tr("New experiment"));
  create->setObjectName("galleryNew");
  auto* open = new QPushButton(themedIcon("document-open"), tr("Open a file…"));
  open->setObjectName("galleryOpen");
  connect(create, &QPushButton::clicked, this, &Gallery::newRequested);
  connect(open, &QPushButton::clicked, this, &Gallery::openRequested);
  back_ = new QPushButton(themedIcon("go-previous"), tr("Back to the experiment"));
  back_->setObjectName("galleryBack");
  back_->hide();
  connect(back_, &QPushButton::clicked, this, &Gallery::backRequested);
  layout->addWidget(back_);
  layout->addWidget(create);
  layout->addWidget(open);
  layout->addSpacing(kGap);
  recentLayout_ = new QVBoxLayout;
  recentLayout_->setSpacing(2);
  layout->addLayout(recentLayout_);
  layout->addStretch(1);
  return side;
}

void Gallery::setOpenDocument(const QString& name) {
  back_->setVisible(!name.isEmpty());
  back_->setToolTip(name);
}

void Gallery::buildCards() {
  std::vector<InputError> faults;
  const std::vector<ShippedExperiment> shipped = shippedExperiments(&faults);
  if (!faults.empty()) showFaults(faults);
  for (const ShippedExperiment& experiment : shipped) {
    const QString file = QString::fromStdString(experiment.file.string());
    auto* card = new GalleryCard(QString::fromStdString(experiment.title),
                                 QString::fromStdString(experiment.summary));
    card->setObjectName("card:" + QString::fromStdString(experiment.name));
    connect(card, &GalleryCard::clicked, this, [this, file] { emit experimentChosen(file); });
    cards_.push_back(card);
    files_ << file;
  }
}

/// One sentence per file that cannot be read, below the cards of the others.
void Gallery::showFaults(const std::vector<InputError>& faults) {
  QStringList sentences;
  for (const InputError& fault : faults) {
    const QString file = QFileInfo(QString::fromStdString(fault.source())).fileName();
    const QString reason = fault.problems().empty()
                               ? QString::fromUtf8(fault.what())
                               : QString::fromStdString(fault.problems().front().message());
    sentences << tr("%1 cannot be read: %2.").arg(file, reason);
  }
  faults_ = new QLabel(sentences.join('\n'));
  faults_->setObjectName("galleryError");
  faults_->setAccessibleName(tr("Experiments that cannot be read"));
  faults_->setTextFormat(Qt::PlainText);
  faults_->setWordWrap(true);
}

void Gallery::showRecent() {
  while (QLayoutItem* item = recentLayout_->takeAt(0)) {
    if (item->widget() != nullptr) item->widget()->deleteLater();
    delete item;
  }
  const QStringList files = recent_.files();
  if (!files.isEmpty()) recentLayout_->addWidget(heading(tr("Recent files")));
  for (const QString& file : files) {
    auto* button = new QPushButton;
    button->setObjectName("recentFile");
    button->setFlat(true);
    button->setStyleSheet("text-align: left; padding: 3px;");
    button->setText(button->fontMetrics().elidedText(QFileInfo(file).fileName(), Qt::ElideMiddle,
                                                     kSideWidth - 2 * kGap));
    button->setToolTip(QDir::toNativeSeparators(file));
    connect(button, &QPushButton::clicked, this, [this, file] { emit fileChosen(file); });
    recentLayout_->addWidget(button);
  }
}

void Gallery::arrange() {
  const int room = width() - kSideWidth - 2 * kGap;
  const int columns = std::max(1, (room - kGap) / (GalleryCard::kPictureSize.width() + kGap));
  if (columns == columns_) return;
  columns_ = columns;
  for (GalleryCard* card : cards_) grid_->removeWidget(card);
  for (int i = 0; i < static_cast<int>(cards_.size()); ++i) {
    grid_->addWidget(cards_[static_cast<std::size_t>(i)], i / columns, i % columns);
  }
  if (faults_ == nullptr) return;
  grid_->removeWidget(faults_);
  grid_->addWidget(faults_, grid_->rowCount(), 0, 1, columns);
}

void Gallery::drawPictures() {
  pictures_.setFuture(QtConcurrent::mapped(
      files_, [scale = devicePixelRatioF(), colors = palette()](const QString& file) {
        return pictureOf(file, scale, colors);
      }));
}

void Gallery::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

void Gallery::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && cardArea_ != nullptr) {
    pictures_.cancel();
    pictures_.waitForFinished();
    drawPictures();
  }
}

}  // namespace rotorbench
