// Editors of lists: a table for lists of plain rows, else a list whose entries open their own
// section.
#pragma once

#include <QListWidget>
#include <QTableView>
#include <QWidget>

#include "ui/forms/list_tools.h"
#include "ui/forms/row_table_model.h"

class QLabel;

namespace rotorbench {

/// What the form needs to know of either editor.
class ListEditor : public QWidget {
  Q_OBJECT

 public:
  ListEditor(const FormContext& context, const schema::Field& field, QString path, QWidget* parent);

  virtual void reload() = 0;
  virtual void refresh() = 0;
  virtual void focusPlace(const QString& place) = 0;

 signals:
  /// An entry wants to be shown as its own section.
  void openRequested(const QString& path);

 protected:
  [[nodiscard]] virtual int currentRow() const = 0;
  virtual void setCurrentRow(int row) = 0;
  void updateTools();
  [[nodiscard]] const FormContext& context() const { return context_; }
  [[nodiscard]] DocumentModel& model() const { return *context_.model; }
  [[nodiscard]] const QString& path() const { return path_; }
  [[nodiscard]] const schema::Field& field() const { return field_; }
  [[nodiscard]] int count() const;
  /// The list's view and the buttons below it.
  void arrange(QAbstractItemView* view);
  void insertAfterCurrent();
  void removeCurrent();

 private:
  const FormContext& context_;
  const schema::Field& field_;
  QString path_;
  ListTools* tools_;
};

class TableEditor : public ListEditor {
  Q_OBJECT

 public:
  TableEditor(const FormContext& context, const schema::Field& field, const QString& path,
              QWidget* parent);
  void reload() override;
  void refresh() override;
  void focusPlace(const QString& place) override;

 protected:
  [[nodiscard]] int currentRow() const override;
  void setCurrentRow(int row) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void commitCell();
  void copySelection();
  void paste();
  void showContextMenu(const QPoint& at);
  void showUnitMenu(const QPoint& at);
  void fitHeight();

  QTableView* view_;
  RowTableModel* rows_;
  QLabel* message_;
};

class EntryListEditor : public ListEditor {
  Q_OBJECT

 public:
  EntryListEditor(const FormContext& context, const schema::Field& field, const QString& path,
                  QWidget* parent);
  void reload() override;
  void refresh() override { reload(); }
  void focusPlace(const QString& place) override;

 protected:
  [[nodiscard]] int currentRow() const override { return list_->currentRow(); }
  void setCurrentRow(int row) override { list_->setCurrentRow(row); }

 private:
  QListWidget* list_;
};

ListEditor* makeListEditor(const FormContext& context, const schema::Field& field,
                           const QString& path, QWidget* parent);

}  // namespace rotorbench
