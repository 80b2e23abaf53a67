// A ready experiment on the start page: picture, title and one line. A button, so the keyboard
// reaches it.
#pragma once

#include <QAbstractButton>
#include <QImage>

namespace rotorbench {

class GalleryCard : public QAbstractButton {
  Q_OBJECT

 public:
  static constexpr QSize kPictureSize{264, 150};

  GalleryCard(const QString& title, const QString& summary, QWidget* parent = nullptr);
  void setPicture(const QImage& picture);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  QString summary_;
  QImage picture_;
};

}  // namespace rotorbench
