// The buttons under a list: add, duplicate, remove, move up and down. Knows only counts and the
// chosen index.
#pragma once

#include <QWidget>

class QToolButton;

namespace rotorbench {

class ListTools : public QWidget {
  Q_OBJECT

 public:
  /// `listName` is spoken by screen readers ("Add to Motors").
  ListTools(const QString& listName, QWidget* parent);
  /// Enables what makes sense; `current` is -1 without a selection.
  void setState(int count, int current, std::size_t minItems, std::size_t maxItems);

 signals:
  void addClicked();
  void duplicateClicked();
  void removeClicked();
  /// -1 up, +1 down.
  void moveClicked(int by);

 private:
  QToolButton* add(const QString& name, const QString& icon, const QString& sign,
                   const QString& text);

  QToolButton* add_;
  QToolButton* duplicate_;
  QToolButton* remove_;
  QToolButton* up_;
  QToolButton* down_;
};

}  // namespace rotorbench
