// The start page: ready experiments as cards, files used last beside them.
#pragma once

#include <QFutureWatcher>
#include <QImage>
#include <QList>
#include <QWidget>
#include <memory>
#include <vector>

#include "sim/core/error.h"
#include "ui/shell/gallery_card.h"
#include "ui/shell/recent_files.h"

class QGridLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace rotorbench {

class Gallery : public QWidget {
  Q_OBJECT

 public:
  Gallery(RecentFiles& recent, QWidget* parent = nullptr);
  ~Gallery() override;
  /// Offers the way back to the experiment that is open in the workbench.
  void setOpenDocument(const QString& name);

 signals:
  void experimentChosen(const QString& file);
  void fileChosen(const QString& file);
  void openRequested();
  void newRequested();
  void backRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void buildCards();
  void showFaults(const std::vector<InputError>& faults);
  QWidget* buildSide();
  void showRecent();
  void arrange();
  void drawPictures();

  RecentFiles& recent_;
  QPushButton* back_ = nullptr;
  QWidget* cardArea_ = nullptr;
  QGridLayout* grid_ = nullptr;
  QLabel* faults_ = nullptr;  ///< null where every experiment could be read
  QVBoxLayout* recentLayout_ = nullptr;
  int columns_ = 0;
  std::vector<GalleryCard*> cards_;
  QStringList files_;
  QFutureWatcher<QImage> pictures_;
};

}  // namespace rotorbench
